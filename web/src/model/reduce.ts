/** The only thing that makes a new state. */
import type { Action, State } from "./state";

export function reduce(state: State, action: Action): State {
  return action.type === "open-scene" ? { ...state, scene: action.scene } : state;
}
