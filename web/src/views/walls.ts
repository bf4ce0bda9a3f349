/** The shapes of walls, doors and windows as colored faces. Core frame, metres. */
import type { Faces } from "./faces";
import { cutOut, onWall, type Panel, type Wall } from "./outline";
import type { Look } from "./palette";

export const THICKNESS = 0.1;
/** Up to here a wall always stays, so that the room keeps its edge when the rest fades. */
export const CUT = 0.1;

const FRAME = 0.06; // width of door and window frames
const LEAF = 0.04; // thickness of a door leaf
const SKIRTING = [0.012, 0.08] as const; // depth, height

/** A part of a wall, between two heights, with its openings cut out. */
export function addWall(
  faces: Faces,
  wall: Wall,
  [bottom, top]: readonly [number, number],
  holes: readonly Panel[],
  look: Look,
): void {
  const whole: Panel = { from: 0, to: wall.length, bottom, top };
  for (const piece of cutOut(whole, holes)) {
    addPiece(faces, wall, piece, whole, look);
  }
  for (const hole of holes) {
    addReveal(faces, wall, hole, bottom, top, look);
  }
}

function addPiece(faces: Faces, wall: Wall, piece: Panel, whole: Panel, look: Look): void {
  const { from, to, bottom, top } = piece;
  const first = from <= whole.from + 1e-4;
  const last = to >= whole.to - 1e-4;
  const outFrom = first ? from - wall.overhang[0] : from;
  const outTo = last ? to + wall.overhang[1] : to;
  const inside = (s: number, z: number) => onWall(wall, s, 0, z);
  const outside = (s: number, z: number) => onWall(wall, s, THICKNESS, z);
  faces.quad(
    inside(to, bottom),
    inside(from, bottom),
    inside(from, top),
    inside(to, top),
    look.wall,
  );
  faces.quad(
    outside(outFrom, bottom),
    outside(outTo, bottom),
    outside(outTo, top),
    outside(outFrom, top),
    look.wallOutside,
  );
  if (top >= whole.top - 1e-4) {
    faces.quad(
      inside(from, top),
      outside(outFrom, top),
      outside(outTo, top),
      inside(to, top),
      look.wallCut,
    );
  }
  if (first) {
    faces.quad(
      inside(from, bottom),
      outside(outFrom, bottom),
      outside(outFrom, top),
      inside(from, top),
      look.wallCut,
    );
  }
  if (last) {
    faces.quad(
      outside(outTo, bottom),
      inside(to, bottom),
      inside(to, top),
      outside(outTo, top),
      look.wallCut,
    );
  }
}

/** The inner sides of an opening. */
function addReveal(
  faces: Faces,
  wall: Wall,
  hole: Panel,
  bottom: number,
  top: number,
  look: Look,
): void {
  const low = Math.max(hole.bottom, bottom);
  const high = Math.min(hole.top, top);
  if (high <= low) {
    return;
  }
  const at = (s: number, d: number, z: number) => onWall(wall, s, d * THICKNESS, z);
  const { from, to } = hole;
  faces.quad(at(from, 1, low), at(from, 0, low), at(from, 0, high), at(from, 1, high), look.trim);
  faces.quad(at(to, 0, low), at(to, 1, low), at(to, 1, high), at(to, 0, high), look.trim);
  if (hole.bottom > bottom) {
    faces.quad(at(from, 0, low), at(from, 1, low), at(to, 1, low), at(to, 0, low), look.trim);
  }
  if (hole.top < top) {
    faces.quad(at(to, 0, high), at(to, 1, high), at(from, 1, high), at(from, 0, high), look.trim);
  }
}

/** The board along the foot of a wall, between its doors. */
export function addSkirting(faces: Faces, wall: Wall, doors: readonly Panel[], look: Look): void {
  const [depth, height] = SKIRTING;
  const foot: Panel = { from: 0, to: wall.length, bottom: 0, top: height };
  for (const piece of cutOut(foot, doors)) {
    const at = (s: number, inward: number, z: number) => onWall(wall, s, -inward, z);
    faces.block(at, [piece.from, piece.to], [0, depth], [0, height], look.trim);
  }
}

