/** The icons: 24 px, one stroke width, round ends; drawn here, colored by the text around them. */
import { html, type SVGTemplateResult, svg, type TemplateResult } from "lit";

const PATHS = {
  // categories
  Bed: "M3 19v-7a2 2 0 0 1 2-2h14a2 2 0 0 1 2 2v7M3 16h18M5 10V6.5A1.5 1.5 0 0 1 6.5 5h11A1.5 1.5 0 0 1 19 6.5V10M8 10V8.5h8V10",
  Chair: "M7 3.5v10M7 4h8.5a1 1 0 0 1 1 1v8.5M7 9h9.5M6 13.5h11.5v2.5H6zM7 16v4.5M16.5 16v4.5",
  Decor:
    "M8 20.5h8l1-6H7zM12 14.5V8M12 11C8.5 11 6.5 9 6.5 5.5 10 5.5 12 7.5 12 11zM12 9c0-3 1.5-5 5-5 0 3.5-1.5 5-5 5z",
  Picture: "M4 4.5h16v15H4zM7 7.5h10v9H7zM8.5 16.5l3-4 2 2.5 1.5-1.5 2 3",
  Sofa: "M5 11V8a2.5 2.5 0 0 1 2.5-2.5h9A2.5 2.5 0 0 1 19 8v3M3 12.5a2 2 0 0 1 4 0V14h10v-1.5a2 2 0 0 1 4 0V18H3zM6 18v2M18 18v2M12 5.5V14",
  Storage: "M5 3.5h14v16H5zM5 9h14M5 14h14M11 6.300h2M11 11.5h2M11 16.700h2M7 19.5V21M17 19.5V21",
  Table: "M2.5 8.5h19M4 8.5v3h16v-3M5.5 11.5v8M18.5 11.5v8",
  TV: "M3 5h18v11.5H3zM12 16.5V20M8 20h8",
  Other: "M12 3l8 4.5v9L12 21l-8-4.5v-9zM4 7.5l8 4.5 8-4.5M12 12v9",
  // tools
  select: "M6 3.5l12.5 9.5-5.5 1 3 5.5-2.5 1.5-3-5.5L6.5 19z",
  room: "M4 4h16v16h-7M4 4v16h4M8 20a5 5 0 0 1 5-5v5",
  box: "M12 3l8 4.5v9L12 21l-8-4.5v-9zM4 7.5l8 4.5 8-4.5M12 12v9",
  door: "M6 21V3.5h12V21M3.5 21h17M14.5 12v.6",
  window: "M4.5 4h15v16h-15zM12 4v16M4.5 12h15",
  orbit:
    "M12 8.5l4 2.200v4.600l-4 2.2-4-2.200v-4.600zM4 15c-1-1-1.5-2-1.5-3C2.5 8.5 6.7 6 12 6s9.5 2.5 9.5 6c0 1.5-.8 2.8-2 3.800M19.8 12.600l-.3 3.3-3.3-.3",
  top: "M4 4h16v16H4zM4 10h6v4M14 20v-6h6",
  walk: "M13 3.5a1.5 1.5 0 1 1-.1 0zM9 21l2.5-6-2-3 1-4.5 3 .5 1.5 3 2.5 1M10.5 7.5L8 9.5v3M11.5 15l3 2 1 4",
  // commands
  undo: "M9 5L4.5 9.5 9 14M4.5 9.5H14a5 5 0 0 1 0 10h-3",
  redo: "M15 5l4.5 4.5L15 14M19.5 9.5H10a5 5 0 0 0 0 10h3",
  save: "M12 4v11M7.5 11l4.5 4.5 4.5-4.5M4.5 19.5h15",
  open: "M3.5 19V5.5h6l2 2.5h9V19zM3.5 12h17",
  new: "M12 5v14M5 12h14",
  export: "M12 15V4M7.5 8.5L12 4l4.5 4.5M5 12v8h14v-8",
  help: "M9 9a3 3 0 1 1 4.5 2.600c-1 .6-1.5 1.2-1.5 2.400M12 17.5v.3",
  more: "M5.5 12v.1M12 12v.1M18.5 12v.1",
  down: "M6 9.5l6 6 6-6",
  before: "M14.5 6l-6 6 6 6",
  next: "M9.5 6l6 6-6 6",
  close: "M6 6l12 12M18 6L6 18",
  check: "M5 12.5l4.5 4.5L19 7.5",
  remove: "M4.5 7h15M9.5 7V4.5h5V7M6.5 7l1 13h9l1-13M10.5 11v5M13.5 11v5",
  duplicate: "M8.5 8.5h11v11h-11zM15.5 8.5v-4h-11v11h4",
  "turn-left": "M5 4v5.5h5.5M5.5 9.5A7.5 7.5 0 1 1 5 14.5",
  "turn-right": "M19 4v5.5h-5.5M18.5 9.5A7.5 7.5 0 1 0 19 14.5",
  heat: "M12 21c4 0 6.5-2.6 6.5-6.200C18.5 10 13 9 13.5 3 9.5 5 8.5 8.5 9.5 11.5 8 11 7.5 10 7.5 9 6 10.5 5.5 12.5 5.5 14.8 5.5 18.4 8 21 12 21z",
  graph:
    "M6 9a2.5 2.5 0 1 0-.1 0zM18 8.5a2.5 2.5 0 1 0-.1 0zM12 20.5a2.5 2.5 0 1 0-.1 0zM8.5 6.5l7-.3M7.3 8.700l3.5 7M16.8 8.200l-3.5 7.5",
  labels: "M3.5 11.5v-7h7l10 10-7 7zM7.5 8.5v.1",
  hide: "M2.5 12S6 5.5 12 5.5 21.5 12 21.5 12 18 18.5 12 18.5 2.5 12 2.5 12zM12 9a3 3 0 1 0 .1 0z",
  corner: "M5 3.5V19h15.5M9 19v-4H5",
  phone: "M7 2.5h10v19H7zM11 18.5h2",
  hand: "M8 12V5.5a1.5 1.5 0 0 1 3 0V11 4.5a1.5 1.5 0 0 1 3 0V11 6a1.5 1.5 0 0 1 3 0v8.5c0 4-2.5 6.5-6 6.5-3 0-4.5-1.5-6-4.5L3.7 13.300a1.5 1.5 0 0 1 2.6-1.5L8 14",
  again: "M12 5v14M5 12h14",
  problem: "M12 3.5L21.5 20h-19zM12 10v4.5M12 17.300v.2",
  info: "M12 3a9 9 0 1 0 .1 0zM12 11v6M12 7.300v.2",
  offline:
    "M3 3l18 18M5 12.5c1.2-1.1 2.7-2 4.3-2.400M2 9c1.5-1.4 3.3-2.4 5.2-3M13.5 10c2 .4 4 1.3 5.5 2.600M12 5.5c3.7 0 7.3 1.2 10 3.5M8.5 16a5 5 0 0 1 7 0M12 19.5v.1",
} as const;

export type IconName = keyof typeof PATHS;

/** The icon of that name; it says nothing to a screen reader, the words beside it do. */
export function icon(name: IconName): TemplateResult {
  return html`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true">${stroke(PATHS[name])}</svg>`;
}

/** The icon of a category; a plain box for one that has none. */
export function categoryIcon(category: string): TemplateResult {
  return icon(category in PATHS ? (category as IconName) : "Other");
}

function stroke(path: string): SVGTemplateResult {
  return svg`<path d=${path} />`;
}
