/** The places on offer one by one, for a small screen: the sentence of one, back and forth. */
import { html, nothing, type TemplateResult } from "lit";
import { shownRefusal } from "../model/ghost";
import type { Placing } from "../model/state";
import { iconButton } from "./controls";
import { isWorse } from "./instead";
import type { Page } from "./page";
import { verdictOf } from "./reasons";
import { begun, ended } from "./words";

export function stepper(page: Page, placing: Placing): TemplateResult {
  const places = placing.answer?.placements ?? [];
  const at = places.findIndex(({ rank }) => rank === placing.alternative);
  const step = (by: number) => (): void => {
    const next = places[(Math.max(at, by < 0 ? 0 : -1) + by + places.length) % places.length];
    if (next !== undefined) page.dispatch({ type: "show-alternative", rank: next.rank });
  };
  const choosing = placing.mode === "scenegen" && places.length > 0;
  return html`<div class="stepper phone-only" role="group" aria-label="Place after place">
    ${choosing ? iconButton({ icon: "before", label: "The place before", run: step(-1) }) : nothing}
    <p>
      ${choosing ? html`<b>${at < 0 ? "Your own place" : `${at + 1} of ${places.length} · ${begun(places[at]?.name ?? "")}`}</b>` : nothing}
      ${ended(wordsOf(page, placing))} ${why(page, placing)}
    </p>
    ${choosing ? iconButton({ icon: "next", label: "The next place", run: step(1) }) : nothing}
  </div>`;
}

/** To what speaks for the place or against it, further down in the sheet. */
function why({ change }: Page, placing: Placing): TemplateResult | typeof nothing {
  if (verdictOf(placing) === null) return nothing;
  const run = (): void => {
    change({ sheet: "half" });
    const part = document.querySelector(".panel .reasons");
    if (part instanceof HTMLDetailsElement) part.open = true;
    part?.scrollIntoView();
  };
  return html`<button type="button" class="link" @click=${run}>
    ${isWorse(placing) ? "Why not here?" : "Why here?"}
  </button>`;
}

/** How things stand with the place, in one sentence. */
function wordsOf({ state }: Page, placing: Placing): string {
  const refusal = placing.problem ?? shownRefusal(state);
  if (refusal !== null) return refusal;
  if (placing.mode === "manual") return "Drag it to where you want it.";
  const none = placing.answer?.placements.length === 0 ? placing.answer.no_good_place : null;
  if (none) return none.text;
  if (placing.answer !== null) return verdictOf(placing)?.sentence ?? "Looking at this place…";
  return state.connection.status === "offline"
    ? "Good places come when the connection is back."
    : "Looking for good places…";
}
