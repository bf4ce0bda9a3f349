/** Where on a heat map something lies, and where its cells lie in the room. Pure; metres. */
import { footprint, topOf } from "../model/footprints";
import type { HeatMap, Point, Vector3 } from "../model/state";
import type { BoxRecord, RoomRecord } from "../net/protocol.gen";
import { along, onWall, type Wall, wallsOf } from "./outline";

/** A patch of a heat map in the room: places in the core frame, and their texture coordinates. */
export interface Patch {
  readonly corners: readonly Vector3[];
  readonly uvs: readonly Point[];
}

const ABOVE_FLOOR = 0.008; // metres; clear of the floor and of the contact shadows
const OFF_WALL = 0.006;
const ABOVE_TOP = 0.006;

/**
 * The texture coordinates of a place: u along the columns, v along the rows. Row 0 is the first
 * in memory and so lies at v = 0; no flip. For walls, `x` runs along the outline and `y` upwards.
 */
export function uvOf(map: HeatMap, [x, y]: Point): Point {
  return [
    (x - map.origin[0]) / (map.cell * map.columns),
    (y - map.origin[1]) / (map.cell * map.rows),
  ];
}

/** The value of the cell at a place; 0 outside of the map. */
export function valueAt(map: HeatMap, at: Point): number {
  const [u, v] = uvOf(map, at);
  const column = Math.floor(u * map.columns);
  const row = Math.floor(v * map.rows);
  if (column < 0 || column >= map.columns || row < 0 || row >= map.rows) {
    return 0;
  }
  return map.values[row * map.columns + column] ?? 0;
}

/** 0 to 1 from unlikely to likely; null where nobody can stand. */
export function likelihoodOf(value: number): number | null {
  return value === 0 ? null : (value - 1) / 254;
}

/** Where the likeliest cell is, in the map's own plane. */
export function brightest(map: HeatMap): Point {
  const best = map.values.reduce((at, value, i) => (value > (map.values[at] ?? 0) ? i : at), 0);
  const column = best % map.columns;
  const row = Math.floor(best / map.columns);
  return [map.origin[0] + (column + 0.5) * map.cell, map.origin[1] + (row + 0.5) * map.cell];
}

/** What a map covers: the floor, the inner sides of the walls, or the tops of the boxes. */
export function patchesOf(
  map: HeatMap,
  room: RoomRecord,
  boxes: readonly BoxRecord[],
): readonly Patch[] {
  switch (map.surface) {
    case "floor":
      return [flatPatch(map, room.corners, ABOVE_FLOOR)];
    case "tops":
      return boxes.map((box) => flatPatch(map, footprint(box), topOf(box) + ABOVE_TOP));
    case "walls":
      return wallsOf(room.corners, 0).map((wall) => wallPatch(map, wall, room.height));
  }
}

function flatPatch(map: HeatMap, outline: readonly Point[], height: number): Patch {
  return {
    corners: outline.map(([x, y]): Vector3 => [x, y, height]),
    uvs: outline.map((point) => uvOf(map, point)),
  };
}

/** Anticlockwise as seen from the room, from the wall's lower end corner on. */
function wallPatch(map: HeatMap, wall: Wall, height: number): Patch {
  const places: readonly Point[] = [
    [wall.length, 0],
    [0, 0],
    [0, height],
    [wall.length, height],
  ];
  return {
    corners: places.map(([s, z]) => onWall(wall, s, -OFF_WALL, z)),
    uvs: places.map(([s, z]) => uvOf(map, [wall.offset + s, z])),
  };
}

/** A place in the room as a place in the plane of a map: the plan, or the unrolled walls. */
export function placeOnMap(map: HeatMap, room: RoomRecord, at: Vector3, wall: number): Point {
  if (map.surface !== "walls") {
    return [at[0], at[1]];
  }
  const hit = wallsOf(room.corners, 0)[wall];
  return hit ? [hit.offset + along(hit, [at[0], at[1]]), at[2]] : [0, 0];
}
