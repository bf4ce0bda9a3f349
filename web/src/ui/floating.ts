/** The panel of a device that shows no page in front of the room: a sentence, and what to press. */
import type { ArControls, FloatingContent, PanelButton } from "../contract";
import type { Action } from "../model/actions";
import { shownRefusal } from "../model/ghost";
import { likelyCategories } from "../model/labels";
import { selectedBox } from "../model/selecting";
import type { Ar, Placing, Point, State } from "../model/state";
import type { Placement } from "../net/protocol.gen";
import { arHint, canCapture, foundInWords } from "./ar_words";
import { placeable } from "./categories";
import { keypad, keypadTitle, sizeRow } from "./keypad";
import { verdictOf } from "./reasons";
import { begun, ended } from "./words";

export interface Floating {
  readonly state: State;
  readonly ar: ArControls;
  dispatch(action: Action): void;
  viewPoint(): Point;
}

/** Labels that fit into a row. */
const IN_A_ROW = 4;
const TURN = Math.PI / 12; // 15°

export function floating(floating: Floating): FloatingContent {
  const { state, ar } = floating;
  const now = state.ar;
  if (now === null) return { title: "", rows: [] };
  const end: PanelButton = { label: "End", run: () => ar.end() };
  if (state.notice !== null) {
    const okay = pressing(floating)("OK", { type: "dismiss-notice" }, true);
    return { title: state.notice.text, rows: [[okay]] };
  }
  const title = titleOf(state, now);
  if (now.step !== "ready") return { title, rows: [[end]] };
  if (now.typing !== null) {
    const rows = keypad(state, now.typing, pressing(floating), floating.dispatch);
    return { title: keypadTitle(now.typing), rows };
  }
  return { title, rows: rowsOf(floating, now, end) };
}

function titleOf(state: State, now: Ar): string {
  if (now.found !== null) return `Your device knows this room: ${foundInWords(now)}.`;
  const hint = arHint(state, now) ?? "Is this right?";
  const { placing } = state;
  if (placing === null || now.carrying) return hint;
  const name = chosenPlace(placing)?.name;
  const sentence = ended(verdictOf(placing)?.sentence ?? hint);
  const named = name && !sentence.includes(name) ? `${begun(name)}: ${sentence}` : sentence;
  return shownRefusal(state) ?? named;
}

/** The place on offer that is shown, unless the hand has moved it since. */
function chosenPlace({ answer, alternative }: Placing): Placement | undefined {
  return answer?.placements.find(({ rank }) => rank === alternative);
}

function rowsOf(floating: Floating, now: Ar, end: PanelButton): FloatingContent["rows"] {
  const { state } = floating;
  const press = pressing(floating);
  if (now.found !== null) {
    const none = press("I draw it myself", { type: "change-ar", change: { found: null } });
    return [[press("Use them", { type: "use-found" }, true), none]];
  }
  if (now.unchecked.length > 0) {
    const keep = press("Keep", { type: "check-piece", keep: true }, true);
    const drop = press("Drop", { type: "check-piece", keep: false });
    return [labels(floating), sizeRow(state, press), [keep, drop]];
  }
  const { placing: placed } = state;
  if (placed !== null) {
    return [alternatives(floating, placed), sizeRow(state, press), placing(floating)];
  }
  if (state.tool !== "select") return marking(floating);
  return selectedBox(state) === undefined ? idle(floating, end) : chosen(floating);
}

function idle(floating: Floating, end: PanelButton): FloatingContent["rows"] {
  const { state, ar, dispatch, viewPoint } = floating;
  const press = pressing(floating);
  const categories = placeable(state.lists.categories).map(
    (category): PanelButton => ({
      label: category,
      run: () => {
        const wish = { category, item: null, size: null, view: viewPoint() };
        dispatch({ type: "place", ...wish, mode: "scenegen" });
      },
    }),
  );
  const half = Math.ceil(categories.length / 2);
  return [
    categories.slice(0, half),
    categories.slice(half),
    [
      press("Mark a thing", { type: "choose-tool", tool: "box" }),
      press("Outline", { type: "choose-tool", tool: "room" }),
      canCapture(state)
        ? { label: "Scan", run: () => ar.capture() }
        : press("Door", { type: "choose-tool", tool: "door" }),
      press("Undo", { type: "undo" }),
      end,
    ],
  ];
}

/** What can be done to the box that is selected. */
function chosen(floating: Floating): FloatingContent["rows"] {
  const press = pressing(floating);
  return [
    labels(floating),
    sizeRow(floating.state, press),
    [
      press("Turn left", { type: "turn", by: TURN }),
      press("Turn right", { type: "turn", by: -TURN }),
      press("Remove", { type: "delete-selected" }),
      press("Undo", { type: "undo" }),
      press("Done", { type: "select", selection: null }, true),
    ],
  ];
}

function marking(floating: Floating): FloatingContent["rows"] {
  const { state } = floating;
  const press = pressing(floating);
  const done = press("Done", { type: "choose-tool", tool: "select" });
  if (state.tool === "room") {
    const corners = state.draft?.kind === "room" ? state.draft.corners.length : 0;
    const close = press("Close it", { type: "close-outline" }, true);
    return [
      [press("Last corner", { type: "remove-last-corner" }), done],
      corners > 2 ? [close] : [],
    ];
  }
  const again = press("Start over", { type: "choose-tool", tool: state.tool });
  if (state.draft !== null) return [[again, done]];
  return [labels(floating), sizeRow(state, press), [press("Undo", { type: "undo" }), done]];
}

/** What the selected box is: the likely ones; what was placed is known. */
function labels(floating: Floating): readonly PanelButton[] {
  const box = selectedBox(floating.state);
  if (box === undefined || box.placed === true) return [];
  return likelyCategories(box.size, floating.state.lists.categories)
    .slice(0, IN_A_ROW)
    .map((category) =>
      pressing(floating)(
        category,
        { type: "edit-box", box: { ...box, category }, done: true },
        category === box.category,
      ),
    );
}

function alternatives(floating: Floating, placing: Placing): readonly PanelButton[] {
  if (placing.mode === "manual") return [];
  return (placing.answer?.placements ?? []).map(({ rank }, i) =>
    pressing(floating)(
      String(i + 1),
      { type: "show-alternative", rank },
      rank === placing.alternative,
    ),
  );
}

function placing(floating: Floating): readonly PanelButton[] {
  const { state, viewPoint } = floating;
  const press = pressing(floating);
  const byHand = state.placing?.mode === "manual";
  const mode = byHand ? "scenegen" : "manual";
  return [
    press("Place it", { type: "confirm" }, true),
    press(byHand ? "SceneGen" : "Manual", { type: "set-mode", mode, view: viewPoint() }),
    press("Cancel", { type: "cancel" }),
  ];
}

function pressing({ dispatch }: Floating) {
  return (label: string, action: Action, primary = false): PanelButton => ({
    label,
    primary,
    run: () => dispatch(action),
  });
}
