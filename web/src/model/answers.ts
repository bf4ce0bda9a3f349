/** What the server says of the object on its way, and when that no longer counts. */
import type { Answer, Inspected } from "../net/protocol.gen";
import type { MapsAction } from "./actions";
import { onAlternative } from "./placing";
import { poseAt, resized } from "./resting";
import type { Connection, Placing, Point, Pose, State } from "./state";

/** The answer to the ask in force; others, and those older than the last, change nothing. */
export function answered(state: State, answer: Answer): State {
  const { placing, connection } = state;
  if (placing === null || answer.ask !== placing.ask) return state;
  const last = placing.answer;
  if (last !== null && last.ask === answer.ask && answer.revision < last.revision) return state;
  const { pose, category } = placing;
  const next: Placing = {
    ...placing,
    answer,
    size: answer.size,
    asset: answer.asset,
    pose: pose === null ? null : resized(category, placing.size, answer.size, pose),
    computing: !isUpToDate(answer, connection),
    problem: null,
  };
  const follows = next.mode === "scenegen" && (next.alternative !== null || pose === null);
  return { ...state, placing: follows ? onAlternative(next, next.alternative ?? 1) : next };
}

/** Heat maps ahead of their answer; older ones than those shown change nothing. */
export function mapped(state: State, maps: MapsAction): State {
  const { placing } = state;
  if (placing === null || maps.ask !== placing.ask) return state;
  const { heatMaps, ask, revision } = maps;
  if (placing.mapsOf?.ask === ask && revision < placing.mapsOf.revision) return state;
  return { ...state, placing: { ...placing, heatMaps, mapsOf: { ask, revision } } };
}

/** Whether the server knew, when it answered, all that it knows and is to know now. */
function isUpToDate(answer: Answer, connection: Connection): boolean {
  return answer.revision >= connection.revision && connection.unsent === 0;
}

/** With nothing left to send, an answer to what the server holds is the newest there will be. */
export function caughtUp(state: State): State {
  const { placing, connection } = state;
  if (placing === null || placing.answer === null) return state;
  if (placing.answer.ask !== placing.ask) return state;
  if (!placing.computing || !isUpToDate(placing.answer, connection)) return state;
  return { ...state, placing: { ...placing, computing: false } };
}

/** What the server says of a pose of the ghost, which may have been dragged on since. */
export function inspected(state: State, value: Inspected, pose: Pose): State {
  const { placing } = state;
  if (placing === null || value.ask !== placing.ask || placing.alternative !== null) return state;
  return { ...state, placing: { ...placing, inspected: value, inspectedPose: pose } };
}

/** The server cannot answer the ask: what it said of the one before is no longer good. */
export function askRefused(state: State, text: string): State {
  const { placing } = state;
  if (placing === null) return state;
  const bare = {
    answer: null,
    heatMaps: [],
    mapsOf: null,
    inspected: null,
    inspectedPose: null,
    weigh: null,
  };
  return { ...state, placing: { ...placing, ...bare, computing: false, problem: text } };
}

/** The question again under a new id: what the old one had is no longer good. */
export function askAgain(state: State): State {
  if (state.placing === null) return state;
  const placing = {
    ...state.placing,
    ask: `ask-${state.nextId}`,
    computing: true,
    problem: null,
    weigh: null,
  };
  return { ...state, placing, nextId: state.nextId + 1 };
}

/** The ghost in another room: nothing that was said of the last one is true of this one. */
export function inAnotherRoom(state: State): State {
  if (state.placing === null) return state;
  const next = askAgain(state);
  const { placing, scene } = next;
  if (placing === null) return next;
  const middle = middleOf(scene.room.corners);
  const byHand = placing.mode === "manual";
  const pose = byHand ? poseAt(scene, placing.category, placing.size, middle) : null;
  const alternative = byHand ? null : 1;
  const bare = { answer: null, heatMaps: [], mapsOf: null, inspected: null, inspectedPose: null };
  return { ...next, placing: { ...placing, ...bare, pose, alternative } };
}

function middleOf(corners: readonly Point[]): Point {
  const xs = corners.map(([x]) => x);
  const ys = corners.map(([, y]) => y);
  const middle = (values: readonly number[]): number =>
    (Math.min(...values) + Math.max(...values)) / 2;
  return [middle(xs), middle(ys)];
}
