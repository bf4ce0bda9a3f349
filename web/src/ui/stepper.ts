/** The places on offer one by one, for a small screen: the sentence of one, back and forth. */
import { html, nothing, type TemplateResult } from "lit";
import { shownRefusal } from "../model/ghost";
import type { Placing } from "../model/state";
import { iconButton } from "./controls";
import type { Page } from "./page";
import { verdictOf } from "./reasons";
import { ended } from "./words";

export function stepper(page: Page, placing: Placing): TemplateResult | typeof nothing {
  const places = placing.answer?.placements ?? [];
  if (placing.mode === "manual" || places.length === 0) return nothing;
  const at = places.findIndex(({ rank }) => rank === placing.alternative);
  const step = (by: number) => (): void => {
    const next = places[(Math.max(at, by < 0 ? 0 : -1) + by + places.length) % places.length];
    if (next !== undefined) page.dispatch({ type: "show-alternative", rank: next.rank });
  };
  const words = shownRefusal(page.state) ?? verdictOf(placing)?.sentence ?? "A place of your own.";
  return html`<div class="stepper phone-only" role="group" aria-label="Place after place">
    ${iconButton({ icon: "before", label: "The place before", run: step(-1) })}
    <p><b>${at < 0 ? "Your own place" : `Place ${at + 1} of ${places.length}`}</b>${ended(words)}</p>
    ${iconButton({ icon: "next", label: "The next place", run: step(1) })}
  </div>`;
}
