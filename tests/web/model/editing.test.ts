import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { Selection, State } from "../../../web/src/model/state";
import { begin, box, play, room } from "../rooms";

const table = box("table", { size: [0.8, 1.2, 0.8], center: [2.5, 2, 0.4] });
const select = (selection: Selection): Action => ({ type: "select", selection });
const selected = (selection: Selection, state = begin([table])): State =>
  play(state, select(selection));
const onTable = selected({ kind: "box", id: "table" });

describe("boxes", () => {
  test("an arrow key moves the selected box, one step of undo each", () => {
    const moved = play(
      onTable,
      { type: "nudge", by: [0.05, 0] },
      { type: "nudge", by: [0, -0.01] },
    );
    expect(moved.scene.boxes[0]?.center).toEqual([2.55, 1.99, 0.4]);
    expect(moved.past).toHaveLength(2);
  });

  test("with nothing selected an arrow key does nothing", () => {
    const state = play(begin([table]), { type: "touched" });
    expect(play(state, { type: "nudge", by: [1, 0] })).toBe(state);
  });

  test("turning adds to the heading, which stays between −π and π", () => {
    const turned = play(
      onTable,
      { type: "turn", by: Math.PI * 0.75 },
      { type: "turn", by: Math.PI * 0.75 },
    );
    expect(turned.scene.boxes[0]?.heading).toBeCloseTo(-Math.PI / 2, 12);
  });

  test("who turns a box where it stands has said where its front is", () => {
    const guessed = { ...table, front_from_wall: true, front_known: false };
    const state = selected({ kind: "box", id: "table" }, begin([guessed]));
    const turned = play(state, { type: "turn", by: 1 }).scene.boxes[0];
    expect(turned).toMatchObject({ front_from_wall: false, front_known: true });
    const moved = play(state, { type: "nudge", by: [1, 0] }).scene.boxes[0];
    expect(moved).toMatchObject({ front_from_wall: true, front_known: false });
  });

  test("a long drawn box that is called a sofa is wide, its back to the nearer wall", () => {
    const long = box("long", {
      size: [1.8, 0.6, 0.8],
      center: [2.5, 3, 0.4],
      front_from_wall: true,
    });
    const called = (category: string) =>
      play(begin([long]), { type: "edit-box", box: { ...long, category }, done: true }).scene
        .boxes[0];
    // The north wall is at y = 4: the front looks south.
    expect(called("Sofa")).toMatchObject({ size: [0.6, 1.8, 0.8], center: [2.5, 3, 0.4] });
    expect(called("Sofa")?.heading).toBeCloseTo(-Math.PI / 2, 12);
    expect(called("Bed")).toMatchObject({ size: [1.8, 0.6, 0.8], heading: 0 });
    const seen = { ...long, front_from_wall: false };
    const kept = play(begin([seen]), {
      type: "edit-box",
      box: { ...seen, category: "Sofa" },
      done: true,
    });
    expect(kept.scene.boxes[0]?.size).toEqual([1.8, 0.6, 0.8]);
  });

  test("deleting removes the selected box and deselects it", () => {
    const deleted = play(onTable, { type: "delete-selected" });
    expect(deleted.scene.boxes).toEqual([]);
    expect(deleted.selection).toBeNull();
  });

  test("a duplicate stands beside the original, has its own id and is selected", () => {
    const doubled = play(onTable, { type: "duplicate-selected" });
    // Heading 0: beside is along y, 1.2 m of width and 0.1 m of air further.
    expect(doubled.scene.boxes[1]).toEqual({ ...table, id: "box-1", center: [2.5, 3.3, 0.4] });
    expect(doubled.selection).toEqual({ kind: "box", id: "box-1" });
  });

  test("the room takes 500 boxes and refuses one more with a sentence", () => {
    const full = begin(Array.from({ length: 500 }, (_, i) => box(`b${i}`)));
    const more = play(full, { type: "edit-box", box: box("one more"), done: true });
    expect(more.scene).toBe(full.scene);
    expect(more.notice?.text).toContain("500");
  });

  test("the boxes that were not edited are the very same values", () => {
    const chair = box("chair");
    const edited = play(begin([table, chair]), {
      type: "edit-box",
      box: { ...table, label: "desk" },
      done: true,
    });
    expect(edited.scene.boxes[1]).toBe(chair);
    expect(edited.scene.room).toBe(edited.past[0]?.room);
  });
});

