/** What a press on the picture is about. Core frame. */
import type { State, Vector3 } from "../model/state";
import { gripOf, isChosen } from "./chosen";
import type { Grip } from "./dragging";
import { type Spot, spotsOf } from "./handle_spots";
import { type Pad, rayOf } from "./pad";
import { meetFloor, type Ray } from "./picking";
import { targetAt } from "./targets";

export type Gesture =
  | { readonly kind: "draw" }
  | { readonly kind: "height" }
  | { readonly kind: "spot"; readonly spot: Spot }
  | { readonly kind: "grip"; readonly grip: Grip }
  | { readonly kind: "look" };

/** Where on the window something points, and with what. */
export type Finger = Pick<PointerEvent, "clientX" | "clientY" | "pointerType">;

const TOUCH = 24; // CSS pixels round a handle: 48 across, more than the 44 that fingers need
const MOUSE = 13;

/** What begins where the pointer goes down. */
export function gestureAt(state: State, pad: Pad, event: Finger, ray: Ray): Gesture {
  if (state.draft?.kind === "box-height") {
    return { kind: "height" };
  }
  const spot = spotAt(state, pad, event);
  if (spot) {
    return { kind: "spot", spot };
  }
  if (state.tool !== "select") {
    const outline = state.tool !== "box";
    const inside = meetFloor(ray, state.scene.room) !== null;
    return { kind: outline || inside ? "draw" : "look" };
  }
  const grip = gripOf(state, targetAt(state, ray), ray);
  return grip ? { kind: "grip", grip } : { kind: "look" };
}

/**
 * The handle nearest to the finger; on the body of a thing only a handle that is hit counts, and
 * not where its middle is nearer: what is small on the screen can be dragged too.
 */
export function spotAt(state: State, pad: Pad, event: Finger): Spot | null {
  let best: Spot | null = null;
  const target = targetAt(state, rayOf(pad, event));
  const onBody = isChosen(state, target);
  const middle = onBody && target !== null && "box" in target ? target.box.center : null;
  const reach = onBody || event.pointerType === "mouse" ? MOUSE : TOUCH;
  let least = Math.min(reach, away(pad, event, middle));
  for (const spot of spotsOf(state)) {
    const gap = away(pad, event, spot.at);
    if (gap < least) {
      best = spot;
      least = gap;
    }
  }
  return best;
}

/** CSS pixels from the finger to a place; infinite if it is nowhere to be seen. */
function away(pad: Pad, { clientX, clientY }: Finger, at: Vector3 | null): number {
  const place = at && pad.place(at);
  return place ? Math.hypot(place[0] - clientX, place[1] - clientY) : Number.POSITIVE_INFINITY;
}
