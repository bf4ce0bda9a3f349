import { expect, test } from "vitest";
import { hangs } from "../../../web/src/model/hanging";
import { box, room } from "../rooms";

const tv = box("tv", { category: "TV", size: [0.1, 1, 0.6], center: [2.5, 2, 1.1] });
const unit = box("unit", { category: "Storage", size: [0.4, 1.4, 0.8], center: [2.5, 2, 0.4] });

test("a television high on the wall hangs, one that stands on a high cabinet does not", () => {
  expect(hangs(tv, room([tv]))).toBe(true);
  expect(hangs(tv, room([tv, unit]))).toBe(false);
  expect(hangs({ ...tv, center: [2.5, 2, 0.8] }, room([tv]))).toBe(false);
});

test("a picture hangs wherever it is, a cupboard is a box like others", () => {
  expect(hangs({ ...tv, category: "Picture" }, room([unit]))).toBe(true);
  expect(hangs({ ...tv, category: "Storage" }, room())).toBe(false);
});
