/** Where the room's frame lies in the frame of the device, and how two corners tell. Pure. */
import { toPage } from "../model/frames";
import {
  add,
  angleOf,
  between,
  cross,
  distance,
  type Segment,
  scale,
  subtract,
  wrapped,
} from "../model/geometry";
import type { Point, Vector3 } from "../model/state";
import { wallsOf } from "../model/walls";
import type { RoomRecord } from "../net/protocol.gen";

export interface Alignment {
  /** The room's origin in the device's frame: metres, y up. */
  readonly at: Vector3;
  /** How far the room is turned about the upright axis, radians. */
  readonly turn: number;
}

/** A place and a turn within the room's frame. */
export interface Move {
  readonly at: Point;
  readonly turn: number;
}

/** The alignment of a frame whose origin and x axis are given in the frame aligned so far. */
export function moved({ at, turn }: Alignment, move: Move): Alignment {
  const [x, y, z] = toPage([...rotated(move.at, turn), 0]);
  return { at: [at[0] + x, at[1] + y, at[2] + z], turn: wrapped(turn + move.turn) };
}

/** The frame in which a drawn wall has its first end at the origin and runs along x. */
export function alongWall([start, end]: Segment): Move {
  return { at: start, turn: angleOf(subtract(end, start)) };
}

/**
 * The ways in which a drawn room fits two neighboring corners of the real one, best first: by how
 * little the length of the wall between them differs. The eye is inside.
 */
export function fits(room: RoomRecord, eye: Point, one: Point, other: Point): readonly Move[] {
  const inside = cross(subtract(other, one), subtract(eye, one)) > 0;
  const [start, end] = inside ? [one, other] : [other, one];
  const metres = distance(start, end);
  return wallsOf(room)
    .toSorted((a, b) => Math.abs(a.length - metres) - Math.abs(b.length - metres))
    .map(({ segment }) => {
      const turn = angleOf(subtract(end, start)) - angleOf(subtract(segment[1], segment[0]));
      const drawn = rotated(between(segment[0], segment[1], 0.5), turn);
      return { at: subtract(between(start, end, 0.5), drawn), turn: wrapped(turn) };
    });
}

/** The same move as seen from the frame to which another one leads. */
export function relativeTo(other: Move, { at, turn }: Move): Move {
  return {
    at: rotated(subtract(at, other.at), -other.turn),
    turn: wrapped(turn - other.turn),
  };
}

function rotated(point: Point, turn: number): Point {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return add(scale([cos, sin], point[0]), scale([-sin, cos], point[1]));
}
