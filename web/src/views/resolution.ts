import type { WebGLRenderer } from "three";

const FULL = 2; // pixels a CSS pixel; more is not seen
const SLOW = 0.055; // seconds a frame; motion looks jerky
const COARSE = 0.6; // of the full resolution

/** Draws coarser while things move on a slow machine, and sharp again at rest. */
export class Resolution {
  readonly #renderer: WebGLRenderer;
  #coarse = false;
  #average = 0;

  constructor(renderer: WebGLRenderer) {
    this.#renderer = renderer;
    this.apply();
  }

  /** Takes note of how long a frame of a motion took. */
  moved(elapsed: number): void {
    this.#average += (elapsed - this.#average) * 0.3;
    if (!this.#coarse && this.#average > SLOW) {
      this.#coarse = true;
      this.apply();
    }
  }

  /** Everything stands still: true if a sharp frame is owed. */
  rested(): boolean {
    this.#average = 0;
    if (!this.#coarse) {
      return false;
    }
    this.#coarse = false;
    this.apply();
    return true;
  }

  apply(): void {
    const full = Math.min(devicePixelRatio, FULL);
    this.#renderer.setPixelRatio(this.#coarse ? full * COARSE : full);
  }
}
