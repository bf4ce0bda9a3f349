/** What dragging a handle does. Pure; core frame, metres. */

import type { Action } from "../model/actions";
import { withoutLoaded } from "../model/carrying";
import { bottomOf, floorPoint, headingOf } from "../model/footprints";
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
import type { Point, State, Vector3 } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { HEIGHT_GAP, type Spot } from "./handle_spots";
import { heightOver, meetLevel, type Ray } from "./picking";

type BoxSpot = Spot & { readonly kind: "side" | "height" | "turn" };

const MIN_SIDE = 0.05; // metres
const QUARTER = Math.PI / 2;
const TURN_SNAP = Math.PI / 12; // 15°
const TURN_REACH = 0.07; // radians; nearer to a multiple of 15° than this, it is taken

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
    : resized(box, spot.side, snapPoint(withoutLoaded(state.scene, box), at, free));
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
