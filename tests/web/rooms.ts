/** Hand-drawn rooms and boxes for the tests. */

import type { Action } from "../../web/src/model/actions";
import { emptyScene, initialState } from "../../web/src/model/initial";
import { reduce } from "../../web/src/model/reduce";
import type { State } from "../../web/src/model/state";
import type { Answer, BoxRecord, Placement, SceneRecord } from "../../web/src/net/protocol.gen";

/** 5 m along x, 4 m along y, corner 0 at the origin. */
export function room(boxes: readonly BoxRecord[] = []): SceneRecord {
  return { ...emptyScene("test-room"), boxes };
}

export function box(id: string, change: Partial<BoxRecord> = {}): BoxRecord {
  return {
    id,
    category: "Table",
    center: [2.5, 2, 0.4],
    size: [0.8, 1.2, 0.8],
    heading: 0,
    ...change,
  };
}

export function begin(boxes: readonly BoxRecord[] = []): State {
  return initialState(room(boxes));
}

export function play(state: State, ...actions: readonly Action[]): State {
  return actions.reduce(reduce, state);
}

export function placement(rank: number, change: Partial<Placement> = {}): Placement {
  return {
    rank,
    center: [1, 1, 0.4],
    heading: 0,
    score: 1,
    likelihood: 1,
    name: "at the wall",
    sentence: "Against the wall.",
    reasons: [],
    rooms: [],
    ...change,
  };
}

export function answer(ask: string, revision: number, change: Partial<Answer> = {}): Answer {
  return {
    type: "answer",
    ask,
    revision,
    category: "Sofa",
    size: [0.9, 2, 0.8],
    asset: "0123456789abcdef0123456789abcdef",
    placements: [placement(1), placement(2, { center: [4, 3, 0.4], heading: Math.PI })],
    no_good_place: null,
    elapsed_ms: 10,
    ...change,
  };
}
