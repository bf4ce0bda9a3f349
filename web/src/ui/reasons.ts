/** "Why here": the sentence, and what each relation adds or takes away. */
import { html, nothing, type TemplateResult } from "lit";
import type { Placing } from "../model/state";
import type { Reason } from "../net/protocol.gen";
import { section } from "./controls";
import { costs } from "./instead";
import { knownRooms } from "./known_rooms";
import { mattersPart } from "./matters";
import type { Page } from "./page";
import { begun, ended, likelihoodInWords, reasonInWords, signed, strengthInWords } from "./words";

/** Bars shown at once; the rest waits behind a click. */
const SHOWN = 4;

/** What speaks for where the ghost stands now; why it may not stand there is said at the button. */
interface Verdict {
  readonly sentence: string;
  readonly score: number | null;
  readonly likelihood: number | null;
  readonly reasons: readonly Reason[];
  readonly rooms: readonly string[];
}

export function reasonsPanel(page: Page): TemplateResult | typeof nothing {
  const { placing } = page.state;
  const verdict = placing === null ? null : verdictOf(placing);
  if (placing === null || verdict === null) return nothing;
  const why = html`<p class="why">
        ${ended(verdict.sentence)}
        ${verdict.likelihood === null ? nothing : html`<small>${begun(`${likelihoodInWords(verdict.likelihood)} place`)}.</small>`}
      </p>
      ${costs(page)} ${bars(page, verdict.reasons)} ${total(page, verdict)}
      ${knownRooms(page, placing.category, verdict.rooms)} ${mattersPart(page, placing)}`;
  return placing.mode === "manual" ? onDemand(why) : section("Why here", why, "reasons");
}

/** Who finds the place without help is told when asking. */
function onDemand(why: TemplateResult): TemplateResult {
  return html`<details class="part reasons more"><summary>Why here?</summary>${why}</details>`;
}

/** Of the chosen alternative, or of the pose the ghost was dragged to; null where it may not stand. */
export function verdictOf(placing: Placing): Verdict | null {
  const chosen = placing.answer?.placements.find(({ rank }) => rank === placing.alternative);
  if (chosen !== undefined) return chosen;
  const { inspected } = placing;
  return inspected?.allowed === true ? { ...inspected, rooms: [] } : null;
}

/** Strongest first, whether they speak for or against. */
export function byStrength(reasons: readonly Reason[]): readonly Reason[] {
  return reasons.toSorted((a, b) => Math.abs(b.contribution) - Math.abs(a.contribution));
}

function bars({ local }: Page, reasons: readonly Reason[]): TemplateResult | typeof nothing {
  if (reasons.length === 0) return nothing;
  const sorted = byStrength(reasons);
  const longest = Math.abs(sorted[0]?.contribution ?? 0) || 1;
  const list = (some: readonly Reason[]): TemplateResult =>
    html`<ul class="bars">${some.map((reason) => bar(reason, longest, local.numbers))}</ul>`;
  const rest = sorted.slice(SHOWN);
  return html`
    ${list(sorted.slice(0, SHOWN))}
    ${
      rest.length === 0
        ? nothing
        : html`<details class="more">
            <summary>Show all ${sorted.length}</summary>
            ${list(rest)}
          </details>`
    }
  `;
}

function bar(reason: Reason, longest: number, numbers: boolean): TemplateResult {
  const share = reason.contribution / longest;
  const length = Math.abs(share) * 50;
  return html`<li>
    <span class="words">${begun(reason.text)}<small>${reasonInWords(reason)}</small></span>
    <span>
      <svg class="measure" viewBox="0 0 100 8" preserveAspectRatio="none" aria-hidden="true">
        <path class="axis" d="M50 0v8" />
        <rect
          class=${share < 0 ? "against" : "for"}
          x=${share < 0 ? 50 - length : 50}
          y="1"
          width=${Math.max(length, 0.5)}
          height="6"
        />
      </svg>
      <small class="number">${numbers ? signed(reason.contribution) : strengthInWords(share)}</small>
    </span>
  </li>`;
}

/** The numbers behind the bars, on demand: they are logarithms, and mean little to most people. */
function total({ local, change }: Page, { score }: Verdict): TemplateResult {
  return html`<label class="check"
      ><input
        type="checkbox"
        .checked=${local.numbers}
        @change=${() => change({ numbers: !local.numbers })}
      /><span>Numbers</span></label
    >
    ${
      !local.numbers || score === null
        ? nothing
        : html`<p class="total">
              <span>All together, against an average spot</span
              ><span class="number">${signed(score)}</span>
            </p>
            <p class="quiet"><small>As logarithms: 0.69 more is twice as likely.</small></p>`
    }`;
}
