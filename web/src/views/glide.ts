import { wrapped } from "../model/geometry";
import type { Pose } from "../model/state";
import { easeOut, reducedMotion } from "./motion";

const DURATION = 0.18; // seconds

/** A pose on its way to another, in place; allocates nothing while it moves. */
export class Glide {
  readonly center = { x: 0, y: 0, z: 0 };
  heading = 0;
  readonly #from = { x: 0, y: 0, z: 0, heading: 0 };
  #goal: Pose | null = null;
  #progress = 1;

  /** Sets off for a pose; `jump` arrives at once. */
  to(pose: Pose, jump: boolean): void {
    if (pose === this.#goal) {
      return;
    }
    const first = this.#goal === null;
    Object.assign(this.#from, this.center);
    this.#from.heading = this.heading;
    this.#goal = pose;
    this.#progress = jump || first || reducedMotion() ? 1 : 0;
    this.#place();
  }

  /** Forgets where it was: the next pose is taken at once. */
  reset(): void {
    this.#goal = null;
    this.#progress = 1;
  }

  /** One step; true while there is more to go. */
  advance(elapsed: number): boolean {
    if (this.#progress >= 1) {
      return false;
    }
    this.#progress = Math.min(1, this.#progress + elapsed / DURATION);
    this.#place();
    return true;
  }

  #place(): void {
    const goal = this.#goal;
    if (!goal) {
      return;
    }
    const t = easeOut(this.#progress);
    this.center.x = this.#from.x + (goal.center[0] - this.#from.x) * t;
    this.center.y = this.#from.y + (goal.center[1] - this.#from.y) * t;
    this.center.z = this.#from.z + (goal.center[2] - this.#from.z) * t;
    this.heading = goal.heading - wrapped(goal.heading - this.#from.heading) * (1 - t);
  }
}
