import { describe, expect, it } from "vitest";
import type { Point } from "../../../web/src/model/state";
import {
  cutOut,
  onWall,
  openingPanel,
  type Panel,
  wallsOf,
  wallUnder,
} from "../../../web/src/views/outline";

const SQUARE: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 3],
  [0, 3],
];
const L_SHAPE: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 2],
  [2, 2],
  [2, 4],
  [0, 4],
];

const area = (panels: readonly Panel[]) =>
  panels.reduce((sum, { from, to, bottom, top }) => sum + (to - from) * (top - bottom), 0);

describe("the walls of a room", () => {
  it("face out of it, whichever way the corners run", () => {
    for (const corners of [SQUARE, [...SQUARE].reverse()]) {
      for (const wall of wallsOf(corners, 0.1)) {
        const [x, y] = onWall(wall, wall.length / 2, 0.5, 0);
        expect(x < 0 || x > 4 || y < 0 || y > 3).toBe(true);
      }
    }
  });

  it("follow one another along the unrolled outline", () => {
    expect(wallsOf(SQUARE, 0).map(({ offset }) => offset)).toEqual([0, 4, 7, 11]);
  });

  it("meet outside at right corners, and draw back where the room turns inwards", () => {
    const walls = wallsOf(L_SHAPE, 0.1);
    const [start, end] = walls[0]?.overhang ?? [0, 0];
    expect(start).toBeCloseTo(0.1);
    expect(end).toBeCloseTo(0.1);
    expect(walls[2]?.overhang[1]).toBeCloseTo(-0.1);
  });

  it("share the outer corner with their neighbor", () => {
    const walls = wallsOf(L_SHAPE, 0.1);
    walls.forEach((wall, i) => {
      const next = walls[(i + 1) % walls.length];
      if (!next) throw new Error("no wall");
      const end = onWall(wall, wall.length + wall.overhang[1], 0.1, 0);
      const start = onWall(next, -next.overhang[0], 0.1, 0);
      expect(end[0]).toBeCloseTo(start[0]);
      expect(end[1]).toBeCloseTo(start[1]);
    });
  });
});

describe("an opening", () => {
  const door = { id: "d", start: [4, 2], end: [4, 1.1], bottom: 0, top: 2 } as const;

  it("belongs to the wall it lies on, from left to right", () => {
    const walls = wallsOf(SQUARE, 0.1);
    expect(wallUnder(walls, door.start, door.end)).toBe(1);
    const wall = walls[1];
    if (!wall) throw new Error("no wall");
    const { from, to } = openingPanel(wall, door);
    expect(from).toBeCloseTo(1.1);
    expect(to).toBeCloseTo(2);
  });
});

describe("cutting openings out of a wall", () => {
  const whole: Panel = { from: 0, to: 4, bottom: 0, top: 2.5 };

  it("leaves as much wall as there is around them", () => {
    const door = { from: 0.5, to: 1.5, bottom: 0, top: 2 };
    const window = { from: 2, to: 3.5, bottom: 1, top: 2.2 };
    expect(area(cutOut(whole, [door, window]))).toBeCloseTo(10 - 2 - 1.8);
  });

  it("leaves everything when there are none", () => {
    expect(cutOut(whole, [])).toEqual([whole]);
  });

  it("counts openings that overlap once", () => {
    const one = { from: 1, to: 3, bottom: 1, top: 2 };
    const other = { from: 2, to: 4, bottom: 1, top: 2 };
    expect(area(cutOut(whole, [one, other]))).toBeCloseTo(10 - 3);
  });
});
