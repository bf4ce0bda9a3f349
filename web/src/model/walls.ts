/** The walls of a room, and what hangs on to them. Wall i joins corner i to i+1, inside is left. */
import type { OpeningRecord, RoomRecord } from "../net/protocol.gen";
import {
  add,
  along,
  angleOf,
  between,
  distance,
  leftOf,
  length,
  nearestOn,
  roundedPoint,
  type Segment,
  scale,
  sides,
  subtract,
} from "./geometry";
import type { Point } from "./state";

export interface Wall {
  readonly index: number;
  readonly segment: Segment;
  readonly length: number;
  /** Unit vector from its start to its end. */
  readonly along: Point;
  /** Unit vector into the room. */
  readonly inward: Point;
}

/** Where something is along a wall: both in metres from the wall's start. */
export interface Stretch {
  readonly wall: number;
  readonly middle: number;
  readonly width: number;
}

/** The walls in order, those of no length left out. */
export function wallsOf(room: RoomRecord): readonly Wall[] {
  return sides(room.corners).flatMap((segment, index) => {
    const run = subtract(segment[1], segment[0]);
    const metres = length(run);
    if (metres === 0) return [];
    const unit = scale(run, 1 / metres);
    return [{ index, segment, length: metres, along: unit, inward: leftOf(unit) }];
  });
}

/** The wall nearest to a point. */
export function nearestWall(room: RoomRecord, point: Point): Wall | undefined {
  const gap = (wall: Wall): number => distance(point, nearestOn(point, wall.segment));
  return wallsOf(room).toSorted((a, b) => gap(a) - gap(b))[0];
}

/** The heading of something whose back is to the wall nearest to a point, radians. */
export function headingFromWall(room: RoomRecord, point: Point): number {
  const wall = nearestWall(room, point);
  return wall === undefined ? 0 : angleOf(wall.inward);
}

/** Which stretch of which wall a door or window takes up. */
export function stretchOf(room: RoomRecord, opening: OpeningRecord): Stretch | undefined {
  const middle = between(opening.start, opening.end, 0.5);
  const wall = nearestWall(room, middle);
  if (wall === undefined) return undefined;
  return {
    wall: wall.index,
    middle: along(middle, wall.segment) * wall.length,
    width: distance(opening.start, opening.end),
  };
}

/** The door or window on that stretch, shortened and shifted so that it fits on the wall. */
export function onWall(opening: OpeningRecord, wall: Wall, middle: number, width: number) {
  const half = Math.min(width, wall.length) / 2;
  const at = Math.min(wall.length - half, Math.max(half, middle));
  const place = (metres: number): Point =>
    roundedPoint(add(wall.segment[0], scale(wall.along, metres)));
  return { ...opening, start: place(at - half), end: place(at + half) };
}

/** The door or window moved onto the wall nearest to its middle. */
export function snappedToWall(room: RoomRecord, opening: OpeningRecord): OpeningRecord {
  const stretch = stretchOf(room, opening);
  const wall = wallsOf(room).find(({ index }) => index === stretch?.wall);
  if (stretch === undefined || wall === undefined) return opening;
  return onWall(opening, wall, stretch.middle, stretch.width);
}

/**
 * The room with other corners, as many as before: doors and windows stay on their walls, as far
 * along in proportion as they were.
 */
export function withCorners(room: RoomRecord, corners: readonly Point[]): RoomRecord {
  const before = wallsOf(room);
  const moved = { ...room, corners };
  const after = wallsOf(moved);
  const follow = (opening: OpeningRecord): OpeningRecord => {
    const stretch = stretchOf(room, opening);
    const old = before.find(({ index }) => index === stretch?.wall);
    const wall = after.find(({ index }) => index === stretch?.wall);
    if (stretch === undefined || old === undefined || wall === undefined) return opening;
    if (old.segment[0] === wall.segment[0] && old.segment[1] === wall.segment[1]) return opening;
    return onWall(opening, wall, (stretch.middle / old.length) * wall.length, stretch.width);
  };
  return { ...moved, doors: room.doors.map(follow), windows: room.windows.map(follow) };
}

/** The room with wall `index` made `metres` long: its end, and what is beyond, moves along it. */
export function withWallLength(room: RoomRecord, index: number, metres: number): RoomRecord {
  const wall = wallsOf(room).find((candidate) => candidate.index === index);
  if (wall === undefined) return room;
  const shift = scale(wall.along, metres - wall.length);
  const end = (index + 1) % room.corners.length;
  const next = (index + 2) % room.corners.length;
  const corners = room.corners.map((corner, i) =>
    i === end || i === next ? roundedPoint(add(corner, shift)) : corner,
  );
  return withCorners(room, corners);
}
