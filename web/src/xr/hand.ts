/** What fingers and controllers do in the real room, as actions. Rays come in, in the core frame. */

import type { Action } from "../model/actions";
import { floorPoint, headingOf } from "../model/footprints";
import { angleOf, distance, subtract, wrapped } from "../model/geometry";
import { GHOST, ghostBox } from "../model/ghost";
import { selectedBox } from "../model/selecting";
import type { Point, State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { drag, finished } from "../views/dragging";
import { type Finger, type Gesture, gestureAt } from "../views/gesture";
import { dragSpot } from "../views/handle_drag";
import type { Pad } from "../views/pad";
import { meetLevel, pointOn, type Ray } from "../views/picking";
import { tap } from "../views/taps";
import { aimed, isMarking, marked } from "./marking";

const SLOP = 14; // CSS pixels that a tap may slip; a phone in the hand is never still
const AHEAD = 2; // metres along a ray at which its place on the screen is taken
const NEAR = 0.1; // metres; too near to the middle of a thing to turn it by

interface Press {
  readonly id: unknown;
  readonly start: Ray;
  readonly place: Point | null;
  readonly gesture: Gesture | null;
  ray: Ray;
  moved: boolean;
  /** It is or was one of two fingers: by itself it means nothing. */
  paired: boolean;
  /** The last action of a drag, to be sent once more as the final one. */
  last: Action | null;
}

/** What is turned, from where. */
interface Turn {
  readonly heading: number;
  readonly angle: number;
}

export class Hand {
  readonly #pad: Pad;
  readonly #dispatch: (action: Action) => void;
  readonly #presses: Press[] = [];
  #state: State;
  #turn: Turn | null = null;

  constructor(pad: Pad, dispatch: (action: Action) => void, state: State) {
    this.#pad = pad;
    this.#dispatch = dispatch;
    this.#state = state;
  }

  get pressing(): boolean {
    return this.#presses.length > 0;
  }

  show(state: State): void {
    this.#state = state;
  }

  down(id: unknown, ray: Ray): void {
    const finger = this.#fingerOf(ray);
    const gesture = isMarking(this.#state) ? null : gestureAt(this.#state, this.#pad, finger, ray);
    const place: Point = [finger.clientX, finger.clientY];
    const paired = this.#presses.length > 0;
    this.#presses.push({ id, start: ray, place, gesture, ray, moved: false, paired, last: null });
    if (paired) for (const press of this.#presses) press.paired = true;
    this.#turn = null;
  }

  move(id: unknown, ray: Ray): void {
    const press = this.#presses.find((one) => one.id === id);
    if (press === undefined) return;
    press.ray = ray;
    const { clientX, clientY } = this.#fingerOf(ray);
    press.moved ||= press.place !== null && distance(press.place, [clientX, clientY]) > SLOP;
    if (this.#presses.length > 1) this.#twist();
    else if (press.moved && !press.paired) this.#drag(press);
  }

  up(id: unknown, ray: Ray): void {
    const at = this.#presses.findIndex((one) => one.id === id);
    const [press] = at === -1 ? [] : this.#presses.splice(at, 1);
    if (press === undefined) return;
    this.#pad.guide([]);
    this.#turn = null;
    if (press.last) for (const action of finished(this.#state, press.last)) this.#dispatch(action);
    else if (!press.paired && (press.gesture === null || !press.moved)) this.tap(ray);
  }

  /** A short touch along a ray, or the button that stands for it. */
  tap(ray: Ray): void {
    const state = this.#state;
    if (isMarking(state)) {
      for (const action of marked(state, ray)) this.#dispatch(action);
    } else if (state.ar?.carrying && state.placing?.mode === "manual") {
      const last = aimed(state, ray);
      if (last) this.#dispatch(last.action);
      this.#dispatch({ type: "change-ar", change: { carrying: false } });
    } else {
      const gesture = gestureAt(state, this.#pad, this.#fingerOf(ray), ray);
      for (const action of tap(state, gesture, ray)) this.#dispatch(action);
    }
  }

  #drag(press: Press): void {
    const state = this.#state;
    const { gesture, ray } = press;
    switch (gesture?.kind) {
      case undefined:
        this.#draw(press);
        return;
      case "spot":
        press.last = dragSpot(state, gesture.spot, ray, false, false) ?? press.last;
        break;
      case "grip": {
        const dragged = drag(state, gesture.grip, ray, false, false);
        this.#pad.guide(dragged?.guides ?? []);
        press.last = dragged?.action ?? press.last;
        break;
      }
      case "look":
        press.last = this.#around(press) ?? press.last;
        break;
      case "draw":
      case "height":
        return;
    }
    if (state.ar?.carrying) this.#dispatch({ type: "change-ar", change: { carrying: false } });
    if (press.last) this.#dispatch(press.last);
  }

  /** A box is begun where the finger went down; from then on it follows the finger. */
  #draw({ start, ray }: Press): void {
    if (this.#state.tool === "box" && this.#state.draft === null) {
      for (const action of marked(this.#state, start)) this.#dispatch(action);
    }
    const dragged = aimed(this.#state, ray);
    if (dragged) this.#dispatch(dragged.action);
  }

  /** A finger outside the thing turns it. */
  #around({ start, ray }: Press): Action | null {
    const box = turnable(this.#state);
    const [from, to] = [meetLevel(start, 0), meetLevel(ray, 0)];
    if (box === null || from === null || to === null) return null;
    const middle = floorPoint(box);
    if (distance(middle, from) < NEAR || distance(middle, to) < NEAR) return null;
    const first = angleOf(subtract(from, middle));
    this.#turn ??= { heading: headingOf(box), angle: first };
    return turned(box, this.#turn, angleOf(subtract(to, middle)));
  }

  /** Two fingers turn the thing as the line between them turns. */
  #twist(): void {
    const [one, other] = this.#presses;
    const box = turnable(this.#state);
    const from = one && meetLevel(one.ray, 0);
    const to = other && meetLevel(other.ray, 0);
    if (box === null || !one || !from || !to || distance(from, to) < NEAR) return;
    const angle = angleOf(subtract(to, from));
    this.#turn ??= { heading: headingOf(box), angle };
    one.last = turned(box, this.#turn, angle);
    this.#dispatch(one.last);
  }

  #fingerOf(ray: Ray): Finger {
    const [clientX, clientY] = this.#pad.place(pointOn(ray, AHEAD)) ?? [Number.NaN, Number.NaN];
    return { clientX, clientY, pointerType: "touch" };
  }
}

/** What a turn is about: the ghost, else the box that is selected. */
function turnable(state: State): BoxRecord | null {
  if (state.placing !== null) return ghostBox(state);
  return selectedBox(state) ?? null;
}

function turned(box: BoxRecord, from: Turn, angle: number): Action {
  const heading = wrapped(from.heading + angle - from.angle);
  return box.id === GHOST
    ? { type: "drag-ghost", pose: { center: box.center, heading }, done: false }
    : { type: "edit-box", box: { ...box, heading }, done: false };
}
