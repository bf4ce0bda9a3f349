/** Points, segments and polygons of the floor: core frame, metres. */
import type { Point } from "./state";

export type Segment = readonly [Point, Point];

export const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1]];
export const subtract = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
export const scale = (a: Point, by: number): Point => [a[0] * by, a[1] * by];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];
export const length = (a: Point): number => Math.hypot(a[0], a[1]);
export const distance = (a: Point, b: Point): number => length(subtract(b, a));
/** The unit vector of an angle, radians anticlockwise from +x. */
export const direction = (angle: number): Point => [Math.cos(angle), Math.sin(angle)];
/** The angle of a vector, radians anticlockwise from +x. */
export const angleOf = (a: Point): number => Math.atan2(a[1], a[0]);
/** A quarter turn anticlockwise. */
export const leftOf = (a: Point): Point => [-a[1], a[0]];
/** The point that lies `by` of the way from a to b. */
export const between = (a: Point, b: Point, by: number): Point => add(a, scale(subtract(b, a), by));

/** The same angle from −π to π, radians. */
export function wrapped(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

/** Rounded to a millimetre: what a pointer on a floor means. */
export function rounded(value: number): number {
  return Math.round(value * 1000) / 1000;
}

export function roundedPoint([x, y]: Point): Point {
  return [rounded(x), rounded(y)];
}

/** The sides of a polygon in order; side i joins corner i to i+1. */
export function sides(corners: readonly Point[]): readonly Segment[] {
  return corners.map((corner, i) => [corner, corners[(i + 1) % corners.length] ?? corner]);
}

/** The area of a polygon, square metres: positive when its corners run anticlockwise. */
export function signedArea(corners: readonly Point[]): number {
  return sides(corners).reduce((sum, [a, b]) => sum + cross(a, b), 0) / 2;
}

/** Whether the point is inside the polygon (even-odd rule). */
export function isInside([x, y]: Point, corners: readonly Point[]): boolean {
  let inside = false;
  for (const [a, b] of sides(corners)) {
    if (a[1] > y !== b[1] > y && x < a[0] + ((y - a[1]) * (b[0] - a[0])) / (b[1] - a[1])) {
      inside = !inside;
    }
  }
  return inside;
}

/** How far along the segment its point nearest to `point` is: 0 at its start, 1 at its end. */
export function along(point: Point, [start, end]: Segment): number {
  const run = subtract(end, start);
  const squared = dot(run, run);
  if (squared === 0) return 0;
  return Math.min(1, Math.max(0, dot(subtract(point, start), run) / squared));
}

/** The point of the segment nearest to `point`. */
export function nearestOn(point: Point, segment: Segment): Point {
  return between(segment[0], segment[1], along(point, segment));
}

/** Whether two segments cross at a point inside both. */
export function crosses([a, b]: Segment, [c, d]: Segment): boolean {
  const side = (from: Point, to: Point, point: Point): number =>
    cross(subtract(to, from), subtract(point, from));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** Whether two segments cross or touch. */
export function meets(one: Segment, other: Segment): boolean {
  const TOUCH = 1e-6; // metres
  const ends: readonly (readonly [Point, Segment])[] = [
    [one[0], other],
    [one[1], other],
    [other[0], one],
    [other[1], one],
  ];
  return (
    crosses(one, other) ||
    ends.some(([point, segment]) => distance(point, nearestOn(point, segment)) < TOUCH)
  );
}

/** Whether no side of the polygon meets another, but for the corners that neighbors share. */
export function isSimple(corners: readonly Point[]): boolean {
  const all = sides(corners);
  return all.every((side, i) =>
    all.every((other, j) => {
      if (j <= i) return true;
      const apart = Math.min(j - i, all.length - (j - i));
      return apart === 1 ? !foldsBack(side, other) : !meets(side, other);
    }),
  );
}

/** Whether two sides that share a corner lie on each other. */
function foldsBack(side: Segment, next: Segment): boolean {
  const a = subtract(side[1], side[0]);
  const b = subtract(next[1], next[0]);
  const parallel = Math.abs(cross(a, b)) <= 1e-9 * length(a) * length(b);
  return parallel && (dot(a, b) < 0 || length(a) === 0 || length(b) === 0);
}
