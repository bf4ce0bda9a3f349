/** From where a camera sees the whole room. Pure; core frame, metres and radians. */
import type { Vector3 } from "../model/state";
import type { RoomRecord } from "../net/protocol.gen";
import { boundsOf, middleOf, onWall, wallsOf } from "./outline";

/** What of the picture is covered by panels, CSS pixels. */
export interface Insets {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

export const NO_INSETS: Insets = { left: 0, right: 0, top: 0, bottom: 0 };

/** The part of the picture that is free, CSS pixels; never less than a quarter of it. */
export function freePart(
  width: number,
  height: number,
  insets: Insets,
): { readonly x: number; readonly y: number; readonly width: number; readonly height: number } {
  const freeWidth = Math.max(width / 4, width - insets.left - insets.right);
  const freeHeight = Math.max(height / 4, height - insets.top - insets.bottom);
  return {
    x: Math.min(insets.left, width - freeWidth),
    y: Math.min(insets.top, height - freeHeight),
    width: freeWidth,
    height: freeHeight,
  };
}

export interface Viewpoint {
  readonly position: Vector3;
  readonly target: Vector3;
}

/** The sine of the angle to a wall below which there is nothing to see on it. */
export const SIDEWAYS = 0.3;

const AIR = 1.1; // how much more than the room is in view

/** Where the camera looks from: steeper and along the room when the picture is upright. */
export function viewDirection(room: RoomRecord, aspect: number): Vector3 {
  const [low, high] = boundsOf(room.corners);
  const long = high[1] - low[1] > high[0] - low[0] ? 1 : 0;
  const upright = aspect < 0.85;
  const azimuth = upright
    ? (long === 1 ? -Math.PI / 2 : 0) + 0.16
    : (long === 1 ? 0 : -Math.PI / 2) - 0.42;
  const elevation = upright ? 0.98 : 0.72;
  return [
    Math.cos(azimuth) * Math.cos(elevation),
    Math.sin(azimuth) * Math.cos(elevation),
    Math.sin(elevation),
  ];
}

/** The nearest viewpoint in a direction that has the room in view; `fov` is the vertical angle. */
export function frameRoom(
  room: RoomRecord,
  direction: Vector3,
  fov: number,
  aspect: number,
): Viewpoint {
  const [middleX, middleY] = middleOf(room.corners);
  const [dx, dy, dz] = direction;
  const flat = Math.hypot(dx, dy) || 1;
  const right: Vector3 = [-dy / flat, dx / flat, 0];
  const up: Vector3 = [-(dx / flat) * dz, -(dy / flat) * dz, flat];
  const tanY = Math.tan(fov / 2) / AIR;
  const tanX = tanY * aspect;
  const points = silhouette(room, direction);
  let target: Vector3 = [middleX, middleY, 0];
  let distance = 0;
  // The target slides in the picture plane until the room is centered; a few steps settle it.
  for (let step = 0; step < 8; step++) {
    const seen = points.map((point) => {
      const offset: Vector3 = [point[0] - target[0], point[1] - target[1], point[2] - target[2]];
      return { x: dot(offset, right), y: dot(offset, up), toward: dot(offset, direction) };
    });
    distance = Math.max(
      ...seen.map(({ x, y, toward }) => toward + Math.max(Math.abs(x) / tanX, Math.abs(y) / tanY)),
    );
    const xs = seen.map(({ x, toward }) => x / (distance - toward));
    const ys = seen.map(({ y, toward }) => y / (distance - toward));
    const shiftX = ((Math.max(...xs) + Math.min(...xs)) / 2) * distance;
    const shiftY = ((Math.max(...ys) + Math.min(...ys)) / 2) * distance;
    target = [
      target[0] + right[0] * shiftX + up[0] * shiftY,
      target[1] + right[1] * shiftX + up[1] * shiftY,
      target[2] + right[2] * shiftX + up[2] * shiftY,
    ];
  }
  const position: Vector3 = [
    target[0] + dx * distance,
    target[1] + dy * distance,
    target[2] + dz * distance,
  ];
  return onFloor(position, target, direction);
}

/** The same view with its target on the floor, so that turning goes round a point of the floor. */
function onFloor(position: Vector3, target: Vector3, direction: Vector3): Viewpoint {
  const drop = target[2] / direction[2];
  return {
    position,
    target: [target[0] - direction[0] * drop, target[1] - direction[1] * drop, 0],
  };
}

/** The sine below which a wall's top adds nothing to the outline of the room. */
const EDGEWAYS = 0.1;

/** The corners of the floor, and the tops of the walls that are not in the way. */
function silhouette(room: RoomRecord, direction: Vector3): Vector3[] {
  const flat = Math.hypot(direction[0], direction[1]) || 1;
  const walls = wallsOf(room.corners, 0);
  return walls.flatMap((wall): Vector3[] => {
    const out = (wall.outward[0] * direction[0] + wall.outward[1] * direction[1]) / flat;
    const ends = [onWall(wall, 0, 0, 0), onWall(wall, wall.length, 0, 0)];
    const tops = ends.map(([x, y]): Vector3 => [x, y, room.height]);
    return out < -EDGEWAYS ? [...ends, ...tops] : ends;
  });
}

function dot(a: Vector3, b: Vector3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
