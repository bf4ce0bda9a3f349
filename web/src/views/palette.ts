/** Colors that mean something, and those of the room by day and at dusk. */

/** The Okabe–Ito palette, which color-blind people can tell apart, by category. */
const CATEGORY_COLORS: Readonly<Record<string, string>> = {
  Bed: "#0072b2",
  Chair: "#e69f00",
  Decor: "#009e73",
  Picture: "#cc79a7",
  Sofa: "#d55e00",
  Storage: "#56b4e9",
  Table: "#f0e442",
  TV: "#3c3c3c",
};
const OTHER_COLOR = "#8a8a8a";

export function categoryColor(category: string): string {
  return CATEGORY_COLORS[category] ?? OTHER_COLOR;
}

export const ACCENT = "#2f6fed";
export const FORBIDDEN = "#d7263d";

/** How the room looks: by day, or at dusk when the person prefers dark. */
export interface Look {
  readonly background: string;
  readonly ground: string;
  readonly wall: string;
  readonly wallOutside: string;
  readonly wallCut: string;
  readonly trim: string;
  readonly door: string;
  readonly sky: string;
  readonly horizon: string;
  readonly hemisphere: readonly [sky: string, ground: string, intensity: number];
  readonly sun: readonly [color: string, intensity: number];
  readonly exposure: number;
  readonly floorTint: string;
  readonly label: string;
  readonly labelText: string;
  /** How much lighter the lines of relations are, 0 to 1, to be seen before the walls. */
  readonly lighterLines: number;
}

export const DAY: Look = {
  background: "#e9e3d9",
  ground: "#ddd5c8",
  wall: "#f8f5ef",
  wallOutside: "#e9e3d9",
  wallCut: "#bfb29e",
  trim: "#fdfbf7",
  door: "#c9a27a",
  sky: "#bfe0f7",
  horizon: "#f7fbff",
  hemisphere: ["#ffffff", "#faf5ee", 3.4],
  sun: ["#fff3df", 1.9],
  exposure: 1,
  floorTint: "#ffffff",
  label: "rgba(255, 255, 255, 0.94)",
  labelText: "#22201c",
  lighterLines: 0,
};

export const DUSK: Look = {
  background: "#1d2027",
  ground: "#191b21",
  wall: "#b9b0a6",
  wallOutside: "#5d5a5c",
  wallCut: "#8a827b",
  trim: "#cfc8bf",
  door: "#8f6d4e",
  sky: "#33456e",
  horizon: "#d98e63",
  hemisphere: ["#c9d0d8", "#b6b4a8", 2.6],
  sun: ["#ffc58a", 1.5],
  exposure: 0.95,
  floorTint: "#cdbfb2",
  label: "rgba(32, 35, 42, 0.92)",
  labelText: "#f2efe9",
  lighterLines: 0.5,
};
