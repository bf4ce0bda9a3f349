import { expect, it } from "vitest";
import type { Ray } from "../../../web/src/views/picking";
import { tap } from "../../../web/src/views/taps";
import { answer, begin, box, play } from "../rooms";

const down: Ray = { origin: [2.5, 2, 5], direction: [0, 0, -1] };
const selectTable = { type: "select", selection: { kind: "box", id: "table" } };

it("selects what is tapped", () => {
  const state = begin([box("table")]);
  expect(tap(state, { kind: "look" }, down)).toEqual([selectTable]);
});

it("selects what is tapped while something is placed, so that it can be moved away", () => {
  const placing = play(begin([box("table")]), {
    type: "place",
    category: "Sofa",
    item: null,
    size: null,
    mode: "scenegen",
    view: [1, 1],
  });
  expect(tap(placing, { kind: "look" }, down)).toContainEqual(selectTable);
});

it("asks why not there where the bare floor is tapped, and the ghost keeps its turn", () => {
  const asking = play(begin(), {
    type: "place",
    category: "Sofa",
    item: null,
    size: [0.9, 2, 0.8],
    mode: "scenegen",
    view: [1, 1],
  });
  const offered = play(asking, {
    type: "answer",
    answer: answer(asking.placing?.ask ?? "", 0),
  });
  expect(tap(offered, { kind: "look" }, down)).toContainEqual({
    type: "drag-ghost",
    pose: { center: [2.5, 2, 0.4], heading: 0 },
    done: true,
  });
});
