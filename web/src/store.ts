/** The one state of the page, and who is told when it changes. */

import type { Action } from "./model/actions";
import { reduce } from "./model/reduce";
import type { State } from "./model/state";

export type Dispatch = (action: Action) => void;

export interface Store {
  getState(): State;
  dispatch: Dispatch;
  /** Called after each change, with the new state; returns how to stop that. */
  subscribe(listener: (state: State) => void): () => void;
}

export function createStore(initial: State): Store {
  let state = initial;
  const listeners = new Set<(state: State) => void>();
  return {
    getState: () => state,
    dispatch(action) {
      const next = reduce(state, action);
      if (next === state) return;
      state = next;
      for (const listener of listeners) listener(state);
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
