/** What is selected, and its numbers to type. */
import { html, nothing, type TemplateResult } from "lit";
import { likelyCategories } from "../model/labels";
import { LENGTHS, SIDES, sized } from "../model/sizes";
import type { Point } from "../model/state";
import { formatAngle } from "../model/units";
import type { BoxRecord } from "../net/protocol.gen";
import { chips } from "./categories";
import { button, deleteButton, lengthField, section } from "./controls";
import { cornerPanel, openingPanel } from "./outline";
import type { Page } from "./page";
import { seeInRoom } from "./quick_look";

const STEP = 0.05; // metres
const TURN = Math.PI / 12; // 15°
const HEIGHTS = { min: 0, max: 10 }; // metres

export function selectionPanel(page: Page): TemplateResult | typeof nothing {
  const { scene, selection } = page.state;
  switch (selection?.kind) {
    case "box": {
      const box = scene.boxes.find(({ id }) => id === selection.id);
      return box === undefined ? nothing : boxPanel(page, box);
    }
    case "door":
    case "window": {
      const openings = selection.kind === "door" ? scene.room.doors : scene.room.windows;
      const opening = openings.find(({ id }) => id === selection.id);
      return opening === undefined ? nothing : openingPanel(page, selection.kind, opening);
    }
    case "corner":
      return cornerPanel(page, selection.index);
    case undefined:
      return nothing;
  }
}

function boxPanel(page: Page, box: BoxRecord): TemplateResult {
  const { state, dispatch } = page;
  const edit = (change: Partial<BoxRecord>): void =>
    dispatch({ type: "edit-box", box: { ...box, ...change }, done: true });
  return section(
    box.label || box.category,
    html`
      ${box.placed === true ? nothing : whatIsIt(page, box, edit)}
      ${sizeFields(box, edit)} ${positionFields(box, bounds(state.scene.room.corners), edit)}
      ${boxCommands(page, box)}
    `,
    "selection",
  );
}

/** The likely ones first, by size; what was placed is known. */
function whatIsIt(
  { state }: Page,
  box: BoxRecord,
  edit: (change: Partial<BoxRecord>) => void,
): TemplateResult {
  const names = likelyCategories(box.size, state.lists.categories);
  return html`<p class="question">What is it?</p>
    ${chips("What is it?", names, box.category, (category) => edit({ category }))}`;
}

function sizeFields(box: BoxRecord, edit: (change: Partial<BoxRecord>) => void): TemplateResult {
  return html`<div class="fields" role="group" aria-label="Size">
    ${SIDES.map((side) =>
      lengthField({
        id: `box-${LENGTHS[side].toLowerCase()}`,
        label: LENGTHS[side],
        unit: "cm",
        value: box.size[side],
        step: STEP,
        change: (length) => edit(sized(box, side, length)),
      }),
    )}
  </div>`;
}

function positionFields(
  box: BoxRecord,
  [corner, opposite]: readonly [Point, Point],
  edit: (change: Partial<BoxRecord>) => void,
): TemplateResult {
  const [x, y, z] = box.center;
  const bottom = z - box.size[2] / 2;
  return html`<div class="fields" role="group" aria-label="Where its middle is">
    ${lengthField({
      id: "box-west",
      label: "From west",
      unit: "m",
      value: x - corner[0],
      limits: { min: 0, max: opposite[0] - corner[0] },
      step: STEP,
      change: (length) => edit({ center: [corner[0] + length, y, z] }),
    })}
    ${lengthField({
      id: "box-south",
      label: "From south",
      unit: "m",
      value: y - corner[1],
      limits: { min: 0, max: opposite[1] - corner[1] },
      step: STEP,
      change: (length) => edit({ center: [x, corner[1] + length, z] }),
    })}
    ${lengthField({
      id: "box-bottom",
      label: "Off the floor",
      unit: "cm",
      value: bottom,
      limits: HEIGHTS,
      step: STEP,
      change: (length) => edit({ center: [x, y, length + box.size[2] / 2] }),
    })}
  </div>`;
}

function boxCommands(page: Page, box: BoxRecord): TemplateResult {
  const { dispatch } = page;
  const turn = (by: number) => (): void => dispatch({ type: "turn", by });
  return html`
    <div class="row" role="group" aria-label="Turn">
      ${button({ icon: "turn-left", label: "15°", keys: "[", run: turn(TURN) })}
      <output class="number" aria-label="Turned">${formatAngle(box.heading ?? 0)}</output>
      ${button({ icon: "turn-right", label: "15°", keys: "]", run: turn(-TURN) })}
    </div>
    <div class="row">
      ${button({ icon: "duplicate", label: "Duplicate", keys: "Ctrl D", run: () => dispatch({ type: "duplicate-selected" }) })}
      ${deleteButton({ dispatch })} ${page.local.placed === null ? seeInRoom(page, box) : nothing}
    </div>
  `;
}

/** The westernmost and southernmost, the easternmost and northernmost places of the room, metres. */
function bounds(corners: readonly Point[]): readonly [Point, Point] {
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  return [
    [Math.min(...xs), Math.min(...ys)],
    [Math.max(...xs), Math.max(...ys)],
  ];
}
