/** The bottom sheet of the phone: three heights, by dragging, by a button, by keys. */
import { html, type TemplateResult } from "lit";
import type { Page, SheetHeight } from "./page";

const HEIGHTS: readonly SheetHeight[] = ["peek", "half", "full"];

/** Pixels that a drag must go before it means another height. */
const DRAG = 40;

/** The next height up (1) or down (−1); it stays at the ends. */
export function stepped(height: SheetHeight, by: number): SheetHeight {
  const index = HEIGHTS.indexOf(height) + by;
  return HEIGHTS[Math.min(HEIGHTS.length - 1, Math.max(0, index))] as SheetHeight;
}

/** A click goes up, and from the top back to the bottom. */
export function cycled(height: SheetHeight): SheetHeight {
  return height === "full" ? "peek" : stepped(height, 1);
}

export function sheetHandle({ local, change }: Page): TemplateResult {
  const keys = (event: KeyboardEvent): void => {
    const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    change({ sheet: stepped(local.sheet, by) });
  };
  const down = (event: PointerEvent): void => {
    const handle = event.currentTarget as HTMLElement;
    handle.setPointerCapture(event.pointerId);
    handle.addEventListener("pointerup", (up) => change({ sheet: after(local.sheet, up, event) }), {
      once: true,
    });
  };
  // A click with the pointer has been dealt with; one without comes from Enter or Space.
  const click = (event: MouseEvent): void => {
    if (event.detail === 0) change({ sheet: cycled(local.sheet) });
  };
  return html`<button
    type="button"
    class="handle"
    aria-label=${local.sheet === "full" ? "Make the panel small" : "Make the panel taller"}
    aria-expanded=${local.sheet !== "peek"}
    @click=${click}
    @keydown=${keys}
    @pointerdown=${down}
  >
    <span aria-hidden="true"></span>
  </button>`;
}

/** The height after the finger went up: a tap cycles, a drag steps, a long one goes to the end. */
function after(height: SheetHeight, up: PointerEvent, down: PointerEvent): SheetHeight {
  const way = down.clientY - up.clientY;
  if (Math.abs(way) < DRAG) return cycled(height);
  return stepped(height, Math.sign(way) * (Math.abs(way) > window.innerHeight / 3 ? 2 : 1));
}
