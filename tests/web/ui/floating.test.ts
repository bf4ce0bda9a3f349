import { expect, test } from "vitest";
import type { PanelButton } from "../../../web/src/contract";
import type { Action } from "../../../web/src/model/actions";
import type { State } from "../../../web/src/model/state";
import { floating } from "../../../web/src/ui/floating";
import { NO_AR } from "../no_ar";
import { answer, begin, box, placement, play } from "../rooms";

const inAr = (state: State): State =>
  play(
    state,
    { type: "enter-ar", room: "new", granted: [] },
    { type: "change-ar", change: { step: "ready" } },
  );

/** The labels on the panel, and the state after pressing some of them in order. */
function panel(state: State, ...labels: readonly string[]) {
  let now = state;
  const content = () =>
    floating({
      state: now,
      ar: NO_AR,
      dispatch: (action: Action) => {
        now = play(now, action);
      },
      viewPoint: () => [1, 1],
    });
  const buttons = (): readonly PanelButton[] => content().rows.flat();
  for (const label of labels)
    buttons()
      .find((button) => button.label === label)
      ?.run();
  return { state: now, title: content().title, labels: buttons().map(({ label }) => label) };
}

test("no row has more than five buttons, and there are no more than three rows", () => {
  const states = [begin(), begin([box("a")])].map(inAr);
  const placing = states.map((state) => panel(state, "Sofa").state);
  const marking = states.map((state) => panel(state, "Mark a thing").state);
  for (const state of [...states, ...placing, ...marking]) {
    const { rows } = floating({ state, ar: NO_AR, dispatch: () => {}, viewPoint: () => [0, 0] });
    expect(rows.length).toBeLessThanOrEqual(3);
    for (const row of rows) expect(row.length).toBeLessThanOrEqual(5);
  }
});

test("a sofa is placed on the second of the places, with its name and reason as the sentence", () => {
  const asked = panel(inAr(begin()), "Sofa").state;
  const told = play(asked, {
    type: "answer",
    answer: answer(asked.placing?.ask ?? "", 1, {
      placements: [
        placement(1),
        placement(2, { center: [4, 3, 0.4], name: "Near the TV", sentence: "By the window" }),
      ],
    }),
  });
  const shown = panel(told, "2");
  expect(shown.title).toBe("Near the TV: By the window.");
  const placed = panel(shown.state, "Place it").state;
  expect(placed.scene.boxes[0]?.center).toEqual([4, 3, 0.4]);
});

test("what goes wrong is said until it was read", () => {
  const wrong = play(inAr(begin()), { type: "notify", tone: "problem", text: "Too thin." });
  expect(panel(wrong)).toMatchObject({ title: "Too thin.", labels: ["OK"] });
  expect(panel(wrong, "OK").labels).toContain("Sofa");
});

test("a device that can look round the room is asked to while nothing is marked in it", () => {
  const able = play(begin(), { type: "enter-ar", room: "new", granted: ["room-capture"] });
  const ready = play(able, { type: "change-ar", change: { step: "ready" } });
  expect(panel(ready).labels).toContain("Scan");
  const marked = play(ready, { type: "edit-box", box: box("a"), done: true });
  expect(panel(marked).labels).not.toContain("Scan");
  expect(panel(marked).labels).toContain("Outline");
  expect(panel(inAr(begin())).labels).not.toContain("Scan");
});

test("doors are put in from the panel too", () => {
  expect(panel(inAr(begin()), "Door").state.tool).toBe("door");
});

test("pieces that the device knows are used, kept and dropped", () => {
  const found = play(inAr(begin()), {
    type: "change-ar",
    change: {
      found: { corners: null, doors: [], windows: [], boxes: [box("box-1"), box("box-2")] },
    },
  });
  expect(panel(found).title).toContain("2 pieces found");
  const checked = panel(found, "Use them", "Keep", "Drop").state;
  expect(checked.scene.boxes.map(({ id }) => id)).toEqual(["box-1"]);
});
