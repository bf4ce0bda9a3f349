/** Choosing what to place, and where: category, item, size, mode, the places on offer. */
import { html, nothing, type TemplateResult } from "lit";
import { shownRefusal } from "../model/ghost";
import { usualSize } from "../model/labels";
import { LENGTHS, SIDES, type Side, withLength } from "../model/sizes";
import type { Mode, Placing, State, Vector3 } from "../model/state";
import { formatSize } from "../model/units";
import type { ModelName } from "../net/protocol.gen";
import { chips, placeable } from "./categories";
import { button, lengthField, section } from "./controls";
import { icon } from "./icons";
import { wayOut } from "./instead";
import type { Page } from "./page";
import { places } from "./places";
import { seeInRoom } from "./quick_look";
import { inSentence, isNow, oneOf } from "./words";

const SIZE_STEP = 0.05; // metres

export function placePanel(page: Page): TemplateResult {
  const { state } = page;
  const { placing } = state;
  const title = placing === null ? "Place something" : `Place ${oneOf(placing.category)}`;
  return section(
    title,
    html`
      ${placing === null ? after(page) : nothing}
      ${chips(
        "What to place",
        placeable(state.lists.categories),
        placing?.category ?? null,
        (name) => {
          if (name !== placing?.category) start(page, name, null, null);
        },
      )}
      ${modeSwitch(page)} ${modelSwitch(page)}
      ${placing === null ? nothing : html`${places(page, placing)} ${size(page, placing)} ${items(page, placing)}`}
    `,
    "place",
  );
}

/** Puts an object on its way into the room, where the view is looking. */
export function start(
  { local, services, dispatch, change }: Page,
  category: string,
  item: string | null,
  size: Vector3 | null,
  mode: Mode = local.mode,
): void {
  change({ placed: null, mode });
  dispatch({ type: "place", category, item, size, mode, view: services.viewPoint() });
}

function modeSwitch({ state, local, services, dispatch, change }: Page): TemplateResult {
  const now = state.placing?.mode ?? local.mode;
  const choose = (mode: Mode): void => {
    change({ mode });
    if (state.placing !== null) dispatch({ type: "set-mode", mode, view: services.viewPoint() });
  };
  const option = (mode: Mode, name: string, words: string): TemplateResult =>
    html`<label class="option"
      ><input
        type="radio"
        name="mode"
        .checked=${now === mode}
        @change=${() => choose(mode)}
      /><span><b>${name}</b><small>${words}</small></span></label
    >`;
  return html`<fieldset class="switch">
    <legend>Who finds the place?</legend>
    ${option("scenegen", "SceneGen", "finds the place")} ${option("manual", "Manual", "you find it")}
  </fieldset>`;
}

const MODELS: readonly (readonly [ModelName, string, string])[] = [
  ["scenegen", "SceneGen", "looks at walls, windows and neighbors"],
  ["paper", "The paper's model", "compares distances, as published"],
];

/** How SceneGen decides; nothing to choose by hand. */
function modelSwitch({ state, local, dispatch }: Page): TemplateResult | typeof nothing {
  if ((state.placing?.mode ?? local.mode) === "manual") return nothing;
  const now = MODELS.find(([model]) => model === state.model)?.[1];
  return html`<details class="more size">
    <summary><span>How it decides</span><span class="quiet">${now}</span></summary>
    <div class="switch" role="radiogroup" aria-label="How it decides">
      ${MODELS.map(
        ([model, name, words]) =>
          html`<label class="option"
            ><input
              type="radio"
              name="model"
              .checked=${state.model === model}
              @change=${() => dispatch({ type: "choose-model", model })}
            /><span><b>${name}</b><small>${words}</small></span></label
          >`,
      )}
    </div>
  </details>`;
}

