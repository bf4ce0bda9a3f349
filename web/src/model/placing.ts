/** An object on its way into the room: by hand (Manual) or by proposal (SceneGen). */

import { add, roundedPoint, wrapped } from "./geometry";
import { ghostBox } from "./ghost";
import { edited } from "./history";
import { usualSize } from "./labels";
import { poseAt, resized, settled } from "./resting";
import { freeId, withBox } from "./scenes";
import type { Mode, Placing, Point, Pose, State, Vector3 } from "./state";

/** Nothing was said of where the ghost stands, or of the ask. */
const UNTOLD = {
  inspected: null,
  inspectedPose: null,
  confirming: false,
  problem: null,
  weigh: null,
};

interface Wish {
  readonly category: string;
  readonly item: string | null;
  readonly size: Vector3 | null;
  readonly mode: Mode;
  readonly view: Point;
}

export function place(state: State, wish: Wish): State {
  const { category, item, mode, view } = wish;
  const size = wish.size ?? sizeOf(state, category, item);
  const placing: Placing = {
    ask: `ask-${state.nextId}`,
    mode,
    category,
    item,
    wishedSize: wish.size,
    relaxed: [],
    size,
    asset: state.lists.catalogue.find(({ id }) => id === item)?.asset ?? null,
    pose: mode === "manual" ? poseAt(state.scene, category, size, view) : null,
    alternative: mode === "manual" ? null : 1,
    computing: true,
    answer: null,
    heatMaps: [],
    mapsOf: null,
    ...UNTOLD,
  };
  return {
    ...state,
    placing,
    nextId: state.nextId + 1,
    tool: "select",
    draft: null,
    selection: null,
  };
}

/** The same object and size in the other mode: by hand where the view is, or on proposal 1. */
export function setMode(state: State, mode: Mode, view: Point): State {
  const { placing, scene } = state;
  if (placing === null || placing.mode === mode) return state;
  const byHand = { ...placing, ...UNTOLD, problem: placing.problem, mode, alternative: null };
  if (mode === "manual") {
    const pose = poseAt(scene, placing.category, placing.size, view);
    return { ...state, placing: { ...byHand, pose } };
  }
  return { ...state, placing: onAlternative(byHand, 1) };
}

/** Another size, or null for the usual one: another question, while the old map stays. */
export function setSize(state: State, wished: Vector3 | null): State {
  const { placing } = state;
  if (placing === null) return state;
  const size = wished ?? sizeOf(state, placing.category, placing.item);
  const { pose, category } = placing;
  const next: Placing = {
    ...placing,
    ask: `ask-${state.nextId}`,
    wishedSize: wished,
    size,
    pose: pose === null ? null : resized(category, placing.size, size, pose),
    computing: true,
    ...UNTOLD,
  };
  return { ...state, placing: next, nextId: state.nextId + 1 };
}

export function showAlternative(state: State, rank: number): State {
  const { placing } = state;
  if (placing?.mode !== "scenegen" || placementOf(placing, rank) === undefined) return state;
  return { ...state, placing: onAlternative(placing, rank) };
}

/** The ghost where it was dragged: from then on its pose is the person's. */
export function dragGhost(state: State, pose: Pose): State {
  const { placing, scene } = state;
  if (placing === null) return state;
  const standing = settled(scene, placing.category, placing.size, pose);
  return { ...state, placing: { ...placing, pose: standing, alternative: null } };
}

export function nudgeGhost(state: State, by: Point): State {
  const pose = state.placing?.pose;
  if (pose == null) return state;
  const [x, y] = roundedPoint(add([pose.center[0], pose.center[1]], by));
  return dragGhost(state, { ...pose, center: [x, y, pose.center[2]] });
}

export function turnGhost(state: State, by: number): State {
  const pose = state.placing?.pose;
  if (pose == null) return state;
  return dragGhost(state, { ...pose, heading: wrapped(pose.heading + by) });
}

/** The ghost becomes a box of the scene, in one step. */
export function placed(state: State): State {
  const { placing } = state;
  const ghost = ghostBox(state);
  if (placing === null || ghost === null) return state;
  const box = { ...ghost, id: freeId("box", state.scene.boxes) };
  const { asset } = placing;
  return {
    ...edited(state, withBox(state.scene, box), true),
    placing: null,
    probe: null,
    selection: { kind: "box", id: box.id },
    models: asset === null ? state.models : { ...state.models, [box.id]: asset },
  };
}

function placementOf(placing: Placing, rank: number) {
  return placing.answer?.placements.find((placement) => placement.rank === rank);
}

/** On that alternative, else on the first; nowhere if there is none. */
export function onAlternative(placing: Placing, rank: number): Placing {
  const placement = placementOf(placing, rank) ?? placing.answer?.placements[0];
  const pose =
    placement === undefined ? null : { center: placement.center, heading: placement.heading };
  const alternative = placement?.rank ?? 1;
  return { ...placing, pose, alternative, inspected: null, inspectedPose: null };
}

function sizeOf(state: State, category: string, item: string | null): Vector3 {
  const known = state.lists.catalogue.find(({ id }) => id === item);
  return known?.size ?? usualSize(category, state.lists.categories);
}
