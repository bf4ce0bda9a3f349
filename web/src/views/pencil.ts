import type { Action } from "../model/actions";
import { floorPoint } from "../model/footprints";
import { distance } from "../model/geometry";
import type { State } from "../model/state";
import { handOnWalls } from "./dragging";
import { middleOf } from "./outline";
import { heightOver, meetLevel, type Ray } from "./picking";

const REACH = 40; // metres from the room within which one can draw
const STEEP = 0.96; // looking down like this, heights cannot be seen

/** Draws outlines, boxes and openings, and pulls boxes up to their height. */
export class Pencil {
  readonly #dispatch: (action: Action) => void;
  /** What to add to the height under the pointer while a box is pulled up. */
  #pull: number | null = null;

  constructor(dispatch: (action: Action) => void) {
    this.#dispatch = dispatch;
  }

  /** Forgets where a box was taken hold of. */
  letGo(): void {
    this.#pull = null;
  }

  draw(type: "draw-down" | "draw-move" | "draw-up", state: State, free: boolean, ray: Ray): void {
    const onWalls = state.tool === "door" || state.tool === "window";
    const at = onWalls ? handOnWalls(state, ray) : meetLevel(ray, 0);
    if (at && distance(at, middleOf(state.scene.room.corners)) < REACH) {
      this.#dispatch({ type, at, free });
    }
  }

  raise(state: State, ray: Ray): void {
    if (state.draft?.kind !== "box-height" || Math.abs(ray.direction[2]) > STEEP) {
      return;
    }
    const { box } = state.draft;
    const height = heightOver(ray, floorPoint(box));
    this.#pull ??= box.size[2] - height;
    this.#dispatch({ type: "draw-height", height: height + this.#pull, done: false });
  }

  finishHeight(state: State): void {
    if (state.draft?.kind === "box-height") {
      this.#dispatch({ type: "draw-height", height: state.draft.box.size[2], done: true });
    }
  }
}
