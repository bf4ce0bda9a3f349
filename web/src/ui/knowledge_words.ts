/** What is known of a category, in words: shares with the counts behind them. */
import type { Bar, CategoryMarginals, Source } from "../model/knowledge";
import type { Vector3 } from "../model/state";
import { formatLength } from "../model/units";
import type { CategoryInfo } from "../net/protocol.gen";
import { counted, inSentence } from "./words";

/** What is not counted one by one. */
const UNCOUNTABLE: ReadonlySet<string> = new Set(["Decor", "Storage"]);

const PLACES: Readonly<Record<string, string>> = {
  corner: "In a corner",
  edge: "Along a wall",
  middle: "Away from walls",
};
const WAYS: Readonly<Record<string, string>> = {
  yes: "Into the room",
  no: "To a wall close by",
};

const NUMBERS = new Intl.NumberFormat("en-US");

/** A row of a chart. */
export interface Row {
  readonly label: string;
  /** The bar's label as people say it. */
  readonly words: string;
  readonly share: number;
  /** Of the examples, whose room has a member of the group at all, 0 to 1; 0 if it is no group. */
  readonly possible: number;
  /** "63 %". */
  readonly percent: string;
  /** "674 of 1,061". */
  readonly counts: string;
  /** "two or more: 56 · in the same room: 90"; empty if it is no group. */
  readonly details: string;
}

/** All of a category: "beds", "storage". */
export function manyInWords(category: string): string {
  if (category === "Other") return "other things";
  const name = inSentence(category);
  if (UNCOUNTABLE.has(category)) return name;
  return /(s|x|ch|sh)$/.test(name) ? `${name}es` : `${name}s`;
}

/** So many of a category: "1 bed", "1,061 pieces of storage". */
export function examplesInWords(count: number, category: string): string {
  const number = NUMBERS.format(count);
  const single = count === 1;
  if (UNCOUNTABLE.has(category)) {
    return `${number} ${single ? "piece" : "pieces"} of ${inSentence(category)}`;
  }
  return `${number} ${single ? inSentence(category) : manyInWords(category)}`;
}

/** "2.0 m deep, 1.6 m wide, 0.50 m high". */
export function sizeInWords([depth, width, height]: Vector3): string {
  return `${formatLength(depth)} deep, ${formatLength(width)} wide, ${formatLength(height)} high`;
}

/** Whole percents; what happens at all is never "0 %". */
export function percentInWords(share: number): string {
  if (share > 0 && share < 0.005) return "under 1 %";
  if (share < 1 && share >= 0.995) return "over 99 %";
  return `${Math.round(share * 100)} %`;
}

/** Where in the room, from the corner to the middle. */
export function positionRows({ position, examples }: CategoryMarginals): readonly Row[] {
  return position.map((bar) => row(bar, PLACES[bar.label] ?? bar.label, examples)).toReversed();
}

export function towardsCenterRows(known: CategoryMarginals): readonly Row[] {
  return known.towards_center.map((bar) => row(bar, WAYS[bar.label] ?? bar.label, known.fronts));
}

/** The groups that were there at least once, the most frequent first. */
export function groupRows(bars: readonly Bar[], of: number): readonly Row[] {
  return bars
    .filter(({ count }) => count > 0)
    .toSorted((a, b) => b.count - a.count)
    .map((bar) => ({
      ...row(bar, bar.label === "Other" ? "Other things" : bar.label, of),
      possible: bar.possible / of,
      details: details(bar),
    }));
}

/** "Not once so close: sofas, TVs."; empty if each group was there. */
export function neverInWords(bars: readonly Bar[]): string {
  const never = bars.filter(({ count }) => count === 0).map(({ label }) => manyInWords(label));
  return never.length === 0 ? "" : `Not once so close: ${never.join(", ")}.`;
}

/** Why nothing is said of what a category faces. */
export function frontlessInWords(symmetry: CategoryInfo["symmetry"] | undefined): string {
  switch (symmetry) {
    case "inside facing":
      return "It has its back to a wall and faces away from it.";
    case "symmetric":
      return "It has no front: it may stand any way round.";
    case "asymmetric":
    case undefined:
      return "In these rooms nobody has said which side is its front.";
  }
}

/** "101 rooms with 1,193 things". */
export function sourceInWords({ rooms, objects }: Source): string {
  return `${counted(rooms, "room")} with ${NUMBERS.format(objects)} things`;
}

function row(bar: Bar, words: string, of: number): Row {
  return {
    label: bar.label,
    words,
    share: bar.share,
    possible: 0,
    percent: percentInWords(bar.share),
    counts: `${NUMBERS.format(bar.count)} of ${NUMBERS.format(of)}`,
    details: "",
  };
}

function details({ several, possible }: Bar): string {
  const there = `in the same room: ${NUMBERS.format(possible)}`;
  return several === 0 ? there : `two or more: ${NUMBERS.format(several)} · ${there}`;
}
