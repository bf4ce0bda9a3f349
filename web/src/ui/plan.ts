/** A small plan of a scene, as it would be drawn on paper. */
import { html, svg, type TemplateResult } from "lit";
import { footprint } from "../model/footprints";
import type { Point } from "../model/state";
import type { SceneRecord } from "../net/protocol.gen";

const MARGIN = 0.25; // metres round the outline

/** The outline, the openings and the boxes from above; north is up. */
export function plan(scene: SceneRecord): TemplateResult {
  const { corners, doors, windows } = scene.room;
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const [left, bottom] = [Math.min(...xs) - MARGIN, Math.min(...ys) - MARGIN];
  const [right, top] = [Math.max(...xs) + MARGIN, Math.max(...ys) + MARGIN];
  return html`<svg
    class="plan"
    viewBox="${left} ${-top} ${right - left} ${top - bottom}"
    aria-hidden="true"
  >
    <path class="floor" d=${path(corners)} />
    ${scene.boxes.map(
      (box) => svg`<path class="piece" data-category=${box.category} d=${path(footprint(box))} />`,
    )}
    ${doors.map(({ start, end }) => svg`<path class="door" d=${path([start, end])} />`)}
    ${windows.map(({ start, end }) => svg`<path class="window" d=${path([start, end])} />`)}
  </svg>`;
}

/** The points joined and closed; y up becomes y down. */
function path(points: readonly Point[]): string {
  return `M${points.map(([x, y]) => `${x.toFixed(2)} ${(-y).toFixed(2)}`).join("L")}Z`;
}
