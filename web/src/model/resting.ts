/** How high a thing stands or hangs where it is put. */
import type { SceneRecord } from "../net/protocol.gen";
import { footprint, topOf } from "./footprints";
import { add, angleOf, direction, distance, isInside, nearestOn, scale } from "./geometry";
import type { Point, Pose, Vector3 } from "./state";
import { nearestWall } from "./walls";

/** The usual height of the middle of what hangs, metres; HANGING_HEIGHT of scenegen_core. */
const HANGING_HEIGHT: Readonly<Record<string, number>> = { Picture: 1.5, TV: 1.1 };
/** Things that may stand on top of others, what may carry them, and how high that may be, metres. */
const STANDS_ON_TOPS: readonly string[] = ["Decor", "TV"];
const CARRIERS: readonly string[] = ["Storage", "Table"];
const REACHABLE_TOP = 1.4;
/** What hangs has its back this near to a wall, metres. */
const ON_WALL = 0.25;

/**
 * Where a thing put down by hand over a point of the floor stands, its back to the nearest wall;
 * what usually hangs, and has nothing to stand on there, hangs on that wall.
 */
export function poseAt(scene: SceneRecord, category: string, size: Vector3, view: Point): Pose {
  const wall = nearestWall(scene.room, view);
  const heading = wall === undefined ? 0 : angleOf(wall.inward);
  const ground = groundAt(scene, category, view);
  const hangs = HANGING_HEIGHT[category];
  if (hangs !== undefined && wall !== undefined && ground === 0) {
    const [x, y] = add(nearestOn(view, wall.segment), scale(direction(heading), size[0] / 2));
    return { center: [x, y, hangs], heading };
  }
  return { center: [...view, ground + size[2] / 2], heading };
}

/** The pose with the height that the thing has there: on the floor, on a top, or on its wall. */
export function settled(scene: SceneRecord, category: string, size: Vector3, pose: Pose): Pose {
  const [x, y, z] = pose.center;
  const standing = groundAt(scene, category, [x, y]) + size[2] / 2;
  const hanging = category in HANGING_HEIGHT && isByWall(scene, size, pose);
  return { ...pose, center: [x, y, hanging ? Math.max(z, standing) : standing] };
}

/** The pose after a change of size: what stands stays standing, what hangs keeps its middle. */
export function resized(category: string, before: Vector3, after: Vector3, pose: Pose): Pose {
  if (category === "Picture") return pose;
  const [x, y, z] = pose.center;
  return { ...pose, center: [x, y, z + (after[2] - before[2]) / 2] };
}

/** The height of what is under a point, metres: a top for what may stand on one, else the floor. */
function groundAt(scene: SceneRecord, category: string, point: Point): number {
  if (!STANDS_ON_TOPS.includes(category)) return 0;
  const tops = scene.boxes
    .filter((box) => CARRIERS.includes(box.category) && isInside(point, footprint(box)))
    .map(topOf);
  return Math.max(0, ...tops.filter((top) => top <= REACHABLE_TOP));
}

function isByWall(scene: SceneRecord, size: Vector3, { center, heading }: Pose): boolean {
  const back = add([center[0], center[1]], scale(direction(heading), -size[0] / 2));
  const wall = nearestWall(scene.room, back);
  return wall !== undefined && distance(back, nearestOn(back, wall.segment)) < ON_WALL;
}
