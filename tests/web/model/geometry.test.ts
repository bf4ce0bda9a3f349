import { describe, expect, test } from "vitest";
import {
  crosses,
  isInside,
  isSimple,
  meets,
  nearestOn,
  signedArea,
  wrapped,
} from "../../../web/src/model/geometry";
import type { Point } from "../../../web/src/model/state";

const L_SHAPE: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 2],
  [2, 2],
  [2, 4],
  [0, 4],
];
const BOW_TIE: readonly Point[] = [
  [0, 0],
  [2, 2],
  [2, 0],
  [0, 2],
];

describe("polygons", () => {
  test("an L of three 2 × 2 squares has an area of 12", () => {
    expect(signedArea(L_SHAPE)).toBe(12);
  });

  test("the area of a polygon that runs clockwise is negative", () => {
    expect(signedArea(L_SHAPE.toReversed())).toBe(-12);
  });

  test("a point in the notch of an L is outside", () => {
    expect(isInside([3, 3], L_SHAPE)).toBe(false);
    expect(isInside([1, 3], L_SHAPE)).toBe(true);
    expect(isInside([3, 1], L_SHAPE)).toBe(true);
    expect(isInside([-1, 1], L_SHAPE)).toBe(false);
  });

  test("an L is simple, a bow tie is not", () => {
    expect(isSimple(L_SHAPE)).toBe(true);
    expect(isSimple(BOW_TIE)).toBe(false);
  });

  test("a spike that folds back on its own wall is not simple", () => {
    expect(
      isSimple([
        [0, 0],
        [4, 0],
        [1, 0],
        [1, 3],
      ]),
    ).toBe(false);
  });

  test("a corner that touches another wall is not simple", () => {
    expect(
      isSimple([
        [0, 0],
        [4, 0],
        [4, 4],
        [2, 0],
        [0, 4],
      ]),
    ).toBe(false);
  });

  test("a corner twice in a row is not simple", () => {
    expect(
      isSimple([
        [0, 0],
        [4, 0],
        [4, 0],
        [4, 4],
      ]),
    ).toBe(false);
  });

  test("a corner in the middle of a straight wall is fine", () => {
    expect(
      isSimple([
        [0, 0],
        [2, 0],
        [4, 0],
        [4, 4],
        [0, 4],
      ]),
    ).toBe(true);
  });
});

describe("segments", () => {
  test("the diagonals of a square cross", () => {
    expect(
      crosses(
        [
          [0, 0],
          [1, 1],
        ],
        [
          [0, 1],
          [1, 0],
        ],
      ),
    ).toBe(true);
  });

  test("segments that share an end meet but do not cross", () => {
    expect(
      crosses(
        [
          [0, 0],
          [1, 1],
        ],
        [
          [1, 1],
          [2, 0],
        ],
      ),
    ).toBe(false);
    expect(
      meets(
        [
          [0, 0],
          [1, 1],
        ],
        [
          [1, 1],
          [2, 0],
        ],
      ),
    ).toBe(true);
  });

  test("parallel segments neither cross nor meet", () => {
    expect(
      crosses(
        [
          [0, 0],
          [1, 0],
        ],
        [
          [0, 1],
          [1, 1],
        ],
      ),
    ).toBe(false);
    expect(
      meets(
        [
          [0, 0],
          [1, 0],
        ],
        [
          [0, 1],
          [1, 1],
        ],
      ),
    ).toBe(false);
  });

  test("the nearest point beyond an end is that end", () => {
    expect(
      nearestOn(
        [5, 1],
        [
          [0, 0],
          [2, 0],
        ],
      ),
    ).toEqual([2, 0]);
    expect(
      nearestOn(
        [1, 1],
        [
          [0, 0],
          [2, 0],
        ],
      ),
    ).toEqual([1, 0]);
  });
});

test("three quarters of a turn is a quarter the other way", () => {
  expect(wrapped((3 * Math.PI) / 2)).toBeCloseTo(-Math.PI / 2, 12);
});
