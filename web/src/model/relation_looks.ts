/** How the lines of each relation look: by color and by dashes, so that color is not the only sign. */

export interface RelationLook {
  readonly color: string;
  readonly dash?: readonly [line: number, gap: number];
}

const LOOKS: Readonly<Record<string, RelationLook>> = {
  BelongsTo: { color: "#8a8a8a", dash: [0.03, 0.05] },
  RoomPosition: { color: "#56b4e9", dash: [0.16, 0.08] },
  AverageDistance: { color: "#0072b2" },
  SurroundedBy: { color: "#009e73" },
  Support: { color: "#7a4fa3", dash: [0.06, 0.04] },
  TowardsCenter: { color: "#b8a600", dash: [0.16, 0.08] },
  AwayFromWall: { color: "#cc79a7", dash: [0.16, 0.08] },
  DirectionSimilarity: { color: "#e69f00", dash: [0.06, 0.04] },
  Facing: { color: "#d55e00" },
  NextTo: { color: "#3c3c3c", dash: [0.1, 0.05] },
};
const UNKNOWN: RelationLook = { color: "#2f6fed" };

export function relationLook(relation: string): RelationLook {
  return LOOKS[relation] ?? UNKNOWN;
}
