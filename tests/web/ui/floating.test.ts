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
  const selected = play(inAr(begin([box("a")])), {
    type: "select",
    selection: { kind: "box", id: "a" },
  });
  const typing = panel(selected, "Depth 80").state;
  for (const state of [...states, ...placing, ...marking, selected, typing]) {
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

test("a name that the sentence says already is not said twice", () => {
  const asked = panel(inAr(begin()), "Sofa").state;
  const place = placement(1, { name: "facing east", sentence: "By the wall, facing east" });
  const reply = answer(asked.placing?.ask ?? "", 1, { placements: [place] });
  const told = play(asked, { type: "answer", answer: reply });
  expect(panel(told).title).toBe("By the wall, facing east.");
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

test("the width of what is placed is typed in centimetres", () => {
  const asked = panel(inAr(begin()), "Sofa").state;
  const [depth = 0, , height = 0] = asked.placing?.size ?? [];
  const open = panel(asked, labelOf(asked, "Width"));
  expect(open.title).toBe("Width: type it in centimetres.");
  expect(panel(open.state, "2", "1", "5", "Back", "4").title).toBe("Width: 214 cm");
  const typed = panel(open.state, "2", "1", "4", "OK");
  expect(typed.state.placing?.size).toEqual([depth, 2.14, height]);
  expect(typed.labels).toContain("Width 214");
  expect(typed.labels).toContain("Place it");
});

test("the height of a selected thing is typed, and its underside stays", () => {
  const state = play(inAr(begin([box("a")])), {
    type: "select",
    selection: { kind: "box", id: "a" },
  });
  expect(panel(state).labels).toEqual([
    ...panel(state).labels.slice(0, 4),
    ...["Depth 80", "Width 120", "Height 80"],
    ...["Turn left", "Turn right", "Remove", "Undo", "Done"],
  ]);
  const typed = panel(state, "Height 80", "9", "0", "OK").state;
  expect(typed.scene.boxes[0]).toMatchObject({ size: [0.8, 1.2, 0.9], center: [2.5, 2, 0.45] });
  expect(panel(typed, "Turn left").state.scene.boxes[0]?.heading).toBeCloseTo(Math.PI / 12, 12);
  expect(panel(typed, "Remove").state.scene.boxes).toEqual([]);
  expect(panel(typed, "Done").labels).toContain("Sofa");
});

test("a length that nothing can have is refused with a sentence, and can be typed again", () => {
  const asked = panel(inAr(begin()), "Sofa").state;
  const nothing = panel(asked, labelOf(asked, "Depth"), "0", "OK");
  expect(nothing.title).toBe("At least 1 cm.");
  expect(panel(nothing.state, "OK").title).toBe("Depth: 0 cm");
  const left = panel(nothing.state, "OK", "Cancel");
  expect(left.state.placing?.size).toEqual(asked.placing?.size);
  expect(left.labels).toContain("Place it");
});

test("what is typed is for the thing that it was begun for", () => {
  const both = inAr(begin([box("a"), box("b", { center: [1, 1, 0.4] })]));
  const choose = (id: string) => ({ type: "select", selection: { kind: "box", id } }) as const;
  const typing = panel(play(both, choose("a")), "Width 120", "2").state;
  const other = panel(play(typing, choose("b")));
  expect(other.labels).toContain("Width 120");
  expect(other.labels).not.toContain("OK");
});

test("OK without a digit asks for one", () => {
  const asked = panel(inAr(begin()), "Sofa").state;
  expect(panel(asked, labelOf(asked, "Width"), "OK").title).toBe("Type a number first.");
});

test("no more digits are taken than a length has", () => {
  const asked = panel(inAr(begin()), "Sofa").state;
  expect(panel(asked, labelOf(asked, "Depth"), "1", "2", "3", "4", "5").title).toBe(
    "Depth: 1234 cm",
  );
});

/** "Width 200": the button that begins so. */
function labelOf(state: State, name: string): string {
  return panel(state).labels.find((label) => label.startsWith(name)) ?? "";
}

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
