import { describe, expect, test } from "vitest";
import { headingOfTurn, pageTurn, toCore, toPage } from "../../../web/src/model/frames";
import type { Vector3 } from "../../../web/src/model/state";
import golden from "../../golden/frames.json";

const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const vector = (numbers: readonly number[]): Vector3 => numbers as unknown as Vector3;

/** toEqual tells 0 from −0, which is the same place. */
const expectSame = (a: readonly number[], b: readonly number[]): void => {
  expect(a.map((value) => value + 0)).toEqual(b);
};

describe("core and page frame", () => {
  test.each(golden.points)("core $core is page $page", ({ core, page }) => {
    expectSame(toPage(vector(core)), page);
  });

  test.each(golden.points)("page $page is core $core", ({ core, page }) => {
    expectSame(toCore(vector(page)), core);
  });

  test.each(golden.fronts)("$name is the turn of the golden file, and back", (front) => {
    const turn = pageTurn(radians(front.heading_degrees));
    expect(turn).toBeCloseTo(radians(front.turn_degrees), 12);
    expect(headingOfTurn(turn)).toBeCloseTo(radians(front.heading_degrees), 12);
  });
});
