import { describe, expect, it } from "vitest";
import { emptyScene, initialState } from "../../../web/src/model/initial";
import type { State } from "../../../web/src/model/state";
import type { BoxRecord } from "../../../web/src/net/protocol.gen";
import { drag, gripBox } from "../../../web/src/views/dragging";
import { dragSpot } from "../../../web/src/views/handle_drag";
import { type Spot, spotsOf } from "../../../web/src/views/handle_spots";
import type { Ray } from "../../../web/src/views/picking";

/** A table in the middle of the bare room of 5 m by 4 m, its front to the east. */
const TABLE: BoxRecord = {
  id: "table",
  category: "Table",
  center: [2.5, 2, 0.4],
  size: [1, 2, 0.8],
  heading: 0,
};
const down = (x: number, y: number): Ray => ({ origin: [x, y, 5], direction: [0, 0, -1] });

function selected(...boxes: readonly BoxRecord[]): State {
  const state = initialState({ ...emptyScene("room"), boxes });
  return { ...state, selection: { kind: "box", id: boxes[0]?.id ?? "" } };
}

function spot(state: State, wanted: (spot: Spot) => boolean): Spot {
  const found = spotsOf(state).find(wanted);
  if (!found) throw new Error("no such handle");
  return found;
}

function edited(state: State, which: Spot, ray: Ray, free = true): BoxRecord {
  const action = dragSpot(state, which, ray, free, false);
  if (action?.type !== "edit-box") throw new Error("no edit");
  return action.box;
}

describe("the handles of a selected box", () => {
  const state = selected(TABLE);

  it("are four sides, the height and the turn", () => {
    expect(spotsOf(state).map(({ kind }) => kind)).toEqual([
      "side",
      "side",
      "side",
      "side",
      "height",
      "turn",
    ]);
  });

  it("move one side while the opposite side stays", () => {
    const front = spot(state, (one) => one.kind === "side" && one.side === 0);
    expect(front.at[0]).toBeCloseTo(3);
    const box = edited(state, front, down(3.5, 2));
    expect(box.size).toEqual([1.5, 2, 0.8]);
    expect(box.center[0] - box.size[0] / 2).toBeCloseTo(2);
    const left = spot(state, (one) => one.kind === "side" && one.side === 1);
    const wider = edited(state, left, down(2.5, 3.4));
    expect(wider.size[1]).toBeCloseTo(2.4);
    expect(wider.center[1] - wider.size[1] / 2).toBeCloseTo(1);
  });

  it("never turn a box inside out", () => {
    const front = spot(state, (one) => one.kind === "side" && one.side === 0);
    expect(edited(state, front, down(0.5, 2)).size[0]).toBeGreaterThan(0);
  });

  it("turn the front towards the pointer, and stop at round angles unless let go", () => {
    const turn = spot(state, ({ kind }) => kind === "turn");
    const almostNorth = down(2.5 - 0.03, 3);
    expect(edited(state, turn, almostNorth, false).heading).toBeCloseTo(Math.PI / 2);
    expect(edited(state, turn, almostNorth, true).heading).toBeCloseTo(Math.PI / 2 + 0.03, 3);
  });

  it("raise the top while the box stays on the floor", () => {
    const height = spot(state, ({ kind }) => kind === "height");
    const before = height.at[2];
    const ray: Ray = { origin: [-2.5, 2, before + 0.5], direction: [1, 0, 0] };
    const box = edited(state, height, ray);
    expect(box.size[2]).toBeCloseTo(1.3);
    expect(box.center[2]).toBeCloseTo(0.65);
  });
});

describe("handles", () => {
  it("are there for every corner while the room tool waits for its first corner", () => {
    const state = initialState(emptyScene("room"));
    const drawing: State = {
      ...state,
      tool: "room",
      draft: { kind: "room", corners: [], pointer: null },
    };
    expect(spotsOf(drawing)).toHaveLength(4);
    const begun = { kind: "room", corners: [[0, 0]], pointer: null } as const;
    expect(spotsOf({ ...drawing, draft: begun })).toHaveLength(0);
  });

  it("are not there when nothing is selected", () => {
    expect(spotsOf(initialState(emptyScene("room")))).toEqual([]);
  });
});

describe("dragging a box", () => {
  const ray: Ray = { origin: [2, 2, 5], direction: [0, 0, -1] };

  it("keeps the hand where it took hold", () => {
    const state = selected(TABLE);
    const grip = gripBox(TABLE, ray, 4.2, false);
    const dragged = drag(state, grip, down(2.3, 2.2), true, false);
    expect(dragged?.action).toMatchObject({
      type: "edit-box",
      box: { center: [2.8, 2.2, 0.4] },
      done: false,
    });
  });

  it("puts it against a wall that it comes near to, and shows that wall", () => {
    const state = selected(TABLE);
    const grip = gripBox(TABLE, ray, 4.2, false);
    const dragged = drag(state, grip, down(0.1, 2), false, false);
    if (dragged?.action.type !== "edit-box") throw new Error("no edit");
    expect(dragged.action.box.center[0]).toBeCloseTo(0.5);
    expect(dragged.guides.length).toBeGreaterThan(0);
  });

  it("leaves a shelf that hangs free at its height", () => {
    const shelf: BoxRecord = { ...TABLE, id: "shelf", category: "Storage", center: [2.5, 2, 1.8] };
    const state = selected(shelf);
    const dragged = drag(state, gripBox(shelf, ray, 2.8, false), down(2.4, 2.2), true, false);
    expect(dragged?.action).toMatchObject({ box: { center: [2.9, 2.2, 1.8] } });
  });

  it("sets what stood on the floor on top of what it comes over", () => {
    const vase: BoxRecord = {
      id: "vase",
      category: "Decor",
      center: [4.5, 3.5, 0.15],
      size: [0.2, 0.2, 0.3],
    };
    const state = selected(vase, TABLE);
    const grip = gripBox(vase, down(4.5, 3.5), 4.7, false);
    const dragged = drag(state, grip, down(2.5, 2), true, true);
    if (dragged?.action.type !== "edit-box") throw new Error("no edit");
    expect(dragged.action.box.center[2]).toBeCloseTo(0.8 + 0.15);
  });

  it("carries a picture to the wall under the pointer", () => {
    const picture: BoxRecord = {
      id: "picture",
      category: "Picture",
      center: [2.5, 3.98, 1.5],
      size: [0.04, 0.8, 0.6],
      heading: -Math.PI / 2,
    };
    const state = selected(picture);
    const grip = gripBox(picture, { origin: [2.5, 1, 1.5], direction: [0, 1, 0] }, 2.9, false);
    const east: Ray = { origin: [2.5, 1, 1.2], direction: [1, 0, 0] };
    const dragged = drag(state, grip, east, false, false);
    if (dragged?.action.type !== "edit-box") throw new Error("no edit");
    expect(dragged.action.box.center[0]).toBeCloseTo(4.98);
    expect(dragged.action.box.center[2]).toBeCloseTo(1.2);
    expect(Math.cos(dragged.action.box.heading ?? 0)).toBeCloseTo(-1);
  });
});
