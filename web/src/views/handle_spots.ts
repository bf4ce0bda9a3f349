/** Where the handles of what is selected are, and what dragging one does. Pure; core frame. */
import { bottomOf, floorPoint, headingOf, topOf } from "../model/footprints";
import {
  add,
  angleOf,
  direction,
  distance,
  dot,
  rounded,
  roundedPoint,
  scale,
  subtract,
  wrapped,
} from "../model/geometry";
import { GHOST, ghostBox } from "../model/ghost";
import { snapPoint } from "../model/snapping";
import type { Action, Draft, Point, State, Vector3 } from "../model/state";
import type { BoxRecord, OpeningRecord } from "../net/protocol.gen";
import { heightOver, meetLevel, type Ray } from "./picking";

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

type BoxSpot = Spot & { readonly kind: "side" | "height" | "turn" };

/** How far from the front of a box the handle that turns it is, metres. */
export const TURN_GAP = 0.32;
const HEIGHT_GAP = 0.28; // metres over the top; clear of the body, which is dragged itself
const MIN_SIDE = 0.05; // metres
const QUARTER = Math.PI / 2;
const TURN_SNAP = Math.PI / 12; // 15°
const TURN_REACH = 0.07; // radians; nearer to a multiple of 15° than this, it is taken

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
      return cornerSpots(state);
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

/** What dragging a handle along a ray does; null if the ray leads nowhere. */
export function dragSpot(
  state: State,
  spot: Spot,
  ray: Ray,
  free: boolean,
  done: boolean,
): Action | null {
  const { scene } = state;
  switch (spot.kind) {
    case "corner": {
      const at = meetLevel(ray, 0);
      return at && { type: "move-corner", index: spot.index, to: at, done };
    }
    case "end": {
      const openings = spot.opening === "door" ? scene.room.doors : scene.room.windows;
      const opening = openings.find(({ id }) => id === spot.id);
      const at = meetLevel(ray, spot.at[2]);
      return opening && at
        ? {
            type: "edit-opening",
            opening: spot.opening,
            value: { ...opening, [spot.end]: at },
            done,
          }
        : null;
    }
    case "turn":
      if (spot.box === GHOST) {
        return turnGhost(state, spot, ray, free, done);
      }
      return changeBox(state, spot, ray, free, done);
    case "side":
    case "height":
      return changeBox(state, spot, ray, free, done);
  }
}

function turnGhost(
  state: State,
  spot: Spot,
  ray: Ray,
  free: boolean,
  done: boolean,
): Action | null {
  const ghost = ghostBox(state);
  const at = meetLevel(ray, spot.at[2]);
  const box = ghost && at && turned(ghost, at, free);
  return box && { type: "drag-ghost", pose: { center: box.center, heading: headingOf(box) }, done };
}

function changeBox(
  state: State,
  spot: BoxSpot,
  ray: Ray,
  free: boolean,
  done: boolean,
): Action | null {
  const box = state.scene.boxes.find(({ id }) => id === spot.box);
  const changed = box && changedBox(state, box, spot, ray, free);
  return changed ? { type: "edit-box", box: changed, done } : null;
}

function changedBox(
  state: State,
  box: BoxRecord,
  spot: BoxSpot,
  ray: Ray,
  free: boolean,
): BoxRecord | null {
  if (spot.kind === "height") {
    return taller(box, heightOver(ray, floorPoint(box)), state.scene.room.height);
  }
  const at = meetLevel(ray, spot.at[2]);
  if (at === null) {
    return null;
  }
  return spot.kind === "turn"
    ? turned(box, at, free)
    : resized(box, spot.side, snapPoint(withoutBox(state, box), at, free));
}

function withoutBox(state: State, box: BoxRecord) {
  return { ...state.scene, boxes: state.scene.boxes.filter(({ id }) => id !== box.id) };
}

function taller(box: BoxRecord, top: number, ceiling: number): BoxRecord {
  const bottom = bottomOf(box);
  const room = Math.max(ceiling - bottom, MIN_SIDE);
  const height = rounded(Math.min(Math.max(top - HEIGHT_GAP - bottom, MIN_SIDE), room));
  return {
    ...box,
    size: [box.size[0], box.size[1], height],
    center: [box.center[0], box.center[1], bottom + height / 2],
  };
}

function turned(box: BoxRecord, at: Point, free: boolean): BoxRecord | null {
  if (distance(at, floorPoint(box)) < 0.05) {
    return null;
  }
  const angle = angleOf(subtract(at, floorPoint(box)));
  const stop = Math.round(angle / TURN_SNAP) * TURN_SNAP;
  return { ...box, heading: wrapped(!free && Math.abs(angle - stop) < TURN_REACH ? stop : angle) };
}

/** The side follows the point; the opposite side stays. */
function resized(box: BoxRecord, side: number, at: Point): BoxRecord {
  const axis = side % 2 === 0 ? 0 : 1;
  const outward = direction(headingOf(box) + side * QUARTER);
  const far = subtract(floorPoint(box), scale(outward, box.size[axis] / 2));
  const length = rounded(Math.max(MIN_SIDE, dot(subtract(at, far), outward)));
  const [x, y] = roundedPoint(add(far, scale(outward, length / 2)));
  const size: Vector3 =
    axis === 0 ? [length, box.size[1], box.size[2]] : [box.size[0], length, box.size[2]];
  return { ...box, size, center: [x, y, box.center[2]] };
}
