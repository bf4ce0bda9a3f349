/** What came over the socket, as far as it is not about the object on its way. */
import type { Graph, SceneRecord } from "../net/protocol.gen";
import { askAgain, caughtUp } from "./answers";
import type { Connection, State } from "./state";

/**
 * In another session revisions start anew, so what is pending is asked again; once the connection is
 * back, what was said could not be done without it is old news.
 */
export function connected(state: State, change: Partial<Connection>): State {
  const keys = Object.keys(change) as (keyof Connection)[];
  if (keys.every((key) => change[key] === state.connection[key])) return state;
  const next = { ...state, connection: { ...state.connection, ...change } };
  const back = change.status === "online" && state.connection.status === "offline";
  const told = { ...next, notice: back ? null : next.notice };
  const moved = next.connection.session !== state.connection.session;
  return moved ? askAgain({ ...told, graph: null }) : caughtUp(told);
}

/** The room of a session that was begun on another device: there is nothing to undo in it. */
export function resumed(state: State, scene: SceneRecord): State {
  return { ...state, scene, past: [], future: [], beforeDrag: null, draft: null };
}

/** Models of boxes that are there; those that the server has not heard of yet stay. */
export function modelled(state: State, boxes: Readonly<Record<string, string>>): State {
  const ids = new Set(state.scene.boxes.map(({ id }) => id));
  const known = Object.entries({ ...state.models, ...boxes }).filter(([id]) => ids.has(id));
  return { ...state, models: Object.fromEntries(known) };
}

export function graphed(state: State, graph: Graph): State {
  if (state.graph !== null && graph.revision < state.graph.revision) return state;
  return { ...state, graph };
}
