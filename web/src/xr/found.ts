/** The room that the device itself knows, from its planes and meshes with labels. Pure; core frame. */

import { footprint } from "../model/footprints";
import {
  angleOf,
  cross,
  direction,
  dot,
  isInside,
  leftOf,
  rounded,
  roundedPoint,
  scale,
  subtract,
  wrapped,
} from "../model/geometry";
import { outlineProblem } from "../model/outlines";
import type { OpeningKind } from "../model/scenes";
import type { Found, Point, Vector3 } from "../model/state";
import { headingFromWall, nearestWall, onWall } from "../model/walls";
import type { BoxRecord, OpeningRecord, RoomRecord } from "../net/protocol.gen";

/** A plane or a mesh: its label in the WebXR registry of semantic labels, and its points. */
export interface Piece {
  readonly label: string;
  readonly points: readonly Vector3[];
  readonly flat: boolean;
}

/** What a label of the registry is here; it has none for chairs. Others are no furniture. */
const CATEGORIES: Readonly<Record<string, string>> = {
  bed: "Bed",
  couch: "Sofa",
  desk: "Table",
  lamp: "Decor",
  other: "Other",
  plant: "Decor",
  screen: "TV",
  shelf: "Storage",
  storage: "Storage",
  table: "Table",
  "wall art": "Picture",
};
const NO_WALLS = { corners: null, doors: [], windows: [] } as const;
const NARROW = 0.2; // metres; what is narrower is no door and no window
const THIN = 0.04; // metres; the least side of a thing
const STANDS = 0.15; // metres over the floor below which a thing stands on it
const UPRIGHT = 0.2; // metres; a flat piece of a greater extent upward is no table top

/** What the pieces say of the room; `room` is the one drawn so far. Null if it is nothing. */
export function foundIn(pieces: readonly Piece[], room: RoomRecord): Found | null {
  const corners = outlineOf(pieces);
  const walls = corners === null ? room : { ...room, corners };
  const solid = boxesOf(
    pieces.filter(({ flat }) => !flat),
    walls,
  );
  // A table top of a table that is known as a whole is not another table.
  const flat = boxesOf(
    pieces.filter(({ flat }) => flat),
    walls,
  ).filter((one) => !solid.some((other) => isPartOf(one, other)));
  const boxes = [...solid, ...flat].map((box, i) => ({ ...box, id: `box-${i + 1}` }));
  if (corners === null) return boxes.length === 0 ? null : { ...NO_WALLS, boxes };
  const doors = openingsOf(pieces, "door", walls);
  return { corners, doors, windows: openingsOf(pieces, "window", walls), boxes };
}

/** Doors or windows where flat pieces of that name are nearest to a wall. */
function openingsOf(
  pieces: readonly Piece[],
  label: OpeningKind,
  room: RoomRecord,
): readonly OpeningRecord[] {
  const named = pieces.filter((piece) => piece.flat && piece.label === label);
  return named.flatMap(({ points }, i) => {
    const wall = nearestWall(room, middleOf(points));
    if (wall === undefined) return [];
    const places = points.map(([x, y]) => dot(subtract([x, y], wall.segment[0]), wall.along));
    const [from, to] = [Math.min(...places), Math.max(...places)];
    const heights = points.map(([, , z]) => z);
    const lowest = Math.min(...heights);
    const opening = {
      id: `${label}-${i + 1}`,
      start: wall.segment[0],
      end: wall.segment[1],
      bottom: lowest < STANDS ? 0 : rounded(lowest),
      top: rounded(Math.max(...heights)),
    };
    const fits = to - from >= NARROW && opening.top > opening.bottom;
    return fits ? [onWall(opening, wall, (from + to) / 2, to - from)] : [];
  });
}

function middleOf(points: readonly Vector3[]): Point {
  const sum = points.reduce<Point>(([x, y], [dx, dy]) => [x + dx, y + dy], [0, 0]);
  return scale(sum, 1 / points.length);
}

function isPartOf(one: BoxRecord, whole: BoxRecord): boolean {
  const [x, y] = one.center;
  return one.category === whole.category && isInside([x, y], footprint(whole));
}

