import { expect, test } from "vitest";
import { sidesOf } from "../../../web/src/model/sides";
import type { Point } from "../../../web/src/model/state";
import { room } from "../rooms";

const shaped = (corners: readonly Point[]) => sidesOf({ ...room().room, corners });

test("north is up on the plan, and each name lies outside of its wall", () => {
  expect(sidesOf(room().room).map(({ name, places }) => [name, places[0]])).toEqual([
    ["North", [2.5, 4.3]],
    ["East", [5.3, 2]],
    ["South", [2.5, -0.3]],
    ["West", [-0.3, 2]],
  ]);
});

test("of several walls on a side the longest has the name", () => {
  const bay: Point[] = [
    [0, 0],
    [5, 0],
    [5, 4],
    [4, 4],
    [4, 3],
    [0, 3],
  ];
  expect(shaped(bay)[0]?.places[0]).toEqual([2, 3.3]);
});

test("a side without a wall has no name", () => {
  const wedge: Point[] = [
    [0, 0],
    [4, 0],
    [2, 8],
  ];
  expect(shaped(wedge).map(({ name }) => name)).toEqual(["East", "South", "West"]);
});
