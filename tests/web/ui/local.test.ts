import { describe, expect, test } from "vitest";
import { cycled, stepped } from "../../../web/src/ui/sheet";
import { answer, begin, box, placement } from "../rooms";
import { type Desk, sitDown } from "./desk";

function placeSofa(desk: Desk): void {
  desk.act({
    type: "place",
    category: "Sofa",
    item: null,
    size: null,
    mode: "scenegen",
    view: [1, 1],
  });
  const ask = desk.state.placing?.ask ?? "";
  const spot = placement(1, { center: [1.5, 1.5, 0.4], sentence: "By the window." });
  desk.act({ type: "answer", answer: answer(ask, 0, { placements: [spot] }) });
}

describe("the first minute", () => {
  test("invites until the person finds a way of their own", () => {
    const desk = sitDown(begin([box("a")]));
    desk.act({ type: "set-camera", camera: "top" });
    expect(desk.local.guide).toBe("invite");
    desk.act({ type: "choose-tool", tool: "box" });
    expect(desk.local.guide).toBe("done");
  });

  test("goes from the first sofa to the three doors", () => {
    const desk = sitDown(begin());
    desk.page.change({ guide: "placing" });
    placeSofa(desk);
    expect(desk.local.guide).toBe("placing");
    desk.act({ type: "confirm" });
    expect(desk.local.guide).toBe("doors");
  });

  test("ends when the first sofa is canceled", () => {
    const desk = sitDown(begin());
    desk.page.change({ guide: "placing" });
    placeSofa(desk);
    desk.act({ type: "cancel" });
    expect(desk.local.guide).toBe("done");
  });
});

describe("what was placed last", () => {
  test("is kept with its sentence, to place another", () => {
    const desk = sitDown(begin());
    placeSofa(desk);
    desk.act({ type: "confirm" });
    expect(desk.local.placed).toMatchObject({ category: "Sofa", sentence: "By the window." });
  });

  test("is forgotten once it is undone", () => {
    const desk = sitDown(begin());
    placeSofa(desk);
    desk.act({ type: "confirm" }, { type: "undo" });
    expect(desk.local.placed).toBeNull();
  });

  test("is nothing when placing was canceled", () => {
    const desk = sitDown(begin());
    placeSofa(desk);
    desk.act({ type: "cancel" });
    expect(desk.local.placed).toBeNull();
  });
});

describe("the sheet of the phone", () => {
  test("stays low for placing, so that the room is seen, and makes way afterwards", () => {
    const desk = sitDown(begin());
    placeSofa(desk);
    expect(desk.local.sheet).toBe("peek");
    desk.page.change({ sheet: "half" });
    desk.act({ type: "confirm" });
    expect(desk.local.sheet).toBe("peek");
  });

  test("steps up and down and stays at its ends", () => {
    expect(stepped("peek", 1)).toBe("half");
    expect(stepped("half", 2)).toBe("full");
    expect(stepped("peek", -1)).toBe("peek");
  });

  test("a tap goes round: peek, half, full, peek", () => {
    expect(cycled("peek")).toBe("half");
    expect(cycled("half")).toBe("full");
    expect(cycled("full")).toBe("peek");
  });
});

test("what was placed is old news once something else is drawn", () => {
  const desk = sitDown(begin());
  const placed = {
    category: "Sofa",
    item: null,
    size: null,
    mode: "manual",
    sentence: "",
  } as const;
  desk.page.change({ placed });
  desk.act({ type: "choose-tool", tool: "box" });
  expect(desk.local.placed).toBeNull();
});
