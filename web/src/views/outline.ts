/** The outline of a room as walls with a thickness. Pure; core frame, metres. */
import { signedArea } from "../model/geometry";
import type { Point } from "../model/state";
import type { OpeningRecord } from "../net/protocol.gen";

/** One wall, from corner i to i + 1, with its own axes. */
export interface Wall {
  readonly start: Point;
  readonly length: number;
  /** Unit vector from the start to the end. */
  readonly along: Point;
  /** Unit vector out of the room. */
  readonly outward: Point;
  /** Where the wall begins on the unrolled outline. */
  readonly offset: number;
  /** How far the outer face reaches beyond the inner one, at the start and at the end. */
  readonly overhang: readonly [number, number];
}

/** A rectangle on a wall: along it and above the floor. */
export interface Panel {
  readonly from: number;
  readonly to: number;
  readonly bottom: number;
  readonly top: number;
}

const MAX_MITER = 2.5; // thicknesses; sharper corners are cut off there
const TOUCHES = 1e-4; // metres

/** The middle of the bounding rectangle of the corners. */
export function middleOf(corners: readonly Point[]): Point {
  const [low, high] = boundsOf(corners);
  return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
}

/** The bounding rectangle of the corners. */
export function boundsOf(corners: readonly Point[]): readonly [Point, Point] {
  const xs = corners.map((corner) => corner[0]);
  const ys = corners.map((corner) => corner[1]);
  return [
    [Math.min(...xs), Math.min(...ys)],
    [Math.max(...xs), Math.max(...ys)],
  ];
}

/** The walls of an outline, anticlockwise as the server has them, mitered for a thickness. */
export function wallsOf(corners: readonly Point[], thickness: number): readonly Wall[] {
  const ring = signedArea(corners) >= 0 ? corners : [...corners].reverse();
  let offset = 0;
  const bare = ring.map((start, i) => {
    const end = ring[(i + 1) % ring.length] ?? start;
    const length = Math.hypot(end[0] - start[0], end[1] - start[1]) || TOUCHES;
    const along: Point = [(end[0] - start[0]) / length, (end[1] - start[1]) / length];
    const outward: Point = [along[1], -along[0]];
    const wall = { start, length, along, outward, offset };
    offset += length;
    return wall;
  });
  return bare.map((wall, i) => {
    const before = bare[(i + bare.length - 1) % bare.length] ?? wall;
    const after = bare[(i + 1) % bare.length] ?? wall;
    return {
      ...wall,
      overhang: [
        thickness * miter(before.along, wall.along),
        thickness * miter(wall.along, after.along),
      ],
    };
  });
}

/** Tangent of half the turn between two directions: what a miter adds, in thicknesses. */
function miter(a: Point, b: Point): number {
  const sin = a[0] * b[1] - a[1] * b[0];
  const cos = a[0] * b[0] + a[1] * b[1];
  const tangent = sin / Math.max(1 + cos, 1e-6);
  return Math.max(-MAX_MITER, Math.min(MAX_MITER, tangent));
}

/** A point on a wall: metres along it, out of the room, and above the floor. */
export function onWall(
  wall: Wall,
  along: number,
  outward: number,
  up: number,
): [number, number, number] {
  return [
    wall.start[0] + wall.along[0] * along + wall.outward[0] * outward,
    wall.start[1] + wall.along[1] * along + wall.outward[1] * outward,
    up,
  ];
}

/** Which wall a segment lies on: the one nearest to its middle. */
export function wallUnder(walls: readonly Wall[], start: Point, end: Point): number {
  const middle: Point = [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2];
  let best = 0;
  let least = Number.POSITIVE_INFINITY;
  walls.forEach((wall, i) => {
    const s = Math.max(0, Math.min(wall.length, along(wall, middle)));
    const [x, y] = onWall(wall, s, 0, 0);
    const gap = Math.hypot(x - middle[0], y - middle[1]);
    if (gap < least) {
      least = gap;
      best = i;
    }
  });
  return best;
}

/** An opening as a panel of its wall, cut off where the wall ends. */
export function openingPanel(wall: Wall, opening: OpeningRecord): Panel {
  const a = along(wall, opening.start);
  const b = along(wall, opening.end);
  const clip = (s: number) => Math.max(0, Math.min(wall.length, s));
  return {
    from: clip(Math.min(a, b)),
    to: clip(Math.max(a, b)),
    bottom: opening.bottom,
    top: opening.top,
  };
}

/** What is left of a panel when the holes are cut out, as upright rectangles. */
export function cutOut(panel: Panel, holes: readonly Panel[]): readonly Panel[] {
  const edges = [panel.from, panel.to, ...holes.flatMap((hole) => [hole.from, hole.to])]
    .filter((s) => s >= panel.from && s <= panel.to)
    .sort((a, b) => a - b);
  const pieces: Panel[] = [];
  for (let i = 0; i + 1 < edges.length; i++) {
    const [from, to] = [edges[i] ?? 0, edges[i + 1] ?? 0];
    if (to - from > TOUCHES) {
      pieces.push(...column(from, to, panel, holes));
    }
  }
  return pieces;
}

function column(from: number, to: number, panel: Panel, holes: readonly Panel[]): Panel[] {
  const middle = (from + to) / 2;
  const pieces: Panel[] = [];
  let bottom = panel.bottom;
  const above = holes
    .filter((hole) => hole.from < middle && hole.to > middle)
    .sort((a, b) => a.bottom - b.bottom);
  for (const hole of above) {
    const top = Math.min(hole.bottom, panel.top);
    if (top - bottom > TOUCHES) {
      pieces.push({ from, to, bottom, top });
    }
    bottom = Math.max(bottom, hole.top);
  }
  if (panel.top - bottom > TOUCHES) {
    pieces.push({ from, to, bottom, top: panel.top });
  }
  return pieces;
}

/** How far along a wall a point lies, metres from its start. */
export function along(wall: Wall, [x, y]: Point): number {
  return (x - wall.start[0]) * wall.along[0] + (y - wall.start[1]) * wall.along[1];
}
