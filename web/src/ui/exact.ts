/** Typed numbers: where an opening is on its wall, where the next wall ends. Core frame, metres. */
import { add, direction, scale } from "../model/geometry";
import type { Point } from "../model/state";
import { onWall, stretchOf, wallsOf } from "../model/walls";
import type { OpeningRecord, RoomRecord } from "../net/protocol.gen";

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
export function withSpan(opening: OpeningRecord, room: RoomRecord, span: Span): OpeningRecord {
  const stretch = stretchOf(room, opening);
  const wall = wallsOf(room).find(({ index }) => index === stretch?.wall);
  if (wall === undefined) return opening;
  return onWall(opening, wall, span.from + span.width / 2, span.width);
}

/** The corner that a wall of that length in that direction ends at. */
export function nextCorner(last: Point, angle: number, metres: number): Point {
  return add(last, scale(direction(angle), metres));
}
