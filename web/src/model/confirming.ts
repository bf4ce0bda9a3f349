/** "Place it": at once where the ghost may stand, later while the server has yet to say so. */
import { isSamePose, isWordToCome, refusalOf } from "./ghost";
import { refused } from "./notices";
import { placed } from "./placing";
import type { Placing, State } from "./state";

/** The ghost becomes a box, or a sentence says why not; where nobody knows yet, it waits. */
export function confirm(state: State): State {
  const { placing } = state;
  if (placing === null || placing.pose === null) return state;
  const waits = refusalOf(state) === null && isWordToCome(state);
  return waits ? { ...state, placing: { ...placing, confirming: true } } : decided(state, placing);
}

/** The server did not say in time: what the page itself knows decides. */
export function stopWaiting(state: State): State {
  return state.placing?.confirming ? decided(state, state.placing) : state;
}

/** A ghost that waits is placed when the word is there, and waits no more when it has moved. */
export function followedUp(before: State, after: State): State {
  const { placing } = after;
  const old = before.placing;
  if (!placing?.confirming || !old?.confirming) return after;
  const grown = placing.size.some((side, i) => side !== old.size[i]);
  if (grown || !isSamePose(placing.pose, old.pose)) {
    return { ...after, placing: { ...placing, confirming: false } };
  }
  return isWordToCome(after) ? after : decided(after, placing);
}

function decided(state: State, placing: Placing): State {
  const refusal = refusalOf(state);
  if (refusal === null) return placed(state);
  return refused({ ...state, placing: { ...placing, confirming: false } }, refusal);
}
