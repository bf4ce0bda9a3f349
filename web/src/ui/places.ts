/** The good places that were found, or why there is none. */
import { html, type TemplateResult } from "lit";
import type { Placing } from "../model/state";
import { icon } from "./icons";
import { remedyOffer } from "./instead";
import type { Page } from "./page";
import { begun } from "./words";

export function places(page: Page, placing: Placing): TemplateResult {
  if (placing.mode === "manual") {
    return html`<p class="quiet">Drag it to where you want it. Turn it with the ring, or with [ and ].</p>`;
  }
  const { answer, computing } = placing;
  if (placing.problem !== null) {
    return html`<p class="blocked">${icon("problem")} ${placing.problem}</p>`;
  }
  if (answer === null) return waiting(page);
  if (answer.no_good_place !== null && answer.placements.length === 0) {
    return html`<div class="no-place">
      ${noPlacePicture()}
      <p>${answer.no_good_place.text}</p>
      ${remedyOffer(page, answer.no_good_place.remedy)}
      <p class="quiet">Or put it where you want it: choose Manual.</p>
    </div>`;
  }
  return html`<ol class="places" aria-label="Good places" aria-busy=${computing}>
    ${answer.placements.map(
      (placement, i) => html`<li>
        <button
          type="button"
          class="place-choice"
          aria-pressed=${placing.alternative === placement.rank}
          @click=${() => page.dispatch({ type: "show-alternative", rank: placement.rank })}
        >
          <kbd>${i + 1}</kbd><span><b>${begun(placement.name)}</b><small>${placement.sentence}</small></span>
        </button>
      </li>`,
    )}
  </ol>`;
}

function waiting({ state }: Page): TemplateResult {
  const { status, ended } = state.connection;
  if (status === "offline") {
    const words = ended ?? "Good places come when the connection is back.";
    return html`<p class="quiet">${words} Until then, put it yourself: choose Manual.</p>`;
  }
  return html`<div class="places" aria-busy="true">
    <p class="quiet">Looking for good places…</p>
    <div class="shimmer"></div>
    <div class="shimmer"></div>
    <div class="shimmer"></div>
  </div>`;
}

function noPlacePicture(): TemplateResult {
  return html`<svg class="picture" viewBox="0 0 96 56" aria-hidden="true">
    <path class="wall" d="M6 6h84v44H6z" />
    <path class="thing" d="M10 10h34v16H10zM50 10h36v12H50zM10 32h22v14H10zM66 28h20v18H66z" />
    <path class="ghost" d="M38 30h24v14H38z" />
    <path class="cross" d="M44 32l12 10M56 32L44 42" />
  </svg>`;
}
