import { expect, test } from "vitest";
import { sidesOf } from "../../../web/src/model/sides";
import type { Point } from "../../../web/src/model/state";
import { room } from "../rooms";

const shaped = (corners: readonly Point[]) => sidesOf({ ...room().room, corners });

test("north is up on the plan, and each name lies outside of its wall", () => {
  const sides = sidesOf(room().room).map(({ name, places }) => [name, places[0]]);
  expect(Object.fromEntries(sides)).toEqual({
    north: [2.5, 4.3],
    east: [5.3, 2],
    south: [2.5, -0.3],
    west: [-0.3, 2],
  });
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
  expect(shaped(bay).find(({ name }) => name === "north")?.places[0]).toEqual([2, 3.3]);
});

test("a slanting wall has the name that texts give it, and a side without a wall has none", () => {
  const wedge: Point[] = [
    [0, 0],
    [4, 0],
    [0, 4],
  ];
  const names = shaped(wedge).map(({ name }) => name);
  expect(names.toSorted()).toEqual(["north-east", "south", "west"]);
});
