/** How the camera turns to the front of what hangs on a wall. Pure; core frame, metres and radians. */
import { headingOf } from "../model/footprints";
import { wrapped } from "../model/geometry";
import { ghostBox } from "../model/ghost";
import { hangs, turnedTo } from "../model/hanging";
import type { State, Vector3 } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import type { Viewpoint } from "./framing";

const EDGE_ON = 0.4; // of its front; less of it turned to the eye tells nothing
const OBLIQUE = 0.9; // radians beside the front: the rest of the room stays in view

/** What hangs on the place that was chosen; null if the place is on the floor or by hand. */
export function hungAlternative(state: State): BoxRecord | null {
  const { placing } = state;
  if (placing === null || placing.mode === "manual" || placing.alternative === null) return null;
  const ghost = ghostBox(state);
  return ghost !== null && hangs(ghost, state.scene) ? ghost : null;
}

/** From where to look at the room to see the front of a box; null if it is seen as it is. */
export function directionToFront(box: BoxRecord, { position, target }: Viewpoint): Vector3 | null {
  if (turnedTo(box, position) > EDGE_ON) return null;
  const [x, y, z] = offset(position, target);
  const heading = headingOf(box);
  const aside = wrapped(Math.atan2(y, x) - heading) < 0 ? -OBLIQUE : OBLIQUE;
  const flat = Math.hypot(x, y);
  const length = Math.hypot(flat, z) || 1;
  const azimuth = heading + aside;
  return [
    (Math.cos(azimuth) * flat) / length,
    (Math.sin(azimuth) * flat) / length,
    Math.max(z, 0) / length,
  ];
}

/** The viewpoint on the way round from one to another; `t` goes from 0 to 1. */
export function roundTo(from: Viewpoint, to: Viewpoint, t: number): Viewpoint {
  const [before, after] = [offset(from.position, from.target), offset(to.position, to.target)];
  const start = Math.atan2(before[1], before[0]);
  const azimuth = start + wrapped(Math.atan2(after[1], after[0]) - start) * t;
  const flat = mix(Math.hypot(before[0], before[1]), Math.hypot(after[0], after[1]), t);
  const target: Vector3 = [
    mix(from.target[0], to.target[0], t),
    mix(from.target[1], to.target[1], t),
    mix(from.target[2], to.target[2], t),
  ];
  const position: Vector3 = [
    target[0] + Math.cos(azimuth) * flat,
    target[1] + Math.sin(azimuth) * flat,
    target[2] + mix(before[2], after[2], t),
  ];
  return { position, target };
}

function offset(position: Vector3, target: Vector3): Vector3 {
  return [position[0] - target[0], position[1] - target[1], position[2] - target[2]];
}

function mix(from: number, to: number, t: number): number {
  return from + (to - from) * t;
}
