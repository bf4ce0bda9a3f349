/** Lengths as people type them. */

export const MIN_LENGTH = 0.01; // metres; thinner things are slips of the finger
export const MAX_LENGTH = 100; // metres; the limit of the wire

export type Unit = "cm" | "m";

export type Typed =
  | { readonly ok: true; readonly metres: number }
  | { readonly ok: false; readonly problem: string };

export interface Limits {
  readonly min: number;
  readonly max: number;
}

const PATTERN = /^([+-]?\d+(?:[.,]\d+)?)\s*(mm|cm|m)?$/i;
const UNITS: Readonly<Record<string, number>> = { mm: 0.001, cm: 0.01, m: 1 };

/**
 * The metres of "85", "85 cm", "0.85 m" or "0,85".
 *
 * A bare number is in the field's unit, except that "0.85" in a field of centimetres means metres:
 * nobody measures furniture in fractions of a centimetre.
 */
export function parseLength(text: string, unit: Unit, limits: Limits = ANY_LENGTH): Typed {
  const match = PATTERN.exec(text.trim());
  if (match?.[1] === undefined) {
    return { ok: false, problem: `Type a number, like ${unit === "cm" ? "85 or 0.85 m" : "3.5"}.` };
  }
  const number = Number(match[1].replace(",", "."));
  const fraction = /[.,]/.test(match[1]) && Math.abs(number) < 10;
  const scale = UNITS[match[2]?.toLowerCase() ?? (fraction ? "m" : unit)] ?? 1;
  const value = Number((number * scale).toFixed(4));
  if (value < limits.min) return { ok: false, problem: `At least ${inUnit(limits.min, unit)}.` };
  if (value > limits.max) return { ok: false, problem: `At most ${inUnit(limits.max, unit)}.` };
  return { ok: true, metres: value };
}

const ANY_LENGTH: Limits = { min: MIN_LENGTH, max: MAX_LENGTH };

/** The metres as the field shows them, without the unit: "85", "4.5" (below 10 cm), "3.25". */
export function shown(value: number, unit: Unit): string {
  if (unit === "m") return String(Number(value.toFixed(2)));
  const scaled = value * 100;
  return String(Number(scaled.toFixed(Math.abs(scaled) < 10 ? 1 : 0)));
}

function inUnit(value: number, unit: Unit): string {
  return unit === "cm" && value < 10 ? `${shown(value, "cm")} cm` : `${shown(value, "m")} m`;
}
