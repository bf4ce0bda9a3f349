import { expect, test } from "vitest";
import { fileProblem } from "../../web/src/room_files";
import { box, room } from "./rooms";

test("a scene file is left to the server", () => {
  expect(fileProblem(JSON.stringify(room([box("table")])))).toBeNull();
});

test("half a file, or one that is no JSON, is told apart from one of another program", () => {
  expect(fileProblem(JSON.stringify(room()).slice(0, 80))).toMatch(/a part of it is missing/);
  expect(fileProblem("")).toMatch(/a part of it is missing/);
  expect(fileProblem('{"name": "scenegen", "version": "1.0.0"}')).toMatch(/no room in this file/);
  expect(fileProblem("null")).toMatch(/no room in this file/);
});

test("too many things are counted", () => {
  const boxes = Array.from({ length: 501 }, (_, i) => box(`box-${i}`));
  expect(fileProblem(JSON.stringify(room(boxes)))).toBe(
    "There are 501 things in this file; a room holds 500 at most.",
  );
});
