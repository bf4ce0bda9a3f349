/** What the person wants to know of the places on offer, or wants otherwise. */
import type { Comfort, Matters, ModelName, Weighing } from "../net/protocol.gen";
import { askAgain } from "./answers";
import { showAlternative } from "./placing";
import type { State } from "./state";

/** The rank of the best place. */
const BEST = 1;

/** Another model finds the places from now on. */
export function chooseModel(state: State, model: ModelName): State {
  return model === state.model ? state : askAgain({ ...state, model });
}

/** A rule does not count for the object on its way. */
export function relax(state: State, rule: Comfort): State {
  const { placing } = state;
  if (placing === null || placing.relaxed.includes(rule)) return state;
  return askAgain({ ...state, placing: { ...placing, relaxed: [...placing.relaxed, rule] } });
}

/** Asks which thing matters most to the best place, which is shown; or lets the question go. */
export function whatMatters(state: State, on: boolean): State {
  const best = on ? showAlternative(state, BEST) : state;
  const { placing, nextId } = best;
  if (placing === null) return state;
  const id = `matters-${nextId}`;
  const weigh = on ? { id, done: 0, total: 0, result: null } : null;
  return { ...best, nextId: nextId + 1, placing: { ...placing, weigh } };
}

export function weighing(state: State, { id, done, total }: Weighing): State {
  const { placing } = state;
  if (placing?.weigh?.id !== id || placing.weigh.result !== null) return state;
  return { ...state, placing: { ...placing, weigh: { ...placing.weigh, done, total } } };
}

/** The thing that matters is selected, so that it is seen. */
export function matters(state: State, result: Matters): State {
  const { placing } = state;
  if (placing?.weigh?.id !== result.id) return state;
  const box = result.found?.box;
  const selection = box === undefined ? state.selection : ({ kind: "box", id: box } as const);
  return { ...state, selection, placing: { ...placing, weigh: { ...placing.weigh, result } } };
}
