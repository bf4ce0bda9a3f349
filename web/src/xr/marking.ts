/** What pointing and tapping mean while the real room is drawn. Pure; core frame. */

import type { Action } from "../model/actions";
import { distance } from "../model/geometry";
import { ghostBox } from "../model/ghost";
import type { Point, State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { type Dragged, drag, handOnWalls } from "../views/dragging";
import { meetBox, meetLevel, pointOn, type Ray } from "../views/picking";

const REACH = 12; // metres; farther away a phone held by hand points nowhere in particular
const STEEP = 0.96; // of the way down: over a thing its height cannot be seen
const SKY = 100; // metres; higher than every thing

/** Whether a tap means a mark, and not what stands there. */
export function isMarking({ tool, draft }: State): boolean {
  return tool !== "select" || draft !== null;
}

/** The actions of a tap along the ray. */
export function marked(state: State, ray: Ray): readonly Action[] {
  const { draft, tool, ar } = state;
  if (draft?.kind === "box-height") {
    const height = heightAt(draft.box, ray) ?? draft.box.size[2];
    return [{ type: "draw-height", height, done: true }];
  }
  const at = pointAt(state, ray);
  if (at === null) return [];
  const free = isFree(state);
  const down: Action = { type: "draw-down", at, free };
  const up: Action = { type: "draw-up", at, free };
  switch (draft?.kind) {
    case "room":
      return [down, up];
    case "box-floor":
      return draft.side === undefined && ar?.marks === 3 ? [{ type: "draw-side", at, free }] : [up];
    case "opening":
      return [up];
    case undefined:
      return tool === "select" ? [] : [down];
  }
}

/** What follows the view while nothing is pressed; null if it changes nothing. */
export function aimed(state: State, ray: Ray): Dragged | null {
  const { draft, ar, placing } = state;
  if (draft?.kind === "box-height") {
    const height = heightAt(draft.box, ray);
    return height === null ? null : alone({ type: "draw-height", height, done: false });
  }
  if (draft !== null) {
    const at = pointAt(state, ray);
    return at && alone({ type: "draw-move", at, free: isFree(state) });
  }
  const ghost = placing?.mode === "manual" && ar?.carrying ? ghostBox(state) : null;
  if (ghost === null || pointAt(state, ray) === null) return null;
  const grip = { kind: "box", box: ghost, level: 0, offset: [0, 0], ghost: true } as const;
  return drag(state, grip, ray, false, false);
}

/** Whether what is marked is in the walls. */
export function isOnWalls({ tool }: State): boolean {
  return tool === "door" || tool === "window";
}

/** Where on the floor (or, for doors and windows, along the walls) a ray points. */
export function pointAt(state: State, ray: Ray): Point | null {
  const at = isOnWalls(state) ? handOnWalls(state, ray) : meetLevel(ray, 0);
  return at && distance(at, [ray.origin[0], ray.origin[1]]) < REACH ? at : null;
}

/** The height at which the ray comes to the box: of its top edge, when that is aimed at. */
export function heightAt(box: BoxRecord, ray: Ray): number | null {
  if (Math.abs(ray.direction[2]) > STEEP) return null;
  const [depth, width] = box.size;
  const tower: BoxRecord = {
    ...box,
    center: [box.center[0], box.center[1], 0],
    size: [depth, width, 2 * SKY],
  };
  const entered = meetBox(ray, tower);
  return entered === null || entered === 0 ? null : Math.max(0, pointOn(ray, entered)[2]);
}

/** The first wall may run anywhere; the others too, unless right angles are wanted. */
function isFree({ draft, ar }: State): boolean {
  return draft?.kind === "room" && (draft.corners.length < 2 || ar?.square === false);
}

function alone(action: Action): Dragged {
  return { action, guides: [] };
}
