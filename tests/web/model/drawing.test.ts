import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { Point, State, Tool } from "../../../web/src/model/state";
import { begin, box, play } from "../rooms";

const tool = (name: Tool): Action => ({ type: "choose-tool", tool: name });
const click = (at: Point, free = false): readonly Action[] => [
  { type: "draw-down", at, free },
  { type: "draw-up", at, free },
];
const drag = (from: Point, to: Point, free = false): readonly Action[] => [
  { type: "draw-down", at: from, free },
  { type: "draw-move", at: to, free },
  { type: "draw-up", at: to, free },
];
const cornersOf = (state: State): readonly Point[] =>
  state.draft?.kind === "room" ? state.draft.corners : [];

describe("the outline of a room", () => {
  const drawing = play(begin(), tool("room"));

  test("clicks set corners, with right angles where they are nearly right", () => {
    const three = play(drawing, ...click([0, 0]), ...click([4, 0.2]), ...click([4.2, 3]));
    expect(cornersOf(three)).toEqual([
      [0, 0],
      [4, 0],
      [4, 3],
    ]);
  });

  test("a wall that is clearly oblique stays oblique", () => {
    const two = play(drawing, ...click([0, 0]), ...click([3, 2]));
    expect(cornersOf(two)).toEqual([
      [0, 0],
      [3, 2],
    ]);
  });

  test("with Alt nothing is made square", () => {
    const two = play(drawing, ...click([0, 0]), ...click([4, 0.2], true));
    expect(cornersOf(two)).toEqual([
      [0, 0],
      [4, 0.2],
    ]);
  });

  test("the fourth corner of a rectangle comes level with the first", () => {
    const four = play(
      drawing,
      ...click([0, 0]),
      ...click([4, 0]),
      ...click([4, 3]),
      ...click([0.15, 3.1]),
    );
    expect(cornersOf(four)).toEqual([
      [0, 0],
      [4, 0],
      [4, 3],
      [0, 3],
    ]);
  });

  test("a click on the first corner closes it, anticlockwise, as one step", () => {
    const closed = play(
      drawing,
      ...click([0, 0]),
      ...click([0, 3]),
      ...click([4, 3]),
      ...click([4, 0]),
      ...click([0.1, 0.1]),
    );
    expect(closed.scene.room.corners).toEqual([
      [4, 0],
      [4, 3],
      [0, 3],
      [0, 0],
    ]);
    expect(closed.draft).toBeNull();
    expect(closed.tool).toBe("select");
    expect(closed.past).toHaveLength(1);
  });

  test("Enter closes it too", () => {
    const closed = play(drawing, ...click([0, 0]), ...click([4, 0]), ...click([4, 3]), {
      type: "close-outline",
    });
    expect(closed.scene.room.corners).toEqual([
      [0, 0],
      [4, 0],
      [4, 3],
    ]);
  });

  test("two corners are not enough", () => {
    const open = play(drawing, ...click([0, 0]), ...click([4, 0]), { type: "close-outline" });
    expect(cornersOf(open)).toHaveLength(2);
    expect(open.notice?.text).toMatch(/three corners/);
  });

  test("a wall that would cross another is refused with a sentence", () => {
    const crossed = play(
      drawing,
      ...click([0, 0]),
      ...click([4, 0]),
      ...click([4, 3]),
      ...click([2, -1], true),
    );
    expect(cornersOf(crossed)).toHaveLength(3);
    expect(crossed.notice?.text).toMatch(/cross/);
  });

  test("so is a closing wall that would cross one", () => {
    const corners: readonly Point[] = [
      [0, 0],
      [4, 0],
      [4, 3],
      [-1, 3],
      [-1, 1],
      [2, 1],
      [2, 2],
    ];
    const clicks = corners.flatMap((corner) => click(corner, true));
    const crossed = play(drawing, ...clicks, { type: "close-outline" });
    expect(cornersOf(crossed)).toEqual(corners);
    expect(crossed.notice?.text).toMatch(/cross/);
  });

  test("a cupboard is too small for a room", () => {
    const tiny = play(drawing, ...click([0, 0]), ...click([0.6, 0]), ...click([0.6, 0.6]), {
      type: "close-outline",
    });
    expect(tiny.notice?.text).toMatch(/too small/);
    expect(tiny.scene.room).toBe(drawing.scene.room);
  });

  test("a double click sets one corner", () => {
    expect(cornersOf(play(drawing, ...click([0, 0]), ...click([0.02, 0])))).toHaveLength(1);
  });

  test("the last corner can be taken back", () => {
    const back = play(drawing, ...click([0, 0]), ...click([4, 0]), { type: "remove-last-corner" });
    expect(cornersOf(back)).toEqual([[0, 0]]);
  });

  test("Esc leaves the room as it was", () => {
    const left = play(drawing, ...click([0, 0]), { type: "cancel" });
    expect(left.scene).toBe(drawing.scene);
    expect(left.tool).toBe("select");
    expect(left.draft).toBeNull();
  });

  test("doors stay where there is still a wall, others go", () => {
    const door = (id: string, start: Point, end: Point): Action => ({
      type: "edit-opening",
      opening: "door",
      value: { id, start, end, bottom: 0, top: 2 },
      done: true,
    });
    const redrawn = play(
      begin(),
      door("stays", [1, 0], [2, 0]),
      door("goes", [5, 2], [5, 3]),
      tool("room"),
      ...click([0, 0]),
      ...click([3, 0]),
      ...click([3, 4]),
      ...click([0, 4]),
      ...click([0, 0]),
    );
    expect(redrawn.scene.room.doors.map(({ id }) => id)).toEqual(["stays"]);
  });
});

