import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { State } from "../../../web/src/model/state";
import type { Counterfactual, Matters } from "../../../web/src/net/protocol.gen";
import { answer, begin, box, play } from "../rooms";

const place: Action = {
  type: "place",
  category: "Sofa",
  item: null,
  size: null,
  mode: "scenegen",
  view: [2, 2],
};
const asking = play(begin([box("tv")]), place);
const askOf = (state: State): string => state.placing?.ask ?? "";
const offered = play(asking, { type: "answer", answer: answer(askOf(asking), 0) });
const FOUND: Counterfactual = {
  box: "tv",
  center: [4, 3, 0.4],
  heading: 0,
  text: "Without the TV it would go by the window.",
  moved: 2.5,
  turned: 0,
  score_change: -1,
};
const wondering = play(offered, { type: "what-matters", on: true });
const idOf = (state: State): string => state.placing?.weigh?.id ?? "";
const matters = (id: string, found: Counterfactual | null): Matters => ({
  type: "matters",
  id,
  ask: askOf(offered),
  revision: 0,
  found,
});

describe("another model", () => {
  test("is another question about the same object", () => {
    const other = play(offered, { type: "choose-model", model: "paper" });
    expect(other.model).toBe("paper");
    expect(askOf(other)).not.toBe(askOf(offered));
    expect(other.placing).toMatchObject({ category: "Sofa", computing: true });
  });

  test("stays for the next object, and choosing it again asks nothing", () => {
    const chosen = play(begin(), { type: "choose-model", model: "paper" }, place);
    expect(chosen.model).toBe("paper");
    expect(play(chosen, { type: "choose-model", model: "paper" })).toEqual(chosen);
  });
});

describe("a rule that one can live without", () => {
  test("counts no more for this object, and counts again for the next", () => {
    const relaxed = play(offered, { type: "relax", rule: "window" });
    expect(relaxed.placing?.relaxed).toEqual(["window"]);
    expect(askOf(relaxed)).not.toBe(askOf(offered));
    expect(play(relaxed, { type: "cancel" }, place).placing?.relaxed).toEqual([]);
  });
});

describe("what matters most", () => {
  test("is waited for, with how far the search has come", () => {
    const on = play(wondering, {
      type: "weighing",
      weighing: { type: "weighing", id: idOf(wondering), done: 3, total: 8 },
    });
    expect(on.placing?.weigh).toMatchObject({ done: 3, total: 8, result: null });
  });

  test("is selected when it is found, so that it is seen", () => {
    const told = play(wondering, { type: "matters", matters: matters(idOf(wondering), FOUND) });
    expect(told.selection).toEqual({ kind: "box", id: "tv" });
    expect(told.placing?.weigh?.result?.found).toEqual(FOUND);
  });

  test("of an older question is not heard", () => {
    const again = play(wondering, { type: "what-matters", on: true });
    const told = play(again, { type: "matters", matters: matters(idOf(wondering), FOUND) });
    expect(told).toEqual(again);
  });

  test("is no more what was asked once the room has changed", () => {
    const without = play(wondering, { type: "remove-box", id: "tv" });
    expect(without.placing?.weigh).toBeNull();
    expect(without.placing?.computing).toBe(true);
  });

  test("when it is taken away it can be put back", () => {
    const without = play(offered, { type: "remove-box", id: "tv" });
    expect(without.scene.boxes).toEqual([]);
    expect(play(without, { type: "undo" }).scene.boxes).toEqual(offered.scene.boxes);
  });
});
