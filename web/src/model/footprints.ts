/** Boxes as seen from above, and what they run into: core frame, metres. */
import type { BoxRecord, RoomRecord } from "../net/protocol.gen";
import {
  add,
  crosses,
  direction,
  dot,
  isInside,
  leftOf,
  type Segment,
  scale,
  sides,
  subtract,
} from "./geometry";
import type { Point } from "./state";

/** Overlaps up to this are contact, metres: measuring a room is no more exact. */
export const CONTACT = 0.02;
/** Things no thicker than this are in nobody's way (rugs), metres. */
export const FLAT = 0.05;

/** Rounding decides nothing, metres. */
const DUST = 1e-9;

export const headingOf = (box: Footprint): number => box.heading ?? 0;
export const bottomOf = (box: BoxRecord): number => box.center[2] - box.size[2] / 2;
export const topOf = (box: BoxRecord): number => box.center[2] + box.size[2] / 2;
export const floorPoint = (box: Footprint): Point => [box.center[0], box.center[1]];

/** The box with its center above another point of the floor. */
export function movedTo(box: BoxRecord, [x, y]: Point): BoxRecord {
  return { ...box, center: [x, y, box.center[2]] };
}

/** What a box takes up of the floor. */
export type Footprint = Pick<BoxRecord, "center" | "size" | "heading">;

/** The four corners anticlockwise from front right; `shrink` takes that off every side. */
export function footprint(box: BoxRecord, shrink = 0): readonly Point[] {
  const ahead = direction(headingOf(box));
  const depth = scale(ahead, Math.max(0, box.size[0] / 2 - shrink));
  const width = scale(leftOf(ahead), Math.max(0, box.size[1] / 2 - shrink));
  const center = floorPoint(box);
  const front = add(center, depth);
  const back = subtract(center, depth);
  return [subtract(front, width), add(front, width), add(back, width), subtract(back, width)];
}

/** Whether a point lies over the footprint, or no further beyond it than that many metres. */
export function isOver(box: Footprint, point: Point, beyond = 0): boolean {
  const ahead = direction(headingOf(box));
  const from = subtract(point, floorPoint(box));
  const within = (axis: Point, side: number): boolean =>
    Math.abs(dot(from, axis)) <= side / 2 + beyond + DUST;
  return within(ahead, box.size[0]) && within(leftOf(ahead), box.size[1]);
}

/** How far the footprint reaches from its center in a direction (a unit vector), metres. */
export function reach(box: Footprint, toward: Point): number {
  const ahead = direction(headingOf(box));
  const depth = Math.abs(dot(ahead, toward)) * box.size[0];
  const width = Math.abs(dot(leftOf(ahead), toward)) * box.size[1];
  return (depth + width) / 2;
}

/** Whether the box stands within the walls; touching them is within. */
export function standsInside(box: BoxRecord, room: RoomRecord): boolean {
  const outline = footprint(box, CONTACT);
  const walls = sides(room.corners);
  const cut = (side: Segment): boolean => walls.some((wall) => crosses(side, wall));
  return outline.every((point) => isInside(point, room.corners)) && !sides(outline).some(cut);
}

/** Whether two boxes take up the same space, beyond contact or that many metres. */
export function overlap(box: BoxRecord, other: BoxRecord, beyond = CONTACT): boolean {
  const shared = Math.min(topOf(box), topOf(other)) - Math.max(bottomOf(box), bottomOf(other));
  if (shared <= FLAT) return false;
  return overlapFromAbove(box, other, beyond);
}

/** Whether two footprints share floor, beyond contact or that many metres (separating axes). */
export function overlapFromAbove(box: Footprint, other: Footprint, beyond = CONTACT): boolean {
  const between = subtract(floorPoint(other), floorPoint(box));
  const axes = [box, other].flatMap((one) => {
    const ahead = direction(headingOf(one));
    return [ahead, leftOf(ahead)];
  });
  return axes.every((axis) => {
    const gap = Math.abs(dot(between, axis)) - reach(box, axis) - reach(other, axis);
    return gap < -beyond;
  });
}
