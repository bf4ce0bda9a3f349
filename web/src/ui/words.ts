/** Numbers and names as people read them. */
import type { Reason } from "../net/protocol.gen";

const RELATION_WORDS: Readonly<Record<string, string>> = {
  AverageDistance: "Distance to others",
  SurroundedBy: "Close company",
  RoomPosition: "Walls nearby",
  Support: "Standing on",
  TowardsCenter: "Faces the middle of the room",
  AwayFromWall: "Back to the wall",
  DirectionSimilarity: "Lined up with others",
  Facing: "Facing",
  NextTo: "Next to",
  BelongsTo: "Part of a group",
  Walls: "Walls",
  FreeSpace: "Room around it",
  Middle: "Middle of the room",
  Doors: "Doors",
  Windows: "Windows",
  Height: "Height",
  Neighbor: "Neighbors",
  Twin: "Another like it",
  Mirror: "Pairs",
  Agreement: "Known rooms",
};

const UNCOUNTED: readonly string[] = ["Decor", "Storage"];

/** A category inside a sentence: "sofa", but "TV". */
export function inSentence(category: string): string {
  return category === category.toUpperCase() ? category : category.toLowerCase();
}

/** "a sofa", but "storage": some names are no single thing. */
export function oneOf(category: string): string {
  return UNCOUNTED.includes(category) ? inSentence(category) : `a ${inSentence(category)}`;
}

/** The sentence with its full stop. */
export function ended(sentence: string): string {
  return sentence === "" || /[.!?]$/.test(sentence) ? sentence : `${sentence}.`;
}

/** With a capital first letter. */
export function begun(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** What was placed where: "The sofa is now against the north wall, facing the TV." */
export function isNow(category: string, sentence: string): string {
  const first = sentence.split(/[\s,]/, 1)[0] ?? "";
  const where = sentence === "" ? "here" : inSentence(first) + sentence.slice(first.length);
  return `The ${inSentence(category)} is now ${ended(where)}`;
}

/** "1 piece", "4 pieces". */
export function counted(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

/** A relation as people say it; an unknown one by its own name, taken apart: "InFrontOf". */
export function relationInWords(relation: string): string {
  const known = RELATION_WORDS[relation];
  if (known !== undefined) return known;
  const spaced = relation.replace(/([a-z])([A-Z])/g, "$1 $2").toLowerCase();
  return spaced.charAt(0).toUpperCase() + spaced.slice(1);
}

/** What a bar is about: "Distance to others · table". */
export function reasonInWords(reason: Reason): string {
  const relation = relationInWords(reason.relation);
  return reason.group === "" ? relation : `${relation} · ${inSentence(reason.group)}`;
}

/** 0 to 1 in words, as in the legend of the heat map. */
export function likelihoodInWords(likelihood: number): string {
  if (likelihood >= 0.85) return "very likely";
  if (likelihood >= 0.6) return "likely";
  if (likelihood >= 0.35) return "possible";
  return "unlikely";
}

/** How much one reason says, −1 to 1 beside the strongest: "strongly for". */
export function strengthInWords(share: number): string {
  const size = Math.abs(share);
  const side = share < 0 ? "against" : "for";
  if (size >= 0.6) return `strongly ${side}`;
  return size >= 0.2 ? side : `a little ${side}`;
}

/** "+1.24", "−0.31", "+111": three digits, and a true minus sign. */
export function signed(value: number): string {
  const size = Math.abs(value);
  const rounded = size.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : 2);
  return `${value < 0 ? "−" : "+"}${rounded}`;
}
