/** The keys: one table for what they do and for the help that lists them. */

import { add } from "../model/geometry";
import type { Point, Tool } from "../model/state";
import type { Page } from "./page";

const STEP = 0.05; // metres an arrow moves a thing
const FINE_STEP = 0.01; // metres, with Shift
const CROSSHAIR_STEP = 0.5; // metres an arrow moves the crosshair while an outline is drawn
const FINE_CROSSHAIR_STEP = 0.05; // metres, with Shift
const NEW_BOX = 1; // metres; each side of the box that Enter puts into the room
const NEW_HEIGHT = 0.75; // metres; its height, a table's
const TURN = Math.PI / 12; // 15°
const FINE_TURN = Math.PI / 180; // 1°, with Shift

export type KeyGroup = "Draw" | "Place" | "Move" | "Look" | "Always";

/** What a key press is compared with: ``KeyboardEvent.key``, lower case, after "mod+". */
export interface KeyBinding {
  readonly keys: readonly string[];
  /** As the help shows it. */
  readonly label: string;
  readonly group: KeyGroup;
  readonly words: string;
  /** False when the key means nothing just now, and goes its usual way. */
  run(page: Page, press: Press): boolean;
}

/** The parts of a KeyboardEvent that count. */
export interface Press {
  readonly key: string;
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
}

const ARROWS: Readonly<Record<string, Point>> = {
  arrowleft: [-1, 0],
  arrowright: [1, 0],
  arrowup: [0, 1],
  arrowdown: [0, -1],
};

export const KEYS: readonly KeyBinding[] = [
  tool("s", "select", "Select and move"),
  tool("r", "room", "Draw the room"),
  tool("b", "box", "Draw a box"),
  tool("d", "door", "Put in a door"),
  tool("w", "window", "Put in a window"),
  {
    keys: ["m"],
    label: "M",
    group: "Place",
    words: "Manual or SceneGen",
    run: always((page) => switchMode(page)),
  },
  {
    keys: ["1", "2", "3", "4", "5"],
    label: "1 – 5",
    group: "Place",
    words: "Show that place",
    run: (page, press) => showAlternative(page, Number(press.key)),
  },
  {
    keys: ["enter"],
    label: "Enter",
    group: "Place",
    words: "Place it; while drawing: put it here",
    run: (page) => enter(page),
  },
  {
    keys: ["escape"],
    label: "Esc",
    group: "Place",
    words: "Cancel, let go",
    run: (page) => letGo(page),
  },
  {
    keys: Object.keys(ARROWS),
    label: "← → ↑ ↓",
    group: "Move",
    words: "Move 5 cm (Shift: 1 cm)",
    run: move,
  },
  {
    keys: ["[", "]", "{", "}"],
    label: "[ ]",
    group: "Move",
    words: "Turn 15° (Shift: 1°)",
    run: turn,
  },
  {
    keys: ["delete", "backspace"],
    label: "Del",
    group: "Move",
    words: "Delete it; while drawing: the last corner",
    run: (page) => remove(page),
  },
  layer("h", "heat", "Show where it is likely"),
  layer("g", "graph", "Show how things relate"),
  layer("l", "labels", "Show names"),
  {
    keys: ["c"],
    label: "C",
    group: "Look",
    words: "Around, from above, walking",
    run: always(({ dispatch, state }) => {
      const next = { orbit: "top", top: "walk", walk: "orbit" } as const;
      dispatch({ type: "set-camera", camera: next[state.shown.camera] });
    }),
  },
  {
    keys: ["mod+z"],
    label: "Ctrl Z",
    group: "Always",
    words: "Undo",
    run: always(({ dispatch }) => dispatch({ type: "undo" })),
  },
  {
    keys: ["mod+shift+z", "mod+y"],
    label: "Ctrl Shift Z",
    group: "Always",
    words: "Redo",
    run: always(({ dispatch }) => dispatch({ type: "redo" })),
  },
  {
    keys: ["mod+s"],
    label: "Ctrl S",
    group: "Always",
    words: "Save the scene as a file",
    run: always(({ services }) => services.saveScene()),
  },
  {
    keys: ["?"],
    label: "?",
    group: "Always",
    words: "This help",
    run: always(({ dispatch }) => dispatch({ type: "toggle-help" })),
  },
];

/** Does what the key means; true when it meant something and must do nothing else. */
export function press(page: Page, event: Press): boolean {
  const name = nameOf(event);
  return KEYS.find((binding) => binding.keys.includes(name))?.run(page, event) ?? false;
}

/** "mod+shift+z" for Ctrl or Command; Shift alone is left out, it only refines. */
function nameOf(event: Press): string {
  const key = event.key.toLowerCase();
  if (event.altKey) return `alt+${key}`;
  if (!event.ctrlKey && !event.metaKey) return key;
  return event.shiftKey ? `mod+shift+${key}` : `mod+${key}`;
}

function tool(key: string, name: Tool, words: string): KeyBinding {
  const run = always((page) => page.dispatch({ type: "choose-tool", tool: name }));
  return { keys: [key], label: key.toUpperCase(), group: "Draw", words, run };
}

function layer(key: string, name: "heat" | "graph" | "labels", words: string): KeyBinding {
  const run = always((page) => page.dispatch({ type: "toggle-layer", layer: name }));
  return { keys: [key], label: key.toUpperCase(), group: "Look", words, run };
}

function always(run: (page: Page) => void): KeyBinding["run"] {
  return (page) => {
    run(page);
    return true;
  };
}

function switchMode({ state, local, services, dispatch, change }: Page): void {
  const now = state.placing?.mode ?? local.mode;
  const mode = now === "manual" ? "scenegen" : "manual";
  change({ mode });
  if (state.placing !== null) dispatch({ type: "set-mode", mode, view: services.viewPoint() });
}

function showAlternative({ state, dispatch }: Page, number: number): boolean {
  const placement = state.placing?.answer?.placements[number - 1];
  if (placement === undefined) return false;
  dispatch({ type: "show-alternative", rank: placement.rank });
  return true;
}

function enter(page: Page): boolean {
  const { state, local, services, dispatch } = page;
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

function letGo({ state, dispatch, change }: Page): boolean {
  const idle = state.placing === null && state.tool === "select" && state.selection === null;
  if (idle) return false;
  dispatch({ type: "cancel" });
  change({ crosshair: null });
  return true;
}

function move({ state, local, services, dispatch, change }: Page, event: Press): boolean {
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

function turn({ state, dispatch }: Page, event: Press): boolean {
  if (!state.placing?.pose && state.selection?.kind !== "box") return false;
  const by = event.shiftKey ? FINE_TURN : TURN;
  dispatch({ type: "turn", by: event.key === "[" || event.key === "{" ? by : -by });
  return true;
}

function remove({ state, dispatch }: Page): boolean {
  if (state.draft?.kind === "room") dispatch({ type: "remove-last-corner" });
  else if (state.selection !== null) dispatch({ type: "delete-selected" });
  else return false;
  return true;
}
