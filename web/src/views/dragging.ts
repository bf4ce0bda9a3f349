/** What dragging the body of a thing does: boxes, the ghost, doors and windows. Pure; core frame. */

import type { Action } from "../model/actions";
import { withoutLoaded } from "../model/carrying";
import { bottomOf, floorPoint, headingOf, movedTo } from "../model/footprints";
import { add, roundedPoint, type Segment, subtract } from "../model/geometry";
import { ghostBox } from "../model/ghost";
import { hangs } from "../model/hanging";
import { settled } from "../model/resting";
import { boxOf } from "../model/scenes";
import { snapBox } from "../model/snapping";
import type { Point, State } from "../model/state";
import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import { meetLevel, meetWall, pointOn, type Ray } from "./picking";

/** What was grabbed, and where: kept for as long as the drag lasts. */
export type Grip =
  | {
      readonly kind: "box";
      readonly box: BoxRecord;
      /** The height of the plane in which the hand moves, metres. */
      readonly level: number;
      /** From the hand to the center of the box. */
      readonly offset: Point;
      readonly ghost: boolean;
    }
  | {
      readonly kind: "opening";
      readonly opening: "door" | "window";
      readonly id: string;
      readonly from: Point;
      readonly start: Point;
      readonly end: Point;
    };

export interface Dragged {
  readonly action: Action;
  readonly guides: readonly Segment[];
}

const RESTS = 0.02; // metres; nearer to where it would stand than this, it stands there

/** Takes hold of a box (or of the ghost) where the ray meets it. */
export function gripBox(box: BoxRecord, ray: Ray, distance: number, ghost: boolean): Grip {
  const at = pointOn(ray, distance);
  // A plane far below the eye keeps the hand steady; above it the box would run away.
  const level = Math.min(at[2], Math.max(bottomOf(box), ray.origin[2] - 0.4));
  const hand = meetLevel(ray, level) ?? [at[0], at[1]];
  return { kind: "box", box, level, offset: subtract(floorPoint(box), hand), ghost };
}

/** What a drag along a ray does; null if the ray leads nowhere. */
export function drag(
  state: State,
  grip: Grip,
  ray: Ray,
  free: boolean,
  done: boolean,
): Dragged | null {
  if (grip.kind === "opening") {
    const action = dragOpening(state, grip, ray, done);
    return action && { action, guides: [] };
  }
  const now = grip.ghost ? ghostBox(state) : grip.box;
  const onWall = now !== null && hangs(now, state.scene);
  const moved = now && movedBox(state.scene, now, grip, ray, onWall);
  if (!moved) {
    return null;
  }
  const rest = grip.ghost ? state.scene : withoutLoaded(state.beforeDrag ?? state.scene, grip.box);
  const { box, guides } = onWall ? { box: moved, guides: [] } : snapBox(rest, moved, free);
  if (grip.ghost) {
    const pose = { center: box.center, heading: headingOf(box) };
    return { action: { type: "drag-ghost", pose, done }, guides };
  }
  const at = { center: box.center, heading: headingOf(box) };
  const center = follows(rest, grip.box)
    ? settled(rest, box.category, box.size, at).center
    : box.center;
  return { action: { type: "edit-box", box: { ...box, center }, done }, guides };
}

/** The end of a drag: what it did last, once and for all; nothing if its box is gone meanwhile. */
export function finished({ scene }: State, last: Action): readonly Action[] {
  if (!("done" in last)) return [];
  const isGone = last.type === "edit-box" && boxOf(scene, last.box.id) === undefined;
  return isGone ? [] : [{ ...last, done: true }];
}

function movedBox(
  scene: SceneRecord,
  box: BoxRecord,
  grip: Grip & { readonly kind: "box" },
  ray: Ray,
  onWall: boolean,
): BoxRecord | null {
  if (onWall) {
    return hung(scene, box, ray);
  }
  const hand = meetLevel(ray, grip.level);
  return hand && movedTo(box, roundedPoint(add(hand, grip.offset)));
}

/** On the wall that the ray meets, at the height where it meets it. */
function hung(scene: SceneRecord, box: BoxRecord, ray: Ray): BoxRecord | null {
  const hit = meetWall(ray, scene.room);
  if (!hit) {
    return null;
  }
  const [depth, , height] = box.size;
  const [x, y] = roundedPoint([
    hit.at[0] + (Math.cos(hit.heading) * depth) / 2,
    hit.at[1] + (Math.sin(hit.heading) * depth) / 2,
  ]);
  const highest = Math.max(height / 2, scene.room.height - height / 2);
  const z = Math.min(Math.max(hit.at[2], height / 2), highest);
  return { ...box, center: [x, y, Math.round(z * 100) / 100], heading: hit.heading };
}

/** Whether the box rests where things of its kind do, and so goes up and down with the ground. */
function follows(rest: SceneRecord, box: BoxRecord): boolean {
  const pose = { center: box.center, heading: headingOf(box) };
  const { center } = settled(rest, box.category, box.size, pose);
  return Math.abs(center[2] - box.center[2]) < RESTS;
}

function dragOpening(
  state: State,
  grip: Grip & { readonly kind: "opening" },
  ray: Ray,
  done: boolean,
): Action | null {
  const { room } = state.scene;
  const openings = grip.opening === "door" ? room.doors : room.windows;
  const opening = openings.find(({ id }) => id === grip.id);
  const hand = handOnWalls(state, ray);
  if (!opening || !hand) {
    return null;
  }
  const by = subtract(hand, grip.from);
  const value = { ...opening, start: add(grip.start, by), end: add(grip.end, by) };
  return { type: "edit-opening", opening: grip.opening, value, done };
}

/** Where on the plan a ray points, walls first: so doors and windows can be grabbed and drawn. */
export function handOnWalls(state: State, ray: Ray): Point | null {
  const hit = meetWall(ray, state.scene.room);
  return hit ? [hit.at[0], hit.at[1]] : meetLevel(ray, 0);
}
