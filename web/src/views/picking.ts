/** What a ray meets. Pure; core frame, metres. A finger, a mouse and a controller all make rays. */
import { headingOf } from "../model/footprints";
import { isInside } from "../model/geometry";
import type { Point, Vector3 } from "../model/state";
import type { BoxRecord, RoomRecord } from "../net/protocol.gen";
import { along, onWall, wallsOf } from "./outline";

export interface Ray {
  readonly origin: Vector3;
  /** Unit length. */
  readonly direction: Vector3;
}

export interface WallHit {
  readonly wall: number;
  readonly at: Vector3;
  /** The heading of what hangs there with its back to the wall. */
  readonly heading: number;
  readonly distance: number;
}

const FLAT = 1e-6;

export function pointOn({ origin, direction }: Ray, distance: number): Vector3 {
  return [
    origin[0] + direction[0] * distance,
    origin[1] + direction[1] * distance,
    origin[2] + direction[2] * distance,
  ];
}

/** Where the ray goes down (or up) through a level; null if it never does. */
export function meetLevel(ray: Ray, level: number): Point | null {
  const drop = ray.direction[2];
  if (Math.abs(drop) < FLAT) {
    return null;
  }
  const distance = (level - ray.origin[2]) / drop;
  if (distance < 0) {
    return null;
  }
  const [x, y] = pointOn(ray, distance);
  return [x, y];
}

/** How far along the ray it enters the box, grown by `margin` on every side; null if it misses. */
export function meetBox(ray: Ray, box: BoxRecord, margin = 0): number | null {
  const heading = headingOf(box);
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  const turned = ([x, y, z]: Vector3): Vector3 => [x * cos + y * sin, y * cos - x * sin, z];
  const origin = turned([
    ray.origin[0] - box.center[0],
    ray.origin[1] - box.center[1],
    ray.origin[2] - box.center[2],
  ]);
  const direction = turned(ray.direction);
  let [enter, leave] = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  for (const axis of [0, 1, 2] as const) {
    const half = box.size[axis] / 2 + margin;
    const step = Math.abs(direction[axis]) < FLAT ? FLAT : direction[axis];
    const [a, b] = [(-half - origin[axis]) / step, (half - origin[axis]) / step];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return leave < Math.max(enter, 0) ? null : Math.max(enter, 0);
}

/** The box that the ray meets first, and how far away. */
export function firstBox(
  ray: Ray,
  boxes: readonly BoxRecord[],
): { readonly box: BoxRecord; readonly distance: number } | null {
  let best: { readonly box: BoxRecord; readonly distance: number } | null = null;
  for (const box of boxes) {
    const distance = meetBox(ray, box);
    if (distance !== null && (best === null || distance < best.distance)) {
      best = { box, distance };
    }
  }
  return best;
}

/** The inner side of a wall that the ray meets first; walls seen from outside let it through. */
export function meetWall(ray: Ray, room: RoomRecord): WallHit | null {
  let best: WallHit | null = null;
  wallsOf(room.corners, 0).forEach((wall, index) => {
    const toward = ray.direction[0] * wall.outward[0] + ray.direction[1] * wall.outward[1];
    if (toward < FLAT) {
      return;
    }
    const gap =
      (wall.start[0] - ray.origin[0]) * wall.outward[0] +
      (wall.start[1] - ray.origin[1]) * wall.outward[1];
    const distance = gap / toward;
    const at = pointOn(ray, distance);
    const s = along(wall, [at[0], at[1]]);
    const inside = s >= 0 && s <= wall.length && at[2] >= 0 && at[2] <= room.height;
    if (distance >= 0 && inside && (best === null || distance < best.distance)) {
      const heading = Math.atan2(-wall.outward[1], -wall.outward[0]);
      best = { wall: index, at, heading, distance };
    }
  });
  return best;
}

/** Where the ray meets the floor of the room; null outside of it. */
export function meetFloor(ray: Ray, room: RoomRecord): Point | null {
  const at = meetLevel(ray, 0);
  return at !== null && isInside(at, room.corners) ? at : null;
}

/** The height at which the ray passes nearest to the upright line over a point of the floor. */
export function heightOver(ray: Ray, [x, y]: Point): number {
  const [dx, dy, dz] = ray.direction;
  const flat = dx * dx + dy * dy;
  if (flat < FLAT) {
    return 0;
  }
  const distance = ((x - ray.origin[0]) * dx + (y - ray.origin[1]) * dy) / flat;
  return ray.origin[2] + dz * distance;
}

/** Where the ray meets the plane of wall `index`, also beyond its ends: along it, and the height. */
export function alongWall(ray: Ray, room: RoomRecord, index: number): Point | null {
  const wall = wallsOf(room.corners, 0)[index];
  if (!wall) {
    return null;
  }
  const toward = ray.direction[0] * wall.outward[0] + ray.direction[1] * wall.outward[1];
  if (Math.abs(toward) < FLAT) {
    return null;
  }
  const [x, y] = onWall(wall, 0, 0, 0);
  const gap = (x - ray.origin[0]) * wall.outward[0] + (y - ray.origin[1]) * wall.outward[1];
  const at = pointOn(ray, gap / toward);
  return [along(wall, [at[0], at[1]]), at[2]];
}
