import { describe, expect, test } from "vitest";
import type { State } from "../../../web/src/model/state";
import type { BoxRecord } from "../../../web/src/net/protocol.gen";
import { type Dragged, drag, finished, gripBox } from "../../../web/src/views/dragging";
import type { Ray } from "../../../web/src/views/picking";
import { begin, box, play } from "../rooms";

const table = box("table", { size: [0.8, 1.2, 0.8], center: [2.5, 2, 0.4] });
const vase = box("vase", { category: "Decor", size: [0.1, 0.1, 0.3], center: [2.5, 2, 0.95] });

const above = (x: number, y: number): Ray => ({ origin: [x, y, 10], direction: [0, 0, -1] });

/** The state after a box was grabbed in its middle and dragged from place to place along x. */
function draggedTo(state: State, grabbed: BoxRecord, places: readonly number[]): State[] {
  const [x, y, z] = grabbed.center;
  const top = z + grabbed.size[2] / 2;
  const grip = gripBox(grabbed, above(x, y), 10 - top, false);
  const states: State[] = [];
  let now = state;
  for (const place of places) {
    const { action } = drag(now, grip, above(place, y), false, false) as Dragged;
    now = play(now, action);
    states.push(now);
  }
  return states;
}

const along = (states: readonly State[], id: string, axis: 0 | 2): (number | undefined)[] =>
  states.map(({ scene }) => scene.boxes.find((one) => one.id === id)?.center[axis]);

describe("a thing with something on it", () => {
  const places = [2.52, 2.54, 2.56, 2.58, 2.6];

  test("follows the hand, and does not snap to what it carries", () => {
    const states = draggedTo(begin([table, vase]), table, places);
    expect(along(states, "table", 0)).toEqual(places);
    expect(along(states, "vase", 0)).toEqual(places);
  });

  test("does not climb onto what it carries", () => {
    const stand = box("stand", {
      category: "Decor",
      size: [0.4, 0.4, 0.3],
      center: [2.5, 2, 0.15],
    });
    const cabinet = box("cabinet", {
      category: "Storage",
      size: [0.3, 0.3, 0.5],
      center: [2.5, 2, 0.55],
    });
    const states = draggedTo(begin([stand, cabinet]), stand, places);
    expect(along(states, "stand", 2)).toEqual(places.map(() => 0.15));
    expect(along(states, "cabinet", 2)).toEqual(places.map(() => 0.55));
  });
});

test("a drag ends with what it did last, and with nothing once its box is gone", () => {
  const last = { type: "edit-box", box: table, done: false } as const;
  expect(finished(begin([table]), last)).toEqual([{ ...last, done: true }]);
  expect(finished(begin([vase]), last)).toEqual([]);
});
