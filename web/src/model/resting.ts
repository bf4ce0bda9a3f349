/** How high a thing stands or hangs where it is put. */
import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import {
  bottomOf,
  FLAT,
  floorPoint,
  footprint,
  headingOf,
  isOver,
  reach,
  topOf,
} from "./footprints";
import {
  add,
  angleOf,
  direction,
  distance,
  dot,
  isInside,
  nearestOn,
  scale,
  subtract,
  wrapped,
} from "./geometry";
import type { Point, Pose, Vector3 } from "./state";
import { nearestWall, type Wall, wallsOf } from "./walls";

/**
 * The usual height of the middle of what hangs, metres; HANGING_HEIGHT of scenegen_core. Storage
 * put down by hand stands, and hangs only where it was offered a place on a wall.
 */
const HANGING_HEIGHT: Readonly<Record<string, number>> = { Picture: 1.5, TV: 1.1 };
/** What may carry other things, and how high that may be, metres. */
const CARRIERS: readonly string[] = ["Storage", "Table"];
const REACHABLE_TOP = 1.4;
/** What hangs has its back this near to a wall, metres. */
const ON_WALL = 0.25;
/** What follows are the rules of scenegen_core/placement/mounts.py and feasible.py. */
/** Undersides this near to what carries them rest on it, metres. */
export const RESTS = 0.05;
/** What hangs may be turned this far from its wall, radians. */
const HANGING_TURN = Math.PI / 16;
/** A thing may stick out this far over what it stands on, metres. */
const OVERHANG = 0.15;
/** Decor up to this height stands on furniture as well as on the floor, metres. */
const TOP_HEIGHT = 0.6;
/** A taller TV has a foot of its own; a deeper one cannot hang, metres. */
const FLOOR_TV = 1.0;
const HANGING_DEPTH = 0.35;
/** Deeper or taller storage cannot hang, metres. */
const CABINET_DEPTH = 0.45;
const CABINET_HEIGHT = 1.1;

type Mount = "floor" | "wall" | "top";

/** What a thing of that category and size can rest on. */
function mounts(category: string, [depth, , height]: Vector3): readonly Mount[] {
  if (category === "Picture") return ["wall"];
  if (category === "TV") {
    if (height > FLOOR_TV) return ["floor"];
    return depth <= HANGING_DEPTH ? ["top", "wall"] : ["top"];
  }
  if (category === "Storage" && depth <= CABINET_DEPTH && height <= CABINET_HEIGHT) {
    return ["floor", "wall"];
  }
  if (category === "Decor" && height > FLAT && height <= TOP_HEIGHT) return ["top", "floor"];
  return ["floor"];
}

/**
 * Where a thing put down by hand over a point of the floor stands, its back to the nearest wall;
 * what usually hangs, and has nothing to stand on there, hangs on that wall.
 */
export function poseAt(scene: SceneRecord, category: string, size: Vector3, view: Point): Pose {
  const wall = nearestWall(scene.room, view);
  const heading = wall === undefined ? 0 : angleOf(wall.inward);
  const ground = groundAt(scene, category, size, view);
  const hangs = hangingHeight(category, size);
  if (hangs !== undefined && wall !== undefined && ground === 0) {
    const [x, y] = add(nearestOn(view, wall.segment), scale(direction(heading), size[0] / 2));
    return { center: [x, y, hangs], heading };
  }
  return { center: [...view, ground + size[2] / 2], heading };
}

/** The pose with the height that the thing has there: on the floor, on a top, or on its wall. */
export function settled(scene: SceneRecord, category: string, size: Vector3, pose: Pose): Pose {
  const [x, y, z] = pose.center;
  const ground = groundAt(scene, category, size, [x, y]);
  const standing = ground + size[2] / 2;
  if (!mounts(category, size).includes("wall") || !isByWall(scene, size, pose)) {
    return { ...pose, center: [x, y, standing] };
  }
  const fromFloor = ground === 0 && z - standing <= RESTS;
  const height = fromFloor ? (hangingHeight(category, size) ?? standing) : z;
  return { ...pose, center: [x, y, Math.max(height, standing)] };
}

/** Whether something that can carry it is under a box, or a wall behind what hangs. */
export function restsOnSomething(scene: SceneRecord, box: BoxRecord): boolean {
  return mounts(box.category, box.size).some((mount) => restsOn(mount, scene, box));
}

function restsOn(mount: Mount, scene: SceneRecord, box: BoxRecord): boolean {
  switch (mount) {
    case "floor":
      return Math.abs(bottomOf(box)) <= RESTS;
    case "wall":
      return bottomOf(box) > RESTS && wallsOf(scene.room).some((wall) => hangsOn(wall, box));
    case "top":
      return standsOnTop(scene, box);
  }
}

/** Whether a box stands on the top of another that can carry it. */
export function standsOnTop(scene: SceneRecord, box: BoxRecord): boolean {
  return carriersIn(scene).some((other) => other.id !== box.id && carries(other, box));
}

function carriersIn(scene: SceneRecord): readonly BoxRecord[] {
  return scene.boxes.filter(({ category }) => CARRIERS.includes(category));
}

function hangsOn(wall: Wall, box: BoxRecord): boolean {
  const from = subtract(floorPoint(box), wall.segment[0]);
  const beside = dot(from, wall.along);
  const turned = Math.abs(wrapped(headingOf(box) - angleOf(wall.inward)));
  const gap = dot(from, wall.inward) - reach(box, wall.inward);
  return beside >= 0 && beside <= wall.length && gap <= RESTS && turned <= HANGING_TURN;
}

function carries(carrier: BoxRecord, box: BoxRecord): boolean {
  if (Math.abs(bottomOf(box) - topOf(carrier)) > RESTS) return false;
  const sticksOut = (corner: Point): boolean => !isOver(carrier, corner, OVERHANG);
  return isOver(carrier, floorPoint(box)) && !footprint(box).some(sticksOut);
}

/** The pose after a change of size: what stands stays standing, a picture keeps its middle. */
export function resized(category: string, before: Vector3, after: Vector3, pose: Pose): Pose {
  if (category === "Picture") return pose;
  const [x, y, z] = pose.center;
  return { ...pose, center: [x, y, z + (after[2] - before[2]) / 2] };
}

/** The height of what is under a point, metres: a top for what may stand on one, else the floor. */
function groundAt(scene: SceneRecord, category: string, size: Vector3, point: Point): number {
  if (!mounts(category, size).includes("top")) return 0;
  const tops = carriersIn(scene)
    .filter((box) => isInside(point, footprint(box)))
    .map(topOf);
  return Math.max(0, ...tops.filter((top) => top <= REACHABLE_TOP));
}

/** The usual height of the middle of a thing that can hang, metres. */
function hangingHeight(category: string, size: Vector3): number | undefined {
  return mounts(category, size).includes("wall") ? HANGING_HEIGHT[category] : undefined;
}

function isByWall(scene: SceneRecord, size: Vector3, { center, heading }: Pose): boolean {
  const back = add([center[0], center[1]], scale(direction(heading), -size[0] / 2));
  const wall = nearestWall(scene.room, back);
  return wall !== undefined && distance(back, nearestOn(back, wall.segment)) < ON_WALL;
}
