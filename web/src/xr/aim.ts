import type { Group } from "three";
import { distance, type Segment } from "../model/geometry";
import type { Point, State, Vector3 } from "../model/state";
import type { Dispatch } from "../store";
import { meetWall, type Ray } from "../views/picking";
import { aimed, isMarking, isOnWalls, pointAt } from "./marking";
import { type Placed, placeOf } from "./rays";
import { Reticle } from "./reticle";

const PAUSE = 0.1; // seconds between two looks at where the phone points
const STILL = 0.005; // metres; nearer than this the aim has not changed

/** The middle of the view: a ring on the floor, and what is drawn or carried follows it. */
export class Aim {
  readonly #reticle = new Reticle();
  readonly #dispatch: Dispatch;
  readonly #guide: (guides: readonly Segment[]) => void;
  #since = 0;
  #last: Point = [Number.NaN, Number.NaN];

  constructor(dispatch: Dispatch, guide: (guides: readonly Segment[]) => void) {
    this.#dispatch = dispatch;
    this.#guide = guide;
  }

  get root(): Group {
    return this.#reticle.root;
  }

  /** The ring lies where a surface was found, while the floor is looked for. */
  find(surface: Placed | null, ray: Ray): void {
    if (surface === null) this.#reticle.hide();
    else this.#ring(placeOf(surface), ray, null);
  }

  /** The ring lies where the next mark would be; true to the floor, not to what stands on it. */
  point(state: State, ray: Ray): void {
    const marking = state.ar?.step === "line-up" || isMarking(state);
    const wall = isOnWalls(state) ? meetWall(ray, state.scene.room) : null;
    if (marking && wall !== null) {
      this.#ring(wall.at, ray, wall.heading);
      return;
    }
    const at = marking && state.draft?.kind !== "box-height" ? pointAt(state, ray) : null;
    if (at === null) this.#reticle.hide();
    else this.#ring([at[0], at[1], 0], ray, null);
  }

  /** Has what is drawn or carried follow, but not more often than one can see. */
  follow(state: State, ray: Ray, elapsed: number): void {
    this.#since += elapsed;
    if (this.#since < PAUSE) return;
    this.#since = 0;
    const upward = state.draft?.kind === "box-height";
    const at = upward ? ([ray.direction[2], ray.origin[2]] as const) : pointAt(state, ray);
    if (at === null || distance(at, this.#last) < STILL) return;
    this.#last = at;
    const dragged = aimed(state, ray);
    if (dragged === null) return;
    this.#guide(dragged.guides);
    this.#dispatch(dragged.action);
  }

  dispose(): void {
    this.#reticle.dispose();
  }

  #ring(at: Vector3, { origin }: Ray, wall: number | null): void {
    const [x, y, z] = origin;
    this.#reticle.show(at, Math.hypot(at[0] - x, at[1] - y, at[2] - z), wall);
  }
}
