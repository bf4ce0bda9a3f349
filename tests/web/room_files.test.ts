import { expect, test } from "vitest";
import { fileProblem } from "../../web/src/room_files";
import { box, room } from "./rooms";

test("a scene file is left to the server", () => {
  expect(fileProblem(JSON.stringify(room([box("table")])))).toBeNull();
});

test("scans of devices are left to the server", () => {
  const scans = [
    { walls: [], objects: [], version: 2 }, // RoomPlan
    { spatialEntities: [] }, // Quest
    { CoordinateSystem: "Unity", Rooms: [] }, // MR Utility Kit
  ];
  for (const scan of scans) expect(fileProblem(JSON.stringify(scan))).toBeNull();
});

test("half a file, or one that is no JSON, is told apart from one that can be no room", () => {
  expect(fileProblem(JSON.stringify(room()).slice(0, 80))).toMatch(/a part of it is missing/);
  expect(fileProblem("")).toMatch(/a part of it is missing/);
  for (const text of ["null", "[]", "3", '"room"']) {
    expect(fileProblem(text)).toMatch(/no room in this file\. Choose a room .*RoomPlan/);
  }
});

test("too many things are counted", () => {
  const boxes = Array.from({ length: 501 }, (_, i) => box(`box-${i}`));
  expect(fileProblem(JSON.stringify(room(boxes)))).toBe(
    "There are 501 things in this file; a room holds 500 at most.",
  );
});
