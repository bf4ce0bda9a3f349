import { expect, test } from "vitest";
import { buttonAt, LAYOUT, placedButtons } from "../../../web/src/xr/panel_layout";

const ROWS = [["a", "b", "c", "d"], ["e"], ["f", "g"]] as const;

test("each button of the floating panel is pressed at its middle, and nothing between them", () => {
  const placed = placedButtons(ROWS);
  for (const { button, x, y, width, height } of placed) {
    expect(buttonAt(placed, x + width / 2, y + height / 2)).toBe(button);
    expect(buttonAt(placed, x + width + LAYOUT.gap / 2, y + height / 2)).toBeUndefined();
  }
});

test("the buttons stay on the panel and do not cover one another", () => {
  const placed = placedButtons(ROWS);
  for (const one of placed) {
    expect(one.x).toBeGreaterThanOrEqual(0);
    expect(one.x + one.width).toBeLessThanOrEqual(LAYOUT.width);
    expect(one.y + one.height).toBeLessThanOrEqual(LAYOUT.height);
    const covers = placed.filter(
      (other) =>
        other !== one &&
        Math.abs(other.y - one.y) < one.height &&
        Math.abs(other.x + other.width / 2 - one.x - one.width / 2) < (one.width + other.width) / 2,
    );
    expect(covers).toEqual([]);
  }
});