test("a new room is a bare one with its own id, ready to be drawn", () => {
  const fresh = play(begin([box("table")]), { type: "new-room" });
  expect(fresh.scene.boxes).toEqual([]);
  expect(fresh.scene.id).not.toBe(begin().scene.id);
  expect(fresh.tool).toBe("room");
  expect(play(fresh, { type: "undo" }).scene.boxes).toHaveLength(1);
});

describe("boxes", () => {
  const drawing = play(begin(), tool("box"));
  const height = (metres: number, done: boolean): Action => ({
    type: "draw-height",
    height: metres,
    done,
  });

  test("a drag on the floor and a height make a box, selected, as one step", () => {
    const drawn = play(drawing, ...drag([1, 1], [2.5, 2]), height(0.4, false), height(0.8, true));
    const [only] = drawn.scene.boxes;
    expect(only?.center).toEqual([1.75, 1.5, 0.4]);
    expect(only?.size.toSorted((a, b) => a - b)).toEqual([0.8, 1, 1.5]);
    expect(drawn.selection).toEqual({ kind: "box", id: only?.id });
    expect(drawn.past).toHaveLength(1);
    expect(drawn.tool).toBe("select");
  });

  test("its back is to the nearest wall", () => {
    const drawn = play(drawing, ...drag([1, 0.2], [3, 1]), height(0.8, true));
    // The nearest wall runs along y = 0, so the front looks along +y: 0.8 m deep, 2 m wide.
    expect(drawn.scene.boxes[0]?.heading).toBeCloseTo(Math.PI / 2, 12);
    expect(drawn.scene.boxes[0]?.size).toEqual([0.8, 2, 0.8]);
    expect(drawn.scene.boxes[0]?.front_from_wall).toBe(true);
  });

  test("it gets the category that its size makes likely", () => {
    const drawn = play(drawing, ...drag([1, 0.2], [3, 1.1]), height(0.8, true));
    expect(drawn.scene.boxes[0]?.category).toBe("Sofa");
  });

  test("a click instead of a drag draws nothing and is told how to draw", () => {
    const state = play(drawing, ...click([1, 1]));
    expect(state.draft).toBeNull();
    expect(state.scene).toBe(drawing.scene);
    expect(state.notice?.text).toMatch(/^Drag from one corner/);
  });

  test("pressing again ends the height that is shown", () => {
    const drawn = play(drawing, ...drag([1, 1], [2, 2]), height(1.3, false), ...click([2, 2]));
    expect(drawn.scene.boxes[0]?.size[2]).toBe(1.3);
    expect(drawn.scene.boxes).toHaveLength(1);
  });

  test("it is no higher than the room", () => {
    const drawn = play(drawing, ...drag([1, 1], [2, 2]), height(9, true));
    expect(drawn.scene.boxes[0]?.size[2]).toBe(2.6);
  });

  test("Esc drops the box that waits for its height", () => {
    const dropped = play(drawing, ...drag([1, 1], [2, 2]), { type: "cancel" });
    expect(dropped.draft).toBeNull();
    expect(dropped.scene).toBe(drawing.scene);
  });
});

describe("doors and windows", () => {
  test("a click puts a usual door on the nearest wall", () => {
    const state = play(begin(), tool("door"), ...click([2, 0.4]));
    expect(state.scene.room.doors).toEqual([
      { id: "door-1", start: [1.55, 0], end: [2.45, 0], bottom: 0, top: 2 },
    ]);
    expect(state.selection).toEqual({ kind: "door", id: "door-1" });
  });

  test("a click puts a usual window on the nearest wall", () => {
    const state = play(begin(), tool("window"), ...click([4.8, 2]));
    expect(state.scene.room.windows).toEqual([
      { id: "window-1", start: [5, 1.4], end: [5, 2.6], bottom: 0.9, top: 2.1 },
    ]);
  });

  test("a drag makes it as wide as the drag, and stays on the first wall", () => {
    const state = play(begin(), tool("window"), ...drag([1, 0.1], [4.9, 1.5]));
    expect(state.scene.room.windows[0]).toMatchObject({ start: [1, 0], end: [4.9, 0] });
  });

  test("a door in a low room is no higher than the room", () => {
    const low = { ...begin().scene.room, height: 1.9 };
    const state = play(
      begin(),
      { type: "edit-room", room: low, done: true },
      tool("door"),
      ...click([2, 0]),
    );
    expect(state.scene.room.doors[0]?.top).toBe(1.9);
  });
});
