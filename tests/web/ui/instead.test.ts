import { describe, expect, test } from "vitest";
import type { State } from "../../../web/src/model/state";
import type { Inspected, Remedy } from "../../../web/src/net/protocol.gen";
import { planUrl } from "../../../web/src/ui/known_rooms";
import { decision, placePanel } from "../../../web/src/ui/place";
import { reasonsPanel } from "../../../web/src/ui/reasons";
import { stepper } from "../../../web/src/ui/stepper";
import { answer, begin, box, play } from "../rooms";
import { sitDown, wordsOf } from "./desk";

const asking = play(
  begin([box("tv", { center: [0.5, 3.5, 0.3] })]),
  { type: "connection", connection: { status: "online" } },
  { type: "place", category: "Sofa", item: null, size: null, mode: "scenegen", view: [2, 2] },
);
const ask = asking.placing?.ask ?? "";
const offered = play(asking, { type: "answer", answer: answer(ask, 0) });
const HERE = { center: [3, 1, 0.4], heading: 0 } as const;
const THERE = { center: [3.3, 1, 0.4], heading: 0 } as const;

function inspected(change: Partial<Inspected>): State {
  const dragged = play(offered, { type: "drag-ghost", pose: HERE, done: true });
  const said: Inspected = {
    type: "inspected",
    id: "i",
    ask,
    revision: 0,
    allowed: true,
    rule: "",
    score: -1,
    likelihood: 0.2,
    sentence: "Out in the room",
    reasons: [],
    costs: [],
    elsewhere: null,
    ...change,
  };
  const pose = dragged.placing?.pose ?? HERE;
  return play(dragged, { type: "inspected", inspected: said, pose });
}

describe("why not here", () => {
  const elsewhere = {
    ...THERE,
    distance: 0.3,
    text: "30 cm further from the door",
    sentence: "By the window",
  };

  test("where it may not stand: the nearest place is one tap away", () => {
    const state = inspected({ allowed: false, sentence: "It blocks the door.", elsewhere });
    const words = wordsOf(decision(sitDown(state).page));
    expect(words).toMatch(/It blocks the door\. .*Move it 30 cm further from the door/);
  });

  test("where it may stand: what costs most, here and at the best place", () => {
    const cost = {
      relation: "Neighbor",
      group: "TV",
      difference: -2,
      here: "its back to the TV",
      best: "2 m in front of the TV",
    };
    const words = wordsOf(reasonsPanel(sitDown(inspected({ costs: [cost], elsewhere })).page));
    expect(words).toContain("Why not here? Neighbors · TV Its back to the TV");
    expect(words).toContain("Best place: 2 m in front of the TV");
    expect(words).toMatch(/Better: 30 cm further from the door \. By the window/);
  });

  test("on a small screen one tap leads there", () => {
    const cost = { relation: "Neighbor", group: "TV", difference: -2, here: "far", best: "near" };
    const small = (state: State): string => {
      if (state.placing === null) throw new Error("Nothing is being placed.");
      return wordsOf(stepper(sitDown(state).page, state.placing));
    };
    expect(small(inspected({ costs: [cost] }))).toMatch(/Your own place .*Why not here\?$/);
    expect(small(inspected({}))).toMatch(/Why here\?$/);
    expect(small(offered)).toMatch(/1 of 2 · At the wall Against the wall\. Why here\?$/);
    expect(small(inspected({ allowed: false }))).not.toContain("here?");
  });

  test("a place as good as the best costs nothing", () => {
    expect(wordsOf(reasonsPanel(sitDown(inspected({})).page))).toContain("No place is better.");
  });

  test("what was said of a place that the ghost has left is not said of the next", () => {
    const state = inspected({ allowed: false, sentence: "It blocks the door.", elsewhere });
    const moved = play(state, { type: "nudge", by: [1, 0] });
    expect(wordsOf(decision(sitDown(moved).page))).not.toContain("Move it");
  });
});

describe("no good place", () => {
  const remedy = (change: Partial<Remedy>): State => {
    const found: Remedy = {
      kind: "size",
      text: "One that is 10 % smaller would fit.",
      ...HERE,
      size: null,
      box: null,
      rule: null,
      ...change,
    };
    const none = { rule: "room", text: "No good place for a sofa.", remedy: found };
    const value = answer(ask, 0, { placements: [], no_good_place: none });
    return play(asking, { type: "answer", answer: value });
  };

  test.each([
    [{ kind: "size", size: [0.8, 1.8, 0.8] } as const, "Use that size"],
    [{ kind: "box", box: "tv" } as const, "Take it away"],
    [{ kind: "rule", rule: "window" } as const, "I can live with that"],
  ])("offers what would give one: %o", (change, label) => {
    const words = wordsOf(placePanel(sitDown(remedy(change)).page));
    expect(words).toMatch(new RegExp(`No good place for a sofa\\. .*would fit\\. .*${label}`));
  });
});

test("the model that decides can be chosen where places are found", () => {
  expect(wordsOf(placePanel(sitDown(offered).page))).toMatch(
    /How it decides SceneGen .*The paper's model compares distances/,
  );
});

test("what matters most is asked for, searched, and told", () => {
  const words = (state: State): string => wordsOf(reasonsPanel(sitDown(state).page));
  expect(words(offered)).toContain("What matters most?");
  const wondering = play(offered, { type: "what-matters", on: true });
  const id = wondering.placing?.weigh?.id ?? "";
  const on = play(wondering, {
    type: "weighing",
    weighing: { type: "weighing", id, done: 2, total: 8 },
  });
  expect(words(on)).toContain("Looking for the place without each thing… 3 of 8");
  const nothing = play(on, {
    type: "matters",
    matters: { type: "matters", id, ask, revision: 0, found: null },
  });
  expect(words(nothing)).toContain("No single thing matters");
});

test("the address of a plan keeps the slashes of the room's id and nothing else", () => {
  expect(planUrl("ithor:Plan 1/a?b", "TV")).toBe(
    "/knowledge/rooms/ithor%3APlan%201/a%3Fb.svg?category=TV",
  );
});
