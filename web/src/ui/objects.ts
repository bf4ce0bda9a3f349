/** The objects of the room as a list for the keyboard and for screen readers. */
import { html, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { Page } from "./page";
import { boxInWords, sceneInWords } from "./whereabouts";

/** Each object takes the focus in turn; the focused one is selected, so that the arrows move it. */
export function objectList({ state, dispatch }: Page): TemplateResult {
  const { scene, selection } = state;
  const selected = selection?.kind === "box" ? selection.id : null;
  return html`<ul class="objects" role="listbox" aria-label="Things in the room: ${sceneInWords(scene)}">
    ${repeat(
      scene.boxes,
      ({ id }) => id,
      (box) => html`<li
        role="option"
        tabindex="0"
        aria-selected=${box.id === selected}
        @focus=${() => {
          if (box.id !== selected)
            dispatch({ type: "select", selection: { kind: "box", id: box.id } });
        }}
      >
        ${boxInWords(box, scene.room)}
      </li>`,
    )}
  </ul>`;
}
