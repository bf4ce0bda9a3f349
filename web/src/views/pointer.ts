import type { Action } from "../model/actions";
import type { State } from "../model/state";
import { cursorOf, isChosen } from "./chosen";
import { drag, finished } from "./dragging";
import { type Gesture, gestureAt, spotAt } from "./gesture";
import { dragSpot } from "./handle_drag";
import { type Pad, rayOf } from "./pad";
import { Pencil } from "./pencil";
import { selectCorner, tap } from "./taps";
import { probeAt, targetAt } from "./targets";

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

const SLOP = 5; // CSS pixels that a tap may slip

/** Turns what mouse, pen and fingers do into actions. */
export class Pointer {
  readonly #pad: Pad;
  readonly #dispatch: (action: Action) => void;
  readonly #pencil: Pencil;
  readonly #listening = new AbortController();
  #state: State | null = null;
  #press: Press | null = null;
  /** The press that the camera was given after all. */
  #handedOver: PointerEvent | null = null;

  constructor(pad: Pad, dispatch: (action: Action) => void) {
    this.#pad = pad;
    this.#dispatch = dispatch;
    this.#pencil = new Pencil(dispatch);
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
      this.#pencil.letGo();
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
    const ray = rayOf(this.#pad, event);
    const gesture = gestureAt(state, this.#pad, event, ray);
    const { pointerId: id, clientX: x, clientY: y } = event;
    this.#press = { id, x, y, gesture, down: event, moved: false, last: null };
    if (gesture.kind === "look") {
      return;
    }
    if (state.probe) {
      this.#dispatch({ type: "probe", probe: null });
    }
    this.#pad.hold(true);
    this.#pad.element.setPointerCapture(id);
    this.#pad.element.focus({ preventScroll: true });
    event.preventDefault();
    if (gesture.kind === "draw") {
      this.#pencil.draw("draw-down", state, event.altKey, ray);
    } else if (gesture.kind === "height") {
      this.#pencil.letGo();
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
    const ray = rayOf(this.#pad, event);
    const { gesture } = press;
    switch (gesture.kind) {
      case "look":
        return;
      case "draw":
        this.#pencil.draw("draw-move", state, event.altKey, ray);
        return;
      case "height":
        this.#pencil.raise(state, ray);
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
      this.#pencil.draw("draw-up", state, event.altKey, rayOf(this.#pad, event));
    } else if (gesture.kind === "height") {
      this.#pencil.finishHeight(state);
    } else if (last) {
      this.#do(finished(state, last));
      this.#do(gesture.kind === "spot" ? selectCorner(gesture.spot) : []);
    } else if (!moved && event.type === "pointerup") {
      this.#do(tap(state, gesture, rayOf(this.#pad, event)));
    }
  }

  #end(): void {
    this.#press = null;
    this.#pad.hold(false);
    this.#pad.guide([]);
  }

  #hover(state: State, event: PointerEvent): void {
    const ray = rayOf(this.#pad, event);
    if (state.draft?.kind === "box-height") {
      this.#pencil.raise(state, ray);
      return;
    }
    if (state.draft) {
      this.#pencil.draw("draw-move", state, event.altKey, ray);
    }
    if (state.tool !== "select") {
      this.#point(null, spotAt(state, this.#pad, event) ? "grab" : "crosshair");
      return;
    }
    const target = targetAt(state, ray);
    const spot = spotAt(state, this.#pad, event);
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

  #do(actions: readonly Action[]): void {
    for (const action of actions) {
      this.#dispatch(action);
    }
  }
}
