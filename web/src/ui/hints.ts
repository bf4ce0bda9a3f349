/** One plain sentence saying what to do next. */
import { ghostBox, shownRefusal } from "../model/ghost";
import { hangs } from "../model/hanging";
import type { Draft, State } from "../model/state";
import { arHint } from "./ar_words";

const FIRST_CORNER = "Mark the first corner of the room.";

/** The sentence for the state; null when nothing needs saying. */
export function hint(state: State): string | null {
  if (state.ar !== null) return arHint(state, state.ar);
  if (state.placing !== null) {
    if (state.placing.pose === null) return null;
    if (shownRefusal(state) !== null) return "Drag it to where it can stand.";
    const ghost = ghostBox(state);
    const where = ghost !== null && hangs(ghost, state.scene) ? "along the walls" : "anywhere";
    return `Drag it ${where}, or place it here.`;
  }
  if (state.draft !== null) return draftHint(state.draft);
  switch (state.tool) {
    case "room":
      return FIRST_CORNER;
    case "box":
      return "Drag on the floor to draw what stands there.";
    case "door":
      return "Drag along a wall where the door is.";
    case "window":
      return "Drag along a wall where the window is.";
    case "select":
      return selectHint(state);
  }
}

function draftHint(draft: Draft): string {
  switch (draft.kind) {
    case "room":
      if (draft.corners.length === 0) return FIRST_CORNER;
      if (draft.corners.length < 3) return "Mark the next corner, or type how long the wall is.";
      return "Mark the next corner, or the first one again to close the room.";
    case "box-floor":
      return "Let go when it covers the floor it stands on.";
    case "box-height":
      return "Pull up to its height, or type it.";
    case "opening":
      return `Let go where the ${draft.opening} ends.`;
  }
}

function selectHint(state: State): string | null {
  switch (state.selection?.kind) {
    case "box":
      return "Drag to move it; drag the ring to turn it.";
    case "door":
    case "window":
      return "Drag it along the wall, or type where it is.";
    case "corner":
      return "Drag the corner, or type how long its walls are.";
    case undefined:
      return null;
  }
}
