import type { Insets } from "./framing";

/** What the panels cover, as they say on the root element. */
export function insetsOf(root: HTMLElement): Insets {
  const style = getComputedStyle(root);
  const pixels = (side: string) =>
    Number.parseFloat(style.getPropertyValue(`--inset-${side}`)) || 0;
  return {
    left: pixels("left"),
    right: pixels("right"),
    top: pixels("top"),
    bottom: pixels("bottom"),
  };
}
