import { describe, expect, test } from "vitest";
import { likelyCategories, usualSize } from "../../../web/src/model/labels";
import type { CategoryInfo } from "../../../web/src/net/protocol.gen";

const info = (name: string, size: readonly [number, number, number]): CategoryInfo => ({
  name,
  symmetry: "asymmetric",
  placeable: true,
  size,
  examples: 10,
});

describe("likely categories", () => {
  test.each([
    ["a double bed", [2.05, 1.7, 0.55], "Bed"],
    ["a two-seater", [0.9, 1.8, 0.8], "Sofa"],
    ["a dining chair", [0.52, 0.47, 0.9], "Chair"],
    ["a framed print", [0.03, 0.7, 0.5], "Picture"],
    ["a bookcase", [0.35, 0.9, 1.8], "Storage"],
  ] as const)("%s is most likely named first", (_, size, category) => {
    expect(likelyCategories(size, [])[0]).toBe(category);
  });

  test("which side was called depth does not matter", () => {
    expect(likelyCategories([1.8, 0.9, 0.8], [])[0]).toBe("Sofa");
  });

  test("Other is always last, even for a thing of just its size", () => {
    expect(likelyCategories([0.5, 0.5, 0.5], []).at(-1)).toBe("Other");
  });

  test("the server's categories are the ones on offer", () => {
    const known = [
      info("Other", [1, 1, 1]),
      info("Piano", [0.6, 1.5, 1.2]),
      info("Lamp", [0.3, 0.3, 1.5]),
    ];
    expect(likelyCategories([0.6, 1.4, 1.1], known)).toEqual(["Piano", "Lamp", "Other"]);
  });
});

test("the server's usual size counts more than the built-in one", () => {
  expect(usualSize("Sofa", [info("Sofa", [1, 2.4, 0.7])])).toEqual([1, 2.4, 0.7]);
});
