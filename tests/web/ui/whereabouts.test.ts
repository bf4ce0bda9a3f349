import { describe, expect, test } from "vitest";
import { compass } from "../../../web/src/model/compass";
import {
  boxInWords,
  nearestWallInWords,
  openingInWords,
  placedInWords,
  sceneInWords,
} from "../../../web/src/ui/whereabouts";
import { box, room } from "../rooms";

const { room: plain } = room();

test("north is up the plan, east to its right", () => {
  expect(compass(Math.PI / 2)).toBe("north");
  expect(compass(0)).toBe("east");
  expect(compass(-Math.PI / 2)).toBe("south");
  expect(compass(-Math.PI)).toBe("west");
  expect(compass(Math.PI / 4)).toBe("north-east");
});

describe("where a box stands", () => {
  test("close to a wall is against it", () => {
    const shelf = box("a", { center: [2.5, 3.7, 0.4], size: [0.5, 1, 0.8], heading: -Math.PI / 2 });
    expect(nearestWallInWords(shelf, plain)).toBe("against the north wall");
  });

  test("further off, the gap from its side is said", () => {
    const table = box("a", { center: [1.5, 2, 0.4], size: [1, 1, 0.8] });
    expect(nearestWallInWords(table, plain)).toBe("1.0 m from the west wall");
  });

  test("a box is named by its label, with size, wall and front", () => {
    const shelf = box("a", { center: [0.3, 2, 0.4], size: [0.6, 1.2, 0.8], label: "Bookshelf" });
    expect(boxInWords(shelf, plain)).toBe(
      "Bookshelf, 0.60 × 1.2 × 0.80 m, against the west wall, facing east",
    );
  });

  test("a front that nobody knows is not made up", () => {
    expect(boxInWords(box("a", { front_known: false }), plain)).not.toContain("facing");
  });
});

test("a door is in the wall it lies on", () => {
  const door = { id: "d", start: [1, 0], end: [1.9, 0], bottom: 0, top: 2 } as const;
  expect(openingInWords(door, plain)).toBe("0.90 m wide, in the south wall");
});

test("a scene is its name, area and what is in it", () => {
  expect(sceneInWords(room())).toBe("My room, 20.0 m², empty");
  expect(sceneInWords(room([box("a"), box("b")]))).toBe("My room, 20.0 m², 2 pieces");
});

describe("what is said after placing", () => {
  const sofa = box("s", { category: "Sofa", center: [2.5, 0.45, 0.4], heading: Math.PI / 2 });

  test("the server's sentence, lower case inside ours", () => {
    expect(placedInWords(sofa, plain, "Against the south wall, facing the TV")).toBe(
      "Sofa placed: against the south wall, facing the TV.",
    );
    expect(placedInWords(sofa, plain, "TV in sight.")).toBe("Sofa placed: TV in sight.");
  });

  test("without a sentence, the nearest wall", () => {
    expect(placedInWords(sofa, plain, "")).toBe("Sofa placed: against the south wall.");
  });
});
