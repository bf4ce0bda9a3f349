import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { State } from "../../../web/src/model/state";
import {
  askedOf,
  inspectionDone,
  NO_QUESTIONS,
  type Question,
  type Questions,
} from "../../../web/src/net/questions";
import { answer, begin, play } from "../rooms";

const place: Action = {
  type: "place",
  category: "Sofa",
  item: null,
  size: [0.9, 2, 0.8],
  mode: "scenegen",
  view: [2, 2],
};
const drag = (x: number): Action => ({
  type: "drag-ghost",
  pose: { center: [x, 2, 0.4], heading: 0 },
  done: false,
});
const asking = play(begin(), place);
const ask = asking.placing?.ask ?? "";
const offered = play(asking, { type: "answer", answer: answer(ask, 1) });

function questions(start: Questions, ...states: readonly State[]) {
  const messages: Question[] = [];
  let now = start;
  for (const state of states) {
    const step = askedOf(now, state);
    now = step.questions;
    messages.push(...step.messages);
  }
  return { now, messages };
}

describe("asking", () => {
  test("an object on its way is asked about once", () => {
    const { messages } = questions(NO_QUESTIONS, asking, asking, offered);
    expect(messages).toEqual([
      {
        type: "ask",
        id: ask,
        query: {
          category: "Sofa",
          size: [0.9, 2, 0.8],
          item: null,
          model: "scenegen",
          count: 5,
          relaxed: [],
        },
      },
    ]);
  });

  test("when it is let go the asking stops", () => {
    const { messages } = questions(NO_QUESTIONS, asking, play(asking, { type: "cancel" }));
    expect(messages.at(-1)).toEqual({ type: "ask", id: ask, query: null });
  });

  test("another size is asked about under another id", () => {
    const bigger = play(offered, { type: "set-size", size: null });
    const { messages } = questions(NO_QUESTIONS, offered, bigger);
    expect(messages.at(-1)).toMatchObject({ type: "ask", query: { size: null } });
    expect(messages).toHaveLength(2);
  });

  test("changing the mode is no other question", () => {
    const manual = play(offered, { type: "set-mode", mode: "manual", view: [2, 2] });
    const { messages } = questions(NO_QUESTIONS, offered, manual);
    expect(messages.filter(({ type }) => type === "ask")).toHaveLength(1);
  });
});

describe("inspecting a dragged ghost", () => {
  const { now: asked } = questions(NO_QUESTIONS, offered);

  test("one pose at a time is asked about, and then the newest", () => {
    const drags = [1, 1.5, 2].map((x) => play(offered, drag(x)));
    const { now, messages } = questions(asked, ...drags);
    expect(messages).toMatchObject([{ type: "inspect", center: [1, 2, 0.4], heading: 0 }]);
    const next = questions(inspectionDone(now), ...drags.slice(-1));
    expect(next.messages).toMatchObject([{ type: "inspect", center: [2, 2, 0.4] }]);
  });

  test("a pose that was asked about is not asked about again", () => {
    const dragged = play(offered, drag(1));
    const { now } = questions(asked, dragged);
    expect(questions(inspectionDone(now), dragged).messages).toEqual([]);
  });

  test("a newer answer makes it ask again, even while the last is on its way", () => {
    const dragged = play(offered, drag(1));
    const { now } = questions(asked, dragged);
    const newer = play(dragged, { type: "answer", answer: answer(ask, 2) });
    expect(questions(now, newer).messages).toMatchObject([
      { type: "inspect", center: [1, 2, 0.4] },
    ]);
  });

  test("by hand too, the server is asked whether it may stand there", () => {
    const manual = play(offered, { type: "set-mode", mode: "manual", view: [2, 2] }, drag(1));
    expect(questions(asked, manual).messages).toMatchObject([
      { type: "inspect", center: [1, 2, 0.4] },
    ]);
  });

  test("until the ask is answered there is nothing to measure a pose by", () => {
    const manual = play(asking, { type: "set-mode", mode: "manual", view: [2, 2] });
    const { messages } = questions(NO_QUESTIONS, manual);
    expect(messages.map(({ type }) => type)).toEqual(["ask"]);
  });

  test("on an alternative there is nothing to ask", () => {
    expect(questions(asked, play(offered, { type: "show-alternative", rank: 2 })).messages).toEqual(
      [],
    );
  });
});

test("the graph is watched while it is shown", () => {
  const shown = play(begin(), { type: "toggle-layer", layer: "graph" });
  const { messages } = questions(NO_QUESTIONS, begin(), shown, shown, begin());
  expect(messages).toEqual([
    { type: "watch_graph", on: true },
    { type: "watch_graph", on: false },
  ]);
});

describe("asking what matters", () => {
  const { now: asked } = questions(NO_QUESTIONS, offered);
  const wondering = play(offered, { type: "what-matters", on: true });
  const id = wondering.placing?.weigh?.id ?? "";

  test("happens once, and ends by itself when it is known", () => {
    const told = play(wondering, {
      type: "matters",
      matters: { type: "matters", id, ask, revision: 1, found: null },
    });
    const { messages } = questions(asked, wondering, wondering, told);
    expect(messages).toEqual([{ type: "what_matters", id, on: true }]);
  });

  test("stops when nobody wants to know any more", () => {
    const { messages } = questions(
      asked,
      wondering,
      play(wondering, { type: "what-matters", on: false }),
    );
    expect(messages.at(-1)).toEqual({ type: "what_matters", id, on: false });
  });

  test("another model is another question, and the old one ends with its ask", () => {
    const other = play(wondering, { type: "choose-model", model: "paper" });
    const { messages } = questions(asked, wondering, other);
    expect(messages.slice(1)).toMatchObject([{ type: "ask", query: { model: "paper" } }]);
  });
});
