/**
 * Pictures and televisions on a wall, which are dragged over it and go out of sight with it; a
 * cupboard that hangs is a box like others. Pure; core frame.
 */

import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import { bottomOf, headingOf } from "./footprints";
import { standsOnTop } from "./resting";
import type { Vector3 } from "./state";

const OUT_OF_REACH = 0.7; // metres over the floor; a television above this hangs or stands on something

export function hangs(box: BoxRecord, scene: SceneRecord): boolean {
  if (box.category !== "TV") return box.category === "Picture";
  return bottomOf(box) > OUT_OF_REACH && !standsOnTop(scene, box);
}

/** How much of its front a box turns to a point: 1 all of it, 0 its edge, less its back. */
export function turnedTo(box: BoxRecord, [x, y]: Vector3): number {
  const heading = headingOf(box);
  const [dx, dy] = [x - box.center[0], y - box.center[1]];
  return (Math.cos(heading) * dx + Math.sin(heading) * dy) / (Math.hypot(dx, dy) || 1);
}
