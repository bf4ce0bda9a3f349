/** What a press on the picture is about. Core frame. */
import type { State } from "../model/state";
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

/** The handle nearest to the finger; on the body of a thing only a handle that is hit counts. */
export function spotAt(state: State, pad: Pad, event: Finger): Spot | null {
  let best: Spot | null = null;
  const onBody = isChosen(state, targetAt(state, rayOf(pad, event)));
  let least = onBody || event.pointerType === "mouse" ? MOUSE : TOUCH;
  for (const spot of spotsOf(state)) {
    const place = pad.place(spot.at);
    const gap = place
      ? Math.hypot(place[0] - event.clientX, place[1] - event.clientY)
      : Number.POSITIVE_INFINITY;
    if (gap < least) {
      best = spot;
      least = gap;
    }
  }
  return best;
}
