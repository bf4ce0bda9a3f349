/**
 * Boxes snap to walls and to each other while they are dragged.
 *
 * The view asks for this before it dispatches `edit-box` or `drag-ghost`, and draws the guides;
 * `free` (Alt held) lets go of everything.
 */
import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import {
  bottomOf,
  CONTACT,
  floorPoint,
  footprint,
  headingOf,
  movedTo,
  reach,
  topOf,
} from "./footprints";
import {
  add,
  angleOf,
  direction,
  distance,
  dot,
  leftOf,
  nearestOn,
  roundedPoint,
  type Segment,
  scale,
  sides,
  subtract,
  wrapped,
} from "./geometry";
import type { Point } from "./state";
import { type Wall, wallsOf } from "./walls";

/** A box nearer to a wall than this is put against it, metres. */
const WALL_REACH = 0.15;
/** Edges nearer to each other than this are aligned, metres. */
const EDGE_REACH = 0.08;
/** Boxes further apart than this do not align, metres. */
const NEIGHBORHOOD = 3.0;
/** Headings that differ by less from a multiple of a right angle count as square, radians. */
const SQUARE = (2 * Math.PI) / 180;
/** These have no back, so they keep the side that they turn to a wall. */
const BACKLESS: readonly string[] = ["Chair", "Decor", "Other", "Table"];

const RIGHT_ANGLE = Math.PI / 2;

export interface Snapped {
  readonly box: BoxRecord;
  /** Lines on the floor that show what the box was aligned with. */
  readonly guides: readonly Segment[];
}

interface Pull {
  readonly shift: number;
  readonly guide: Segment;
}

/** The box against the walls it is near, else aligned with its neighbors. */
export function snapBox(scene: SceneRecord, box: BoxRecord, free: boolean): Snapped {
  if (free) return { box, guides: [] };
  const walls = wallsOf(scene.room);
  const first = nearest(box, walls);
  if (first === undefined) return alignWith(scene, box, leftAndAhead(box));
  const turned = against({ ...box, heading: headingAt(box, first) }, first);
  const rest = walls.filter((wall) => Math.abs(dot(wall.inward, first.inward)) < 0.5);
  const second = nearest(turned, rest);
  if (second !== undefined) {
    return { box: against(turned, second), guides: [first.segment, second.segment] };
  }
  const aligned = alignWith(scene, turned, [first.along]);
  return { box: aligned.box, guides: [first.segment, ...aligned.guides] };
}

/** A point of a drawn box on the corner, the wall or the edge that it is near to. */
export function snapPoint(scene: SceneRecord, point: Point, free: boolean): Point {
  if (free) return roundedPoint(point);
  const outlines = [scene.room.corners, ...scene.boxes.map((box) => footprint(box))];
  const onCorners = outlines.flat();
  const onSides = outlines.flatMap(sides).map((side) => nearestOn(point, side));
  for (const candidates of [onCorners, onSides]) {
    const [best] = candidates.toSorted((a, b) => distance(a, point) - distance(b, point));
    if (best !== undefined && distance(best, point) <= EDGE_REACH) return roundedPoint(best);
  }
  return roundedPoint(point);
}

/** The heading with the back to the wall, or the nearest square one for what has no back. */
function headingAt(box: BoxRecord, wall: Wall): number {
  const back = angleOf(wall.inward);
  if (!BACKLESS.includes(box.category)) return back;
  const quarters = Math.round(wrapped(headingOf(box) - back) / RIGHT_ANGLE);
  return wrapped(back + quarters * RIGHT_ANGLE);
}

/** How far the box stays off the wall's line, metres; negative beyond it. */
function gapTo(box: BoxRecord, wall: Wall): number {
  const off = dot(subtract(floorPoint(box), wall.segment[0]), wall.inward);
  return off - reach(box, wall.inward);
}

