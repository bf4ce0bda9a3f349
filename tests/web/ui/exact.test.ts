import { expect, test } from "vitest";
import { nextCorner, spanOf, withSpan } from "../../../web/src/ui/exact";
import { room } from "../rooms";

const { room: plain } = room();
const door = { id: "d", start: [1, 0], end: [1.9, 0], bottom: 0, top: 2 } as const;

test("a door's span is measured from the first corner of its wall", () => {
  expect(spanOf(door, plain).from).toBeCloseTo(1, 9);
  expect(spanOf(door, plain).width).toBeCloseTo(0.9, 9);
});

test("a typed span moves the door along its wall", () => {
  const moved = withSpan(door, plain, { from: 2, width: 1 });
  expect(moved).toEqual({ ...door, start: [2, 0], end: [3, 0] });
});

test("a span beyond the wall is kept on the wall", () => {
  const moved = withSpan(door, plain, { from: 4.8, width: 0.9 });
  expect(moved.end[0]).toBeCloseTo(5, 9);
});

test("the next corner is as far as was typed", () => {
  const [x, y] = nextCorner([1, 2], Math.PI / 2, 3);
  expect(x).toBeCloseTo(1, 9);
  expect(y).toBeCloseTo(5, 9);
});
