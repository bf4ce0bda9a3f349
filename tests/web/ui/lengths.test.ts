import { describe, expect, test } from "vitest";
import { parseLength, shown } from "../../../web/src/ui/lengths";

const metres = (text: string, unit: "cm" | "m") => {
  const typed = parseLength(text, unit);
  return typed.ok ? typed.metres : typed.problem;
};

describe("a length as people type it", () => {
  test.each([
    ["85", "cm", 0.85],
    ["85 cm", "m", 0.85],
    ["0.85", "cm", 0.85],
    ["0,85 m", "cm", 0.85],
    ["850mm", "cm", 0.85],
    [" 3 ", "m", 3],
    ["3,5", "m", 3.5],
    ["12.5", "cm", 0.125],
    ["5", "cm", 0.05],
  ] as const)("%j in a field of %s is %d metres", (text, unit, expected) => {
    expect(metres(text, unit)).toBe(expected);
  });

  test.each([
    ["", "cm", "Type a number, like 85 or 0.85 m."],
    ["wide", "m", "Type a number, like 3.5."],
    ["1e3", "cm", "Type a number, like 85 or 0.85 m."],
    ["0", "cm", "At least 1 cm."],
    ["-20", "cm", "At least 1 cm."],
    ["101", "m", "At most 100 m."],
  ] as const)("%j in a field of %s is refused with what to do", (text, unit, problem) => {
    expect(metres(text, unit)).toBe(problem);
  });

  test("a field may allow less", () => {
    const typed = parseLength("3", "m", { min: 0, max: 2.6 });
    expect(typed).toEqual({ ok: false, problem: "At most 2.6 m." });
  });
});

test("a field shows whole centimetres, thin things by the millimetre", () => {
  expect(shown(0.974, "cm")).toBe("97");
  expect(shown(0.045, "cm")).toBe("4.5");
  expect(shown(3.25, "m")).toBe("3.25");
  expect(shown(4, "m")).toBe("4");
});
