import { describe, expect, test } from "vitest";
import { obstacleOf } from "../../../web/src/model/obstacles";
import { poseAt, settled } from "../../../web/src/model/resting";
import type { Pose } from "../../../web/src/model/state";
import type { BoxRecord, SceneRecord } from "../../../web/src/net/protocol.gen";
import { box, room } from "../rooms";

/** 5 m by 4 m; a door of 0.9 m in the south wall, a window from 0.9 m up in the east wall. */
function furnished(...boxes: readonly BoxRecord[]): SceneRecord {
  const bare = room(boxes);
  const door = { id: "d", start: [1, 0], end: [1.9, 0], bottom: 0, top: 2 } as const;
  const window = { id: "w", start: [5, 1], end: [5, 2], bottom: 0.9, top: 2.1 } as const;
  return { ...bare, room: { ...bare.room, doors: [door], windows: [window] } };
}

const kindOf = (scene: SceneRecord, one: BoxRecord): string | undefined =>
  obstacleOf(scene, one)?.kind;

describe("the square before a door", () => {
  const chair = (x: number, y: number): BoxRecord =>
    box("c", { category: "Chair", center: [x, y, 0.45], size: [0.5, 0.5, 0.9] });

  test("stays free, as deep as the door is wide", () => {
    expect(kindOf(furnished(), chair(1.45, 0.5))).toBe("door");
    expect(kindOf(furnished(), chair(1.45, 1.1))).toBe("door"); // from y = 0.85
    expect(kindOf(furnished(), chair(1.45, 1.2))).toBeUndefined(); // from y = 0.95
  });

  test("ends at the sides of the door", () => {
    expect(kindOf(furnished(), chair(0.72, 0.3))).toBeUndefined(); // up to x = 0.97
    expect(kindOf(furnished(), chair(0.8, 0.3))).toBe("door");
  });

  test("is no deeper than 1.5 m, however wide the door", () => {
    const scene = furnished();
    const wide = { id: "d", start: [0.5, 0], end: [3.5, 0], bottom: 0, top: 2 } as const;
    const hall = { ...scene, room: { ...scene.room, doors: [wide] } };
    expect(kindOf(hall, chair(2, 1.7))).toBe("door"); // from y = 1.45
    expect(kindOf(hall, chair(2, 1.8))).toBeUndefined(); // from y = 1.55
  });

  test("takes a rug", () => {
    const rug = box("r", { category: "Decor", center: [1.5, 1, 0.005], size: [1, 1, 0.01] });
    expect(kindOf(furnished(), rug)).toBeUndefined();
  });
});

describe("half a metre before a window", () => {
  const cabinet = (x: number, height: number): BoxRecord =>
    box("s", { category: "Storage", center: [x, 1.5, height / 2], size: [0.4, 0.8, height] });

  test("stays free of what is taller than the sill", () => {
    expect(kindOf(furnished(), cabinet(4.6, 1.8))).toBe("window");
    expect(kindOf(furnished(), cabinet(4.6, 0.85))).toBeUndefined();
    expect(kindOf(furnished(), cabinet(4.2, 1.8))).toBeUndefined(); // up to x = 4.4
  });

  test("and of pictures on the glass", () => {
    const picture = box("p", {
      category: "Picture",
      center: [4.98, 1.5, 1.5],
      size: [0.04, 0.6, 0.4],
      heading: Math.PI,
    });
    expect(kindOf(furnished(), picture)).toBe("window");
    expect(kindOf(furnished(), { ...picture, center: [4.98, 3, 1.5] })).toBeUndefined();
  });
});

describe("what carries things", () => {
  const picture = box("p", {
    category: "Picture",
    center: [2.5, 3.98, 1.5],
    size: [0.04, 0.8, 0.6],
    heading: -Math.PI / 2,
  });
  const board = box("b", { category: "Storage", center: [3, 2, 0.3], size: [0.4, 1.6, 0.6] });
  const tv = box("t", { category: "TV", center: [3, 2, 0.95], size: [0.1, 1.2, 0.7] });

  test("a picture hangs on a wall, its back to it", () => {
    expect(kindOf(furnished(), picture)).toBeUndefined();
    expect(kindOf(furnished(), { ...picture, center: [2.5, 3.8, 1.5] })).toBe("hold");
    const turned = { ...picture, center: [2.5, 3.85, 1.5], heading: 0.3 - Math.PI / 2 } as const;
    expect(kindOf(furnished(), turned)).toBe("hold");
  });

  test("a shallow cupboard stands or hangs, a deep one stands", () => {
    const hung = box("c", {
      category: "Storage",
      center: [2.5, 3.82, 1.8],
      size: [0.35, 0.8, 0.7],
      heading: -Math.PI / 2,
    });
    expect(kindOf(furnished(), hung)).toBeUndefined();
    expect(kindOf(furnished(), { ...hung, center: [1.5, 2, 0.35] })).toBeUndefined();
    const deep = { ...hung, center: [2.5, 3.7, 1.8], size: [0.6, 0.8, 0.7] } as const;
    expect(kindOf(furnished(), deep)).toBe("hold");
  });

  test("a cupboard that is put down stands; one that hangs stays up along its wall", () => {
    const size = [0.35, 0.8, 0.7] as const;
    const at = (z: number): Pose => ({ center: [2.5, 3.82, z], heading: -Math.PI / 2 });
    expect(settled(furnished(), "Storage", size, at(0.35)).center[2]).toBeCloseTo(0.35, 9);
    expect(settled(furnished(), "Storage", size, at(1.8)).center[2]).toBeCloseTo(1.8, 9);
    const away = { center: [2.5, 2, 1.8], heading: 0 } as const;
    expect(settled(furnished(), "Storage", size, away).center[2]).toBeCloseTo(0.35, 9);
    expect(poseAt(furnished(), "Storage", size, [2.5, 3.8]).center[2]).toBeCloseTo(0.35, 9);
  });

  test("a TV stands on a sideboard, not beside it on the floor", () => {
    expect(kindOf(furnished(board), tv)).toBeUndefined();
    expect(kindOf(furnished(board), { ...tv, center: [1, 3, 0.35] })).toBe("hold");
  });

  test("a lamp stands on a table or on the floor, not on a chair", () => {
    const chair = box("c", { category: "Chair", center: [3, 2, 0.22], size: [0.5, 0.5, 0.45] });
    const lamp = box("l", { category: "Decor", center: [3, 2, 0.65], size: [0.2, 0.2, 0.4] });
    expect(kindOf(furnished(chair), lamp)).toBe("hold");
    expect(kindOf(furnished(board), { ...lamp, center: [3, 2, 0.8] })).toBeUndefined();
    expect(kindOf(furnished(chair), { ...lamp, center: [1, 3, 0.2] })).toBeUndefined();
  });
});

describe("a chair at a table", () => {
  const table = (height: number): BoxRecord =>
    box("t", { category: "Table", center: [3, 2, height / 2], size: [1, 1.6, height] });
  const chair = (x: number): BoxRecord =>
    box("c", { category: "Chair", center: [x, 2, 0.45], size: [0.5, 0.5, 0.9] });

  test("goes under it, all but its back", () => {
    expect(kindOf(furnished(table(0.75)), chair(3.31))).toBeUndefined(); // 44 cm
    expect(kindOf(furnished(table(0.75)), chair(3.29))).toBe("box"); // 46 cm
  });

  test("does not go under a coffee table", () => {
    expect(kindOf(furnished(table(0.45)), chair(3.65))).toBe("box"); // 10 cm
  });
});
