import { floorPoint } from "../model/footprints";
import { distance, type Segment } from "../model/geometry";
import type { Action, Point, State, Vector3 } from "../model/state";
import { cursorOf, gripOf, isChosen, selectionOf } from "./chosen";
import { drag, type Grip, handOnWalls } from "./dragging";
import { dragSpot } from "./handle_drag";
import { type Spot, spotsOf } from "./handle_spots";
import { middleOf } from "./outline";
import { heightOver, meetFloor, meetLevel, type Ray } from "./picking";
import { probeAt, targetAt } from "./targets";

/** What the pointer needs of the picture: rays into it, places on it, and signs of its own. */
export interface Pad {
  readonly element: HTMLElement;
  /** The ray through a point of the window, core frame. */
  ray(x: number, y: number): Ray;
  /** Where on the window a place is; null behind the eye. */
  place(at: Vector3): Point | null;
  /** Keeps the camera still. */
  hold(held: boolean): void;
  /** Which box is pointed at. */
  hover(id: string | null): void;
  /** What the thing that is dragged has snapped to. */
  guide(guides: readonly Segment[]): void;
}

type Gesture =
  | { readonly kind: "draw" }
  | { readonly kind: "height" }
  | { readonly kind: "spot"; readonly spot: Spot }
  | { readonly kind: "grip"; readonly grip: Grip }
  | { readonly kind: "look" };

interface Press {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly gesture: Gesture;
  readonly down: PointerEvent;
  moved: boolean;
  /** The last action of a drag, to be sent once more as the final one. */
  last: Action | null;
}

const TOUCH = 24; // CSS pixels round a handle: 48 across, more than the 44 that fingers need
const MOUSE = 13;
const SLOP = 5; // CSS pixels that a tap may slip
const REACH = 40; // metres from the room within which one can draw
const STEEP = 0.96; // looking down like this, heights cannot be seen

/** Turns what mouse, pen and fingers do into actions. */
export class Pointer {
  readonly #pad: Pad;
  readonly #dispatch: (action: Action) => void;
  readonly #listening = new AbortController();
  #state: State | null = null;
  #press: Press | null = null;
  /** What to add to the height under the pointer while a box is pulled up. */
  #pull: number | null = null;
  /** The press that the camera was given after all. */
  #handedOver: PointerEvent | null = null;

