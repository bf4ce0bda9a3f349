/** Undo and redo. A drag is one step: `done: false` edits replace each other, `done: true` ends it. */
import type { SceneRecord } from "../net/protocol.gen";
import type { State } from "./state";

/** Older steps are forgotten. */
export const MAX_STEPS = 200;

/** The state with another scene, as a step or as part of one. */
export function edited(state: State, scene: SceneRecord, done: boolean): State {
  const before = state.beforeDrag ?? state.scene;
  if (!done) return scene === state.scene ? state : { ...state, scene, beforeDrag: before };
  if (scene === before) return { ...state, scene, beforeDrag: null };
  const past = [...state.past, before].slice(-MAX_STEPS);
  return { ...state, scene, past, future: [], beforeDrag: null };
}

/** One step back; in the middle of a drag, back to where it began. */
export function undo(state: State): State {
  if (state.beforeDrag !== null) return { ...state, scene: state.beforeDrag, beforeDrag: null };
  const scene = state.past.at(-1);
  if (scene === undefined) return state;
  return {
    ...state,
    scene,
    past: state.past.slice(0, -1),
    future: [state.scene, ...state.future],
  };
}

/** One undone step forward again. */
export function redo(state: State): State {
  const [scene, ...future] = state.future;
  if (scene === undefined || state.beforeDrag !== null) return state;
  return { ...state, scene, past: [...state.past, state.scene], future };
}
