/** Which targets are chosen, and so can be dragged. Pure; core frame. */
import type { State } from "../model/state";
import { type Grip, gripBox, handOnWalls } from "./dragging";
import type { Spot } from "./handle_spots";
import type { Ray } from "./picking";
import type { Target } from "./targets";

/** What tapping the target selects. */
export function selectionOf(target: Target | null) {
  if (target?.kind === "box") {
    return { kind: "box", id: target.box.id } as const;
  }
  return target?.kind === "opening"
    ? ({ kind: target.opening, id: target.value.id } as const)
    : null;
}

/** Whether the target is what is selected, or being placed, and so is dragged. */
export function isChosen(state: State, target: Target | null): boolean {
  const { selection } = state;
  if (target?.kind === "ghost") {
    return true;
  }
  const aimed = selectionOf(target);
  return (
    aimed !== null &&
    selection !== null &&
    selection.kind === aimed.kind &&
    "id" in selection &&
    selection.id === aimed.id
  );
}

/** How a chosen target is taken hold of; null for what is not chosen. */
export function gripOf(state: State, target: Target | null, ray: Ray): Grip | null {
  if (!isChosen(state, target)) {
    return null;
  }
  switch (target?.kind) {
    case "ghost":
      return gripBox(target.box, ray, target.distance, true);
    case "box":
      return gripBox(target.box, ray, target.distance, false);
    case "opening": {
      const { value, opening } = target;
      const from = handOnWalls(state, ray) ?? value.start;
      return { kind: "opening", opening, id: value.id, from, start: value.start, end: value.end };
    }
    case "alternative":
    case undefined:
      return null;
  }
}

/** The cursor over a target or a handle. */
export function cursorOf(target: Target | null, chosen: boolean, spot: Spot | null): string {
  if (spot || chosen) {
    return "grab";
  }
  return target ? "pointer" : "";
}
