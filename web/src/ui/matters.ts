/** "What matters most?": the thing without which the place would be another. */
import { html, nothing, type TemplateResult } from "lit";
import type { Placing, Weigh } from "../model/state";
import type { Counterfactual } from "../net/protocol.gen";
import { button } from "./controls";
import type { Page } from "./page";
import { signed } from "./words";

export function mattersPart(page: Page, placing: Placing): TemplateResult | typeof nothing {
  const { weigh, answer } = placing;
  if (answer === null || answer.placements.length === 0) return nothing;
  if (page.state.scene.boxes.length === 0) return nothing;
  return html`<div class="matters" aria-live="polite">
    ${weigh === null ? question(page) : reply(page, weigh)}
  </div>`;
}

function question({ state, dispatch }: Page): TemplateResult {
  return button({
    icon: "info",
    label: "What matters most?",
    disabled: state.connection.status !== "online" || (state.placing?.computing ?? true),
    run: () => dispatch({ type: "what-matters", on: true }),
  });
}

function reply(page: Page, { done, total, result }: Weigh): TemplateResult {
  const stop = (): void => page.dispatch({ type: "what-matters", on: false });
  if (result === null) {
    const words = total === 0 ? "" : ` ${done + 1} of ${total}`;
    return html`<p>Looking for the place without each thing…${words}</p>
      <progress max=${Math.max(total, 1)} value=${done} aria-label="Things tried"></progress>
      ${button({ icon: "close", label: "Stop", run: stop }, "quiet")}`;
  }
  const { found } = result;
  if (found === null) {
    return html`<p>No single thing matters: without any one of them it would go to the same place.</p>
      ${button({ icon: "close", label: "Good to know", run: stop }, "quiet")}`;
  }
  return told(page, found, stop);
}

function told({ local, dispatch }: Page, found: Counterfactual, stop: () => void): TemplateResult {
  return html`<p><b>What matters most:</b> ${found.text}</p>
    ${
      local.numbers && found.center !== null
        ? html`<p class="total">
            <span>Score of the best place, without it</span
            ><span class="number">${signed(found.score_change)}</span>
          </p>`
        : nothing
    }
    <div class="row">
      ${button({
        icon: "remove",
        label: "Try without it",
        run: () => dispatch({ type: "remove-box", id: found.box }),
      })}
      ${button({ icon: "close", label: "Close", run: stop }, "quiet")}
    </div>`;
}
