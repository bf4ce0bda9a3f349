import { describe, expect, test } from "vitest";
import type { State } from "../../../web/src/model/state";
import { KEYS } from "../../../web/src/ui/keyboard";
import { answer, begin, box, placement } from "../rooms";
import { sitDown } from "./desk";

const times = (count: number, key: string): string[] => Array<string>(count).fill(key);

/** A sofa on the first of two places. */
function placing(): State {
  const desk = sitDown(begin());
  desk.act({
    type: "place",
    category: "Sofa",
    item: null,
    size: null,
    mode: "scenegen",
    view: [1, 1],
  });
  const ask = desk.state.placing?.ask ?? "";
  const far = placement(2, { center: [3.5, 3, 0.4], heading: Math.PI });
  const near = placement(1, { center: [1.5, 1.5, 0.4] });
  desk.act({ type: "answer", answer: answer(ask, 0, { placements: [near, far] }) });
  return desk.state;
}

function selected(): ReturnType<typeof sitDown> {
  const desk = sitDown(begin([box("a")]));
  desk.act({ type: "select", selection: { kind: "box", id: "a" } });
  return desk;
}

test("no key means two things", () => {
  const keys = KEYS.flatMap((binding) => binding.keys);
  expect(new Set(keys).size).toBe(keys.length);
});

test("a key that means nothing just now goes its usual way", () => {
  const desk = sitDown(begin());
  expect(desk.type(["ArrowUp"])).toBe(false);
  expect(desk.type(["1"])).toBe(false);
  expect(desk.type(["Enter"])).toBe(false);
  expect(desk.type(["Escape"])).toBe(false);
  expect(desk.type(["x"])).toBe(false);
  expect(desk.type(["b"], { ctrlKey: true })).toBe(false);
});

describe("what is selected", () => {
  test("Ctrl D makes another one, and means nothing while nothing is selected", () => {
    const desk = selected();
    desk.type(["d"], { ctrlKey: true });
    expect(desk.state.scene.boxes).toHaveLength(2);
    expect(sitDown(begin([box("a")])).type(["d"], { ctrlKey: true })).toBe(false);
  });

  test("arrows move it by 5 cm, with Shift by 1 cm", () => {
    const desk = selected();
    desk.type(["ArrowRight", "ArrowRight", "ArrowUp"]);
    expect(desk.state.scene.boxes[0]?.center).toEqual([2.6, 2.05, 0.4]);
    desk.type(["ArrowLeft"], { shiftKey: true });
    expect(desk.state.scene.boxes[0]?.center[0]).toBeCloseTo(2.59, 9);
  });

  test("[ turns it 15° to the left, ] back, with Shift by 1°", () => {
    const desk = selected();
    desk.type(["["]);
    expect(desk.state.scene.boxes[0]?.heading).toBeCloseTo(Math.PI / 12, 9);
    desk.type(["]"]);
    desk.type(["{"], { shiftKey: true });
    expect(desk.state.scene.boxes[0]?.heading).toBeCloseTo(Math.PI / 180, 9);
  });

  test("Del deletes it, Ctrl Z brings it back, Ctrl Shift Z deletes it again", () => {
    const desk = selected();
    desk.type(["Delete"]);
    expect(desk.state.scene.boxes).toHaveLength(0);
    desk.type(["z"], { ctrlKey: true });
    expect(desk.state.scene.boxes).toHaveLength(1);
    desk.type(["Z"], { ctrlKey: true, shiftKey: true });
    expect(desk.state.scene.boxes).toHaveLength(0);
  });

  test("Esc lets go of it", () => {
    const desk = selected();
    desk.type(["Escape"]);
    expect(desk.state.selection).toBeNull();
  });
});

describe("placing", () => {
  test("a number shows that place, Enter makes it solid there", () => {
    const desk = sitDown(placing());
    desk.type(["2", "Enter"]);
    expect(desk.state.placing).toBeNull();
    expect(desk.state.scene.boxes[0]).toMatchObject({ category: "Sofa", center: [3.5, 3, 0.4] });
  });

  test("a number without a place does nothing", () => {
    expect(sitDown(placing()).type(["3"])).toBe(false);
  });

  test("arrows move the ghost away from its place", () => {
    const desk = sitDown(placing());
    desk.type(["ArrowUp"]);
    expect(desk.state.placing?.pose?.center).toEqual([1.5, 1.55, 0.4]);
    expect(desk.state.placing?.alternative).toBeNull();
  });

  test("M goes from SceneGen to Manual and keeps the object", () => {
    const desk = sitDown(placing());
    desk.type(["m"]);
    expect(desk.state.placing).toMatchObject({ mode: "manual", category: "Sofa" });
    expect(desk.local.mode).toBe("manual");
  });

  test("M before placing sets how the next object is placed", () => {
    const desk = sitDown(begin());
    desk.type(["m"]);
    expect(desk.local.mode).toBe("manual");
  });

  test("Esc cancels and leaves the room as it was", () => {
    const desk = sitDown(placing());
    desk.type(["Escape"]);
    expect(desk.state.placing).toBeNull();
    expect(desk.state.scene.boxes).toHaveLength(0);
  });
});

describe("drawing with keys alone", () => {
  test("B and Enter put a box of one by one metre where the view looks", () => {
    const desk = sitDown(begin());
    desk.type(["b", "Enter"]);
    expect(desk.state.scene.boxes).toHaveLength(1);
    expect(desk.state.scene.boxes[0]).toMatchObject({ center: [1, 1, 0.375], size: [1, 1, 0.75] });
    expect(desk.state.selection).toMatchObject({ kind: "box" });
  });

  test("D and Enter put a door of the usual width into the nearest wall", () => {
    const desk = sitDown(begin());
    desk.type(["d", "Enter"]);
    const [door] = desk.state.scene.room.doors;
    const width = Math.hypot(
      (door?.end[0] ?? 0) - (door?.start[0] ?? 0),
      (door?.end[1] ?? 0) - (door?.start[1] ?? 0),
    );
    expect(width).toBeCloseTo(0.9, 6);
  });

  test("the outline: arrows move the crosshair by half a metre, Enter sets a corner", () => {
    const desk = sitDown(begin());
    desk.type(["r", "Enter"]);
    desk.type([...times(8, "ArrowRight"), "Enter"]);
    desk.type([...times(6, "ArrowUp"), "Enter"]);
    desk.type([...times(8, "ArrowLeft"), "Enter"]);
    desk.type([...times(6, "ArrowDown"), "Enter"]);
    expect(desk.state.scene.room.corners).toEqual([
      [1, 1],
      [5, 1],
      [5, 4],
      [1, 4],
    ]);
    expect(desk.state.tool).toBe("select");
  });

  test("Backspace takes back the last corner", () => {
    const desk = sitDown(begin());
    desk.type(["r", "Enter", "ArrowRight", "Enter", "Backspace"]);
    expect(desk.state.draft).toMatchObject({ kind: "room", corners: [[1, 1]] });
  });
});

test("H, G and L switch what is shown, C goes through the cameras", () => {
  const desk = sitDown(begin());
  desk.type(["h", "g", "l", "c"]);
  expect(desk.state.shown).toMatchObject({
    heat: false,
    graph: true,
    labels: false,
    camera: "top",
  });
  desk.type(["c", "c"]);
  expect(desk.state.shown.camera).toBe("orbit");
});

test("Ctrl S saves, ? asks for help", () => {
  const desk = sitDown(begin());
  desk.type(["s"], { ctrlKey: true });
  desk.type(["?"], { shiftKey: true });
  expect(desk.saved).toBe(1);
  expect(desk.state.help).toBe(true);
});
