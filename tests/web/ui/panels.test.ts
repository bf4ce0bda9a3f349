import { describe, expect, test } from "vitest";
import type { State } from "../../../web/src/model/state";
import type { Reason } from "../../../web/src/net/protocol.gen";
import { connectionInWords } from "../../../web/src/ui/header";
import { hint } from "../../../web/src/ui/hints";
import { decision, placePanel } from "../../../web/src/ui/place";
import { reasonsPanel } from "../../../web/src/ui/reasons";
import { selectionPanel } from "../../../web/src/ui/selection";
import { situation } from "../../../web/src/ui/situation";
import { answer, begin, box, placement, play } from "../rooms";
import { sitDown, wordsOf } from "./desk";

const online = (state: State): State =>
  play(state, { type: "connection", connection: { status: "online" } });

function asked(mode: "manual" | "scenegen" = "scenegen"): State {
  return play(online(begin()), {
    type: "place",
    category: "Sofa",
    item: null,
    size: null,
    mode,
    view: [2, 2],
  });
}

function answeredWith(change: Parameters<typeof answer>[2]): State {
  const state = asked();
  const value = answer(state.placing?.ask ?? "", 0, change);
  return play(state, { type: "answer", answer: value });
}

const reason = (text: string, contribution: number): Reason => ({
  relation: "Facing",
  group: "TV",
  contribution,
  text,
});

const panelOf = (state: State): string => wordsOf(placePanel(sitDown(state).page));

describe("the place panel", () => {
  test("says that it is looking while there is no answer", () => {
    expect(panelOf(asked())).toContain("Looking for good places…");
  });

  test("says when places will come while there is no connection", () => {
    const state = play(asked(), { type: "connection", connection: { status: "offline" } });
    expect(panelOf(state)).toContain("Good places come when the connection is back.");
  });

  test("lists the places with their numbers", () => {
    const words = panelOf(
      answeredWith({
        placements: [
          placement(1, { name: "at the wall", sentence: "By the wall." }),
          placement(2, { name: "opposite the TV", sentence: "By the TV." }),
        ],
      }),
    );
    expect(words).toMatch(/1 At the wall By the wall\. 2 Opposite the TV By the TV\./);
  });

  test("says which rule leaves no place, and what to try", () => {
    const words = panelOf(
      answeredWith({
        placements: [],
        no_good_place: { rule: "wall", text: "No free wall is wide enough.", remedy: null },
      }),
    );
    expect(words).toContain(
      "No free wall is wide enough. Or put it where you want it: choose Manual.",
    );
  });

  test("has no list of places in Manual", () => {
    expect(panelOf(asked("manual"))).toContain("Drag it to where you want it.");
  });
});

describe("the reasons", () => {
  const reasons = [
    reason("weak", 0.1),
    reason("against", -2),
    reason("for", 1),
    reason("weaker", -0.05),
    reason("least", 0.01),
  ];
  const state = answeredWith({
    placements: [placement(1, { reasons, score: -0.94, rooms: ["Flat 3", "Flat 7"] })],
  });
  const words = wordsOf(reasonsPanel(sitDown(state).page));

  const inNumbers = (): string => {
    const desk = sitDown(state);
    desk.page.change({ numbers: true });
    return wordsOf(reasonsPanel(desk.page));
  };

  test("come strongest first, in words, for or against", () => {
    expect(words).toMatch(/Against Facing · TV strongly against For Facing · TV for Weak/);
    expect(words).not.toMatch(/[+−]\d/);
  });

  test("come with their numbers on demand", () => {
    expect(inNumbers()).toMatch(/Against Facing · TV −2\.00 For Facing · TV \+1\.00 Weak/);
  });

  test("hide the weakest behind a click that says how many there are", () => {
    expect(words).toMatch(/Weaker .* Show all 5 Least/);
  });

  test("give the total and the rooms that speak for it", () => {
    expect(inNumbers()).toContain("All together, against an average spot −0.94");
    expect(words).toMatch(/Rooms that speak for it .* Flat 3 Flat 7/);
  });

  test("give way to why not, at the button, where it may not stand", () => {
    const dragged = play(state, {
      type: "drag-ghost",
      pose: { center: [1, 1, 0.4], heading: 0 },
      done: true,
    });
    const inspected = play(dragged, {
      type: "inspected",
      pose: { center: [1, 1, 0.4], heading: 0 },
      inspected: {
        type: "inspected",
        id: "i",
        ask: dragged.placing?.ask ?? "",
        revision: 0,
        allowed: false,
        score: null,
        likelihood: null,
        sentence: "It blocks the door",
        reasons: [],
        rule: "",
        costs: [],
        elsewhere: null,
      },
    });
    const { page } = sitDown(inspected);
    expect(wordsOf(reasonsPanel(page))).toBe("");
    expect(wordsOf(decision(page))).toContain("It blocks the door");
    expect(hint(inspected)).toBe("Drag it to where it can stand.");
  });
});

describe("the selection", () => {
  test("of a box offers what it could be, the likely one first", () => {
    const bed = box("a", { size: [2, 1.6, 0.5], category: "Other" });
    const state = play(begin([bed]), { type: "select", selection: { kind: "box", id: "a" } });
    expect(wordsOf(selectionPanel(sitDown(state).page))).toMatch(/What is it\? Bed /);
  });

  test("of a placed thing does not ask what it is", () => {
    const sofa = box("a", { category: "Sofa", placed: true });
    const state = play(begin([sofa]), { type: "select", selection: { kind: "box", id: "a" } });
    expect(wordsOf(selectionPanel(sitDown(state).page))).not.toContain("What is it?");
  });
});

describe("one sentence says what to do next", () => {
  test.each([
    ["room", "Mark the first corner of the room."],
    ["box", "Drag on the floor to draw what stands there."],
    ["door", "Drag along a wall where the door is."],
    ["window", "Drag along a wall where the window is."],
  ] as const)("with the %s tool: %s", (tool, sentence) => {
    expect(hint(play(begin(), { type: "choose-tool", tool }))).toBe(sentence);
  });

  test("nothing is said when nothing is begun", () => {
    expect(hint(begin())).toBeNull();
  });
});

describe("the states of the page", () => {
  const over = (state: State): string => wordsOf(situation(sitDown(state).page));

  test("an empty room says what to do with it", () => {
    expect(over(online(begin()))).toContain("An empty room. Draw what stands in it");
  });

  test("an empty room makes way for the tool in hand", () => {
    expect(over(play(online(begin()), { type: "choose-tool", tool: "box" }))).toBe("");
  });

  test("offline says that one can go on", () => {
    const gone = play(begin(), { type: "connection", connection: { status: "offline" } });
    expect(over(gone)).toBe("Offline. You can go on; I'll catch up.");
  });

  test("a furnished room online needs no words", () => {
    expect(over(online(begin([box("a")])))).toBe("");
  });
});

test("the connection says what waits", () => {
  const at = { session: null, revision: 0, ended: null };
  expect(connectionInWords({ ...at, status: "offline", unsent: 3 })).toBe(
    "Offline, 3 changes waiting",
  );
  expect(connectionInWords({ ...at, status: "online", unsent: 0 })).toBe("Connected");
});
