/** "What does it know about beds?": its examples of a category as bars, with the counts behind. */
import { html, nothing, svg, type TemplateResult } from "lit";
import type { CategoryMarginals, KnowledgeMarginals, Source } from "../model/knowledge";
import { chips, placeable } from "./categories";
import { button, iconButton } from "./controls";
import { categoryIcon, icon } from "./icons";
import {
  examplesInWords,
  frontlessInWords,
  groupRows,
  manyInWords,
  neverInWords,
  positionRows,
  type Row,
  sizeInWords,
  sourceInWords,
  towardsCenterRows,
} from "./knowledge_words";
import type { Page } from "./page";
import { ended } from "./words";

/** Where a thing stands in a small square room, as x and y of its picture. */
const SPOTS: Readonly<Record<string, readonly [number, number]>> = {
  corner: [4, 4],
  edge: [9, 4],
  middle: [9, 9],
};

/** Shows what is known of a category, and asks the server for it unless it is here already. */
export function openKnowledge(page: Page, category: string): void {
  const { local, change } = page;
  change({ knowledgeOf: category });
  if (local.knowledge === null || local.knowledge === "out of reach") void load(page);
}

/** The category that the person is busy with; else the first. */
export function categoryAtHand({ state }: Page): string {
  const { placing, selection, scene, lists } = state;
  const selected = scene.boxes.find(({ id }) => selection?.kind === "box" && selection.id === id);
  const names = placeable(lists.categories);
  const busyWith = placing?.category ?? selected?.category ?? "";
  return names.includes(busyWith) ? busyWith : (names[0] ?? "");
}

/** The quiet way there. */
export function knowledgeButton(page: Page, category: string): TemplateResult {
  const label = `What does it know about ${manyInWords(category)}?`;
  const run = (): void => openKnowledge(page, category);
  return button({ icon: "info", label, keys: "K", run }, "quiet");
}

export function knowledgeDialog(page: Page): TemplateResult {
  const { knowledgeOf } = page.local;
  return html`<dialog
    class="knowledge"
    aria-labelledby="knowledge-title"
    @close=${() => page.change({ knowledgeOf: null })}
  >
    ${knowledgeOf === null ? nothing : content(page, knowledgeOf)}
  </dialog>`;
}

async function load({ services, change }: Page): Promise<void> {
  change({ knowledge: "loading" });
  change({ knowledge: (await services.fetchKnowledge()) ?? "out of reach" });
}

function content(page: Page, category: string): TemplateResult {
  const { state, local, change } = page;
  const facts = typeof local.knowledge === "string" ? null : local.knowledge;
  const names = facts?.categories.map((known) => known.category);
  return html`
    <div class="title">
      <h2 id="knowledge-title">What it knows about ${manyInWords(category)}</h2>
      ${iconButton({ icon: "close", label: "Close", keys: "Esc", run: () => change({ knowledgeOf: null }) })}
    </div>
    ${chips("About what", names ?? placeable(state.lists.categories), category, (name) =>
      change({ knowledgeOf: name }),
    )}
    ${facts === null ? waiting(page) : known(page, facts, category)}
  `;
}

function waiting(page: Page): TemplateResult {
  if (page.local.knowledge !== "out of reach") {
    return html`<p role="status">Looking it up…</p>
      <div class="shimmer"></div>`;
  }
  return html`<p role="alert">What it knows is with the server, and that can't be reached now.</p>
    ${button({ icon: "again", label: "Try again", run: () => void load(page) }, "primary")}`;
}

function known(page: Page, facts: KnowledgeMarginals, category: string): TemplateResult {
  const part = facts.categories.find((one) => one.category === category);
  return html`
    ${part === undefined ? html`<p role="status">It has seen none yet.</p>` : figures(page, part)}
    ${sources(facts.sources)}
  `;
}

function figures({ state }: Page, part: CategoryMarginals): TemplateResult {
  const info = state.lists.categories.find(({ name }) => name === part.category);
  return html`
    <p class="seen" role="status">
      It has seen ${examplesInWords(part.examples, part.category)}.
      ${info === undefined ? nothing : `The usual size: ${ended(sizeInWords(info.size))}`}
    </p>
    <div class="figures" data-category=${part.category}>
      ${figure(
        "Where in the room?",
        positionRows(part),
        "Measured from its middle: a wall nearer than 1 m counts, two make a corner. Long things miss the wall at their end.",
      )}
      ${figure(
        "What is within 1 m of it?",
        groupRows(part.surrounded_by, part.examples),
        neverInWords(part.surrounded_by),
        "around",
      )}
      ${
        part.facing.length === 0
          ? html`<section>
              <h3>What does it face?</h3>
              <p>${frontlessInWords(info?.symmetry)}</p>
            </section>`
          : fronts(part)
      }
    </div>
  `;
}

function fronts(part: CategoryMarginals): TemplateResult {
  return html`
    ${figure(
      "What is right in front of it, within 1 m?",
      groupRows(part.facing, part.fronts),
      neverInWords(part.facing),
    )}
    ${figure(
      "Does it face the middle of the room?",
      towardsCenterRows(part),
      "Into the room: what it looks at is one of the walls further away.",
    )}
  `;
}

function figure(title: string, rows: readonly Row[], note: string, kind = ""): TemplateResult {
  return html`<section class=${kind}>
    <h3>${title}</h3>
    <ul class="facts" aria-label=${title}>
      ${rows.map(fact)}
    </ul>
    ${rows.some(({ possible }) => possible > 0) ? key() : nothing}
    ${note === "" ? nothing : html`<p class="quiet">${note}</p>`}
  </section>`;
}

/** One row: its name, its bar, and what the bar shows in numbers. */
function fact(row: Row): TemplateResult {
  return html`<li data-category=${row.possible > 0 ? row.label : nothing}>
    ${picture(row)}
    <span class="name">${row.words}</span>
    <span class="counts"><b>${row.percent}</b> ${row.counts}</span>
    ${bar(row.share, row.possible)}
    ${row.details === "" ? nothing : html`<small>${row.details}</small>`}
  </li>`;
}

function bar(share: number, possible: number): TemplateResult {
  return html`<svg class="share" viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true">
    <rect class="track" width="100" height="10" />
    <rect class="possible" width=${100 * possible} height="10" />
    <rect class="filled" width=${100 * share} height="10" />
  </svg>`;
}

/** What the two shades of a bar mean. */
function key(): TemplateResult {
  return html`<p class="key quiet" aria-hidden="true">
    <span><i class="filled"></i>Close by</span><span><i class="possible"></i>Somewhere in the room</span>
  </p>`;
}

function picture({ label, possible }: Row): TemplateResult {
  if (possible > 0) return categoryIcon(label);
  const spot = SPOTS[label];
  if (spot === undefined) return icon(label === "yes" ? "check" : "close");
  return html`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
    ${svg`<path d="M3 3h18v18H3z" /><rect class="spot" x=${spot[0]} y=${spot[1]} width="6" height="6" />`}
  </svg>`;
}

function sources(all: readonly Source[]): TemplateResult {
  return html`<section class="sources">
    <h3>All it knows comes from these rooms</h3>
    <ul>
      ${all.map(
        (source) => html`<li>
          <b>${source.name}</b>
          <small>${sourceInWords(source)} · license: ${source.license} · ${source.copyright}</small>
        </li>`,
      )}
    </ul>
  </section>`;
}
