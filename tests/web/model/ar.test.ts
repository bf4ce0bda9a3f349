import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { Point, State } from "../../../web/src/model/state";
import { begin, box, play } from "../rooms";

const enter = (state: State, room: "new" | "known" = "new"): State =>
  play(state, { type: "enter-ar", room, granted: ["hit-test", "local-floor"] });
const ready = (state: State): State =>
  play(enter(state), { type: "change-ar", change: { step: "ready" } });
const found = (...ids: readonly string[]): Action => ({
  type: "change-ar",
  change: { found: { corners: null, doors: [], windows: [], boxes: ids.map((id) => box(id)) } },
});

describe("the camera view", () => {
  test("begins by looking for the floor, and lets go of what was begun", () => {
    const placing = play(begin([box("a")]), {
      type: "place",
      category: "Sofa",
      item: null,
      size: null,
      mode: "manual",
      view: [1, 1],
    });
    const entered = enter(placing);
    expect(entered.ar?.step).toBe("floor");
    expect(entered.placing).toBeNull();
    expect(entered.scene).toBe(placing.scene);
  });

  test("leaves the room as it was drawn there", () => {
    const drawn = play(ready(begin()), { type: "edit-box", box: box("a"), done: true });
    const left = play(drawn, { type: "leave-ar" });
    expect(left.ar).toBeNull();
    expect(left.scene.boxes).toHaveLength(1);
  });

  test("what the camera saw last comes too late once it is off", () => {
    const left = play(ready(begin()), { type: "leave-ar" });
    expect(play(left, { type: "change-ar", change: { surface: true } })).toBe(left);
  });

  test("another room has to be lined up, a new one is drawn where it is", () => {
    const drawn = play(ready(begin([box("a")])), { type: "new-room" });
    expect(drawn.ar?.step).toBe("ready");
    const back = play(drawn, { type: "choose-tool", tool: "select" }, { type: "undo" });
    expect(back.scene.boxes).toHaveLength(1);
    expect(back.ar).toMatchObject({ step: "line-up", room: "known" });
  });

  test("what is placed by hand goes where the phone points until SceneGen is asked", () => {
    const wish = { category: "Chair", item: null, size: null, view: [1, 1] as Point };
    const byHand = play(ready(begin()), { type: "place", ...wish, mode: "manual" });
    expect(byHand.ar?.carrying).toBe(true);
    const asked = play(byHand, { type: "set-mode", mode: "scenegen", view: [1, 1] });
    expect(asked.ar?.carrying).toBe(false);
  });

  test("after the outline things are marked, one after the other", () => {
    const corners: readonly Point[] = [
      [0, 0],
      [4, 0],
      [4, 3],
    ];
    const closed = play(
      ready(begin()),
      { type: "choose-tool", tool: "room" },
      ...corners.flatMap((at): readonly Action[] => [
        { type: "draw-down", at, free: true },
        { type: "draw-up", at, free: true },
      ]),
      { type: "close-outline" },
    );
    expect(closed.tool).toBe("box");
    const marked = play(
      closed,
      { type: "draw-down", at: [2, 1], free: true },
      { type: "draw-side", at: [3, 1], free: true },
      { type: "draw-up", at: [3, 0.5], free: true },
      { type: "draw-height", height: 0.7, done: true },
    );
    expect(marked.tool).toBe("box");
    expect(marked.selection).toEqual({ kind: "box", id: "box-1" });
  });
});

describe("a box marked by three corners", () => {
  const marks = (a: Point, b: Point, c: Point): State =>
    play(
      begin(),
      { type: "choose-tool", tool: "box" },
      { type: "draw-down", at: a, free: true },
      { type: "draw-side", at: b, free: true },
      { type: "draw-up", at: c, free: true },
      { type: "draw-height", height: 0.8, done: true },
    );

  test("is turned as its first side is, and as deep as the third corner is away from that", () => {
    // A side of √2 m at 45°; the third corner is 1/√2 m beside its line, and 2 cm along it.
    const [made] = marks([2, 1.5], [3, 2.5], [2.51, 3.01]).scene.boxes;
    expect([...(made?.size ?? [])].sort()).toEqual([
      expect.closeTo(Math.SQRT1_2, 2),
      expect.closeTo(0.8, 6),
      expect.closeTo(Math.SQRT2, 2),
    ]);
    expect(Math.abs(Math.sin(2 * (made?.heading ?? 0)))).toBeCloseTo(1, 6);
  });

  test.each([
    ["west", [0.05, 2.4], [0.05, 1.6], [2.05, 1.6], 0],
    ["east", [4.9, 1.6], [4.9, 2.4], [3.0, 2.4], Math.PI],
    ["south", [2, 0.1], [3, 0.1], [3, 0.6], Math.PI / 2],
    ["north", [3, 3.4], [2, 3.4], [2, 3.95], -Math.PI / 2],
  ] as const)("has its back to the %s wall beside it", (_, a, b, c, heading) => {
    const [made] = marks(a, b, c).scene.boxes;
    expect(Math.cos((made?.heading ?? 0) - heading)).toBeCloseTo(1, 6);
  });

  test("needs two different corners for its side", () => {
    const state = play(
      begin(),
      { type: "choose-tool", tool: "box" },
      { type: "draw-down", at: [1, 1], free: true },
      { type: "draw-side", at: [1.01, 1], free: true },
    );
    expect(state.draft).toMatchObject({ kind: "box-floor", start: [1, 1] });
    expect(state.notice?.text).toContain("same corner");
  });
});

describe("what the device knows of the room", () => {
  const used = play(ready(begin()), found("box-1", "box-2", "box-3"), { type: "use-found" });

  test("becomes the room in one step, each piece to be looked at", () => {
    expect(used.scene.boxes.map(({ id }) => id)).toEqual(["box-1", "box-2", "box-3"]);
    expect(used.ar?.unchecked).toHaveLength(3);
    expect(play(used, { type: "undo" }).scene.boxes).toEqual([]);
  });

  test("is kept, put right, or dropped piece by piece; the piece in question is selected", () => {
    expect(used.selection).toEqual({ kind: "box", id: "box-1" });
    const kept = play(used, { type: "check-piece", keep: true });
    expect(kept.selection).toEqual({ kind: "box", id: "box-2" });
    const fixed = { ...box("box-2"), category: "Chair" };
    const dropped = play(
      kept,
      { type: "edit-box", box: fixed, done: true },
      { type: "check-piece", keep: true },
      { type: "check-piece", keep: false },
    );
    expect(dropped.scene.boxes).toEqual([box("box-1"), fixed]);
    expect(dropped.ar?.unchecked).toEqual([]);
    expect(dropped.selection).toBeNull();
  });
});
