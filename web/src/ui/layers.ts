/** What is shown over the room: the map, its legend, the graph, the names. */
import { html, nothing, type TemplateResult } from "lit";
import { relationLook } from "../model/relation_looks";
import { shownMaps } from "../model/showing";
import type { HeatMap, Layer, State } from "../model/state";
import { toolButton } from "./controls";
import type { IconName } from "./icons";
import type { Page } from "./page";
import { likelihoodInWords, relationInWords, signed } from "./words";

const LAYERS: readonly { layer: Layer; icon: IconName; label: string; keys: string }[] = [
  { layer: "heat", icon: "heat", label: "Map", keys: "H" },
  { layer: "graph", icon: "graph", label: "Relations", keys: "G" },
  { layer: "labels", icon: "labels", label: "Names", keys: "L" },
];

const PIXELS = 50; // a metre of a line in the room, in the sample

/** Over the room on a desk; on a phone it is a part of the sheet. */
export function layers(page: Page): TemplateResult {
  return html`<section class="layers desk-only" aria-label="What is shown">${content(page)}</section>`;
}

export function layersPanel(page: Page): TemplateResult {
  return html`<section class="part phone-only" aria-label="What is shown">${content(page)}</section>`;
}

function content(page: Page): TemplateResult {
  return html`${legend(page)} ${relations(page)} ${toggles(page)}`;
}

function toggles({ state, dispatch }: Page): TemplateResult {
  return html`<div class="toggles" role="group" aria-label="Show">
    ${LAYERS.map(({ layer, icon, label, keys }) =>
      toolButton({
        icon,
        label,
        keys,
        pressed: state.shown[layer],
        run: () => dispatch({ type: "toggle-layer", layer }),
      }),
    )}
  </div>`;
}

/** The colors of the map in words, and how strongly they cover the floor. */
function legend({ state, dispatch }: Page): TemplateResult | typeof nothing {
  const map = shownMaps(state)[0];
  if (map === undefined) return nothing;
  return html`<div class="legend">
    <div class="scale" aria-hidden="true"></div>
    <p class="ends"><span>unlikely</span><span>likely</span></p>
    ${numbers(map)} ${probe(state)}
    <label class="slider"
      ><span>Strength</span
      ><input
        type="range"
        min="0.1"
        max="1"
        step="0.05"
        .value=${String(state.shown.heatOpacity)}
        @input=${(event: Event) =>
          dispatch({
            type: "set-heat-opacity",
            opacity: Number((event.target as HTMLInputElement).value),
          })}
    /></label>
  </div>`;
}

function numbers(map: HeatMap): TemplateResult {
  return html`<details class="more">
    <summary>Numbers</summary>
    <p class="ends"><span class="number">${signed(map.min)}</span><span class="number">${signed(map.max)}</span></p>
    <p class="quiet">How likely, as a logarithm: 0.69 more is twice as likely.</p>
  </details>`;
}

function probe({ probe }: State): TemplateResult | typeof nothing {
  if (probe === null) return nothing;
  const { likelihood } = probe;
  const words = likelihood === null ? "it cannot stand here" : likelihoodInWords(likelihood);
  const share = likelihood === null ? nothing : ` (${Math.round(likelihood * 100)} of 100)`;
  return html`<p class="probe">Under the pointer: <b>${words}</b>${share}</p>`;
}

/** One switch for each kind of relation in the graph, with a piece of its line. */
function relations({ state, dispatch }: Page): TemplateResult | typeof nothing {
  if (!state.shown.graph) return nothing;
  const kinds = [...new Set(state.graph?.edges.map(({ relation }) => relation) ?? [])];
  if (kinds.length === 0) {
    return html`<p class="quiet">Relations appear when there are two things in the room.</p>`;
  }
  return html`<div class="relations" role="group" aria-label="Relations shown">
    ${kinds.map(
      (relation) => html`<label class="check"
        ><input
          type="checkbox"
          .checked=${!state.shown.hiddenRelations.includes(relation)}
          @change=${() => dispatch({ type: "toggle-relation", relation })}
        />${line(relation)}<span>${relationInWords(relation)}</span></label
      >`,
    )}
  </div>`;
}

/** A piece of the line that stands for the relation. */
function line(relation: string): TemplateResult {
  const { color, dash } = relationLook(relation);
  const pattern = dash === undefined ? nothing : dash.map((length) => length * PIXELS).join(" ");
  return html`<svg class="line" viewBox="0 0 32 8" aria-hidden="true">
    <path d="M1 4h30" stroke=${color} stroke-dasharray=${pattern} />
  </svg>`;
}
