import { describe, expect, test } from "vitest";
import {
  headingFromWall,
  nearestWall,
  onWall,
  snappedToWall,
  wallsOf,
  withCorners,
  withWallLength,
} from "../../../web/src/model/walls";
import type { OpeningRecord, RoomRecord } from "../../../web/src/net/protocol.gen";
import { room } from "../rooms";

const DOOR: OpeningRecord = { id: "door-1", start: [1, 0], end: [2, 0], bottom: 0, top: 2 };
const ROOM: RoomRecord = { ...room().room, doors: [DOOR] };

describe("walls", () => {
  test("the inside of a wall is on its left", () => {
    expect(wallsOf(ROOM).map(({ inward }) => inward.map((value) => value + 0))).toEqual([
      [0, 1],
      [-1, 0],
      [0, -1],
      [1, 0],
    ]);
  });

  test("the wall nearest to a point is the one least far from it", () => {
    expect(nearestWall(ROOM, [4.5, 2])?.index).toBe(1);
    expect(nearestWall(ROOM, [2, 3.9])?.index).toBe(2);
  });

  test("what stands with its back to the wall at x = 0 looks along +x", () => {
    expect(headingFromWall(ROOM, [0.3, 2])).toBeCloseTo(0, 12);
  });
});

describe("doors and windows", () => {
  test("a door dragged into the room goes back onto the nearest wall", () => {
    const dragged = { ...DOOR, start: [4.7, 1] as const, end: [4.7, 2] as const };
    expect(snappedToWall(ROOM, dragged)).toMatchObject({ start: [5, 1], end: [5, 2] });
  });

  test("a door dragged past the end of a wall stops at the corner", () => {
    const dragged = { ...DOOR, start: [4.2, 0.1] as const, end: [5.2, 0.1] as const };
    expect(snappedToWall(ROOM, dragged)).toMatchObject({ start: [4, 0], end: [5, 0] });
  });

  test("a window wider than its wall is made as wide as the wall", () => {
    const wall = wallsOf(ROOM)[1];
    if (wall === undefined) throw new Error("no wall");
    expect(onWall(DOOR, wall, 2, 9)).toMatchObject({ start: [5, 0], end: [5, 4] });
  });

  test("when a corner moves, the door stays as far along its wall in proportion", () => {
    // The wall of 5 m becomes one of 10 m; the middle of the door goes from 1.5 m to 3 m.
    const moved = withCorners(ROOM, [
      [0, 0],
      [10, 0],
      [5, 4],
      [0, 4],
    ]);
    expect(moved.doors[0]).toMatchObject({ start: [2.5, 0], end: [3.5, 0] });
  });

  test("a door on a wall that did not move is the very same value", () => {
    const moved = withCorners(ROOM, [
      ROOM.corners[0] ?? [0, 0],
      ROOM.corners[1] ?? [5, 0],
      [6, 5],
      [0, 4],
    ]);
    expect(moved.doors[0]).toBe(DOOR);
  });
});

test("a rectangle whose wall is given another length stays a rectangle", () => {
  expect(withWallLength(ROOM, 0, 6).corners).toEqual([
    [0, 0],
    [6, 0],
    [6, 4],
    [0, 4],
  ]);
});
