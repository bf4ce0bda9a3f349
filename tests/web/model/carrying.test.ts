import { describe, expect, test } from "vitest";
import { loadOf } from "../../../web/src/model/carrying";
import type { State } from "../../../web/src/model/state";
import type { BoxRecord } from "../../../web/src/net/protocol.gen";
import { begin, box, play, room } from "../rooms";

const table = box("table", { size: [0.8, 1.2, 0.8], center: [2.5, 2, 0.4] });
const tray = box("tray", { category: "Other", size: [0.4, 0.4, 0.04], center: [2.7, 2.3, 0.82] });
const cup = box("cup", { category: "Decor", size: [0.1, 0.1, 0.1], center: [2.7, 2.4, 0.89] });
const lamp = box("lamp", { category: "Decor", size: [0.3, 0.3, 0.3], center: [2.5, 2, 1.8] });
const chair = box("chair", { category: "Chair", size: [0.5, 0.5, 0.9], center: [2.2, 2, 0.45] });
const all = [table, tray, cup, lamp, chair];

const ids = (boxes: readonly BoxRecord[]) => boxes.map(({ id }) => id).sort();
const load = (carrier: BoxRecord, ...others: readonly BoxRecord[]) =>
  ids(loadOf(room([carrier, ...others]), carrier));
const boxIn = (state: State, id: string) => state.scene.boxes.find((one) => one.id === id);

describe("what stands on a thing", () => {
  test("is what rests on its top, and what rests on that", () => {
    expect(load(table, tray, cup, lamp, chair)).toEqual(["cup", "tray"]);
  });

  test("a cushion lies in a sofa, a picture hangs behind it", () => {
    const sofa = box("sofa", { category: "Sofa", size: [0.9, 2, 0.8] });
    const cushion = box("cushion", { size: [0.4, 0.4, 0.3], center: [2.5, 2.5, 0.6] });
    const picture = box("picture", {
      category: "Picture",
      size: [0.04, 0.8, 0.6],
      center: [2.1, 2, 1],
    });
    expect(load(sofa, cushion, picture)).toEqual(["cushion"]);
  });

  test("what stands on a rug stands on the floor", () => {
    const rug = box("rug", { category: "Decor", size: [2, 2, 0.02], center: [2.5, 2, 0.01] });
    expect(load(rug, table, chair)).toEqual([]);
  });

  test("a parent that a source names counts wherever it is, in a ring too", () => {
    const one = { ...table, parent: "lamp" };
    expect(load(one, { ...lamp, parent: "table" })).toEqual(["lamp"]);
  });
});

describe("it goes along", () => {
  const drag = (at: BoxRecord, done = false) => ({ type: "edit-box", box: at, done }) as const;

  test("with a table that is moved, and back with one undo", () => {
    const start = begin(all);
    const moved = play(
      start,
      drag({ ...table, center: [2.6, 2, 0.4] }),
      drag({ ...table, center: [3, 2.5, 0.4] }, true),
    );
    expect(boxIn(moved, "tray")?.center).toEqual([3.2, 2.8, 0.82]);
    expect(boxIn(moved, "cup")?.center).toEqual([3.2, 2.9, 0.89]);
    expect(boxIn(moved, "lamp")).toBe(lamp);
    expect(boxIn(moved, "chair")).toBe(chair);
    expect(play(moved, { type: "undo" }).scene).toBe(start.scene);
  });

  test("with a table that is turned: a quarter turn takes +x to +y", () => {
    const turned = play(
      begin(all),
      { type: "select", selection: { kind: "box", id: "table" } },
      { type: "turn", by: Math.PI / 2 },
    );
    // The tray was 0.2 m along x and 0.3 m along y from the middle of the table.
    expect(boxIn(turned, "tray")?.center).toEqual([2.2, 2.2, 0.82]);
    expect(boxIn(turned, "tray")?.heading).toBeCloseTo(Math.PI / 2, 12);
  });

  test("up with a table that becomes higher, not aside with one that becomes wider", () => {
    const higher = play(
      begin(all),
      drag({ ...table, size: [0.8, 1.2, 0.9], center: [2.5, 2, 0.45] }, true),
    );
    expect(boxIn(higher, "tray")?.center).toEqual([2.7, 2.3, 0.92]);
    const wider = play(
      begin(all),
      drag({ ...table, size: [0.8, 1.6, 0.8], center: [2.5, 2.2, 0.4] }, true),
    );
    expect(boxIn(wider, "tray")).toBe(tray);
  });

  test("what a table passes by on the way stays where it is", () => {
    const shelf = box("shelf", { category: "Storage", center: [4, 2, 0.4], size: [0.4, 0.4, 0.8] });
    const vase = box("vase", { category: "Decor", size: [0.1, 0.1, 0.3], center: [4, 2, 0.95] });
    const passed = play(
      begin([table, shelf, vase]),
      drag({ ...table, center: [4, 2, 0.4] }),
      drag({ ...table, center: [2.5, 3, 0.4] }, true),
    );
    expect(boxIn(passed, "vase")).toBe(vase);
  });

  test("when a table is taken away, and says so", () => {
    const start = begin(all);
    const gone = play(start, { type: "remove-box", id: "table" });
    expect(ids(gone.scene.boxes)).toEqual(["chair", "lamp"]);
    expect(gone.notice?.text).toBe("With it went the 2 things on it. Undo brings all back.");
    expect(play(gone, { type: "undo" }).scene).toBe(start.scene);
    const selected = play(
      begin([table, tray]),
      { type: "select", selection: { kind: "box", id: "table" } },
      { type: "delete-selected" },
    );
    expect(selected.scene.boxes).toEqual([]);
    expect(selected.notice?.text).toBe("With it went something else. Undo brings both back.");
  });

  test("no longer once it was taken off, whatever a source says", () => {
    const source = begin([table, { ...cup, parent: "table" }]);
    const moved = play(source, drag({ ...cup, parent: "table", center: [2.7, 2.1, 0.85] }, true));
    expect(boxIn(moved, "cup")?.parent).toBe("table");
    const off = play(source, drag({ ...cup, parent: "table", center: [4, 1, 0.05] }, true));
    expect(boxIn(off, "cup")?.parent).toBeNull();
    const after = play(off, drag({ ...table, center: [2.5, 3, 0.4] }, true));
    expect(boxIn(after, "cup")?.center).toEqual([4, 1, 0.05]);
  });

  test("not back with a table that is removed while it is dragged", () => {
    const removed = play(
      begin([table, cup]),
      drag({ ...table, center: [2.6, 2, 0.4] }),
      { type: "remove-box", id: "table" },
      drag({ ...table, center: [2.7, 2, 0.4] }),
    );
    expect(removed.scene.boxes).toEqual([]);
  });

  test("with a middle exactly over the edge of the table, on every side", () => {
    for (const [x, y] of [
      [2.1, 2],
      [2.9, 2],
      [2.5, 1.4],
      [2.5, 2.6],
    ] as const) {
      expect(load(table, { ...cup, center: [x, y, 0.85] })).toEqual(["cup"]);
    }
  });

  test("not when a thing that carries nothing is taken away", () => {
    const gone = play(begin(all), { type: "remove-box", id: "lamp" });
    expect(ids(gone.scene.boxes)).toEqual(["chair", "cup", "table", "tray"]);
    expect(gone.notice?.text).toBe("Without the decor piece now. Undo brings it back.");
    expect(play(gone, { type: "undo" }).notice).toBeNull();
  });
});
