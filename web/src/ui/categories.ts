/** Chips to pick a category: its icon, its name, its color. */
import { html, type TemplateResult } from "lit";
import type { CategoryInfo } from "../net/protocol.gen";
import { categoryIcon } from "./icons";

/** The categories of the paper, until the server has named those that it knows. */
const BEFORE_THE_SERVER = ["Bed", "Chair", "Decor", "Picture", "Sofa", "Storage", "Table", "TV"];

/** The names of what can be placed. */
export function placeable(known: readonly CategoryInfo[]): readonly string[] {
  if (known.length === 0) return BEFORE_THE_SERVER;
  return known.filter((category) => category.placeable).map((category) => category.name);
}

/** A row of chips; the picked one is pressed. */
export function chips(
  label: string,
  names: readonly string[],
  picked: string | null,
  pick: (name: string) => void,
): TemplateResult {
  return html`<div class="chips" role="group" aria-label=${label}>
    ${names.map(
      (name) =>
        html`<button
          type="button"
          class="chip"
          data-category=${name}
          aria-pressed=${name === picked}
          @click=${() => pick(name)}
        >
          ${categoryIcon(name)}<span>${name}</span>
        </button>`,
    )}
  </div>`;
}