/** The wall that the box is nearest to, of those that it is near enough to and beside. */
function nearest(box: BoxRecord, walls: readonly Wall[]): Wall | undefined {
  return walls
    .map((wall) => ({ wall, gap: gapTo(box, wall) }))
    .filter(({ wall, gap }) => {
      const step = dot(subtract(floorPoint(box), wall.segment[0]), wall.along);
      const beyond = -reach(box, wall.inward); // half of it may be in the wall
      return gap <= WALL_REACH && gap >= beyond && step >= 0 && step <= wall.length;
    })
    .toSorted((a, b) => Math.abs(a.gap) - Math.abs(b.gap))[0]?.wall;
}

function against(box: BoxRecord, wall: Wall): BoxRecord {
  const shift = scale(wall.inward, -gapTo(box, wall));
  return movedTo(box, roundedPoint(add(floorPoint(box), shift)));
}

function leftAndAhead(box: BoxRecord): readonly Point[] {
  const ahead = direction(headingOf(box));
  return [ahead, leftOf(ahead)];
}

/** The box shifted, along each axis by itself, to the nearest line of a neighbor. */
function alignWith(scene: SceneRecord, box: BoxRecord, axes: readonly Point[]): Snapped {
  const others = scene.boxes.filter((other) => other.id !== box.id && isNeighbor(box, other));
  let moved = box;
  const guides: Segment[] = [];
  for (const axis of axes) {
    const pull = others
      .flatMap((other) => pullsOf(moved, other, axis))
      .toSorted((a, b) => Math.abs(a.shift) - Math.abs(b.shift))[0];
    if (pull === undefined) continue;
    moved = movedTo(moved, roundedPoint(add(floorPoint(moved), scale(axis, pull.shift))));
    guides.push(pull.guide);
  }
  return { box: moved, guides };
}

function isNeighbor(box: BoxRecord, other: BoxRecord): boolean {
  const apart = subtract(floorPoint(other), floorPoint(box));
  const turn = wrapped(headingOf(other) - headingOf(box));
  const square = Math.abs(turn - Math.round(turn / RIGHT_ANGLE) * RIGHT_ANGLE) < SQUARE;
  return square && Math.hypot(...apart) < NEIGHBORHOOD;
}

/** Edges that may touch (side by side only), edges and middles that may be in line. */
function pullsOf(box: BoxRecord, other: BoxRecord, axis: Point): readonly Pull[] {
  const apart = subtract(floorPoint(other), floorPoint(box));
  const across = leftOf(axis);
  const step = dot(apart, axis);
  const mine = reach(box, axis);
  const theirs = reach(other, axis);
  const beside = Math.abs(dot(apart, across)) < reach(box, across) + reach(other, across) - CONTACT;
  const level = bottomOf(box) < topOf(other) && bottomOf(other) < topOf(box);
  const touching = beside && level ? [step - theirs - mine, step + theirs + mine] : [];
  const inLine = [step, step - theirs + mine, step + theirs - mine];
  return [...touching, ...inLine]
    .filter((shift) => Math.abs(shift) <= EDGE_REACH)
    .map((shift) => ({ shift, guide: guideAt(box, other, axis, shift) }));
}

/** The line that the two have in common after the shift: a middle or an edge of the other. */
function guideAt(box: BoxRecord, other: BoxRecord, axis: Point, shift: number): Segment {
  const across = leftOf(axis);
  const step = dot(subtract(floorPoint(other), floorPoint(box)), axis) - shift;
  const theirs = reach(other, axis);
  const candidates = [0, theirs, -theirs];
  const line = candidates.find((edge) =>
    [0, 1, -1].some((side) => Math.abs(step + edge - side * reach(box, axis)) < 1e-6),
  );
  const onLine = add(floorPoint(other), scale(axis, line ?? 0));
  const ends = [floorPoint(box), floorPoint(other)].flatMap((center, i) => {
    const at = dot(subtract(center, onLine), across);
    const half = reach(i === 0 ? box : other, across);
    return [at - half, at + half];
  });
  const place = (at: number): Point => add(onLine, scale(across, at));
  return [place(Math.min(...ends)), place(Math.max(...ends))];
}
