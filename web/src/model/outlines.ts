/** The outline of a room as it is clicked, corner by corner. */
import { MAX_CORNERS } from "../net/protocol.gen";
import {
  add,
  angleOf,
  crosses,
  direction,
  distance,
  dot,
  isSimple,
  length,
  roundedPoint,
  scale,
  sides,
  signedArea,
  subtract,
  wrapped,
} from "./geometry";
import type { Point } from "./state";

/** A click this near to the first corner closes the outline, metres. */
const CLOSING = 0.3;
/** Corners are no nearer to each other than this, metres: a second click on one is a slip. */
const APART = 0.1;
/** Walls this near to a right angle are made square, radians. */
const NEARLY_SQUARE = (12 * Math.PI) / 180;
/** A corner this near to being level with the first is made level, metres. */
const NEARLY_LEVEL = 0.2;
/** Square metres; below that nobody can stand in it. MIN_AREA of scenegen_core. */
const MIN_AREA = 0.5;
/** Lengths of drawn walls are whole centimetres, metres. */
const STEP = 0.01;

const CROSSING = "Walls can't cross. Pick another spot for this corner.";

/** Where the next corner would go: closing, square to the last wall, level with the first corner. */
export function assisted(corners: readonly Point[], pointer: Point, free: boolean): Point {
  const first = corners[0];
  const last = corners.at(-1);
  if (first === undefined || last === undefined) return roundedPoint(pointer);
  if (corners.length >= 3 && distance(pointer, first) < CLOSING) return first;
  const square = free ? null : squareDirection(corners, last, pointer);
  if (square === null) return roundedPoint(pointer);
  const run = dot(subtract(pointer, last), square);
  const level = dot(subtract(first, last), square);
  const metres =
    corners.length >= 2 && Math.abs(run - level) < NEARLY_LEVEL && Math.abs(level) > APART
      ? level
      : Math.round(run / STEP) * STEP;
  return roundedPoint(add(last, scale(square, metres)));
}

/** The outline with one more corner, or a sentence that says why not; null for a slip. */
export function withNextCorner(
  corners: readonly Point[],
  corner: Point,
): readonly Point[] | string | null {
  const last = corners.at(-1);
  if (last === undefined) return [corner];
  if (distance(last, corner) < APART) return null;
  if (corners.length >= MAX_CORNERS) return `A room has ${MAX_CORNERS} corners at most.`;
  const walls = sides(corners).slice(0, -1);
  if (walls.some((wall) => crosses(wall, [last, corner]))) return CROSSING;
  return [...corners, corner];
}

/** A sentence that says why these corners make no room, or null if they do. */
export function outlineProblem(corners: readonly Point[]): string | null {
  if (corners.length < 3) return "A room needs at least three corners.";
  if (!isSimple(corners)) return CROSSING;
  if (Math.abs(signedArea(corners)) < MIN_AREA) return "That is too small for a room.";
  return null;
}

/** The corners anticlockwise, as scenes have them. */
export function anticlockwise(corners: readonly Point[]): readonly Point[] {
  return signedArea(corners) < 0 ? corners.toReversed() : corners;
}

/** The direction square to the last wall that the pointer nearly has; null if it has none. */
function squareDirection(corners: readonly Point[], last: Point, pointer: Point): Point | null {
  const before = corners.at(-2);
  const base = before === undefined ? 0 : angleOf(subtract(last, before));
  const run = subtract(pointer, last);
  if (length(run) === 0) return null;
  const off = wrapped(angleOf(run) - base);
  const quarter = Math.round(off / (Math.PI / 2)) * (Math.PI / 2);
  return Math.abs(off - quarter) < NEARLY_SQUARE ? direction(base + quarter) : null;
}
