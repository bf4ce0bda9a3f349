import { DataTexture, LinearFilter, SRGBColorSpace } from "three";

const STEPS = 256;

/**
 * The cividis colormap, which everybody can read: red, green, blue from 0 to 255 (the polynomial
 * of d3-scale-chromatic, by Jamie R. Nuñez, Christopher R. Anderton and Ryan S. Renslow).
 */
export function cividis(t: number): readonly [number, number, number] {
  const red = -4.54 - t * (35.34 - t * (2381.73 - t * (6402.7 - t * (7024.72 - t * 2710.57))));
  const green = 32.49 + t * (170.73 + t * (52.82 - t * (131.46 - t * (176.58 - t * 67.37))));
  const blue = 81.24 + t * (442.36 - t * (2482.43 - t * (6167.24 - t * (6614.94 - t * 2475.67))));
  return [byte(red), byte(green), byte(blue)];
}

function byte(value: number): number {
  return Math.max(0, Math.min(255, Math.round(value)));
}

const LIKELY = cividis(1);
/** The blue that cividis begins with, lightened: navy on a floor looks like a shadow. */
const UNLIKELY = [88, 160, 255] as const;

/**
 * The colors of the map, from light blue to yellow. Straight between the two: the grays in the
 * middle of cividis look like stains on wood.
 */
export function heatColor(t: number): readonly [number, number, number] {
  const mixed = (side: 0 | 1 | 2) => byte(UNLIKELY[side] + (LIKELY[side] - UNLIKELY[side]) * t);
  return [mixed(0), mixed(1), mixed(2)];
}

/** The colors of the map as a look-up texture. */
export function heatTexture(): DataTexture {
  const data = new Uint8Array(STEPS * 4);
  for (let i = 0; i < STEPS; i++) {
    data.set([...heatColor(i / (STEPS - 1)), 255], i * 4);
  }
  const texture = new DataTexture(data, STEPS, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
