import { type PerspectiveCamera, Vector3 } from "three";
import { toPage } from "../model/frames";
import type { Point } from "../model/state";
import { CORE_IN_PAGE } from "./axes";

export const EYE_HEIGHT = 1.6; // metres
const SPEED = 1.6; // metres a second, a calm walk
const LOOK = 0.005; // radians a pixel
const MAX_PITCH = 1.2; // radians

const STEPS: Readonly<Record<string, readonly [ahead: number, left: number]>> = {
  KeyW: [1, 0],
  ArrowUp: [1, 0],
  KeyS: [-1, 0],
  ArrowDown: [-1, 0],
  KeyA: [0, 1],
  ArrowLeft: [0, 1],
  KeyD: [0, -1],
  ArrowRight: [0, -1],
};

/** A person in the room: drag to look round, keys to walk while the picture has the focus. */
export class Walk {
  enabled = false;
  readonly #camera: PerspectiveCamera;
  readonly #element: HTMLElement;
  readonly #changed: () => void;
  readonly #down = new Set<string>();
  readonly #listening = new AbortController();
  readonly #ahead = new Vector3();
  #heading = 0;
  #pitch = -0.12;
  #pointer: { id: number; x: number; y: number } | null = null;

  constructor(camera: PerspectiveCamera, element: HTMLElement, changed: () => void) {
    this.#camera = camera;
    this.#element = element;
    this.#changed = changed;
    const { signal } = this.#listening;
    element.addEventListener("pointerdown", (event) => this.#grab(event), { signal });
    element.addEventListener("pointermove", (event) => this.#look(event), { signal });
    element.addEventListener("pointerup", () => this.#release(), { signal });
    element.addEventListener("pointercancel", () => this.#release(), { signal });
    element.addEventListener("keydown", (event) => this.#press(event), { signal });
    element.addEventListener("keyup", ({ code }) => this.#down.delete(code), { signal });
    element.addEventListener("blur", () => this.#down.clear(), { signal });
  }

  /** Puts the person at a point of the floor, looking along a heading (core frame). */
  stand([x, y]: Point, heading: number): void {
    this.#camera.position.set(...toPage([x, y, EYE_HEIGHT]));
    this.#heading = heading;
    this.#pitch = -0.12;
    this.#aim();
  }

  /** One step; true while a key is down. */
  advance(elapsed: number): boolean {
    if (!this.enabled || this.#down.size === 0) {
      return false;
    }
    let ahead = 0;
    let left = 0;
    for (const code of this.#down) {
      ahead += STEPS[code]?.[0] ?? 0;
      left += STEPS[code]?.[1] ?? 0;
    }
    const length = Math.hypot(ahead, left) || 1;
    const cos = Math.cos(this.#heading);
    const sin = Math.sin(this.#heading);
    this.#ahead.set(ahead * cos - left * sin, ahead * sin + left * cos, 0);
    this.#ahead.applyMatrix4(CORE_IN_PAGE);
    this.#camera.position.addScaledVector(this.#ahead, (SPEED * elapsed) / length);
    this.#aim();
    return true;
  }

  dispose(): void {
    this.#listening.abort();
  }

  #aim(): void {
    const flat = Math.cos(this.#pitch);
    this.#ahead.set(
      Math.cos(this.#heading) * flat,
      Math.sin(this.#heading) * flat,
      Math.sin(this.#pitch),
    );
    this.#camera.lookAt(this.#ahead.applyMatrix4(CORE_IN_PAGE).add(this.#camera.position));
  }

  #grab(event: PointerEvent): void {
    if (this.enabled && event.isPrimary) {
      this.#pointer = { id: event.pointerId, x: event.clientX, y: event.clientY };
      this.#element.setPointerCapture(event.pointerId);
    }
  }

  #look(event: PointerEvent): void {
    const pointer = this.#pointer;
    if (!this.enabled || pointer?.id !== event.pointerId) {
      return;
    }
    this.#heading += (event.clientX - pointer.x) * LOOK;
    const pitch = this.#pitch + (event.clientY - pointer.y) * LOOK;
    this.#pitch = Math.max(-MAX_PITCH, Math.min(MAX_PITCH, pitch));
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    this.#aim();
    this.#changed();
  }

  #release(): void {
    this.#pointer = null;
  }

  #press(event: KeyboardEvent): void {
    if (this.enabled && event.code in STEPS && !event.ctrlKey && !event.metaKey) {
      this.#down.add(event.code);
      event.preventDefault();
      event.stopPropagation();
      this.#changed();
    }
  }
}
