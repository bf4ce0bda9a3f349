/** The sides of a room by the compass of its plan, north up: what "the north wall" means. */
import type { RoomRecord } from "../net/protocol.gen";
import { add, between, dot, scale } from "./geometry";
import type { Point } from "./state";
import { wallsOf } from "./walls";

export interface Side {
  readonly name: "North" | "East" | "South" | "West";
  /** Places on the floor outside of its longest wall, metres; the best one first. */
  readonly places: readonly Point[];
}

const WAYS = [
  ["North", [0, 1]],
  ["East", [1, 0]],
  ["South", [0, -1]],
  ["West", [-1, 0]],
] as const;
const TURNED = Math.SQRT1_2; // cosine: a wall turned further than 45° is of another side
const OUTSIDE = 0.3; // metres
const ALONG = [0.5, 0.25, 0.75, 0.1, 0.9]; // shares of the wall

/** Each side that has a wall, at its longest one. */
export function sidesOf(room: RoomRecord): readonly Side[] {
  const walls = wallsOf(room);
  return WAYS.flatMap(([name, way]) => {
    const [longest] = walls
      .filter(({ inward }) => -dot(inward, way) >= TURNED)
      .toSorted((a, b) => b.length - a.length);
    if (longest === undefined) return [];
    const [start, end] = longest.segment;
    const out = scale(longest.inward, -OUTSIDE);
    return [{ name, places: ALONG.map((share) => add(between(start, end, share), out)) }];
  });
}
