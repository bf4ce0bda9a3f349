/** The rooms that speak loudest for a place, as little plans; a tap makes one large. */
import { html, nothing, type TemplateResult } from "lit";
import type { Page } from "./page";
import { inSentence } from "./words";

export function knownRooms(
  page: Page,
  category: string,
  names: readonly string[],
): TemplateResult | typeof nothing {
  if (names.length === 0) return nothing;
  const { plan } = page.local;
  const large = plan !== null && names.includes(plan) ? plan : null;
  return html`<div class="known">
    <h3>Rooms that speak for it</h3>
    <p class="quiet">
      <small>It has learned from them. The ${inSentence(category)} is blue; a bar marks its front.</small>
    </p>
    <div class="known-rooms" role="group" aria-label="Rooms that speak for it">
      ${names.map((name) => thumbnail(page, category, name, name === large))}
    </div>
    ${
      large === null
        ? nothing
        : html`<img class="plan-large" src=${planUrl(large, category)} alt=${planInWords(large, category)} />`
    }
  </div>`;
}

function thumbnail(
  { change }: Page,
  category: string,
  name: string,
  open: boolean,
): TemplateResult {
  return html`<button
    type="button"
    class="known-room"
    aria-expanded=${open}
    aria-label=${planInWords(name, category)}
    title=${name}
    @click=${() => change({ plan: open ? null : name })}
  >
    <img src=${planUrl(name, category)} alt="" loading="lazy" />
    <small>${name}</small>
  </button>`;
}

/** Where the plan of a known room is drawn; ids may hold slashes. */
export function planUrl(name: string, category: string): string {
  const path = name.split("/").map(encodeURIComponent).join("/");
  return `/knowledge/rooms/${path}.svg?category=${encodeURIComponent(category)}`;
}

function planInWords(name: string, category: string): string {
  return `Plan of ${name}, with its ${inSentence(category)}`;
}
