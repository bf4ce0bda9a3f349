/** Where the handles of what is selected are. Pure; core frame, metres. */
import { bottomOf, floorPoint, headingOf, topOf } from "../model/footprints";
import { add, direction, scale } from "../model/geometry";
import { ghostBox } from "../model/ghost";
import type { Draft, State, Vector3 } from "../model/state";
import type { BoxRecord, OpeningRecord } from "../net/protocol.gen";

export type Spot =
  | { readonly kind: "side"; readonly box: string; readonly side: number; readonly at: Vector3 }
  | { readonly kind: "height"; readonly box: string; readonly at: Vector3 }
  | { readonly kind: "turn"; readonly box: string; readonly at: Vector3 }
  | { readonly kind: "corner"; readonly index: number; readonly at: Vector3 }
  | {
      readonly kind: "end";
      readonly opening: "door" | "window";
      readonly id: string;
      readonly end: "start" | "end";
      readonly at: Vector3;
    };

/** How far from the front of a box the handle that turns it is, metres. */
export const TURN_GAP = 0.32;
/** How far over the top the handle of the height is, metres: clear of the body, which is dragged. */
export const HEIGHT_GAP = 0.28;
const QUARTER = Math.PI / 2;

/** The handles to show. */
export function spotsOf(state: State): readonly Spot[] {
  const { selection, scene, tool, placing, draft } = state;
  if (placing !== null) {
    const ghost = ghostBox(state);
    return ghost && ghost.category !== "Picture" ? [turnSpot(ghost)] : [];
  }
  if (draft !== null && !isBlank(draft)) {
    return [];
  }
  switch (tool) {
    case "box":
      return [];
    case "room":
      return state.ar === null ? cornerSpots(state) : [];
    case "door":
    case "window": {
      const openings = tool === "door" ? scene.room.doors : scene.room.windows;
      return openings.flatMap((opening) => endSpots(tool, opening));
    }
    case "select":
      break;
  }
  switch (selection?.kind) {
    case undefined:
      return [];
    case "box": {
      const box = scene.boxes.find(({ id }) => id === selection.id);
      return box ? boxSpots(box) : [];
    }
    case "corner":
      return cornerSpots(state);
    case "door":
    case "window": {
      const openings = selection.kind === "door" ? scene.room.doors : scene.room.windows;
      const opening = openings.find(({ id }) => id === selection.id);
      return opening ? endSpots(selection.kind, opening) : [];
    }
  }
}

/** An outline that has no corner yet leaves the old ones to be dragged. */
function isBlank(draft: Draft): boolean {
  return draft.kind === "room" && draft.corners.length === 0;
}

function boxSpots(box: BoxRecord): readonly Spot[] {
  const low = bottomOf(box) + 0.02;
  const sides = [0, 1, 2, 3].map((side): Spot => {
    const reach = box.size[side % 2 === 0 ? 0 : 1] / 2;
    const [x, y] = add(floorPoint(box), scale(direction(headingOf(box) + side * QUARTER), reach));
    return { kind: "side", box: box.id, side, at: [x, y, low] };
  });
  const top = topOf(box) + HEIGHT_GAP;
  return [
    ...sides,
    { kind: "height", box: box.id, at: [box.center[0], box.center[1], top] },
    turnSpot(box),
  ];
}

function turnSpot(box: BoxRecord): Spot {
  const ahead = scale(direction(headingOf(box)), box.size[0] / 2 + TURN_GAP);
  const [x, y] = add(floorPoint(box), ahead);
  return { kind: "turn", box: box.id, at: [x, y, bottomOf(box) + 0.02] };
}

function cornerSpots(state: State): readonly Spot[] {
  return state.scene.room.corners.map(([x, y], index) => ({
    kind: "corner",
    index,
    at: [x, y, 0.05],
  }));
}

function endSpots(kind: "door" | "window", opening: OpeningRecord): readonly Spot[] {
  const height = Math.min(1, (opening.bottom + opening.top) / 2);
  return (["start", "end"] as const).map((end) => ({
    kind: "end",
    opening: kind,
    id: opening.id,
    end,
    at: [opening[end][0], opening[end][1], height],
  }));
}
