/**
 * What keeps a thing from standing where it is: the rules of scenegen_core/placement/feasible.py
 * as far as the page can tell by itself, so that it is honest without the server too.
 */
import type {
  BoxRecord,
  Comfort,
  OpeningRecord,
  RoomRecord,
  SceneRecord,
} from "../net/protocol.gen";
import {
  bottomOf,
  CONTACT,
  FLAT,
  type Footprint,
  overlap,
  overlapFromAbove,
  standsInside,
  topOf,
} from "./footprints";
import { add, angleOf, between, distance, scale } from "./geometry";
import { nameOf } from "./labels";
import { restsOnSomething } from "./resting";
import { nearestWall } from "./walls";

/** Ceilings are measured no more exactly than this, metres; RESTS of scenegen_core. */
const CEILING = 0.05;
/** A door's own square stays free, at most this deep, metres; DOOR_DEPTH of scenegen_core. */
const DOOR_DEPTH = 1.5;
/** Before a window this stays free of what is taller than its sill, metres; WINDOW_DEPTH. */
const WINDOW_DEPTH = 0.5;
/** Sills are measured no more exactly than this, metres; LAYER of scenegen_core. */
const SILL = 0.01;
/** A chair goes this far under a table, all but its back, metres; TUCK of scenegen_core. */
const TUCK = 0.45;
/** Under lower things, as coffee tables, no seat goes, metres; SEAT_ROOM. */
const SEAT_ROOM = 0.6;

export type Obstacle =
  | { readonly kind: "wall" | "ceiling" | "hold" | "door" | "window" }
  | { readonly kind: "box"; readonly box: BoxRecord };

/**
 * The first thing in the way of a box, its own former self excepted; null if nothing is. Rules that
 * are `relaxed` do not count.
 */
export function obstacleOf(
  scene: SceneRecord,
  box: BoxRecord,
  relaxed: readonly Comfort[] = [],
): Obstacle | null {
  const { room } = scene;
  if (!standsInside(box, room)) return { kind: "wall" };
  if (topOf(box) > room.height + CEILING) return { kind: "ceiling" };
  if (!restsOnSomething(scene, box)) return { kind: "hold" };
  const hit = scene.boxes.find((other) => other.id !== box.id && collide(box, other));
  if (hit !== undefined) return { kind: "box", box: hit };
  if (blocksDoor(room, box)) return { kind: "door" };
  return !relaxed.includes("window") && coversWindow(room, box) ? { kind: "window" } : null;
}

/** The obstacle as a sentence. */
export function obstacleSentence(obstacle: Obstacle): string {
  switch (obstacle.kind) {
    case "wall":
      return "It would stick through a wall or out of the room.";
    case "ceiling":
      return "It is too tall for this room.";
    case "hold":
      return "It has to hang on a wall, or stand on something that can carry it.";
    case "door":
      return "It would stand in the way of a door.";
    case "window":
      return "It would cover a window.";
    case "box":
      return `It would stand in ${nameOf(obstacle.box)}.`;
  }
}

function collide(box: BoxRecord, other: BoxRecord): boolean {
  const tucks = goesUnder(box, other) || goesUnder(other, box);
  return overlap(box, other, tucks ? TUCK : CONTACT);
}

function goesUnder(box: BoxRecord, other: BoxRecord): boolean {
  return box.category === "Chair" && other.category === "Table" && topOf(other) >= SEAT_ROOM;
}

function blocksDoor(room: RoomRecord, box: BoxRecord): boolean {
  if (box.size[2] <= FLAT) return false;
  return room.doors.some((door) => {
    const depth = Math.min(distance(door.start, door.end), DOOR_DEPTH);
    return bottomOf(box) < door.top && reachesInto(room, door, depth, box);
  });
}

function coversWindow(room: RoomRecord, box: BoxRecord): boolean {
  return room.windows.some((opening) => {
    const across = topOf(box) > opening.bottom + SILL && bottomOf(box) < opening.top;
    return across && reachesInto(room, opening, WINDOW_DEPTH, box);
  });
}

/** Whether a box reaches into the floor before a door or window, on the inner side. */
function reachesInto(
  room: RoomRecord,
  opening: OpeningRecord,
  depth: number,
  box: BoxRecord,
): boolean {
  const middle = between(opening.start, opening.end, 0.5);
  const wall = nearestWall(room, middle);
  if (wall === undefined) return false;
  const [x, y] = add(middle, scale(wall.inward, depth / 2));
  const clear: Footprint = {
    center: [x, y, 0],
    size: [depth, distance(opening.start, opening.end), 0],
    heading: angleOf(wall.inward),
  };
  return overlapFromAbove(box, clear);
}
