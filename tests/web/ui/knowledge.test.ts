import { describe, expect, test } from "vitest";
import type { Bar, CategoryMarginals, KnowledgeMarginals } from "../../../web/src/model/knowledge";
import { categoryAtHand, knowledgeDialog, openKnowledge } from "../../../web/src/ui/knowledge";
import {
  examplesInWords,
  groupRows,
  manyInWords,
  neverInWords,
  percentInWords,
  positionRows,
  sizeInWords,
  towardsCenterRows,
} from "../../../web/src/ui/knowledge_words";
import type { Page } from "../../../web/src/ui/page";
import { begin, box } from "../rooms";
import { sitDown, wordsOf } from "./desk";

const bar = (label: string, count: number, of: number, change: Partial<Bar> = {}): Bar => ({
  label,
  count,
  share: count / of,
  several: 0,
  possible: 0,
  ...change,
});

/** Eight beds, of which four have a front that is known. */
const BED: CategoryMarginals = {
  category: "Bed",
  examples: 8,
  fronts: 4,
  position: [bar("middle", 1, 8), bar("edge", 5, 8), bar("corner", 2, 8)],
  surrounded_by: [
    bar("Chair", 2, 8, { possible: 3 }),
    bar("Sofa", 0, 8),
    bar("Storage", 6, 8, { several: 4, possible: 7 }),
    bar("Other", 1, 8, { possible: 1 }),
  ],
  facing: [bar("Storage", 1, 4, { possible: 4 })],
  towards_center: [bar("yes", 3, 4), bar("no", 1, 4)],
};
const TABLE: CategoryMarginals = { ...BED, category: "Table", facing: [], towards_center: [] };
const SOURCE = {
  id: "flats",
  name: "Flats of Utrecht",
  license: "CC-BY-4.0",
  copyright: "© 2020 A. Jansen",
  rooms: 12,
  objects: 1193,
};
const KNOWN: KnowledgeMarginals = { sources: [SOURCE], categories: [BED, TABLE] };

describe("names in sentences", () => {
  test.each([
    ["Bed", "beds"],
    ["TV", "TVs"],
    ["Storage", "storage"],
    ["Decor", "decor"],
    ["Bench", "benches"],
    ["Other", "other things"],
  ])("many of %s are %s", (category, words) => {
    expect(manyInWords(category)).toBe(words);
  });

  test.each([
    [1, "Sofa", "1 sofa"],
    [64, "Sofa", "64 sofas"],
    [1061, "Storage", "1,061 pieces of storage"],
    [1, "Decor", "1 piece of decor"],
  ])("%d of %s", (count, category, words) => {
    expect(examplesInWords(count, category)).toBe(words);
  });
});

test.each([
  [674 / 1061, "64 %"],
  [0, "0 %"],
  [1, "100 %"],
  [1 / 1000, "under 1 %"],
  [999 / 1000, "over 99 %"],
])("a share of %d is %s", (share, words) => {
  expect(percentInWords(share)).toBe(words);
});

test("a size says which length is which", () => {
  expect(sizeInWords([2, 1.6, 0.5])).toBe("2.0 m deep, 1.6 m wide, 0.50 m high");
});

describe("charts", () => {
  test("places go from the corner to the middle, with their counts", () => {
    expect(positionRows(BED).map(({ words, counts }) => [words, counts])).toEqual([
      ["In a corner", "2 of 8"],
      ["Along a wall", "5 of 8"],
      ["Away from walls", "1 of 8"],
    ]);
  });

  test("ways to face are counted among the fronts that are known", () => {
    expect(towardsCenterRows(BED).map(({ percent, counts }) => [percent, counts])).toEqual([
      ["75 %", "3 of 4"],
      ["25 %", "1 of 4"],
    ]);
  });

  test("groups come most frequent first; those never there are told apart", () => {
    const rows = groupRows(BED.surrounded_by, BED.examples);
    expect(rows.map(({ words }) => words)).toEqual(["Storage", "Chair", "Other things"]);
    expect(rows[0]?.details).toBe("two or more: 4 · in the same room: 7");
    expect(rows[1]?.details).toBe("in the same room: 3");
    expect(rows[1]?.possible).toBe(3 / 8);
    expect(neverInWords(BED.surrounded_by)).toBe("Not once so close: sofas.");
    expect(neverInWords(BED.facing)).toBe("");
  });
});

