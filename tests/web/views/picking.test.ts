import { describe, expect, it } from "vitest";
import type { BoxRecord, RoomRecord } from "../../../web/src/net/protocol.gen";
import {
  firstBox,
  heightOver,
  meetBox,
  meetFloor,
  meetLevel,
  meetWall,
  type Ray,
} from "../../../web/src/views/picking";

const ROOM: RoomRecord = {
  corners: [
    [0, 0],
    [4, 0],
    [4, 3],
    [0, 3],
  ],
  height: 2.5,
  doors: [],
  windows: [],
  room_type: "",
};
const down = (x: number, y: number): Ray => ({ origin: [x, y, 5], direction: [0, 0, -1] });
const box = (id: string, center: BoxRecord["center"], heading = 0): BoxRecord => ({
  id,
  category: "Sofa",
  center,
  size: [2, 1, 1],
  heading,
});
const S = Math.SQRT1_2;

describe("a ray from above", () => {
  it("meets the floor below it, and no floor outside the room", () => {
    expect(meetFloor(down(1, 2), ROOM)).toEqual([1, 2]);
    expect(meetFloor(down(5, 2), ROOM)).toBeNull();
  });

  it("enters a box at its top", () => {
    expect(meetBox(down(1, 1), box("a", [1, 1, 0.5]))).toBeCloseTo(4);
  });

  it("meets a turned box where it now is", () => {
    const turned = box("a", [1, 1, 0.5], Math.PI / 2);
    expect(meetBox(down(1, 1.9), turned)).toBeCloseTo(4);
    expect(meetBox(down(1.9, 1), turned)).toBeNull();
  });

  it("meets the higher of two boxes first", () => {
    const found = firstBox(down(1, 1), [box("low", [1, 1, 0.5]), box("high", [1, 1, 1.5])]);
    expect(found?.box.id).toBe("high");
    expect(found?.distance).toBeCloseTo(3);
  });
});

describe("a ray that climbs", () => {
  it("never meets the floor", () => {
    expect(meetLevel({ origin: [0, 0, 1], direction: [S, 0, S] }, 0)).toBeNull();
  });
});

describe("a ray through the room", () => {
  it("passes through walls seen from outside and meets the inner side of the far one", () => {
    const hit = meetWall({ origin: [-3, 1, 1], direction: [1, 0, 0] }, ROOM);
    expect(hit?.wall).toBe(1);
    expect(hit?.at).toEqual([4, 1, 1]);
    expect(Math.cos(hit?.heading ?? 0)).toBeCloseTo(-1);
  });

  it("meets no wall above the ceiling", () => {
    expect(meetWall({ origin: [-3, 1, 3], direction: [1, 0, 0] }, ROOM)).toBeNull();
  });

  it("tells the height at which it passes over a point", () => {
    expect(heightOver({ origin: [-3, 1, 4], direction: [S, 0, -S] }, [0, 1])).toBeCloseTo(1);
  });
});
