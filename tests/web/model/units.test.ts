import { expect, test } from "vitest";
import { formatAngle, formatArea, formatLength, formatSize } from "../../../web/src/model/units";

test("lengths of a metre and more have one decimal, shorter ones two", () => {
  expect(formatLength(1.1)).toBe("1.1 m");
  expect(formatLength(2)).toBe("2.0 m");
  expect(formatLength(0.45)).toBe("0.45 m");
});

test("what rounds to a metre is written as one", () => {
  expect(formatLength(0.996)).toBe("1.0 m");
});

test("a size lists its lengths in the order given", () => {
  expect(formatSize([0.9, 2, 0.8])).toBe("0.90 × 2.0 × 0.80 m");
});

test("an area has one decimal", () => {
  expect(formatArea(20)).toBe("20.0 m²");
});

test("angles are whole degrees from 0 to 359", () => {
  expect(formatAngle(Math.PI / 2)).toBe("90°");
  expect(formatAngle(-Math.PI / 2)).toBe("270°");
  expect(formatAngle(2 * Math.PI)).toBe("0°");
  expect(formatAngle(-0.001)).toBe("0°");
});