  constructor(pad: Pad, dispatch: (action: Action) => void) {
    this.#pad = pad;
    this.#dispatch = dispatch;
    const { element } = pad;
    const options = { signal: this.#listening.signal, capture: true };
    element.addEventListener("pointerdown", (event) => this.#down(event), options);
    element.addEventListener("pointermove", (event) => this.#move(event), options);
    element.addEventListener("pointerup", (event) => this.#up(event), options);
    element.addEventListener("pointercancel", (event) => this.#up(event), options);
    element.addEventListener("pointerleave", (event) => this.#leave(event), options);
    element.addEventListener("contextmenu", (event) => event.preventDefault(), options);
    addEventListener("keydown", (event) => this.#key(event), options);
  }

  show(state: State): void {
    this.#state = state;
    if (state.draft?.kind !== "box-height") {
      this.#pull = null;
    }
  }

  dispose(): void {
    this.#listening.abort();
  }

  #down(event: PointerEvent): void {
    const state = this.#state;
    if (!state) {
      return;
    }
    if (state.welcome) {
      this.#dispatch({ type: "touched" });
    }
    if (this.#press) {
      this.#secondFinger(state, this.#press);
      return;
    }
    if (!event.isPrimary || event.button !== 0 || event === this.#handedOver) {
      return;
    }
    const ray = this.#ray(event);
    const gesture = this.#gesture(state, event, ray);
    const { pointerId: id, clientX: x, clientY: y } = event;
    this.#press = { id, x, y, gesture, down: event, moved: false, last: null };
    if (gesture.kind === "look") {
      return;
    }
    this.#pad.hold(true);
    this.#pad.element.setPointerCapture(id);
    this.#pad.element.focus({ preventScroll: true });
    event.preventDefault();
    if (gesture.kind === "draw") {
      this.#draw("draw-down", state, event, ray);
    }
  }

  /** Two fingers move the camera: what one of them began to draw is dropped. */
  #secondFinger(state: State, { gesture, down }: Press): void {
    if (gesture.kind === "look") {
      this.#press = null;
    }
    if (gesture.kind !== "draw") {
      return;
    }
    this.#end();
    if (state.draft?.kind === "box-floor") {
      this.#dispatch({ type: "draw-up", at: state.draft.start, free: true });
    }
    // The camera has not seen the first finger; it needs both.
    this.#handedOver = new PointerEvent(down.type, down);
    this.#pad.element.dispatchEvent(this.#handedOver);
  }

  #gesture(state: State, event: PointerEvent, ray: Ray): Gesture {
    if (state.draft?.kind === "box-height") {
      this.#pull = null;
      return { kind: "height" };
    }
    const spot = this.#spotAt(state, event);
    if (spot) {
      return { kind: "spot", spot };
    }
    if (state.tool !== "select") {
      const outline = state.tool === "room" || state.tool === "door" || state.tool === "window";
      const inside = meetFloor(ray, state.scene.room) !== null;
      return { kind: outline || inside ? "draw" : "look" };
    }
    const grip = gripOf(state, targetAt(state, ray), ray);
    return grip ? { kind: "grip", grip } : { kind: "look" };
  }

  #move(event: PointerEvent): void {
    const state = this.#state;
    const press = this.#press;
    if (!state) {
      return;
    }
    if (!press) {
      if (event.pointerType !== "touch") {
        this.#hover(state, event);
      }
      return;
    }
    if (press.id !== event.pointerId) {
      return;
    }
    const slipped = Math.hypot(event.clientX - press.x, event.clientY - press.y);
    press.moved ||= slipped > SLOP;
    if (press.moved || press.gesture.kind === "draw") {
      this.#drag(state, press, event);
    }
  }

  #drag(state: State, press: Press, event: PointerEvent): void {
    const ray = this.#ray(event);
    const { gesture } = press;
    switch (gesture.kind) {
      case "look":
        return;
      case "draw":
        this.#draw("draw-move", state, event, ray);
        return;
      case "height":
        this.#raise(state, ray);
        return;
      case "spot":
        press.last = dragSpot(state, gesture.spot, ray, event.altKey, false) ?? press.last;
        break;
      case "grip": {
        const dragged = drag(state, gesture.grip, ray, event.altKey, false);
        press.last = dragged?.action ?? press.last;
        this.#pad.guide(dragged?.guides ?? []);
      }
    }
    if (press.last) {
      this.#dispatch(press.last);
    }
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    const state = this.#state;
    if (!state || press?.id !== event.pointerId) {
      return;
    }
    this.#end();
    const { gesture, last, moved } = press;
    if (gesture.kind === "draw") {
      this.#draw("draw-up", state, event, this.#ray(event));
    } else if (gesture.kind === "height") {
      this.#finishHeight(state);
    } else if (last && "done" in last) {
      this.#dispatch({ ...last, done: true });
      this.#selectCorner(gesture);
    } else if (!moved && event.type === "pointerup") {
      this.#tap(state, gesture, this.#ray(event));
    }
  }

  #end(): void {
    this.#press = null;
    this.#pad.hold(false);
    this.#pad.guide([]);
  }

  #tap(state: State, gesture: Gesture, ray: Ray): void {
    if (gesture.kind === "spot") {
      this.#tapSpot(state, gesture.spot);
      return;
    }
    const target = targetAt(state, ray);
    if (target?.kind === "ghost") {
      return;
    }
    if (target?.kind === "alternative") {
      this.#dispatch({ type: "show-alternative", rank: target.rank });
      return;
    }
    if (state.placing) {
      this.#dispatch({ type: "probe", probe: probeAt(state, ray) });
      return;
    }
    this.#dispatch({ type: "select", selection: selectionOf(target) });
  }

