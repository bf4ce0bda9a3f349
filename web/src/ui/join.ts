/** "Open on your phone": the code to scan and the address, or why no phone gets here. */
import { html, type TemplateResult } from "lit";
import { iconButton } from "./controls";
import type { Page } from "./page";

/** Shows how to join, and asks the server for it. */
export function openJoin(page: Page): void {
  page.change({ joinDoor: true, join: "loading" });
  void load(page);
}

export function joinButton(page: Page): TemplateResult {
  return iconButton({ icon: "phone", label: "Open on your phone", run: () => openJoin(page) });
}

export function joinDialog(page: Page): TemplateResult {
  const close = (): void => page.change({ joinDoor: false });
  return html`<dialog class="help join" aria-labelledby="join-title" @close=${close}>
    <div class="title">
      <h2 id="join-title">Open on your phone</h2>
      ${iconButton({ icon: "close", label: "Close", run: close })}
    </div>
    <div class="words">${content(page)}</div>
  </dialog>`;
}

async function load({ services, change }: Page): Promise<void> {
  change({ join: (await services.fetchJoin()) ?? "out of reach" });
}

function content({ local }: Page): TemplateResult {
  const { join } = local;
  if (join === "loading") return html`<p class="quiet">One moment…</p>`;
  if (join === "out of reach") {
    return html`<p>That needs the server, and it can't be reached now. Try again when you are online.</p>`;
  }
  if (join.address === null) return html`<p>${join.text}</p>`;
  return html`<img class="code" src=${join.picture} alt="Code to scan" />
    <p>${join.text} Or open this address there:</p>
    <p><code class="address">${join.address}</code></p>
    <p class="quiet">
      The phone goes on with this room, and this page waits: reload it to take the room back. Whoever
      has the code gets in, so show it only to people you trust.
    </p>`;
}
