/** What the keys do, one function an action; false when it means nothing just now. */
import { add } from "../model/geometry";
import type { Point } from "../model/state";
import { markInWords } from "./ar_words";
import type { Page } from "./page";

const STEP = 0.05; // metres an arrow moves a thing
const FINE_STEP = 0.01; // metres, with Shift
const CROSSHAIR_STEP = 0.5; // metres an arrow moves the crosshair while an outline is drawn
const FINE_CROSSHAIR_STEP = 0.05; // metres, with Shift
const NEW_BOX = 1; // metres; each side of the box that Enter puts into the room
const NEW_HEIGHT = 0.75; // metres; its height, a table's
const TURN = Math.PI / 12; // 15°
const FINE_TURN = Math.PI / 180; // 1°, with Shift

/** The parts of a KeyboardEvent that count. */
export interface Press {
  readonly key: string;
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
}

export const ARROWS: Readonly<Record<string, Point>> = {
  arrowleft: [-1, 0],
  arrowright: [1, 0],
  arrowup: [0, 1],
  arrowdown: [0, -1],
};

export function switchMode({ state, local, services, dispatch, change }: Page): void {
  const now = state.placing?.mode ?? local.mode;
  const mode = now === "manual" ? "scenegen" : "manual";
  change({ mode });
  if (state.placing !== null) dispatch({ type: "set-mode", mode, view: services.viewPoint() });
}

export function showAlternative({ state, dispatch }: Page, number: number): boolean {
  const placement = state.placing?.answer?.placements[number - 1];
  if (placement === undefined) return false;
  dispatch({ type: "show-alternative", rank: placement.rank });
  return true;
}

export function enter(page: Page): boolean {
  const { state, local, services, dispatch } = page;
  if (state.ar !== null && markInWords(state, state.ar) !== null) {
    services.ar.mark();
    return true;
  }
  if (state.placing !== null) {
    if (state.placing.pose === null) return false;
    dispatch({ type: "confirm" });
    return true;
  }
  if (state.draft?.kind === "box-height") {
    dispatch({ type: "draw-height", height: state.draft.box.size[2], done: true });
    return true;
  }
  if (state.tool === "select") return false;
  putHere(page, local.crosshair ?? services.viewPoint());
  return true;
}

/** Draws with the tool in hand at a point, for those who draw with keys or a button. */
export function putHere({ state, dispatch, change }: Page, at: Point): void {
  const half = state.tool === "box" ? NEW_BOX / 2 : 0;
  const free = state.tool === "box";
  dispatch({ type: "draw-down", at: [at[0] - half, at[1] - half], free });
  dispatch({ type: "draw-up", at: [at[0] + half, at[1] + half], free });
  if (free) dispatch({ type: "draw-height", height: NEW_HEIGHT, done: true });
  else if (state.tool === "room") change({ crosshair: at });
}

export function letGo({ state, dispatch, change }: Page): boolean {
  const idle = state.placing === null && state.tool === "select" && state.selection === null;
  if (idle) return false;
  dispatch({ type: "cancel" });
  change({ crosshair: null });
  return true;
}

export function move({ state, local, services, dispatch, change }: Page, event: Press): boolean {
  const [dx, dy] = ARROWS[event.key.toLowerCase()] as Point;
  const by = (step: number): Point => [dx * step, dy * step];
  if (state.tool === "room") {
    const from = local.crosshair ?? services.viewPoint();
    const at = add(from, by(event.shiftKey ? FINE_CROSSHAIR_STEP : CROSSHAIR_STEP));
    change({ crosshair: at });
    dispatch({ type: "draw-move", at, free: true });
    return true;
  }
  if (!state.placing?.pose && state.selection === null) return false;
  dispatch({ type: "nudge", by: by(event.shiftKey ? FINE_STEP : STEP) });
  return true;
}

export function turn({ state, dispatch }: Page, event: Press): boolean {
  if (!state.placing?.pose && state.selection?.kind !== "box") return false;
  const by = event.shiftKey ? FINE_TURN : TURN;
  dispatch({ type: "turn", by: event.key === "[" || event.key === "{" ? by : -by });
  return true;
}

export function remove({ state, dispatch }: Page): boolean {
  if (state.draft?.kind === "room") dispatch({ type: "remove-last-corner" });
  else if (state.selection !== null) dispatch({ type: "delete-selected" });
  else return false;
  return true;
}

export function duplicate({ state, dispatch }: Page): boolean {
  if (state.selection?.kind !== "box") return false;
  dispatch({ type: "duplicate-selected" });
  return true;
}

/** Into the camera view, or out of it. */
export function switchCamera({ state, services, change }: Page): void {
  if (state.ar === null) change({ arDoor: true });
  else services.ar.end();
}

export function hideOrShow({ state: { ar }, dispatch }: Page): boolean {
  if (ar === null) return false;
  dispatch({ type: "change-ar", change: { occlusion: !ar.occlusion } });
  return true;
}

/** Takes up what is placed by hand, to go where the phone points. */
export function pickUp({ state: { ar, placing }, dispatch }: Page): boolean {
  if (ar === null || placing?.mode !== "manual") return false;
  dispatch({ type: "change-ar", change: { carrying: !ar.carrying } });
  return true;
}
