/** What lies over the room: how things stand, what to do next, what happened. */
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Notice, State } from "../model/state";
import { button, iconButton } from "./controls";
import { hasRoom, hint } from "./hints";
import { type IconName, icon } from "./icons";
import type { Page } from "./page";

const TONES: Readonly<Record<Notice["tone"], IconName>> = {
  info: "info",
  success: "check",
  problem: "problem",
};

/** Which of the states of the page needs a picture and words of its own. */
export function situationOf(state: State): "loading" | "no-room" | "empty" | "offline" | null {
  if (state.connection.status === "offline") return "offline";
  if (!hasRoom(state)) return state.connection.status === "connecting" ? "loading" : "no-room";
  const busy = state.tool !== "select" || state.placing !== null;
  return state.scene.boxes.length === 0 && !busy ? "empty" : null;
}

export function situation(page: Page): TemplateResult | typeof nothing {
  const { state, dispatch } = page;
  switch (situationOf(state)) {
    case "loading":
      return html`<section class="card state" aria-label="Loading">
        ${roomPicture(nothing)}
        <p>Getting the room ready…</p>
      </section>`;
    case "no-room":
      if (state.tool === "room") return nothing;
      return html`<section class="card state" aria-label="No room yet">
        ${roomPicture(svg`<path class="ghost" d="M14 44V12h40" /><path class="cross" d="M50 8l8 4-8 4" />`)}
        <p><b>No room yet.</b> Draw its outline, or open one from the menu.</p>
        ${button({ icon: "room", label: "Draw the room", keys: "R", run: () => dispatch({ type: "choose-tool", tool: "room" }) }, "primary")}
      </section>`;
    case "empty":
      return html`<section class="card state" aria-label="Empty room">
        ${roomPicture(svg`<path class="ghost" d="M36 26h24v14H36z" />`)}
        <p><b>An empty room.</b> Draw what stands in it, or pick something to place.</p>
        ${button({ icon: "box", label: "Draw a box", keys: "B", run: () => dispatch({ type: "choose-tool", tool: "box" }) })}
      </section>`;
    case "offline":
      return html`<p class="pill offline">${icon("offline")}<span>Offline. You can go on; I'll catch up.</span></p>`;
    case null:
      return nothing;
  }
}

/** One sentence saying what to do next. */
export function nextStep({ state, local }: Page): TemplateResult | typeof nothing {
  const guided = local.guide !== "invite" && local.guide !== "done";
  const words = guided ? null : hint(state);
  return words === null ? nothing : html`<p class="pill hint">${words}</p>`;
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

function roomPicture(inside: unknown): TemplateResult {
  return html`<svg class="picture" viewBox="0 0 96 56" aria-hidden="true">
    <path class="wall" d="M6 6h84v44H6z" />${inside}
  </svg>`;
}
