import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { State, Vector3 } from "../../../web/src/model/state";
import type { Ray } from "../../../web/src/views/picking";
import { aimed, heightAt, marked } from "../../../web/src/xr/marking";
import { begin, box, play } from "../rooms";

const EYE: Vector3 = [2.5, 0.2, 1.5];
const tool = (name: "room" | "box" | "door"): Action => ({ type: "choose-tool", tool: name });
const inAr = (state: State): State =>
  play(
    state,
    { type: "enter-ar", room: "new", granted: [] },
    { type: "change-ar", change: { step: "ready" } },
  );

/** The ray from the eye to a place. */
function toward(place: Vector3, origin: Vector3 = EYE): Ray {
  const run = place.map((metres, i) => metres - (origin[i] ?? 0)) as unknown as Vector3;
  const length = Math.hypot(...run);
  return { origin, direction: [run[0] / length, run[1] / length, run[2] / length] };
}

/** The state after a tap toward each place. */
const tapped = (state: State, ...places: readonly Vector3[]): State =>
  places.reduce((now, place) => play(now, ...marked(now, toward(place))), state);

describe("marks in the real room", () => {
  test("four corners and the first again make the room", () => {
    const outlined = tapped(
      play(inAr(begin()), tool("room")),
      [0, 0, 0],
      [4, 0, 0],
      [4, 3, 0],
      [0, 3, 0],
      [0.02, 0.03, 0],
    );
    expect(outlined.draft).toBeNull();
    expect(outlined.scene.room.corners).toEqual([
      [0, 0],
      [4, 0],
      [4, 3],
      [0, 3],
    ]);
  });

  test("the first wall may run anywhere: nearly level is not made level", () => {
    const two = tapped(play(inAr(begin()), tool("room")), [0, 0, 0], [4, 0.3, 0]);
    expect(two.draft).toMatchObject({
      corners: [
        [0, 0],
        [4, 0.3],
      ],
    });
  });

  test("right angles can be had, or not", () => {
    const wall: readonly Vector3[] = [
      [0, 0, 0],
      [4, 0, 0],
      [4.3, 3, 0],
    ];
    const square = tapped(play(inAr(begin()), tool("room")), ...wall);
    expect(square.draft).toMatchObject({ corners: { 2: [4, 3] } });
    const free = play(inAr(begin()), tool("room"), {
      type: "change-ar",
      change: { square: false },
    });
    expect(tapped(free, ...wall).draft).toMatchObject({ corners: { 2: [4.3, 3] } });
  });

  test.each([
    [
      3,
      [
        [1, 1, 0],
        [2, 1, 0],
        [2, 1.6, 0],
      ],
    ],
    [
      2,
      [
        [1, 1, 0],
        [2, 1.6, 0],
      ],
    ],
  ] as const)("a box by %d corners and its top edge", (marks, corners) => {
    const state = play(inAr(begin()), tool("box"), { type: "change-ar", change: { marks } });
    const made = tapped(state, ...corners, [1.5, 1, 0.74]).scene.boxes[0];
    expect(made?.center).toEqual([1.5, 1.3, expect.closeTo(0.37, 6)]);
    expect([...(made?.size ?? [])].sort()).toEqual([0.6, 0.74, 1]);
  });

  test("a door is marked by where it begins and ends on its wall", () => {
    const made = tapped(play(inAr(begin()), tool("door")), [1, 4, 1], [1.9, 4, 1]).scene.room.doors;
    expect(made).toHaveLength(1);
    expect(made[0]).toMatchObject({ start: [1.9, 4], end: [1, 4] });
  });

  test("pointing at the sky marks nothing", () => {
    expect(marked(play(inAr(begin()), tool("room")), toward([2, 3, 5]))).toEqual([]);
  });
});

describe("the height of a box", () => {
  const tall = box("a", { center: [2.5, 2, 0.5], size: [1, 1, 1] });

  test("is that of the top edge that is aimed at, wherever along the front", () => {
    expect(heightAt(tall, toward([2.5, 1.5, 0.83]))).toBeCloseTo(0.83, 9);
    expect(heightAt(tall, toward([2.1, 1.5, 0.83]))).toBeCloseTo(0.83, 9);
  });

  test("can be above the eye", () => {
    expect(heightAt(tall, toward([2.5, 1.5, 2.1]))).toBeCloseTo(2.1, 9);
  });

  test("is not known when looking past it, or straight down on it", () => {
    expect(heightAt(tall, toward([0, 3, 0.5]))).toBeNull();
    expect(heightAt(tall, toward([2.5, 2, 0], [2.5, 2, 3]))).toBeNull();
  });
});

test("what is carried goes where the phone points, and snaps to the wall there", () => {
  const placing = play(inAr(begin()), {
    type: "place",
    category: "Sofa",
    item: null,
    size: [0.9, 2, 0.8],
    mode: "manual",
    view: [2, 2],
  });
  const dragged = aimed(placing, toward([3, 3.5, 0]));
  const moved = play(placing, ...(dragged ? [dragged.action] : []));
  // Its back against the wall at y = 4.
  expect(moved.placing?.pose?.center).toEqual([3, expect.closeTo(3.55, 6), expect.closeTo(0.4, 6)]);
  const down = play(placing, { type: "change-ar", change: { carrying: false } });
  expect(aimed(down, toward([3, 3.5, 0]))).toBeNull();
});
