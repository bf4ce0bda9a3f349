/** Where a thing stands, in words: for the list of objects and for what is said aloud. */
import { compass } from "../model/compass";
import { footprint } from "../model/footprints";
import { between, distance, nearestOn, sides, signedArea } from "../model/geometry";
import { sideOf } from "../model/sides";
import type { Point } from "../model/state";
import { formatArea, formatLength, formatSize } from "../model/units";
import { nearestWall, type Wall, wallsOf } from "../model/walls";
import type { BoxRecord, OpeningRecord, RoomRecord, SceneRecord } from "../net/protocol.gen";
import { counted, ended, inSentence } from "./words";

/** Closer than this to a wall is against it, metres. */
const AGAINST = 0.15;

/** "Sofa, 0.90 × 2.1 × 0.80 m, against the north wall, facing south". */
export function boxInWords(box: BoxRecord, room: RoomRecord): string {
  const name = box.label || box.category;
  const facing = box.front_known === false ? "" : `, facing ${compass(box.heading ?? 0)}`;
  return `${name}, ${formatSize(box.size)}, ${nearestWallInWords(box, room)}${facing}`;
}

/** "Living room, 24.0 m², 7 pieces, 2 doors". */
export function sceneInWords({ name, room, boxes }: SceneRecord): string {
  const parts = [name || "Room", formatArea(Math.abs(signedArea(room.corners)))];
  parts.push(boxes.length === 0 ? "empty" : counted(boxes.length, "piece"));
  if (room.doors.length > 0) parts.push(counted(room.doors.length, "door"));
  if (room.windows.length > 0) parts.push(counted(room.windows.length, "window"));
  return parts.join(", ");
}

/** "against the north wall" or "0.40 m from the north wall". */
export function nearestWallInWords(box: BoxRecord, room: RoomRecord): string {
  const walls = wallsOf(room).map((wall) => ({ wall, gap: gapToWall(box, wall) }));
  const nearest = walls.toSorted((a, b) => a.gap - b.gap)[0];
  if (nearest === undefined) return "in no room yet";
  const name = `the ${sideOf(nearest.wall)} wall`;
  return nearest.gap <= AGAINST ? `against ${name}` : `${formatLength(nearest.gap)} from ${name}`;
}

/** "0.90 m wide, in the south wall". */
export function openingInWords(opening: OpeningRecord, room: RoomRecord): string {
  const width = formatLength(distance(opening.start, opening.end));
  const wall = nearestWall(room, between(opening.start, opening.end, 0.5));
  return wall === undefined ? `${width} wide` : `${width} wide, in the ${sideOf(wall)} wall`;
}

/** "Sofa placed: against the north wall, facing the TV." */
export function placedInWords(box: BoxRecord, room: RoomRecord, sentence: string): string {
  const where = ended(sentence || nearestWallInWords(box, room));
  const first = where.split(/[\s,]/, 1)[0] ?? "";
  return `${box.category} placed: ${inSentence(first)}${where.slice(first.length)}`;
}

/** Metres between the footprint and the wall. */
function gapToWall(box: BoxRecord, wall: Wall): number {
  const outline = footprint(box);
  const fromCorners = outline.map((corner) => distance(corner, nearestOn(corner, wall.segment)));
  const fromEnds = wall.segment.flatMap((end: Point) =>
    sides(outline).map((side) => distance(end, nearestOn(end, side))),
  );
  return Math.min(...fromCorners, ...fromEnds);
}
