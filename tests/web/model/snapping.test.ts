import { describe, expect, test } from "vitest";
import { snapBox, snapPoint } from "../../../web/src/model/snapping";
import { box, room } from "../rooms";

const sofa = box("sofa", { category: "Sofa", size: [0.9, 2, 0.8], center: [2.5, 2, 0.4] });

describe("walls", () => {
  test("a sofa 10 cm from the wall goes flush and turns its back to it", () => {
    const near = { ...sofa, center: [2.5, 0.55, 0.4] as const, heading: Math.PI / 2 - 0.2 };
    // Turned by 0.2 rad it reaches a little further; its front edge was 0.1 m off when straight.
    const { box: snapped } = snapBox(room(), near, false);
    expect(snapped.heading).toBeCloseTo(Math.PI / 2, 12);
    expect(snapped.center[1]).toBeCloseTo(0.45, 3);
  });

  test("a sofa pushed some way into the wall comes back out", () => {
    const pushed = { ...sofa, center: [2.5, 0.3, 0.4] as const, heading: Math.PI / 2 };
    expect(snapBox(room(), pushed, false).box.center).toEqual([2.5, 0.45, 0.4]);
  });

  test("a sofa 20 cm from the wall is left alone", () => {
    const off = { ...sofa, center: [2.5, 0.65, 0.4] as const, heading: Math.PI / 2 };
    expect(snapBox(room(), off, false)).toEqual({ box: off, guides: [] });
  });

  test("in a corner it is flush with both walls, and both are shown", () => {
    const corner = { ...sofa, center: [1.1, 0.5, 0.4] as const, heading: Math.PI / 2 };
    const { box: snapped, guides } = snapBox(room(), corner, false);
    expect(snapped.center).toEqual([1, 0.45, 0.4]);
    expect(guides).toHaveLength(2);
  });

  test("a chair keeps the side that it turns to the wall", () => {
    const chair = box("c", { category: "Chair", size: [0.5, 0.5, 0.9], center: [2.5, 0.3, 0.45] });
    expect(snapBox(room(), { ...chair, heading: 0 }, false).box.heading).toBeCloseTo(0, 12);
  });

  test("Alt lets go of everything", () => {
    const near = { ...sofa, center: [2.5, 0.5, 0.4] as const, heading: 1 };
    expect(snapBox(room(), near, true)).toEqual({ box: near, guides: [] });
  });
});

describe("other boxes", () => {
  const table = box("table", { center: [2.5, 2, 0.4], size: [1, 1, 0.8] });

  test("a box 5 cm beside another touches it", () => {
    const near = box("b", { center: [3.55, 2.3, 0.4], size: [1, 1, 0.8] });
    expect(snapBox(room([table]), near, false).box.center).toEqual([3.5, 2.3, 0.4]);
  });

  test("a box whose middle is 4 cm off another's is lined up, and a guide joins them", () => {
    const near = box("b", { center: [1, 2.04, 0.4], size: [0.6, 0.6, 0.8] });
    const { box: snapped, guides } = snapBox(room([table]), near, false);
    expect(snapped.center).toEqual([1, 2, 0.4]);
    const [guide = []] = guides;
    expect(guide.toSorted((a, b) => a[0] - b[0])).toEqual([
      [0.7, 2],
      [3, 2],
    ]);
  });

  test("a box that is turned by 20 degrees does not line up", () => {
    const turned = box("b", { center: [1, 2.04, 0.4], heading: 0.35 });
    expect(snapBox(room([table]), turned, false)).toEqual({ box: turned, guides: [] });
  });

  test("a box does not snap to where it was itself", () => {
    const moved = { ...table, center: [2.54, 2.04, 0.4] as const };
    expect(snapBox(room([table]), moved, false).box).toEqual(moved);
  });
});

describe("points", () => {
  test("a point near a corner of the room is that corner", () => {
    expect(snapPoint(room(), [4.96, 0.05], false)).toEqual([5, 0]);
  });

  test("a point near a wall is on it", () => {
    expect(snapPoint(room(), [2, 0.07], false)).toEqual([2, 0]);
  });

  test("a point near the edge of a box is on it", () => {
    const table = box("table", { center: [2.5, 2, 0.4], size: [1, 1, 0.8] });
    expect(snapPoint(room([table]), [3.05, 2], false)).toEqual([3, 2]);
  });

  test("with Alt a point stays where it is", () => {
    expect(snapPoint(room(), [2, 0.07], true)).toEqual([2, 0.07]);
  });
});
