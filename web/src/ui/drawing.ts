/** Drawing by numbers and buttons: what the pointer does on the floor, done without it. */
import { html, nothing, type TemplateResult } from "lit";
import type { Draft, Point } from "../model/state";
import { formatSize } from "../model/units";
import { button, lengthField, section } from "./controls";
import { nextCorner } from "./exact";
import { hasRoom, hint } from "./hints";
import { putHere } from "./keyboard";
import { parseLength } from "./lengths";
import type { Page } from "./page";
import { wallFields } from "./selection";

const STEP = 0.05; // metres
const TITLES = {
  room: "Draw the room",
  box: "Draw a box",
  door: "Put in a door",
  window: "Put in a window",
};
const WAYS: readonly { angle: number; name: string; sign: string }[] = [
  { angle: Math.PI / 2, name: "north", sign: "↑" },
  { angle: 0, name: "east", sign: "→" },
  { angle: -Math.PI / 2, name: "south", sign: "↓" },
  { angle: Math.PI, name: "west", sign: "←" },
];

export function drawingPanel(page: Page): TemplateResult | typeof nothing {
  const { tool } = page.state;
  if (tool === "select") return nothing;
  return section(
    TITLES[tool],
    html`<p class="quiet">${hint(page.state)}</p>
      ${tool === "room" ? outline(page) : single(page)}
      <div class="row">
        ${button({
          icon: "check",
          label: "Done",
          keys: "Esc",
          run: () => page.dispatch({ type: "choose-tool", tool: "select" }),
        })}
      </div>`,
    "drawing",
  );
}

function single(page: Page): TemplateResult | typeof nothing {
  const { state, local, services } = page;
  if (state.draft?.kind === "box-height") return height(page, state.draft);
  if (!hasRoom(state) && state.tool !== "box") {
    return html`<p class="quiet">There is no wall yet: draw the room first.</p>`;
  }
  const label =
    state.tool === "box" ? "Put a box in the middle of the view" : "Put it in the nearest wall";
  const at = (): Point => local.crosshair ?? services.viewPoint();
  return button({
    icon: state.tool === "box" ? "box" : state.tool === "door" ? "door" : "window",
    label,
    keys: "Enter",
    run: () => putHere(page, at()),
  });
}

function height({ dispatch }: Page, draft: Draft & { kind: "box-height" }): TemplateResult {
  return html`<p class="number">${formatSize(draft.box.size)}</p>
    ${lengthField({
      id: "draft-height",
      label: "Height",
      unit: "cm",
      value: draft.box.size[2],
      step: STEP,
      change: (length) => dispatch({ type: "draw-height", height: length, done: true }),
    })}`;
}

/** While there is a draft: the next wall by length and direction. Else: the walls as they are. */
function outline(page: Page): TemplateResult {
  const { state, dispatch } = page;
  const corners = state.draft?.kind === "room" ? state.draft.corners : null;
  if (corners === null || corners.length === 0) return standing(page);
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
    <div class="row">
      ${button(
        {
          icon: "check",
          label: "Close the room",
          disabled: corners.length < 3,
          run: () => dispatch({ type: "close-outline" }),
        },
        "primary",
      )}
      ${button({ icon: "undo", label: "Last corner", keys: "Del", run: () => dispatch({ type: "remove-last-corner" }) })}
    </div>
  `;
}

function standing(page: Page): TemplateResult {
  const { scene } = page.state;
  const begin = button({
    icon: "new",
    label: "Start in the middle of the view",
    keys: "Enter",
    run: () => putHere(page, page.local.crosshair ?? page.services.viewPoint()),
  });
  if (!hasRoom(page.state)) return begin;
  const { room } = scene;
  return html`${begin}
    <p class="question">The walls as they are</p>
    ${wallFields(
      page,
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
        page.dispatch({ type: "edit-room", room: { ...room, height: length }, done: true }),
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
