import type { Segment } from "../model/geometry";
import type { Point, Vector3 } from "../model/state";
import type { Ray } from "./picking";

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

export function rayOf(pad: Pad, event: Pick<PointerEvent, "clientX" | "clientY">): Ray {
  return pad.ray(event.clientX, event.clientY);
}
