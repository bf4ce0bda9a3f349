/** The room seen through the camera: how far one has come, and what the device knows of it. */
import type { SceneRecord } from "../net/protocol.gen";
import { edited } from "./history";
import { anticlockwise } from "./outlines";
import { withoutBoxes } from "./scenes";
import type { Ar, State } from "./state";

/** Of a headset that knows planes: it may let the user look round the room to find them. */
export const ROOM_CAPTURE = "room-capture";

export function enterAr(state: State, room: Ar["room"], granted: readonly string[]): State {
  const ar: Ar = {
    step: "floor",
    room,
    surface: false,
    tracking: "good",
    granted,
    corner: null,
    marks: 3,
    square: true,
    occlusion: true,
    carrying: false,
    found: null,
    unchecked: [],
    typing: null,
  };
  return { ...idle(state), ar };
}

/** Changes nothing once the camera is off: what it saw last may come too late. */
export function changeAr(state: State, change: Partial<Ar>): State {
  return state.ar === null ? state : { ...state, ar: { ...state.ar, ...change } };
}

/** What is placed by hand goes where the phone points until it is put down. */
export function carried(state: State): State {
  return changeAr(state, { carrying: state.placing?.mode === "manual" });
}

/** Another room than the one that was lined up has a place of its own; a new one gets it as drawn. */
export function elsewhere(before: State, after: State): State {
  if (after.scene.id === before.scene.id || after.tool === "room") return after;
  return changeAr(after, { step: "line-up", room: "known", corner: null });
}

/** A length is typed of one thing, as long as that is what is looked at. */
export function typingStopped(before: State, after: State): State {
  const { ar } = after;
  const isSame =
    before.selection === after.selection &&
    before.tool === after.tool &&
    before.scene.id === after.scene.id &&
    before.placing?.ask === after.placing?.ask;
  return ar === null || ar.typing === null || isSame ? after : changeAr(after, { typing: null });
}

export function leaveAr(state: State): State {
  return state.ar === null ? state : { ...state, ar: null, draft: null, tool: "select" };
}

/** The outline and the pieces that the device knows become the room, in one step. */
export function useFound(state: State): State {
  const { ar, scene } = state;
  if (ar === null || ar.found === null) return state;
  const { corners, doors, windows, boxes } = ar.found;
  const room =
    corners === null
      ? scene.room
      : { ...scene.room, corners: anticlockwise(corners), doors, windows };
  const known: SceneRecord = { ...scene, room, boxes };
  const next = edited({ ...idle(state), tool: "select" }, known, true);
  return inQuestion({ ...next, ar: { ...ar, found: null, unchecked: boxes.map(({ id }) => id) } });
}

/** The piece in question stays as it is now, or is dropped; then comes the next. */
export function checkPiece(state: State, keep: boolean): State {
  const { ar, scene } = state;
  const [id, ...unchecked] = ar?.unchecked ?? [];
  if (ar === null || id === undefined) return state;
  const after = keep ? state : edited(state, withoutBoxes(scene, [id]), true);
  return inQuestion({ ...after, ar: { ...ar, unchecked } });
}

/** The piece that is to be looked at is selected, so that it can be put right. */
function inQuestion(state: State): State {
  const id = state.ar?.unchecked[0];
  return { ...state, selection: id === undefined ? null : { kind: "box", id } };
}

/** Nothing is begun: what was is left as it is. */
function idle(state: State): State {
  return { ...state, draft: null, tool: "select", placing: null, selection: null, probe: null };
}
