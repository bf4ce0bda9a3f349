import { describe, expect, test } from "vitest";
import { footprint, overlap, reach, standsInside } from "../../../web/src/model/footprints";
import type { RoomRecord } from "../../../web/src/net/protocol.gen";
import { box, room } from "../rooms";

const L_ROOM: RoomRecord = {
  ...room().room,
  corners: [
    [0, 0],
    [4, 0],
    [4, 2],
    [2, 2],
    [2, 4],
    [0, 4],
  ],
};

describe("footprint", () => {
  test("depth runs along the heading, width across it", () => {
    const corners = footprint(box("a", { center: [0, 0, 0.4], size: [1, 2, 0.8], heading: 0 }));
    expect(corners).toEqual([
      [0.5, -1],
      [0.5, 1],
      [-0.5, 1],
      [-0.5, -1],
    ]);
  });

  test("a quarter turn swaps depth and width", () => {
    const turned = box("a", { center: [0, 0, 0.4], size: [1, 2, 0.8], heading: Math.PI / 2 });
    const xs = footprint(turned).map(([x]) => Math.abs(x));
    const ys = footprint(turned).map(([, y]) => Math.abs(y));
    for (const x of xs) expect(x).toBeCloseTo(1, 12);
    for (const y of ys) expect(y).toBeCloseTo(0.5, 12);
  });

  test("a square turned by 45 degrees reaches half its diagonal", () => {
    const square = box("a", { size: [1, 1, 1], heading: Math.PI / 4 });
    expect(reach(square, [1, 0])).toBeCloseTo(Math.SQRT2 / 2, 12);
  });
});

describe("standing inside", () => {
  test("a box against the wall is inside", () => {
    expect(standsInside(box("a", { center: [0.4, 2, 0.4] }), room().room)).toBe(true);
  });

  test("a box 5 cm into the wall is not", () => {
    expect(standsInside(box("a", { center: [0.35, 2, 0.4] }), room().room)).toBe(false);
  });

  test("a box over the inner corner of an L is not, though its own corners are", () => {
    const across = box("a", { center: [2, 2, 0.4], size: [0.2, 2.4, 0.8], heading: Math.PI / 4 });
    expect(standsInside(across, L_ROOM)).toBe(false);
  });
});

describe("overlap", () => {
  const table = box("table", { center: [2, 2, 0.4], size: [0.8, 1.2, 0.8] });

  test("boxes side by side do not overlap", () => {
    expect(overlap(table, box("b", { center: [2.8, 2, 0.4] }))).toBe(false);
  });

  test("boxes 10 cm into each other do", () => {
    expect(overlap(table, box("b", { center: [2.7, 2, 0.4] }))).toBe(true);
  });

  test("a lamp on the table does not overlap it", () => {
    const lamp = box("b", { center: [2, 2, 1.0], size: [0.2, 0.2, 0.4] });
    expect(overlap(table, lamp)).toBe(false);
  });

  test("a rug under the table does not overlap it", () => {
    expect(overlap(table, box("b", { center: [2, 2, 0.01], size: [2, 3, 0.02] }))).toBe(false);
  });

  test("a turned box misses a corner that its bounding rectangle would hit", () => {
    const diamond = box("b", {
      center: [2.85, 3.05, 0.4],
      size: [1, 1, 0.8],
      heading: Math.PI / 4,
    });
    expect(overlap(table, diamond)).toBe(false);
    expect(overlap(table, { ...diamond, heading: 0 })).toBe(true);
  });
});
