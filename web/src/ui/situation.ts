/** What lies over the room: how things stand, what to do next, what happened. */
import { html, nothing, type TemplateResult } from "lit";
import type { Notice } from "../model/state";
import { button, iconButton } from "./controls";
import { hint } from "./hints";
import { type IconName, icon } from "./icons";
import type { Page } from "./page";

const TONES: Readonly<Record<Notice["tone"], IconName>> = {
  info: "info",
  success: "check",
  problem: "problem",
};

export function situation(page: Page): TemplateResult | typeof nothing {
  const { state } = page;
  const { status, ended } = state.connection;
  if (ended !== null) return pill("problem", ended, reload());
  if (status === "offline") return pill("offline", "Offline. You can go on; I'll catch up.");
  if (state.ar !== null) return nothing;
  const busy = state.tool !== "select" || state.placing !== null;
  return state.scene.boxes.length === 0 && !busy ? emptyRoom(page) : nothing;
}

function pill(
  name: IconName,
  words: string,
  way: TemplateResult | typeof nothing = nothing,
): TemplateResult {
  return html`<div class="pill">${icon(name)}<span>${words}</span>${way}</div>`;
}

function reload(): TemplateResult {
  return button({ icon: "turn-right", label: "Reload", run: () => location.reload() });
}

function emptyRoom({ dispatch }: Page): TemplateResult {
  return html`<section class="card" aria-label="Empty room">
    <svg class="picture" viewBox="0 0 96 56" aria-hidden="true">
      <path class="wall" d="M6 6h84v44H6z" /><path class="ghost" d="M36 20h24v16H36z" />
    </svg>
    <p><b>An empty room.</b> Draw what stands in it, or pick something to place.</p>
    ${button({
      icon: "box",
      label: "Draw a box",
      keys: "B",
      run: () => dispatch({ type: "choose-tool", tool: "box" }),
    })}
  </section>`;
}

/** One sentence saying what to do next. */
export function nextStep({ state, local }: Page): TemplateResult | typeof nothing {
  if (state.ar !== null) return nothing;
  const guided = local.guide !== "invite" && local.guide !== "done";
  const words = guided ? null : hint(state);
  return words === null ? nothing : html`<p class="pill hint">${words}</p>`;
}

/** The same in the camera view: above, where it hides nothing that is pointed at. */
export function coaching({ state: { ar }, state }: Page): TemplateResult | typeof nothing {
  const words = ar === null ? null : hint(state);
  return words === null ? nothing : html`<p class="pill hint coach">${words}</p>`;
}

/** What happened, until it is dismissed. */
export function toast({ state, dispatch }: Page): TemplateResult | typeof nothing {
  const { notice } = state;
  if (notice === null) return nothing;
  return html`<div class="toast" data-tone=${notice.tone}>
    ${icon(TONES[notice.tone])}<span>${notice.text}</span>
    ${iconButton({ icon: "close", label: "Dismiss", run: () => dispatch({ type: "dismiss-notice" }) })}
  </div>`;
}
