/** Things in the real room without a camera view of our own: models that the system can show. */
import { html, nothing, type TemplateResult } from "lit";
import type { BoxRecord } from "../net/protocol.gen";
import type { Page } from "./page";

/** One thing that was placed; nothing where the browser has no viewer for it. */
export function seeInRoom(
  { state, services }: Page,
  box: BoxRecord,
): TemplateResult | typeof nothing {
  const digest = state.models[box.id];
  if (!services.quickLook || !box.placed || digest === undefined) return nothing;
  return viewer(`/usdz/${digest}.usdz`, "See it in your room");
}

/** All that was placed: in the room, else as a file for a device that can show it. */
export function allPlaced({ state, services }: Page): TemplateResult | typeof nothing {
  const { session, status, unsent } = state.connection;
  const ready = status === "online" && unsent === 0 && session !== null;
  if (!ready || !state.scene.boxes.some(({ placed }) => placed)) return nothing;
  const model = `/usdz/sessions/${encodeURIComponent(session)}.usdz`;
  if (services.quickLook) return viewer(model, "See all you placed in your room");
  return html`<a class="button quiet" href=${model} download="placed.usdz">
    <img class="icon" src="/cube.svg" alt="" />What you placed, for iPhones (USDZ)
  </a>`;
}

/** Safari opens the viewer only for a link whose one child element is a picture. */
function viewer(model: string, words: string): TemplateResult {
  return html`<a class="button" rel="ar" href=${model}><img class="icon" src="/cube.svg" alt="" />${words}</a>`;
}
