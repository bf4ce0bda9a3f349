/** What things are called and how big they usually are, when the server has not said so (yet). */
import type { BoxRecord, CategoryInfo } from "../net/protocol.gen";
import type { Vector3 } from "./state";

export const OTHER = "Other";

/** Depth, width, height in metres: common catalogue sizes, used until the server's list is here. */
const USUAL_SIZES: Readonly<Record<string, Vector3>> = {
  Bed: [2.0, 1.6, 0.5],
  Chair: [0.5, 0.5, 0.85],
  Decor: [0.3, 0.3, 0.4],
  Picture: [0.04, 0.8, 0.6],
  Sofa: [0.9, 2.0, 0.8],
  Storage: [0.45, 1.0, 1.2],
  Table: [0.8, 1.4, 0.75],
  TV: [0.1, 1.1, 0.65],
  [OTHER]: [0.5, 0.5, 0.5],
};

const UNKNOWN_SIZE: Vector3 = [0.5, 0.5, 0.5];

/** The usual depth, width and height of a category, metres. */
export function usualSize(category: string, known: readonly CategoryInfo[]): Vector3 {
  const info = known.find(({ name }) => name === category);
  return info?.size ?? USUAL_SIZES[category] ?? UNKNOWN_SIZE;
}

/** All categories, the one whose usual size is most like `size` first and Other last. */
export function likelyCategories(size: Vector3, known: readonly CategoryInfo[]): readonly string[] {
  const names = known.length > 0 ? known.map(({ name }) => name) : Object.keys(USUAL_SIZES);
  const rank = (name: string): number =>
    name === OTHER
      ? Number.POSITIVE_INFINITY
      : Math.min(...typicalSizes(name, known).map((usual) => unlikeness(size, usual)));
  return names.toSorted((a, b) => rank(a) - rank(b));
}

/** What was learned is an average of many kinds; the common one of catalogues counts as well. */
function typicalSizes(category: string, known: readonly CategoryInfo[]): readonly Vector3[] {
  const common = USUAL_SIZES[category];
  return [usualSize(category, known), ...(common === undefined ? [] : [common])];
}

/** How many times bigger or smaller, side by side; which side is the front does not matter. */
function unlikeness(size: Vector3, usual: Vector3): number {
  const [depth, width, height] = size;
  const turned: Vector3 = [width, depth, height];
  return Math.min(logDistance(size, usual), logDistance(turned, usual));
}

function logDistance(a: Vector3, b: Vector3): number {
  return Math.hypot(Math.log(a[0] / b[0]), Math.log(a[1] / b[1]), Math.log(a[2] / b[2]));
}

/** A box as one speaks of it: "the coffee table". */
export function nameOf({ label, category }: BoxRecord): string {
  const name = label || category;
  if (name === OTHER) return "something else";
  if (name === "Storage" || name === "Decor") return `the ${name.toLowerCase()} piece`;
  return `the ${name.startsWith("TV") ? name : name.toLowerCase()}`;
}
