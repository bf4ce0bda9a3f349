/** The sides of a room by the compass of its plan, north up: what "the north wall" means. */
import type { RoomRecord } from "../net/protocol.gen";
import { compass } from "./compass";
import { add, angleOf, between, scale } from "./geometry";
import type { Point } from "./state";
import { type Wall, wallsOf } from "./walls";

export interface Side {
  /** As "north-east". */
  readonly name: string;
  /** Places on the floor outside of its longest wall, metres; the best one first. */
  readonly places: readonly Point[];
}

const OUTSIDE = 0.3; // metres
const ALONG = [0.5, 0.25, 0.75, 0.1, 0.9]; // shares of the wall

/** Each side that has a wall, at its longest one. */
export function sidesOf(room: RoomRecord): readonly Side[] {
  const longest = new Map<string, Wall>();
  for (const wall of wallsOf(room).toSorted((a, b) => a.length - b.length)) {
    longest.set(sideOf(wall), wall);
  }
  return [...longest].map(
    ([
      name,
      {
        segment: [start, end],
        inward,
      },
    ]) => {
      const out = scale(inward, -OUTSIDE);
      return { name, places: ALONG.map((share) => add(between(start, end, share), out)) };
    },
  );
}

/** The side of the room that a wall closes: "north". */
export function sideOf(wall: Wall): string {
  return compass(angleOf(scale(wall.inward, -1)));
}
