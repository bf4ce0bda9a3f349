import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import { MAX_STEPS } from "../../../web/src/model/history";
import type { State } from "../../../web/src/model/state";
import { begin, box, play } from "../rooms";

const table = box("table");
const at = (x: number, done: boolean): Action => ({
  type: "edit-box",
  box: { ...table, center: [x, 2, 0.4] },
  done,
});
const whereIsIt = (state: State): number | undefined => state.scene.boxes[0]?.center[0];

describe("undo and redo", () => {
  test("a drag is one step, however many moves it has", () => {
    const dragged = play(begin([table]), at(3, false), at(3.5, false), at(4, true));
    expect(dragged.past).toHaveLength(1);
    expect(whereIsIt(play(dragged, { type: "undo" }))).toBe(2.5);
  });

  test("two drags are two steps", () => {
    const dragged = play(begin([table]), at(3, false), at(3, true), at(4, false), at(4, true));
    const once = play(dragged, { type: "undo" });
    expect(whereIsIt(once)).toBe(3);
    expect(whereIsIt(play(once, { type: "undo" }))).toBe(2.5);
  });

  test("what was undone is redone", () => {
    const undone = play(begin([table]), at(4, true), { type: "undo" });
    expect(whereIsIt(play(undone, { type: "redo" }))).toBe(4);
  });

  test("another edit makes what was undone unreachable", () => {
    const branched = play(begin([table]), at(4, true), { type: "undo" }, at(1, true));
    expect(whereIsIt(play(branched, { type: "redo" }))).toBe(1);
  });

  test("undo in the middle of a drag goes back to where the drag began", () => {
    const undone = play(begin([table]), at(3, true), at(4, false), { type: "undo" });
    expect(whereIsIt(undone)).toBe(3);
    expect(undone.past).toHaveLength(1);
  });

  test("with nothing to undo or redo nothing changes", () => {
    const state = play(begin([table]), { type: "touched" });
    expect(play(state, { type: "undo" }, { type: "redo" })).toBe(state);
  });

  test("the oldest steps are forgotten", () => {
    const many = Array.from({ length: MAX_STEPS + 20 }, (_, i) => at(1 + i / 1000, true));
    expect(play(begin([table]), ...many).past).toHaveLength(MAX_STEPS);
  });

  test("opening a scene is a step too", () => {
    const other = { ...begin().scene, id: "other" };
    const opened = play(begin([table]), { type: "open-scene", scene: other });
    expect(opened.scene).toBe(other);
    expect(play(opened, { type: "undo" }).scene.boxes).toEqual([table]);
  });
});

test("scenes of files without an id get one each", () => {
  const nameless: Action = { type: "open-scene", scene: { ...begin().scene, id: "" } };
  const first = play(begin(), nameless);
  expect(first.scene.id).not.toBe("");
  expect(play(first, nameless).scene.id).not.toBe(first.scene.id);
});

describe("selection", () => {
  const selected: Action = { type: "select", selection: { kind: "box", id: "table" } };

  test("undoing the drawing of a box deselects it", () => {
    const drawn = play(begin(), at(3, true), selected);
    expect(drawn.selection).toEqual({ kind: "box", id: "table" });
    expect(play(drawn, { type: "undo" }).selection).toBeNull();
  });

  test("opening a scene without it deselects it", () => {
    const other = { ...begin().scene, id: "other" };
    const opened = play(begin([table]), selected, { type: "open-scene", scene: other });
    expect(opened.selection).toBeNull();
  });

  test("what is not there cannot be selected", () => {
    expect(play(begin(), selected).selection).toBeNull();
    const corner: Action = { type: "select", selection: { kind: "corner", index: 4 } };
    expect(play(begin(), corner).selection).toBeNull();
  });

  test("it goes round all boxes, then doors and windows", () => {
    const door = { id: "door-1", start: [1, 0], end: [2, 0], bottom: 0, top: 2 } as const;
    const next: Action = { type: "cycle-selection", by: 1 };
    const state = play(begin([table, box("chair")]), {
      type: "edit-opening",
      opening: "door",
      value: door,
      done: true,
    });
    const seen = [1, 2, 3, 4].map((steps) => play(state, ...Array(steps).fill(next)).selection);
    expect(seen).toEqual([
      { kind: "box", id: "table" },
      { kind: "box", id: "chair" },
      { kind: "door", id: "door-1" },
      { kind: "box", id: "table" },
    ]);
  });

  test("backwards it begins with the last", () => {
    const back: Action = { type: "cycle-selection", by: -1 };
    const state = begin([table, box("chair")]);
    expect(play(state, back).selection).toEqual({ kind: "box", id: "chair" });
    expect(play(state, back, back).selection).toEqual({ kind: "box", id: "table" });
  });

  test("in an empty room there is nothing to go round", () => {
    expect(play(begin(), { type: "cycle-selection", by: 1 }).selection).toBeNull();
  });
});