/** A frame, and a leaf with its fields. */
export function addDoor(faces: Faces, wall: Wall, door: Panel, bottom: number, look: Look): void {
  const { from, to, top } = door;
  const at = (s: number, inward: number, z: number) => onWall(wall, s, -inward, z);
  const depth = [-THICKNESS - 0.01, 0.015] as const;
  faces.block(at, [from - FRAME, from], depth, [bottom, top + FRAME], look.trim);
  faces.block(at, [to, to + FRAME], depth, [bottom, top + FRAME], look.trim);
  faces.block(at, [from, to], depth, [top, top + FRAME], look.trim);
  const leaf = [-THICKNESS * 0.5 - LEAF, -THICKNESS * 0.5] as const;
  faces.block(at, [from, to], leaf, [bottom, top], look.door);
  addDoorPanels(faces, at, door, leaf[1], look);
}

/** The foot of a door: its frame and its leaf, up to where the wall is cut. */
export function addDoorFoot(faces: Faces, wall: Wall, { from, to }: Panel, look: Look): void {
  const at = (s: number, inward: number, z: number) => onWall(wall, s, -inward, z);
  const depth = [-THICKNESS - 0.01, 0.015] as const;
  faces.block(at, [from - FRAME, from], depth, [0, CUT], look.trim);
  faces.block(at, [to, to + FRAME], depth, [0, CUT], look.trim);
  faces.block(at, [from, to], [-THICKNESS * 0.5 - LEAF, -THICKNESS * 0.5], [0, CUT], look.door);
}

/** Two raised fields and a handle. */
function addDoorPanels(
  faces: Faces,
  at: (s: number, inward: number, z: number) => [number, number, number],
  { from, to, top }: Panel,
  face: number,
  look: Look,
): void {
  const inset = Math.min(0.13, (to - from) / 5);
  const raised = [face, face + 0.008] as const;
  faces.block(at, [from + inset, to - inset], raised, [0.2, top * 0.45], look.door);
  faces.block(at, [from + inset, to - inset], raised, [top * 0.52, top - 0.15], look.door);
  faces.block(at, [from + 0.05, from + 0.15], [face, face + 0.05], [1.02, 1.05], look.wallCut);
}

/** A frame with a cross bar and a sill. */
export function addWindow(faces: Faces, wall: Wall, window: Panel, look: Look): void {
  const { from, to, bottom, top } = window;
  const at = (s: number, inward: number, z: number) => onWall(wall, s, -inward, z);
  const depth = [-THICKNESS * 0.8, -THICKNESS * 0.35] as const;
  const bar = FRAME * 0.75;
  faces.block(at, [from, from + bar], depth, [bottom, top], look.trim);
  faces.block(at, [to - bar, to], depth, [bottom, top], look.trim);
  faces.block(at, [from, to], depth, [bottom, bottom + bar], look.trim);
  faces.block(at, [from, to], depth, [top - bar, top], look.trim);
  for (const middle of sashes(from, to)) {
    faces.block(at, [middle - bar / 2, middle + bar / 2], depth, [bottom, top], look.trim);
  }
  const sill = [-THICKNESS * 0.35, 0.06] as const;
  faces.block(at, [from - 0.05, to + 0.05], sill, [bottom - 0.03, bottom], look.trim);
}

/** Where the upright bars stand: no pane is wider than about a metre. */
function sashes(from: number, to: number): number[] {
  const panes = Math.max(1, Math.round((to - from) / 0.9));
  return Array.from({ length: panes - 1 }, (_, i) => from + ((i + 1) * (to - from)) / panes);
}

/** The daylight behind a window. */
export function addGlass(
  faces: Faces,
  wall: Wall,
  { from, to, bottom, top }: Panel,
  look: Look,
): void {
  const at = (s: number, z: number) => onWall(wall, s, THICKNESS * 0.6, z);
  faces.quad(
    at(to, bottom),
    at(from, bottom),
    at(from, top),
    at(to, top),
    look.horizon,
    look.horizon,
    look.sky,
    look.sky,
  );
}

/** How a plan shows a window: a light bar in the cut wall. */
export function addWindowMark(faces: Faces, wall: Wall, { from, to }: Panel, look: Look): void {
  const at = (s: number, outward: number) => onWall(wall, s, outward * THICKNESS, CUT + 0.002);
  faces.quad(at(from, 0.3), at(from, 0.7), at(to, 0.7), at(to, 0.3), look.sky);
}
