/** The keys: one table for what they do and for the help that lists them. */
import type { Tool } from "../model/state";
import {
  ARROWS,
  duplicate,
  enter,
  hideOrShow,
  letGo,
  move,
  type Press,
  pickUp,
  remove,
  showAlternative,
  switchCamera,
  switchMode,
  turn,
} from "./key_actions";
import { categoryAtHand, openKnowledge } from "./knowledge";
import type { Page } from "./page";

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
  {
    keys: ["mod+d"],
    label: "Ctrl D",
    group: "Move",
    words: "Duplicate it",
    run: (page) => duplicate(page),
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
    keys: ["v"],
    label: "V",
    group: "Look",
    words: "Camera: see it in your own room",
    run: always((page) => switchCamera(page)),
  },
  {
    keys: ["o"],
    label: "O",
    group: "Look",
    words: "Camera: real things hide what is behind",
    run: (page) => hideOrShow(page),
  },
  {
    keys: ["p"],
    label: "P",
    group: "Place",
    words: "Camera: pick it up, put it down",
    run: (page) => pickUp(page),
  },
  {
    keys: ["k"],
    label: "K",
    group: "Look",
    words: "What it knows about a kind of furniture",
    run: always((page) => openKnowledge(page, categoryAtHand(page))),
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