describe("corners", () => {
  const corner = (index: number): Selection => ({ kind: "corner", index });

  test("a dragged corner moves", () => {
    const moved = play(begin(), { type: "move-corner", index: 2, to: [6, 5], done: true });
    expect(moved.scene.room.corners[2]).toEqual([6, 5]);
  });

  test("a corner dragged across a wall stays where it last could be, and a sentence says so", () => {
    const dragged = play(
      begin(),
      { type: "move-corner", index: 2, to: [4, 3], done: false },
      { type: "move-corner", index: 2, to: [2, -2], done: false },
    );
    expect(dragged.scene.room.corners[2]).toEqual([4, 3]);
    expect(dragged.notice).toBeNull();
    const dropped = play(dragged, { type: "move-corner", index: 2, to: [2, -2], done: true });
    expect(dropped.scene.room.corners[2]).toEqual([4, 3]);
    expect(dropped.past).toHaveLength(1);
    expect(dropped.notice?.text).toMatch(/cross/);
  });

  test("a corner is taken away, but not from a triangle", () => {
    const triangle = play(begin(), select(corner(2)), { type: "delete-selected" });
    expect(triangle.scene.room.corners).toEqual([
      [0, 0],
      [5, 0],
      [0, 4],
    ]);
    const refused = play(triangle, select(corner(0)), { type: "delete-selected" });
    expect(refused.scene).toBe(triangle.scene);
    expect(refused.notice?.text).toMatch(/three corners/);
  });

  test("a nudged corner moves by the nudge", () => {
    const nudged = play(begin(), select(corner(1)), { type: "nudge", by: [0.05, 0] });
    expect(nudged.scene.room.corners[1]).toEqual([5.05, 0]);
  });
});

describe("doors and windows", () => {
  const value = { id: "window-1", start: [1, 0.2], end: [2, 0.2], bottom: 0.9, top: 2.1 } as const;
  const withWindow = play(begin(), { type: "edit-opening", opening: "window", value, done: true });

  test("a window goes onto the wall that it is near", () => {
    expect(withWindow.scene.room.windows).toEqual([{ ...value, start: [1, 0], end: [2, 0] }]);
  });

  test("an arrow key slides it along its wall", () => {
    const slid = play(withWindow, select({ kind: "window", id: "window-1" }), {
      type: "nudge",
      by: [0.05, 0.05],
    });
    expect(slid.scene.room.windows[0]).toMatchObject({ start: [1.05, 0], end: [2.05, 0] });
  });

  test("it can be deleted", () => {
    const deleted = play(withWindow, select({ kind: "window", id: "window-1" }), {
      type: "delete-selected",
    });
    expect(deleted.scene.room.windows).toEqual([]);
  });
});

describe("the room", () => {
  test("its height can be changed", () => {
    const lower = { ...room().room, height: 2.2 };
    const edited = play(begin(), { type: "edit-room", room: lower, done: true });
    expect(edited.scene.room.height).toBe(2.2);
  });

  test("corners that make no room are refused with a sentence", () => {
    const bowTie = {
      ...room().room,
      corners: [
        [0, 0],
        [5, 4],
        [5, 0],
        [0, 4],
      ] as const,
    };
    const refused = play(begin(), { type: "edit-room", room: bowTie, done: true });
    expect(refused.scene).toEqual(begin().scene);
    expect(refused.notice?.tone).toBe("problem");
  });
});
