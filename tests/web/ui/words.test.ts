import { describe, expect, test } from "vitest";
import {
  counted,
  ended,
  inSentence,
  isNow,
  likelihoodInWords,
  oneOf,
  relationInWords,
  signed,
} from "../../../web/src/ui/words";

test("a category in a sentence is lower case, an abbreviation is not", () => {
  expect(inSentence("Sofa")).toBe("sofa");
  expect(inSentence("TV")).toBe("TV");
});

test("a piece of furniture has its article, storage and decor have none", () => {
  expect(oneOf("TV")).toBe("a TV");
  expect(oneOf("Storage")).toBe("storage");
});

test("one is singular", () => {
  expect(counted(1, "piece")).toBe("1 piece");
  expect(counted(0, "piece")).toBe("0 pieces");
});

test("a sentence gets one full stop", () => {
  expect(ended("Against the wall")).toBe("Against the wall.");
  expect(ended("Why not?")).toBe("Why not?");
  expect(ended("")).toBe("");
});

test("what was placed is told with its place, in one sentence", () => {
  expect(isNow("Sofa", "Against the north wall, facing the TV")).toBe(
    "The sofa is now against the north wall, facing the TV.",
  );
  expect(isNow("Picture", "")).toBe("The picture is now here.");
});

describe("relations", () => {
  test("those of the paper have plain words", () => {
    expect(relationInWords("AverageDistance")).toBe("Distance to others");
  });

  test("a relation nobody has named yet is taken apart", () => {
    expect(relationInWords("InFrontOf")).toBe("In front of");
  });
});

test("a contribution has its sign and three digits", () => {
  expect(signed(1.236)).toBe("+1.24");
  expect(signed(-0.31)).toBe("−0.31");
  expect(signed(28.25)).toBe("+28.3");
  expect(signed(-111.15)).toBe("−111");
});

test("the legend's ends are said as they are written", () => {
  expect(likelihoodInWords(0)).toBe("unlikely");
  expect(likelihoodInWords(0.7)).toBe("likely");
  expect(likelihoodInWords(1)).toBe("very likely");
});
