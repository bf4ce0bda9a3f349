/** The selected door, window or corner, and the walls, by their lengths. */
import { html, nothing, type TemplateResult } from "lit";
import { sideOf } from "../model/sides";
import { wallsOf, withWallLength } from "../model/walls";
import type { OpeningRecord } from "../net/protocol.gen";
import { deleteButton, lengthField, section } from "./controls";
import { spanOf, withSpan } from "./exact";
import type { Page } from "./page";
import { begun } from "./words";

const STEP = 0.05; // metres

export function openingPanel(
  page: Page,
  kind: "door" | "window",
  opening: OpeningRecord,
): TemplateResult {
  const { room } = page.state.scene;
  const { from, width } = spanOf(opening, room);
  const edit = (value: OpeningRecord): void =>
    page.dispatch({ type: "edit-opening", opening: kind, value, done: true });
  const heights = { min: 0, max: room.height };
  const field = (id: string, label: string, value: number, change: (metres: number) => void) =>
    lengthField({
      id: `${kind}-${id}`,
      label,
      unit: "cm",
      value,
      limits: heights,
      step: STEP,
      change,
    });
  return section(
    kind === "door" ? "Door" : "Window",
    html`
      <div class="fields" role="group" aria-label="Where it is in the wall">
        ${lengthField({
          id: `${kind}-from`,
          label: "From the corner",
          unit: "m",
          value: from,
          limits: { min: 0, max: 100 },
          step: STEP,
          change: (length) => edit(withSpan(opening, room, { from: length, width })),
        })}
        ${lengthField({
          id: `${kind}-width`,
          label: "Width",
          unit: "cm",
          value: width,
          step: STEP,
          change: (length) => edit(withSpan(opening, room, { from, width: length })),
        })}
      </div>
      <div class="fields" role="group" aria-label="Heights above the floor">
        ${field("bottom", "Begins at", opening.bottom, (bottom) => {
          if (bottom < opening.top) edit({ ...opening, bottom });
        })}
        ${field("top", "Ends at", opening.top, (top) => {
          if (top > opening.bottom) edit({ ...opening, top });
        })}
      </div>
      <div class="row">${deleteButton(page)}</div>
    `,
    "selection",
  );
}

export function cornerPanel(page: Page, index: number): TemplateResult {
  const { corners } = page.state.scene.room;
  const before = (index + corners.length - 1) % corners.length;
  return section(
    "Corner",
    html`
      <p class="quiet">How long its two walls are:</p>
      ${wallFields(page, [before, index])}
      <div class="row">${corners.length > 3 ? deleteButton(page) : nothing}</div>
    `,
    "selection",
  );
}

/** The lengths of walls, to be typed; the next wall moves along, so right angles stay right. */
export function wallFields(
  { state, dispatch }: Pick<Page, "state" | "dispatch">,
  indices: readonly number[],
): TemplateResult {
  const { room } = state.scene;
  const walls = wallsOf(room).filter(({ index }) => indices.includes(index));
  return html`<div class="fields pairs" role="group" aria-label="Lengths of the walls">
    ${walls.map((wall) =>
      lengthField({
        id: `wall-${wall.index}`,
        label: `${begun(sideOf(wall))} wall`,
        unit: "m",
        value: wall.length,
        step: STEP,
        change: (length) =>
          dispatch({
            type: "edit-room",
            room: withWallLength(room, wall.index, length),
            done: true,
          }),
      }),
    )}
  </div>`;
}
