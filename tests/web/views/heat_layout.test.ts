import { describe, expect, it } from "vitest";
import type { HeatMap } from "../../../web/src/model/state";
import type { RoomRecord } from "../../../web/src/net/protocol.gen";
import {
  brightest,
  likelihoodOf,
  patchesOf,
  placeOnMap,
  uvOf,
  valueAt,
} from "../../../web/src/views/heat_layout";

const ROOM: RoomRecord = {
  corners: [
    [1, 2],
    [5, 2],
    [5, 4],
    [1, 4],
  ],
  height: 2.5,
  doors: [],
  windows: [],
  room_type: "",
};

/** Two rows of four cells of a metre; each value differs, so no mirroring goes unseen. */
const MAP: HeatMap = {
  surface: "floor",
  origin: [1, 2],
  cell: 1,
  rows: 2,
  columns: 4,
  min: 0,
  max: 1,
  values: Uint8Array.from([10, 20, 30, 40, 50, 60, 70, 255]),
};

describe("a heat map of the floor", () => {
  it("has its first row at the smallest y and its first column at the smallest x", () => {
    expect(valueAt(MAP, [1.5, 2.5])).toBe(10);
    expect(valueAt(MAP, [4.5, 2.5])).toBe(40);
    expect(valueAt(MAP, [1.5, 3.5])).toBe(50);
    expect(valueAt(MAP, [4.5, 3.5])).toBe(255);
  });

  it("gives the first byte of the texture to v = 0, as WebGL reads it without a flip", () => {
    expect(uvOf(MAP, [1, 2])).toEqual([0, 0]);
    expect(uvOf(MAP, [5, 4])).toEqual([1, 1]);
    expect(uvOf(MAP, [2, 3.5])).toEqual([0.25, 0.75]);
  });

  it("has no value outside", () => {
    expect(valueAt(MAP, [0.9, 2.5])).toBe(0);
    expect(valueAt(MAP, [1.5, 4.1])).toBe(0);
  });

  it("is brightest in the middle of its highest cell", () => {
    expect(brightest(MAP)).toEqual([4.5, 3.5]);
  });

  it("lies just over the floor, corner on corner", () => {
    const [patch] = patchesOf(MAP, ROOM, []);
    expect(patch?.corners.map(([x, y]) => [x, y])).toEqual(ROOM.corners);
    expect(patch?.corners.every(([, , z]) => z > 0 && z < 0.02)).toBe(true);
    expect(patch?.uvs).toEqual([
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ]);
  });
});

describe("a heat map of the walls", () => {
  const walls: HeatMap = { ...MAP, surface: "walls", origin: [0, 0], columns: 12, rows: 3 };

  it("unrolls the outline from corner 0 and counts rows from the floor", () => {
    const patches = patchesOf(walls, ROOM, []);
    expect(patches).toHaveLength(4);
    const [u0, u1] = [4 / 12, 6 / 12];
    const us = patches[1]?.uvs.map(([u]) => u);
    expect(us?.[0]).toBeCloseTo(u1);
    expect(us?.[1]).toBeCloseTo(u0);
    expect(patches[1]?.uvs[1]?.[1]).toBe(0);
    expect(patches[1]?.uvs[2]?.[1]).toBeCloseTo(2.5 / 3);
  });

  it("lies on the inner side of each wall", () => {
    const [south, east] = patchesOf(walls, ROOM, []);
    expect(south?.corners.every(([, y]) => y > 2 && y < 2.02)).toBe(true);
    expect(east?.corners.every(([x]) => x < 5 && x > 4.98)).toBe(true);
  });

  it("finds the place of a point on the second wall beyond the length of the first", () => {
    expect(placeOnMap(walls, ROOM, [5, 2.5, 1.2], 1)).toEqual([4.5, 1.2]);
  });
});

describe("a heat map of the tops", () => {
  it("lies on each box, at the height of its top", () => {
    const box = { id: "a", category: "Table", center: [2, 3, 0.4], size: [1, 1, 0.8] } as const;
    const [patch] = patchesOf({ ...MAP, surface: "tops" }, ROOM, [box]);
    expect(patch?.corners).toHaveLength(4);
    expect(patch?.corners.every(([, , z]) => z > 0.8 && z < 0.82)).toBe(true);
  });
});

describe("a value", () => {
  it("is nowhere at 0, the least at 1 and the most at 255", () => {
    expect(likelihoodOf(0)).toBeNull();
    expect(likelihoodOf(1)).toBe(0);
    expect(likelihoodOf(255)).toBe(1);
  });
});
