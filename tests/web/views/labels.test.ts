import { describe, expect, it } from "vitest";
import { hideOverlaps, type LabelBox } from "../../../web/src/views/label_layout";

const label = (x: number, y: number): LabelBox => ({ x, y, width: 60, height: 20, shown: true });
const shown = (labels: readonly LabelBox[]) => {
  hideOverlaps(labels);
  return labels.map((one) => one.shown);
};

describe("labels on the screen", () => {
  it("are all shown when they are apart", () => {
    expect(shown([label(0, 0), label(100, 0), label(0, 40)])).toEqual([true, true, true]);
  });

  it("give way to those before them", () => {
    expect(shown([label(0, 0), label(30, 5)])).toEqual([true, false]);
  });

  it("do not give way to one that is hidden itself", () => {
    expect(shown([label(0, 0), label(50, 0), label(100, 0)])).toEqual([true, false, true]);
  });

  it("give way to what is there already", () => {
    const names = [label(0, 0), label(100, 0)];
    hideOverlaps(names, [[label(110, 5)]]);
    expect(names.map((one) => one.shown)).toEqual([true, false]);
  });

  it("come back once there is room again", () => {
    const labels = [label(0, 0), label(30, 0)];
    hideOverlaps(labels);
    const second = labels[1];
    if (second) second.x = 200;
    expect(shown(labels)).toEqual([true, true]);
  });
});
