/** The geometries of a room. Core frame, metres. */
import { type BufferGeometry, Shape, ShapeGeometry, Vector2 } from "three";
import type { RoomRecord } from "../net/protocol.gen";
import { Faces } from "./faces";
import { openingPanel, type Panel, type Wall, wallsOf, wallUnder } from "./outline";
import type { Look } from "./palette";
import { addDoorFoot, addSkirting, addWall, addWindowMark, CUT } from "./walls";

/** The doors or windows of each wall, as panels of it. */
export function panelsByWall(walls: readonly Wall[], openings: RoomRecord["doors"]): Panel[][] {
  const panels: Panel[][] = walls.map(() => []);
  for (const opening of openings) {
    const index = wallUnder(walls, opening.start, opening.end);
    const wall = walls[index];
    if (wall) {
      panels[index]?.push(openingPanel(wall, opening));
    }
  }
  return panels;
}

/** What always stays of the walls: their feet, with the gaps of the doors. */
export function lowPart(
  walls: readonly Wall[],
  doors: readonly Panel[][],
  windows: readonly Panel[][],
  look: Look,
): BufferGeometry {
  const faces = new Faces();
  walls.forEach((wall, i) => {
    const gaps = doors[i] ?? [];
    addWall(faces, wall, [0, CUT], gaps, look);
    addSkirting(faces, wall, gaps, look);
    for (const door of gaps) {
      addDoorFoot(faces, wall, door, look);
    }
    for (const window of windows[i] ?? []) {
      addWindowMark(faces, wall, window, look);
    }
  });
  return faces.geometry();
}

/** The floor; its planks run along the longest wall. */
export function floorOf(room: RoomRecord): ShapeGeometry {
  const geometry = new ShapeGeometry(new Shape(room.corners.map(([x, y]) => new Vector2(x, y))));
  const longest = wallsOf(room.corners, 0).reduce((a, b) => (b.length > a.length ? b : a));
  const [cos, sin] = longest.along;
  const uv = geometry.getAttribute("uv");
  const position = geometry.getAttribute("position");
  for (let i = 0; i < uv.count; i++) {
    const [x, y] = [position.getX(i), position.getY(i)];
    uv.setXY(i, x * cos + y * sin, y * cos - x * sin);
  }
  return geometry;
}
