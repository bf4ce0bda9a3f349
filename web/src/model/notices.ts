/** Sentences for the person. */
import type { Notice, State } from "./state";

export function notified(state: State, tone: Notice["tone"], text: string): State {
  return { ...state, notice: { id: state.nextId, tone, text }, nextId: state.nextId + 1 };
}

/** Nothing changes but that a sentence says why. */
export function refused(state: State, text: string): State {
  return notified(state, "problem", text);
}

/** What was said is done with. */
export function silenced(state: State): State {
  return state.notice === null ? state : { ...state, notice: null };
}
