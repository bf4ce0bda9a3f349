/** What is said and asked while the room is seen through the camera. */
import { ROOM_CAPTURE } from "../model/ar";
import type { Ar, ArSupport, Draft, State } from "../model/state";
import { counted, inSentence } from "./words";

/** Why there is no camera view here, and what to do; null where there is one. */
export function obstacleInWords(support: ArSupport): string | null {
  switch (support) {
    case "yes":
    case "unknown":
      return null;
    case "insecure":
      return "The camera needs a secure page. Open it by its https address, or on this computer as localhost.";
    case "missing":
      return "This browser can't show your room through the camera. Chrome on an Android phone can, and so can the browser of a Quest. Here you can draw the room instead.";
    case "refused":
      return "The camera view is switched off for this page. Open the page by itself, not inside another one.";
  }
}

/** One plain sentence saying what to do next; null when nothing needs saying. */
export function arHint(state: State, ar: Ar): string | null {
  if (ar.tracking === "paused") return "Paused. Come back to go on.";
  if (ar.tracking === "lost" && ar.step !== "floor") {
    return "I've lost the room. Point the phone where you were, and move it slowly.";
  }
  switch (ar.step) {
    case "floor":
      return ar.surface
        ? "Put the ring on the floor, and tap."
        : "Point at the floor and move your phone slowly.";
    case "line-up":
      return ar.corner === null
        ? "Point at a corner of the room, down where the walls meet the floor, and tap."
        : "Now the next corner along the same wall.";
    case "ready":
      if (ar.found !== null) return "Your device knows this room already.";
      return ar.unchecked.length > 0 ? null : readyHint(state, ar);
  }
}

function readyHint(state: State, ar: Ar): string | null {
  if (state.placing !== null) {
    if (state.placing.pose === null) return null;
    if (ar.carrying) return "Point to where it should go, and tap.";
    return state.placing.mode === "manual"
      ? "Drag it, turn it with two fingers, or place it."
      : "Drag it, tap another spot to ask about it, or place it.";
  }
  if (state.draft !== null) return draftHint(state.draft, ar);
  switch (state.tool) {
    case "room":
      return "Point at a corner of the room, down on the floor, and tap.";
    case "box": {
      const first = state.scene.boxes.length === 0 ? "What stands here? Tap" : "Next thing: tap";
      return `${first} one of its corners, down on the floor.`;
    }
    case "door":
    case "window":
      return `Point at the wall where the ${state.tool} begins, and tap.`;
    case "select":
      return state.selection === null ? "Pick what to place, or mark what stands here." : null;
  }
}

function draftHint(draft: Draft, ar: Ar): string {
  switch (draft.kind) {
    case "room":
      if (draft.corners.length === 0) return "Tap a corner of the room, down on the floor.";
      if (draft.corners.length < 3) return "Now the next corner along the wall.";
      return "Go on round the room. The first corner again closes it.";
    case "box-floor":
      if (ar.marks === 2) return "Tap the opposite corner.";
      return draft.side === undefined
        ? "Tap the other end of that side."
        : "Point to where its back is, and tap.";
    case "box-height":
      return "Point at its top edge, and tap.";
    case "opening":
      return `Tap where the ${draft.opening} ends.`;
  }
}

/** The button that does what a tap in the middle of the view does; null while that is nothing. */
export function markInWords(state: State, ar: Ar): string | null {
  if (ar.tracking !== "good" || ar.found !== null) return null;
  if (ar.step === "floor") return ar.surface ? "The floor is here" : null;
  if (ar.step === "line-up") return "The corner is here";
  if (state.placing !== null) return ar.carrying ? "Put it down here" : null;
  switch (state.draft?.kind) {
    case "room":
      return "Corner here";
    case "box-floor":
      return state.draft.side === undefined ? "Corner here" : "This deep";
    case "box-height":
      return "This tall";
    case "opening":
      return "It ends here";
    case undefined:
      break;
  }
  switch (state.tool) {
    case "select":
      return null;
    case "room":
    case "box":
      return "Corner here";
    case "door":
    case "window":
      return "It begins here";
  }
}

/** Whether the device can look round the room, and nobody has drawn in it. */
export function canCapture({ ar, scene }: State): boolean {
  return ar?.step === "ready" && ar.granted.includes(ROOM_CAPTURE) && scene.boxes.length === 0;
}

/** "12 pieces found" */
export function foundInWords({ found }: Ar): string {
  return `${counted(found?.boxes.length ?? 0, "piece")} found`;
}

/** What a screen reader is told of the step from one state to the next; null if nothing. */
export function arAnnouncement(before: State, after: State): string | null {
  const { ar } = after;
  if (ar === null) return before.ar === null ? null : "The camera is off.";
  const hint = arHint(after, ar);
  if (before.ar === null) return hint;
  if (ar.found !== null && before.ar.found === null) return `${foundInWords(ar)}.`;
  const [id] = ar.unchecked;
  if (id !== undefined && id !== before.ar.unchecked[0]) {
    const box = after.scene.boxes.find((one) => one.id === id);
    return box === undefined ? null : `Is this a ${inSentence(box.category)}?`;
  }
  const steps = ar.step !== before.ar.step || ar.tracking !== before.ar.tracking;
  const found = ar.surface !== before.ar.surface || ar.corner !== before.ar.corner;
  const drawing = stageOf(before) !== stageOf(after);
  return steps || found || drawing ? hint : null;
}

/** How far a drawing has come. */
function stageOf({ draft, tool }: State): string {
  const marks = draft?.kind === "room" ? draft.corners.length : 0;
  const side = draft?.kind === "box-floor" && draft.side !== undefined;
  return `${tool} ${draft?.kind} ${marks} ${side}`;
}
