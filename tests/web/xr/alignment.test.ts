import { describe, expect, test } from "vitest";
import type { Point } from "../../../web/src/model/state";
import { type Alignment, fits, type Move, moved, relativeTo } from "../../../web/src/xr/alignment";
import { room } from "../rooms";

/** By the book: turn, then shift. */
const seen = ({ at, turn }: Move, [x, y]: Point): Point => [
  at[0] + x * Math.cos(turn) - y * Math.sin(turn),
  at[1] + x * Math.sin(turn) + y * Math.cos(turn),
];
const close = ([x, y]: Point) => [expect.closeTo(x, 9), expect.closeTo(y, 9)];

describe("lining up a drawn room by two corners", () => {
  // The room of 5 by 4 m really lies here:
  const truth: Move = { at: [2, -1], turn: 0.7 };
  const drawn = room().room;
  const eye = seen(truth, [2.5, 2]);

  test.each([
    ["one way round", [0, 0], [5, 0]],
    ["the other way round", [5, 0], [0, 0]],
  ] as const)("the room lies where its corners are, marked %s", (_, a, b) => {
    const ways = fits(drawn, eye, seen(truth, a), seen(truth, b));
    // A rectangle also fits turned by half; one of the two best ways is the truth.
    const places = ways.slice(0, 2).map((way) => seen(way, [0, 0]));
    expect(places).toContainEqual(close(seen(truth, [0, 0])));
    expect(places).toContainEqual(close(seen(truth, [5, 4])));
  });

  test("a short wall is taken for a short one", () => {
    const [best] = fits(drawn, eye, seen(truth, [5, 0]), seen(truth, [5, 4.02]));
    const corners = drawn.corners.map((corner) => seen(best as Move, corner));
    // What is off by 2 cm is shared by both ends.
    const nearest = Math.min(
      ...corners.map(([x, y]) =>
        Math.hypot(x - seen(truth, [5, 0])[0], y - seen(truth, [5, 0])[1]),
      ),
    );
    expect(nearest).toBeCloseTo(0.01, 6);
  });

  test("the eye is always inside", () => {
    for (const way of fits(drawn, eye, seen(truth, [0, 0]), seen(truth, [5, 0])).slice(0, 2)) {
      const [x, y] = seen({ at: [0, 0], turn: -way.turn }, [
        eye[0] - way.at[0],
        eye[1] - way.at[1],
      ]);
      expect([x > 0 && x < 5, y > 0 && y < 4]).toEqual([true, true]);
    }
  });
});

test("a move within a frame adds up, seen from the device (whose y axis is up)", () => {
  const before: Alignment = { at: [1, 0.2, -3], turn: Math.PI / 2 };
  // Core (2, 0) of a frame turned by 90° lies 2 m along core +y, which is the page's −z.
  expect(moved(before, { at: [2, 0], turn: 0.5 })).toEqual({
    at: [expect.closeTo(1, 9), 0.2, expect.closeTo(-5, 9)],
    turn: Math.PI / 2 + 0.5,
  });
});

test("a move seen from another one leads to the same place", () => {
  const [one, other]: readonly [Move, Move] = [
    { at: [1, 2], turn: 0.4 },
    { at: [-2, 0.5], turn: 2 },
  ];
  const way = relativeTo(other, one);
  expect(seen(other, seen(way, [3, 4]))).toEqual(close(seen(one, [3, 4])));
});
