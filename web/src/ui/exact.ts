/** Things put into the room by a key or a button, without a pointer. Core frame, metres. */

import { add, along, direction, scale } from "../model/geometry";
import type { Point } from "../model/state";
import { nearestWall, onWall, stretchOf, wallsOf } from "../model/walls";
import type { BoxRecord, OpeningRecord, RoomRecord } from "../net/protocol.gen";

/** The box that a key puts into the room, before it is given its size. */
const NEW_BOX = [1, 1, 0.75] as const; // metres
const NEW_DOOR = { width: 0.9, bottom: 0, top: 2.0 }; // metres; a usual inner door
const NEW_WINDOW = { width: 1.2, bottom: 0.9, top: 2.1 }; // metres

/** A box of one by one metre on the floor. */
export function newBox(id: string, at: Point): BoxRecord {
  return { id, category: "Other", center: [at[0], at[1], NEW_BOX[2] / 2], size: NEW_BOX };
}

/** A door or window in the wall nearest to the point; null where there is no wall. */
export function newOpening(
  kind: "door" | "window",
  id: string,
  at: Point,
  room: RoomRecord,
): OpeningRecord | null {
  const wall = nearestWall(room, at);
  if (wall === undefined) return null;
  const { width, bottom, top } = kind === "door" ? NEW_DOOR : NEW_WINDOW;
  const opening = { id, start: at, end: at, bottom, top: Math.min(top, room.height) };
  return onWall(opening, wall, along(at, wall.segment) * wall.length, width);
}

/** How far an opening starts from the first corner of its wall, and how wide it is, metres. */
export interface Span {
  readonly from: number;
  readonly width: number;
}

export function spanOf(opening: OpeningRecord, room: RoomRecord): Span {
  const stretch = stretchOf(room, opening);
  if (stretch === undefined) return { from: 0, width: 0 };
  return { from: stretch.middle - stretch.width / 2, width: stretch.width };
}

/** The opening with another span on its wall; it is kept on the wall. */
export function withSpan(
  opening: OpeningRecord,
  room: RoomRecord,
  { from, width }: Span,
): OpeningRecord {
  const stretch = stretchOf(room, opening);
  const wall = wallsOf(room).find(({ index }) => index === stretch?.wall);
  return wall === undefined ? opening : onWall(opening, wall, from + width / 2, width);
}

/** The corner that a wall of that length in that direction ends at. */
export function nextCorner(last: Point, angle: number, metres: number): Point {
  return add(last, scale(direction(angle), metres));
}
