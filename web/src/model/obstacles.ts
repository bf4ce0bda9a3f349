/** What keeps a thing from standing where it is. */
import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import { overlap, standsInside, topOf } from "./footprints";
import { OTHER } from "./labels";

/** Ceilings are measured no more exactly than this, metres; RESTS of scenegen_core. */
const CEILING = 0.05;

export type Obstacle =
  | { readonly kind: "wall" }
  | { readonly kind: "ceiling" }
  | { readonly kind: "box"; readonly box: BoxRecord };

/** Pairs that may share space: boxes round them are bigger than the things themselves. */
const NATURAL: readonly (readonly [string, string])[] = [
  ["Chair", "Table"],
  ["Decor", "Bed"],
  ["Decor", "Chair"],
  ["Decor", "Decor"],
  ["Decor", "Sofa"],
  ["Decor", "Storage"],
];

/** The first thing in the way of a box, its own former self excepted; null if nothing is. */
export function obstacleOf(scene: SceneRecord, box: BoxRecord): Obstacle | null {
  if (!standsInside(box, scene.room)) return { kind: "wall" };
  if (topOf(box) > scene.room.height + CEILING) return { kind: "ceiling" };
  const hit = scene.boxes.find(
    (other) => other.id !== box.id && !isNatural(box, other) && overlap(box, other),
  );
  return hit === undefined ? null : { kind: "box", box: hit };
}

/** The obstacle as a sentence. */
export function obstacleSentence(obstacle: Obstacle): string {
  switch (obstacle.kind) {
    case "wall":
      return "It would stand in the wall.";
    case "ceiling":
      return "It is too tall for this room.";
    case "box":
      return `It would stand in ${nameOf(obstacle.box)}.`;
  }
}

function isNatural(box: BoxRecord, other: BoxRecord): boolean {
  return NATURAL.some(
    ([a, b]) =>
      (box.category === a && other.category === b) || (box.category === b && other.category === a),
  );
}

function nameOf(box: BoxRecord): string {
  const name = box.label || box.category;
  if (name === OTHER) return "something else";
  return `the ${name === "TV" ? name : name.toLowerCase()}`;
}