/** What can be done right after something was placed. */
function after(page: Page): TemplateResult | typeof nothing {
  const { placed } = page.local;
  if (placed === null) return nothing;
  const { scene, selection } = page.state;
  const box = scene.boxes.find(({ id }) => selection?.kind === "box" && id === selection.id);
  return html`<div class="placed">
    <p>${isNow(placed.category, placed.sentence)}</p>
    <div class="row">
      ${button(
        {
          icon: "again",
          label: "Place another",
          run: () => start(page, placed.category, placed.item, placed.size, placed.mode),
        },
        "primary",
      )}
      ${button({
        icon: "undo",
        label: "Undo",
        keys: "Ctrl Z",
        run: () => {
          page.change({ placed: null });
          page.dispatch({ type: "undo" });
        },
      })}
      ${box === undefined ? nothing : seeInRoom(page, box)}
    </div>
  </div>`;
}

function items(page: Page, placing: Placing): TemplateResult | typeof nothing {
  const offered = page.state.lists.catalogue.filter((item) => item.category === placing.category);
  if (offered.length === 0) return nothing;
  const pick = (id: string | null): void => start(page, placing.category, id, null, placing.mode);
  const choice = (id: string | null, name: string, size: Vector3 | null): TemplateResult =>
    html`<button
      type="button"
      class="item"
      aria-pressed=${placing.item === id}
      @click=${() => pick(id)}
    >
      <b>${name}</b><small>${size === null ? "simple shape" : formatSize(size)}</small>
    </button>`;
  return html`<div class="items" role="group" aria-label="Which one">
    ${choice(null, `Any ${inSentence(placing.category)}`, null)}
    ${offered.map((item) => choice(item.id, item.name, item.size))}
  </div>`;
}

function size({ state, dispatch }: Page, placing: Placing): TemplateResult {
  const change = (side: Side, length: number): void =>
    dispatch({ type: "set-size", size: withLength(placing.size, side, length) });
  const usual = usualSize(placing.category, state.lists.categories);
  const isUsual = placing.size.every((length, i) => Math.abs(length - (usual[i] ?? 0)) < 0.005);
  return html`<details class="more size">
    <summary><span>Size</span><span class="quiet">${formatSize(placing.size)}</span></summary>
    <div class="fields" role="group" aria-label="Size">
      ${SIDES.map((side) =>
        lengthField({
          id: `place-${LENGTHS[side].toLowerCase()}`,
          label: LENGTHS[side],
          unit: "cm",
          value: placing.size[side],
          step: SIZE_STEP,
          change: (length) => change(side, length),
        }),
      )}
    </div>
    ${
      placing.wishedSize === null || isUsual
        ? nothing
        : html`<button type="button" class="link" @click=${() => dispatch({ type: "set-size", size: null })}>
            Use the usual size
          </button>`
    }
  </details>`;
}

/** The end of placing, always in reach below the panel. */
export function decision(page: Page): TemplateResult | typeof nothing {
  const { state, local, dispatch } = page;
  const { placing } = state;
  // In the first minute the card asks; two ways to say the same would be one too many.
  if (placing === null || local.guide === "placing") return nothing;
  const refusal = shownRefusal(state);
  return html`<div class="decision">
    ${refusal === null ? nothing : html`<p class="blocked">${icon("problem")} ${refusal}</p>${wayOut(page)}`}
    <div class="row">
      ${button(
        {
          icon: "check",
          label: placing.confirming ? "Placing…" : "Place it",
          keys: "Enter",
          disabled: placing.pose === null || placing.confirming || refusal !== null,
          run: () => dispatch({ type: "confirm" }),
        },
        "primary",
      )}
      ${pickUpButton(state, dispatch)}
      ${button({ icon: "close", label: "Cancel", keys: "Esc", run: () => dispatch({ type: "cancel" }) })}
    </div>
  </div>`;
}

/** What is placed by hand in the camera view goes with the phone again. */
function pickUpButton({ ar, placing }: State, dispatch: Page["dispatch"]) {
  if (ar === null || ar.carrying || placing?.mode !== "manual") return nothing;
  const run = (): void => dispatch({ type: "change-ar", change: { carrying: true } });
  return button({ icon: "hand", label: "Pick up", keys: "P", run });
}
