/** What it would take: another place, another size, one thing less, one rule less. */
import { html, nothing, type TemplateResult } from "lit";
import { isSamePose } from "../model/ghost";
import type { Placing } from "../model/state";
import type { Cost, Remedy } from "../net/protocol.gen";
import { button, type Command } from "./controls";
import type { Page } from "./page";
import { begun, reasonInWords } from "./words";

/** From where the ghost may not stand to the nearest place where it may. */
export function wayOut({ state, dispatch }: Page): TemplateResult | typeof nothing {
  const { placing } = state;
  if (placing === null || !isAbout(placing) || placing.inspected?.allowed !== false) return nothing;
  const { elsewhere } = placing.inspected;
  if (elsewhere === null) return html`<p class="quiet">It fits nowhere near.</p>`;
  const { center, heading, text } = elsewhere;
  const run = (): void => dispatch({ type: "drag-ghost", pose: { center, heading }, done: true });
  return button({ icon: "next", label: `Move it ${text}`, run });
}

/** Whether the ghost stands where it may, but another place is better. */
export function isWorse(placing: Placing): boolean {
  const { inspected } = placing;
  return isAbout(placing) && inspected?.allowed === true && inspected.costs.length > 0;
}

/** What a place of one's own loses to the best one, and where it would be better. */
export function costs({ state, dispatch }: Page): TemplateResult | typeof nothing {
  const { placing } = state;
  if (placing === null || !isAbout(placing) || placing.inspected?.allowed !== true) return nothing;
  const { costs, elsewhere } = placing.inspected;
  if (costs.length === 0) return html`<p>No place is better.</p>`;
  const told = costs.filter(({ here, best }) => here !== best);
  return html`<h3>Why not here?</h3>
    ${
      told.length === 0
        ? html`<p>Nearly as good as the best place.</p>`
        : html`<ul class="costs">
            ${told.map(cost)}
          </ul>`
    }
    ${
      elsewhere === null
        ? nothing
        : html`<p>Better: <b>${elsewhere.text}</b>. ${elsewhere.sentence}.</p>
            ${button({
              icon: "next",
              label: "Move it there",
              run: () =>
                dispatch({
                  type: "drag-ghost",
                  pose: { center: elsewhere.center, heading: elsewhere.heading },
                  done: true,
                }),
            })}`
    }`;
}

function cost({ relation, group, here, best }: Cost): TemplateResult {
  const about = reasonInWords({ relation, group, contribution: 0, text: here });
  return html`<li>
    <small>${about}</small>
    <span>${begun(here === "" ? "nothing to say here" : here)}</span>
    ${best === "" ? nothing : html`<span class="quiet">Best place: ${best}</span>`}
  </li>`;
}

/** Of the pose where the ghost is now, not of one that it has left. */
function isAbout({ inspectedPose, pose, alternative }: Placing): boolean {
  return alternative === null && isSamePose(pose, inspectedPose);
}

/** The nearest thing that gives a place where there is none. */
export function remedyOffer(page: Page, remedy: Remedy | null): TemplateResult | typeof nothing {
  if (remedy === null) return nothing;
  const command = commandOf(page, remedy);
  return html`<p>${remedy.text}</p>
    ${command === null ? nothing : button(command, "primary")}`;
}

function commandOf({ dispatch }: Page, { kind, size, box, rule }: Remedy): Command | null {
  switch (kind) {
    case "size": {
      if (size === null) return null;
      return {
        icon: "check",
        label: "Use that size",
        run: () => dispatch({ type: "set-size", size }),
      };
    }
    case "box": {
      if (box === null) return null;
      const run = (): void => dispatch({ type: "remove-box", id: box });
      return { icon: "remove", label: "Take it away", run };
    }
    case "rule": {
      if (rule === null) return null;
      const run = (): void => dispatch({ type: "relax", rule });
      return { icon: "check", label: "I can live with that", run };
    }
  }
}
