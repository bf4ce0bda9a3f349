/**
 * The only place of the page where axes are swapped.
 *
 * Core: right-handed, z up, heading anticlockwise from +x. Page, glTF and WebXR: right-handed,
 * y up; a model's front looks along +z (the glTF convention).
 */
import type { Vector3 } from "./state";

/** A core point as a page point, metres: x stays, z becomes y, y becomes −z. */
export function toPage([x, y, z]: Vector3): Vector3 {
  return [x, z, -y];
}

/** A page point as a core point, metres; the inverse of `toPage`. */
export function toCore([x, y, z]: Vector3): Vector3 {
  return [x, -z, y];
}

/** The turn about the page's +y, radians, that makes a model's +z front point along heading. */
export function pageTurn(heading: number): number {
  return heading + Math.PI / 2;
}

/** The heading of a model turned about the page's +y; the inverse of `pageTurn`. */
export function headingOfTurn(turn: number): number {
  return turn - Math.PI / 2;
}
