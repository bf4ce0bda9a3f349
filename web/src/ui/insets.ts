/** Tells the stage which part of the window the panels leave free. */

export interface Insets {
  /** Called after each drawing: what is new is watched from then on. */
  watch(): void;
  dispose(): void;
}

const SIDES = ["left", "right", "top", "bottom"] as const;
const WATCHED = ".panel, .card, .cameras";
/** Below this width the panel is a sheet at the bottom; the style sheet has the same number. */
const PHONE = "(max-width: 899px)";

/** Writes --inset-left, -right, -top and -bottom (pixels) on :root, and has the stage follow. */
export function createInsets(element: HTMLElement): Insets {
  const watched = new WeakSet<Element>();
  let last = "";
  const measure = (): void => {
    const pixels = insetsOf(element);
    if (last === pixels.join()) return;
    last = pixels.join();
    SIDES.forEach((side, i) => {
      document.documentElement.style.setProperty(`--inset-${side}`, `${pixels[i]}px`);
    });
    window.dispatchEvent(new Event("resize"));
  };
  const observer = new ResizeObserver(measure);
  return {
    watch() {
      for (const part of element.querySelectorAll(WATCHED)) {
        if (watched.has(part)) continue;
        watched.add(part);
        observer.observe(part);
      }
    },
    dispose: () => observer.disconnect(),
  };
}

/** Left, right, top, bottom in pixels; a card over the room counts as a part of the bottom. */
function insetsOf(element: HTMLElement): readonly number[] {
  const box = (name: string): DOMRect | undefined =>
    element.querySelector(name)?.getBoundingClientRect();
  const [panel, card] = [box(".panel"), box(".card")];
  const phone = window.matchMedia(PHONE).matches;
  const floor = box(".cameras")?.top || panel?.top || window.innerHeight;
  const bottom = window.innerHeight - Math.min(floor, card?.top ?? floor);
  const top = box(".bar")?.bottom ?? 0;
  if (phone) return [0, 0, top, bottom].map(Math.round);
  const right = window.innerWidth - (panel?.left ?? window.innerWidth);
  return [box(".tools")?.right ?? 0, right, top, bottom].map(Math.round);
}
