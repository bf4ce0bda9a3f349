/** Drawing by numbers and buttons: what the pointer does on the floor, done without it. */
import { html, nothing, type TemplateResult } from "lit";
import type { Draft, Point } from "../model/state";
import { formatSize } from "../model/units";
import { button, lengthField, section } from "./controls";
import { nextCorner } from "./exact";
import { putHere } from "./key_actions";
import { parseLength } from "./lengths";
import { wallFields } from "./outline";
import type { Page } from "./page";

const STEP = 0.05; // metres
const TITLES = {
  room: "Draw the room",
  box: "Draw a box",
  door: "Put in a door",
  window: "Put in a window",
};
const PUT = {
  room: "Start in the middle",
  box: "Put one in the middle",
  door: "Into the nearest wall",
  window: "Into the nearest wall",
};
const WAYS: readonly { angle: number; name: string; sign: string }[] = [
  { angle: Math.PI / 2, name: "north", sign: "↑" },
  { angle: 0, name: "east", sign: "→" },
  { angle: -Math.PI / 2, name: "south", sign: "↓" },
  { angle: Math.PI, name: "west", sign: "←" },
];

export function drawingPanel(page: Page): TemplateResult | typeof nothing {
  const { tool, draft } = page.state;
  if (tool === "select") return nothing;
  const corners = draft?.kind === "room" ? draft.corners : [];
  const content = corners.length > 0 ? nextWall(page, corners) : single(page);
  return section(TITLES[tool], content, "drawing");
}

/** Back to selecting. */
function leave({ dispatch }: Page, label: string): TemplateResult {
  const run = (): void => dispatch({ type: "choose-tool", tool: "select" });
  return button({ icon: "close", label, keys: "Esc", run });
}

/** One thing put where the view is looking. */
function single(page: Page): TemplateResult {
  const { state, local, services } = page;
  if (state.draft?.kind === "box-height") return height(page, state.draft);
  if (state.tool === "select") throw new Error("Selecting draws nothing.");
  const put = button({
    icon: state.tool,
    label: PUT[state.tool],
    keys: "Enter",
    run: () => putHere(page, local.crosshair ?? services.viewPoint()),
  });
  return html`<div class="row">${put} ${leave(page, "Done")}</div>
    ${state.tool === "room" ? standing(page) : nothing}`;
}

function height({ dispatch }: Page, draft: Draft & { kind: "box-height" }): TemplateResult {
  const finish = (height: number): void => dispatch({ type: "draw-height", height, done: true });
  const { size } = draft.box;
  return html`<p class="number">${formatSize(size)}</p>
    <div class="field-and-button">
      ${lengthField({ id: "draft-height", label: "Height", unit: "cm", value: size[2], step: STEP, change: finish })}
      ${button({ icon: "check", label: "Done", keys: "Enter", run: () => finish(size[2]) }, "primary")}
    </div>`;
}

/** The next wall by its length and its direction. */
function nextWall(page: Page, corners: readonly Point[]): TemplateResult {
  const { dispatch } = page;
  const last = corners[corners.length - 1] as Point;
  return html`
    <p class="question">Or type the next wall:</p>
    <div class="next-wall">
      <div class="field">
        <label for="next-wall">Length</label>
        <span class="input"
          ><input id="next-wall" type="text" inputmode="decimal" value="3" autocomplete="off" aria-describedby="next-wall-problem" /><span class="unit" aria-hidden="true">m</span></span
        >
        <span class="problem" id="next-wall-problem" role="alert"></span>
      </div>
      <div class="ways" role="group" aria-label="Which way it goes">
        ${WAYS.map(
          ({ angle, name, sign }) =>
            html`<button type="button" class="icon-button way-${name}" aria-label="Wall to the ${name}" title="To the ${name}" @click=${() => addWall(page, last, angle)}>${sign}</button>`,
        )}
      </div>
    </div>
    ${button(
      {
        icon: "check",
        label: "Close the room",
        disabled: corners.length < 3,
        run: () => dispatch({ type: "close-outline" }),
      },
      "primary",
    )}
    <div class="row">
      ${button({ icon: "undo", label: "Last corner", keys: "Del", run: () => dispatch({ type: "remove-last-corner" }) })}
      ${leave(page, "Stop")}
    </div>
  `;
}

/** The walls as they are, each by its length, and the ceiling. */
function standing({ state, dispatch }: Page): TemplateResult {
  const { room } = state.scene;
  return html`<p class="question">Or type how long the walls are:</p>
    ${wallFields(
      { state, dispatch },
      room.corners.map((_, i) => i),
    )}
    ${lengthField({
      id: "room-height",
      label: "Ceiling",
      unit: "m",
      value: room.height,
      limits: { min: 1, max: 20 },
      step: STEP,
      change: (length) =>
        dispatch({ type: "edit-room", room: { ...room, height: length }, done: true }),
    })}`;
}

function addWall({ dispatch, change }: Page, last: Point, angle: number): void {
  const input = document.getElementById("next-wall") as HTMLInputElement;
  const typed = parseLength(input.value, "m");
  const problem = document.getElementById("next-wall-problem") as HTMLElement;
  input.setAttribute("aria-invalid", String(!typed.ok));
  problem.textContent = typed.ok ? "" : typed.problem;
  if (!typed.ok) return;
  const at = nextCorner(last, angle, typed.metres);
  change({ crosshair: at });
  dispatch({ type: "draw-down", at, free: true });
  dispatch({ type: "draw-up", at, free: true });
}
