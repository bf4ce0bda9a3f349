/** The tools and the cameras: a column on a desk, a row at the thumb on a phone. */
import { html, type TemplateResult } from "lit";
import type { CameraMode, Tool } from "../model/state";
import { arButton, arControls } from "./ar";
import { toolButton } from "./controls";
import { history } from "./header";
import { icon } from "./icons";
import type { Page } from "./page";

const TOOLS: readonly { tool: Tool; label: string; keys: string }[] = [
  { tool: "select", label: "Select", keys: "S" },
  { tool: "room", label: "Room", keys: "R" },
  { tool: "box", label: "Box", keys: "B" },
  { tool: "door", label: "Door", keys: "D" },
  { tool: "window", label: "Window", keys: "W" },
];

const CAMERAS: readonly { camera: CameraMode; label: string }[] = [
  { camera: "orbit", label: "Around" },
  { camera: "top", label: "Above" },
  { camera: "walk", label: "Walk" },
];

export function tools(page: Page): TemplateResult {
  const { state, dispatch } = page;
  return html`<nav class="tools" aria-label="Tools">
    <div class="tool-group" role="group" aria-label="Draw">
      ${TOOLS.map(({ tool, label, keys }) =>
        toolButton({
          icon: tool,
          label,
          keys,
          pressed: state.tool === tool,
          run: () => dispatch({ type: "choose-tool", tool }),
        }),
      )}
    </div>
    <div class="phone-only tool-group">
      ${history(page, toolButton)}
      <button type="button" class="tool" popovertarget="export-menu">${icon("more")}<span>More</span></button>
    </div>
  </nav>`;
}

export function cameras(page: Page): TemplateResult {
  const { state, dispatch } = page;
  if (state.ar !== null) return arControls(page, state.ar);
  return html`<div class="cameras" role="group" aria-label="How to look">
    ${CAMERAS.map(({ camera, label }) =>
      toolButton({
        icon: camera,
        label,
        keys: "C",
        pressed: state.shown.camera === camera,
        run: () => dispatch({ type: "set-camera", camera }),
      }),
    )}
    ${arButton(page)}
  </div>`;
}