describe("the category at hand", () => {
  test("is the one being placed", () => {
    const desk = sitDown(begin());
    const view = [1, 1] as const;
    desk.act({ type: "place", category: "TV", item: null, size: null, mode: "manual", view });
    expect(categoryAtHand(desk.page)).toBe("TV");
  });

  test("is that of the selected box", () => {
    const desk = sitDown(begin([box("a", { category: "Sofa" })]));
    desk.act({ type: "select", selection: { kind: "box", id: "a" } });
    expect(categoryAtHand(desk.page)).toBe("Sofa");
  });

  test("is the first where nothing is at hand, or something unknown", () => {
    const desk = sitDown(begin([box("a", { category: "Other" })]));
    expect(categoryAtHand(desk.page)).toBe("Bed");
    desk.act({ type: "select", selection: { kind: "box", id: "a" } });
    expect(categoryAtHand(desk.page)).toBe("Bed");
  });
});

describe("the dialog", () => {
  const answering = (page: Page, answer: KnowledgeMarginals | null): Page => ({
    ...page,
    services: { ...page.services, fetchKnowledge: async () => answer },
  });
  const settled = (): Promise<void> => new Promise((done) => setTimeout(done));

  test("says that it is looking, then what is known, with sources and licenses", async () => {
    const desk = sitDown(begin());
    openKnowledge(answering(desk.page, KNOWN), "Bed");
    expect(wordsOf(knowledgeDialog(desk.page))).toContain("Looking it up…");
    await settled();
    const words = wordsOf(knowledgeDialog(desk.page));
    expect(words).toContain("What it knows about beds");
    expect(words).toContain("It has seen 8 beds.");
    expect(words).toContain("12 rooms with 1,193 things · license: CC-BY-4.0 · © 2020 A. Jansen");
  });

  test("says so when the server is out of reach, and asks again the next time", async () => {
    const desk = sitDown(begin());
    openKnowledge(answering(desk.page, null), "Bed");
    await settled();
    expect(wordsOf(knowledgeDialog(desk.page))).toContain("can't be reached now");
    openKnowledge(answering(desk.page, KNOWN), "Bed");
    await settled();
    expect(wordsOf(knowledgeDialog(desk.page))).toContain("It has seen 8 beds.");
  });

  test("needs the server only once", async () => {
    const desk = sitDown(begin());
    openKnowledge(answering(desk.page, KNOWN), "Bed");
    await settled();
    openKnowledge(answering(desk.page, null), "Table");
    await settled();
    expect(wordsOf(knowledgeDialog(desk.page))).toContain("It has seen 8 tables.");
  });

  test("K opens it", () => {
    const desk = sitDown(begin([box("a", { category: "Sofa" })]));
    desk.act({ type: "select", selection: { kind: "box", id: "a" } });
    expect(desk.type(["k"])).toBe(true);
    expect(wordsOf(knowledgeDialog(desk.page))).toContain("What it knows about sofas");
  });

  test("of what has no front it says no more than that", async () => {
    const desk = sitDown(begin());
    openKnowledge(answering(desk.page, KNOWN), "Table");
    await settled();
    const words = wordsOf(knowledgeDialog(desk.page));
    expect(words).toContain("which side is its front");
    expect(words).not.toContain("middle of the room?");
  });

  test("of a kind it has never seen it says so", async () => {
    const desk = sitDown(begin());
    openKnowledge(answering(desk.page, KNOWN), "TV");
    await settled();
    expect(wordsOf(knowledgeDialog(desk.page))).toContain("It has seen none yet.");
  });
});
