/** What a tap means: a press that did not move. Core frame. */

import type { Action } from "../model/actions";
import type { Point, State } from "../model/state";
import { selectionOf } from "./chosen";
import type { Gesture } from "./gesture";
import type { Spot } from "./handle_spots";
import { meetFloor, type Ray } from "./picking";
import { probeAt, targetAt } from "./targets";

/** The actions of a tap, in order. */
export function tap(state: State, gesture: Gesture, ray: Ray): readonly Action[] {
  if (gesture.kind === "spot") {
    return tapSpot(state, gesture.spot);
  }
  const target = targetAt(state, ray);
  if (target?.kind === "ghost") {
    return [];
  }
  if (target?.kind === "alternative") {
    return [{ type: "show-alternative", rank: target.rank }];
  }
  // What is selected can be dragged out of the way while something is placed.
  const select: Action = { type: "select", selection: selectionOf(target) };
  if (!state.placing) {
    return [select];
  }
  const probe: Action = { type: "probe", probe: probeAt(state, ray) };
  return target ? [select, probe] : [select, probe, ...whatAbout(state, ray)];
}

/** Why not here? The ghost goes where the bare floor is tapped, turned as it is. */
function whatAbout({ placing, scene }: State, ray: Ray): readonly Action[] {
  const at = meetFloor(ray, scene.room);
  if (placing?.mode !== "scenegen" || !placing.pose || !at) {
    return [];
  }
  const { center, heading } = placing.pose;
  return [{ type: "drag-ghost", pose: { center: [at[0], at[1], center[2]], heading }, done: true }];
}

/** A corner of the old outline that is tapped, not dragged, is where a new outline begins. */
function tapSpot(state: State, spot: Spot): readonly Action[] {
  if (spot.kind !== "corner") {
    return [];
  }
  if (state.tool !== "room") {
    return selectCorner(spot);
  }
  const at: Point = [spot.at[0], spot.at[1]];
  return [
    { type: "draw-down", at, free: true },
    { type: "draw-up", at, free: true },
  ];
}

/** A corner that was tapped or dragged can then be nudged or removed. */
export function selectCorner(spot: Spot): readonly Action[] {
  return spot.kind === "corner"
    ? [{ type: "select", selection: { kind: "corner", index: spot.index } }]
    : [];
}