  /** A corner that was dragged can then be nudged or removed. */
  #selectCorner(gesture: Gesture): void {
    if (gesture.kind === "spot" && gesture.spot.kind === "corner") {
      this.#dispatch({ type: "select", selection: { kind: "corner", index: gesture.spot.index } });
    }
  }

  /** A corner of the old outline that is tapped, not dragged, is where a new outline begins. */
  #tapSpot(state: State, spot: Spot): void {
    if (spot.kind !== "corner") {
      return;
    }
    const at: Point = [spot.at[0], spot.at[1]];
    if (state.tool === "room") {
      this.#dispatch({ type: "draw-down", at, free: true });
      this.#dispatch({ type: "draw-up", at, free: true });
    } else {
      this.#dispatch({ type: "select", selection: { kind: "corner", index: spot.index } });
    }
  }

  #hover(state: State, event: PointerEvent): void {
    const ray = this.#ray(event);
    if (state.draft?.kind === "box-height") {
      this.#raise(state, ray);
      return;
    }
    if (state.draft) {
      this.#draw("draw-move", state, event, ray);
    }
    if (state.tool !== "select") {
      this.#point(null, this.#spotAt(state, event) ? "grab" : "crosshair");
      return;
    }
    const target = targetAt(state, ray);
    const spot = this.#spotAt(state, event);
    const chosen = isChosen(state, target);
    this.#point(target?.kind === "box" ? target.box.id : null, cursorOf(target, chosen, spot));
    const probe = probeAt(state, ray);
    if (probe || state.probe) {
      this.#dispatch({ type: "probe", probe });
    }
  }

  #point(id: string | null, cursor: string): void {
    this.#pad.hover(id);
    this.#pad.element.style.cursor = cursor;
  }

  #draw(
    type: "draw-down" | "draw-move" | "draw-up",
    state: State,
    event: PointerEvent,
    ray: Ray,
  ): void {
    const onWalls = state.tool === "door" || state.tool === "window";
    const at = onWalls ? handOnWalls(state, ray) : meetLevel(ray, 0);
    if (at && distance(at, middleOf(state.scene.room.corners)) < REACH) {
      this.#dispatch({ type, at, free: event.altKey });
    }
  }

  #raise(state: State, ray: Ray): void {
    if (state.draft?.kind !== "box-height" || Math.abs(ray.direction[2]) > STEEP) {
      return;
    }
    const { box } = state.draft;
    const height = heightOver(ray, floorPoint(box));
    this.#pull ??= box.size[2] - height;
    this.#dispatch({ type: "draw-height", height: height + this.#pull, done: false });
  }

  #finishHeight(state: State): void {
    if (state.draft?.kind === "box-height") {
      this.#dispatch({ type: "draw-height", height: state.draft.box.size[2], done: true });
    }
  }

  #leave(event: PointerEvent): void {
    if (this.#press || event.pointerType === "touch") {
      return;
    }
    this.#pad.hover(null);
    if (this.#state?.probe) {
      this.#dispatch({ type: "probe", probe: null });
    }
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "Escape" && this.#press) {
      this.#end();
    }
  }

  #ray(event: PointerEvent): Ray {
    return this.#pad.ray(event.clientX, event.clientY);
  }

  /** The handle nearest to the finger; on the body of a thing only a handle that is hit counts. */
  #spotAt(state: State, event: PointerEvent): Spot | null {
    let best: Spot | null = null;
    const onBody = isChosen(state, targetAt(state, this.#ray(event)));
    let least = onBody || event.pointerType === "mouse" ? MOUSE : TOUCH;
    for (const spot of spotsOf(state)) {
      const place = this.#pad.place(spot.at);
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
}
