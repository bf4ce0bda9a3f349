/** Numbers as people read them. */

/** Metres with one decimal, two below a metre: "1.1 m", "0.45 m". */
export function formatLength(metres: number): string {
  return `${metres.toFixed(Math.abs(metres) < 0.995 ? 2 : 1)} m`;
}

/** A size as "2.0 × 0.9 × 0.8 m" (the order given), metres. */
export function formatSize(lengths: readonly number[]): string {
  return `${lengths.map((length) => length.toFixed(length < 0.995 ? 2 : 1)).join(" × ")} m`;
}

/** Square metres with one decimal: "20.0 m²". */
export function formatArea(squareMetres: number): string {
  return `${squareMetres.toFixed(1)} m²`;
}

/** Radians as whole degrees from 0° to 359°. */
export function formatAngle(radians: number): string {
  const degrees = Math.round((radians * 180) / Math.PI) % 360;
  return `${degrees < 0 ? degrees + 360 : degrees}°`;
}