/** The outline of the floor; null unless it makes a room. */
function outlineOf(pieces: readonly Piece[]): readonly Point[] | null {
  const floor = pieces.find(({ label, flat }) => flat && label === "floor");
  if (floor === undefined) return null;
  const points = floor.points.map(([x, y]) => roundedPoint([x, y]));
  const corners = points.filter((point, i) => !isOnTheWay(points, point, i));
  return outlineProblem(corners) === null ? corners : null;
}

function isOnTheWay(points: readonly Point[], point: Point, i: number): boolean {
  const before = points.at(i - 1) ?? point;
  const after = points[(i + 1) % points.length] ?? point;
  return Math.abs(cross(subtract(point, before), subtract(after, point))) < 1e-4;
}

function boxesOf(pieces: readonly Piece[], room: RoomRecord): readonly BoxRecord[] {
  return pieces.flatMap((piece) => {
    const category = CATEGORIES[piece.label];
    return category === undefined || piece.points.length < 3 ? [] : [boxOf(piece, category, room)];
  });
}

/** The upright box of the least footprint round the points, its back to the nearest wall. */
function boxOf({ points, flat }: Piece, category: string, room: RoomRecord): BoxRecord {
  const heights = points.map(([, , z]) => z);
  const top = Math.max(...heights);
  const lowest = Math.min(...heights);
  const isTop = flat && top - lowest < UPRIGHT;
  const bottom = isTop || lowest < STANDS ? 0 : lowest;
  const { middle, angle, sides } = leastRectangle(hullOf(points.map(([x, y]) => [x, y])));
  const back = headingFromWall(room, middle);
  const quarters = Math.round((back - angle) / (Math.PI / 2));
  const [along, across] = quarters % 2 === 0 ? sides : [sides[1], sides[0]];
  const height = Math.max(rounded(top - bottom), THIN);
  return {
    id: "",
    category,
    center: [...roundedPoint(middle), bottom + height / 2],
    size: [Math.max(rounded(along), THIN), Math.max(rounded(across), THIN), height],
    heading: wrapped(angle + (quarters * Math.PI) / 2),
    front_from_wall: true,
  };
}

interface Rectangle {
  readonly middle: Point;
  /** Of its first side, radians. */
  readonly angle: number;
  readonly sides: readonly [number, number];
}

/** One side of the least rectangle round a hull lies on a side of the hull. */
function leastRectangle(hull: readonly Point[]): Rectangle {
  const rectangles = hull.map((corner, i) => {
    const next = hull[(i + 1) % hull.length] ?? corner;
    return rectangleAlong(hull, angleOf(subtract(next, corner)));
  });
  const area = ({ sides }: Rectangle): number => sides[0] * sides[1];
  return rectangles.reduce((best, one) => (area(one) < area(best) ? one : best));
}

function rectangleAlong(hull: readonly Point[], angle: number): Rectangle {
  const axis = direction(angle);
  const [u, v] = [hull.map((point) => dot(point, axis)), hull.map((p) => dot(p, leftOf(axis)))];
  const [u0, u1, v0, v1] = [Math.min(...u), Math.max(...u), Math.min(...v), Math.max(...v)];
  const [a, b] = [(u0 + u1) / 2, (v0 + v1) / 2];
  const [ax, ay] = axis;
  return { middle: [a * ax - b * ay, a * ay + b * ax], angle, sides: [u1 - u0, v1 - v0] };
}

/** The convex hull, anticlockwise (Andrew's monotone chain). */
function hullOf(points: readonly Point[]): readonly Point[] {
  const sorted = points.toSorted((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (ordered: readonly Point[]): readonly Point[] => {
    const chain: Point[] = [];
    for (const point of ordered) {
      while (chain.length > 1 && !turnsLeft(chain.at(-2), chain.at(-1), point)) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  const hull = [...half(sorted), ...half(sorted.toReversed())];
  return hull.length > 0 ? hull : points.slice(0, 1);
}

function turnsLeft(a: Point | undefined, b: Point | undefined, c: Point): boolean {
  return a !== undefined && b !== undefined && cross(subtract(b, a), subtract(c, b)) > 0;
}
