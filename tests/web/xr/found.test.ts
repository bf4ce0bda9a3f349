import { describe, expect, test } from "vitest";
import type { Vector3 } from "../../../web/src/model/state";
import { foundIn, type Piece } from "../../../web/src/xr/found";
import { room } from "../rooms";

const drawn = room().room; // 5 m by 4 m
const floor: Piece = {
  label: "floor",
  flat: true,
  points: [
    [0, 0, 0],
    [2, 0, 0],
    [5, 0, 0],
    [5, 4, 0],
    [0, 4, 0],
  ],
};

/** The corners of a box that is turned by an angle about its middle. */
function corners(middle: Vector3, [depth, width, height]: Vector3, turn: number): Vector3[] {
  return [-1, 1].flatMap((i) =>
    [-1, 1].flatMap((j) =>
      [-1, 1].map((k): Vector3 => {
        const [x, y] = [(i * depth) / 2, (j * width) / 2];
        return [
          middle[0] + x * Math.cos(turn) - y * Math.sin(turn),
          middle[1] + x * Math.sin(turn) + y * Math.cos(turn),
          middle[2] + (k * height) / 2,
        ];
      }),
    ),
  );
}
const solid = (label: string, points: readonly Vector3[]): Piece => ({
  label,
  points,
  flat: false,
});

describe("a room that the device knows", () => {
  test("has the outline of its floor, corners on a straight wall left out", () => {
    expect(foundIn([floor], drawn)?.corners).toEqual([
      [0, 0],
      [5, 0],
      [5, 4],
      [0, 4],
    ]);
  });

  test("has the least box round each piece of furniture, its back to the nearest wall", () => {
    const couch = corners([2.5, 3.5, 0.4], [0.9, 2, 0.8], -Math.PI / 2);
    const found = foundIn([floor, solid("couch", couch)], drawn);
    expect(found?.boxes).toEqual([
      expect.objectContaining({
        id: "box-1",
        category: "Sofa",
        center: [2.5, 3.5, expect.closeTo(0.4, 6)],
        size: [expect.closeTo(0.9, 3), expect.closeTo(2, 3), expect.closeTo(0.8, 3)],
        heading: expect.closeTo(-Math.PI / 2, 6),
      }),
    ]);
  });

  test("finds how a piece is turned", () => {
    const table = corners([2, 2, 0.37], [0.7, 1.4, 0.74], 0.5);
    const [box] = foundIn([floor, solid("table", table)], drawn)?.boxes ?? [];
    expect([...(box?.size ?? [])].sort()).toEqual([
      expect.closeTo(0.7, 3),
      expect.closeTo(0.74, 3),
      expect.closeTo(1.4, 3),
    ]);
    expect(Math.abs(Math.sin(2 * ((box?.heading ?? 0) - 0.5)))).toBeCloseTo(0, 3);
  });

  test("a table top reaches down to the floor; the same table as a solid counts once", () => {
    const top: Piece = {
      label: "table",
      flat: true,
      points: corners([2, 2, 0.74], [0.7, 1.4, 0], 0).filter((_, i) => i % 2 === 0),
    };
    const outline: Piece = { ...top, points: [0, 1, 3, 2].map((i) => top.points[i] as Vector3) };
    expect(foundIn([outline], drawn)?.boxes[0]).toMatchObject({
      category: "Table",
      center: [2, 2, expect.closeTo(0.37, 6)],
    });
    const whole = solid("table", corners([2, 2, 0.37], [0.7, 1.4, 0.74], 0));
    expect(foundIn([outline, whole], drawn)?.boxes).toHaveLength(1);
  });

  test("has its doors and windows on the walls that they are nearest to", () => {
    const upright = (
      label: string,
      x: readonly number[],
      y: number,
      z: readonly number[],
    ): Piece => ({
      label,
      flat: true,
      points: x.flatMap((at) => z.map((height): Vector3 => [at, y, height])),
    });
    const door = upright("door", [1, 1.9], 0.03, [0.02, 2.05]);
    const window = upright("window", [2, 3.2], 4.05, [0.9, 2.1]);
    const slit = upright("window", [4, 4.1], 4, [0.9, 2.1]);
    const found = foundIn([floor, door, window, slit], drawn);
    expect(found?.doors).toEqual([
      { id: "door-1", start: [1, 0], end: [1.9, 0], bottom: 0, top: 2.05 },
    ]);
    expect(found?.windows).toEqual([
      { id: "window-1", start: [3.2, 4], end: [2, 4], bottom: 0.9, top: 2.1 },
    ]);
    expect(foundIn([door], drawn)).toBeNull(); // without walls there is nothing to put it in
  });

  test("walls, ceilings and labels that nobody knows are no furniture", () => {
    const others = ["wall", "ceiling", "global mesh", "spaceship"].map((label) =>
      solid(label, corners([1, 1, 1], [1, 1, 1], 0)),
    );
    expect(foundIn(others, drawn)).toBeNull();
  });
});
