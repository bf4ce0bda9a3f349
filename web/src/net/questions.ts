/**
 * What the server is asked, as a pure value: the object that is being placed, the pose that its
 * ghost was dragged to (one at a time, the newest wins), and whether the graph is watched.
 */
import type { Placing, Pose, State } from "../model/state";
import type {
  Answer,
  Ask,
  Inspect,
  Inspected,
  ModelName,
  Query,
  WatchGraph,
  WhatMatters,
} from "./protocol.gen";

export type Question = Ask | Inspect | WhatMatters | WatchGraph;

/** Alternatives that are asked for. */
const COUNT = 5;

export interface Questions {
  /** The ask in force; null when nothing is being placed. */
  readonly ask: string | null;
  /** The pose that was inspected last, and the answer that it was compared with. */
  readonly pose: Pose | null;
  readonly against: Answer | null;
  /** The inspection that is on its way. */
  readonly inspecting: string | null;
  /** What is being found out about what matters most. */
  readonly weighing: string | null;
  readonly watching: boolean;
  readonly nextInspection: number;
}

/** Nothing is asked: so it is on a new socket. */
export const NO_QUESTIONS: Questions = {
  ask: null,
  pose: null,
  against: null,
  inspecting: null,
  weighing: null,
  watching: false,
  nextInspection: 1,
};

export interface Asked {
  readonly questions: Questions;
  readonly messages: readonly Question[];
}

/** What to ask now that the state is this. */
export function askedOf(questions: Questions, state: State): Asked {
  const { placing, shown } = state;
  const messages: Question[] = [];
  let next = questions;
  if ((placing?.ask ?? null) !== next.ask) {
    messages.push(askFor(state, next.ask));
    const asked = { pose: null, against: null, inspecting: null, weighing: null };
    next = { ...next, ...asked, ask: placing?.ask ?? null };
  }
  const weighing = openQuestion(placing);
  if (weighing !== next.weighing) {
    const over = placing?.weigh?.id === next.weighing;
    if (weighing !== null) messages.push({ type: "what_matters", id: weighing, on: true });
    else if (!over) messages.push({ type: "what_matters", id: next.weighing ?? "", on: false });
    next = { ...next, weighing };
  }
  if (placing !== null && isToInspect(next, placing)) {
    const { pose, answer } = placing;
    const id = `inspect-${next.nextInspection}`;
    messages.push({ type: "inspect", id, center: pose.center, heading: pose.heading });
    const nextInspection = next.nextInspection + 1;
    next = { ...next, pose, against: answer, inspecting: id, nextInspection };
  }
  if (shown.graph !== next.watching) {
    messages.push({ type: "watch_graph", on: shown.graph });
    next = { ...next, watching: shown.graph };
  }
  return { questions: next, messages };
}

/** The pose that an inspection is about; null if it is no longer waited for. */
export function poseInspected(questions: Questions, { id }: Inspected): Pose | null {
  return questions.inspecting === id ? questions.pose : null;
}

/** The inspection that was on its way is over: the next pose may be asked about. */
export function inspectionDone(questions: Questions): Questions {
  return { ...questions, inspecting: null };
}

/**
 * Whoever put the ghost where no alternative stands, may it stand there? A newer answer makes an
 * inspection that is on its way worthless, so it is not waited for.
 */
function isToInspect(
  questions: Questions,
  placing: Placing,
): placing is Placing & { readonly pose: Pose } {
  const { alternative, pose, answer, ask, computing } = placing;
  const known = answer?.ask === ask && !computing;
  if (alternative !== null || pose === null || !known) return false;
  if (placing.answer !== questions.against) return true;
  return questions.inspecting === null && placing.pose !== questions.pose;
}

/** What the person wants to know of what matters, as long as it is not known. */
function openQuestion(placing: Placing | null): string | null {
  const weigh = placing?.weigh ?? null;
  return weigh === null || weigh.result !== null ? null : weigh.id;
}

function askFor({ placing, model }: State, last: string | null): Ask {
  if (placing === null) return { type: "ask", id: last ?? "none", query: null };
  return { type: "ask", id: placing.ask, query: queryOf(placing, model) };
}

/** The question of an object on its way. */
export function queryOf(placing: Placing, model: ModelName): Query {
  const { category, wishedSize, item, relaxed } = placing;
  return { category, size: wishedSize, item, model, count: COUNT, relaxed };
}
