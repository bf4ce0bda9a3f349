/** How what only the panels know follows the state. */
import type { State } from "../model/state";
import type { Guide, LastPlaced, Local, SheetHeight } from "./page";
import { verdictOf } from "./reasons";

/** The local value after the state has gone from one to the next. */
export function follow(local: Local, before: State, after: State): Local {
  const placed = lastPlaced(before, after);
  const guide = guideAfter(local.guide, before, after, placed !== null);
  const elsewhere = after.tool !== before.tool || after.selection !== before.selection;
  const forgotten = elsewhere || after.placing !== null || after.past.length < before.past.length;
  return {
    ...local,
    guide,
    placed: placed ?? (forgotten ? null : local.placed),
    crosshair: after.tool === before.tool ? local.crosshair : null,
    mode: after.placing?.mode ?? local.mode,
    sheet: sheetAfter(local.sheet, before, after),
  };
}

/** The object that this step made solid. */
function lastPlaced(before: State, after: State): LastPlaced | null {
  const { placing } = before;
  if (placing === null || after.placing !== null) return null;
  if (after.scene.boxes.length <= before.scene.boxes.length) return null;
  return {
    category: placing.category,
    item: placing.item,
    size: placing.wishedSize,
    mode: placing.mode,
    sentence: verdictOf(placing)?.sentence ?? "",
  };
}

/** The invitation ends when the person finds a way of their own. */
function guideAfter(guide: Guide, before: State, after: State, placed: boolean): Guide {
  switch (guide) {
    case "invite":
      return after.tool !== "select" || after.placing !== null || after.past.length > 0
        ? "done"
        : "invite";
    case "placing":
      if (placed) return "doors";
      if (after.placing?.mode === "manual") return "done";
      return before.placing !== null && after.placing === null ? "done" : "placing";
    case "doors":
      return after.tool !== "select" || after.placing !== null ? "done" : guide;
    case "done":
      return "done";
  }
}

/** The room needs to be seen beside the panel when something begins in it. */
function sheetAfter(sheet: SheetHeight, before: State, after: State): SheetHeight {
  const began = before.placing === null && after.placing !== null;
  const ended = before.placing !== null && after.placing === null;
  if ((began || before.tool !== after.tool) && sheet === "full") return "half";
  return ended ? "peek" : sheet;
}
