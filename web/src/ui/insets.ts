/** Tells the stage which part of the window the panels leave free. */

export interface Insets {
  measure(): void;
  dispose(): void;
}

const SIDES = ["left", "right", "top", "bottom"] as const;
/** Below this width the panel is a sheet at the bottom; the style sheet has the same number. */
export const PHONE = "(max-width: 899px)";

/** Writes --inset-left, -right, -top and -bottom (pixels) on :root, and has the stage follow. */
export function createInsets(element: HTMLElement): Insets {
  const observer = new ResizeObserver(() => measure());
  let observed: Element | null = null;
  let last = "";
  function measure(): void {
    const panel = element.querySelector(".panel");
    if (panel !== null && panel !== observed) {
      observer.observe(panel);
      observed = panel;
    }
    const pixels = insetsOf(element);
    if (last === pixels.join()) return;
    last = pixels.join();
    SIDES.forEach((side, i) => {
      document.documentElement.style.setProperty(`--inset-${side}`, `${pixels[i]}px`);
    });
    window.dispatchEvent(new Event("resize"));
  }
  return { measure, dispose: () => observer.disconnect() };
}

/** Left, right, top, bottom in pixels. */
function insetsOf(element: HTMLElement): readonly number[] {
  const box = (name: string): DOMRect | undefined =>
    element.querySelector(name)?.getBoundingClientRect();
  const panel = box(".panel");
  const phone = window.matchMedia(PHONE).matches;
  if (phone)
    return [0, 0, 0, window.innerHeight - (panel?.top ?? window.innerHeight)].map(Math.round);
  const right = window.innerWidth - (panel?.left ?? window.innerWidth);
  return [box(".tools")?.right ?? 0, right, box(".bar")?.bottom ?? 0, 0].map(Math.round);
}
