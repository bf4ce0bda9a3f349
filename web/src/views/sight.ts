import { type Camera, Matrix4, Raycaster, Vector2, Vector3 } from "three";
import type { Vector3 as Place, Point } from "../model/state";
import { CORE_IN_PAGE } from "./axes";
import type { Ray } from "./picking";

/** Between points of the window and the core frame, as a camera sees them. */
export class Sight {
  readonly #element: HTMLElement;
  readonly #toCore = new Matrix4().copy(CORE_IN_PAGE).invert();
  readonly #caster = new Raycaster();
  readonly #pointer = new Vector2();
  readonly #place = new Vector3();

  constructor(element: HTMLElement) {
    this.#element = element;
  }

  /** The ray through a point of the window. */
  ray(camera: Camera, x: number, y: number): Ray {
    const frame = this.#element.getBoundingClientRect();
    this.#pointer.x = ((x - frame.left) / frame.width) * 2 - 1;
    this.#pointer.y = 1 - ((y - frame.top) / frame.height) * 2;
    this.#caster.setFromCamera(this.#pointer, camera);
    const { origin, direction } = this.#caster.ray.applyMatrix4(this.#toCore);
    return {
      origin: [origin.x, origin.y, origin.z],
      direction: [direction.x, direction.y, direction.z],
    };
  }

  /** Where on the window a place is; null behind the eye. */
  place(camera: Camera, at: Place): Point | null {
    const { x, y, z } = this.#place
      .set(...at)
      .applyMatrix4(CORE_IN_PAGE)
      .project(camera);
    if (z > 1 || z < -1) {
      return null;
    }
    const frame = this.#element.getBoundingClientRect();
    return [frame.left + ((x + 1) / 2) * frame.width, frame.top + ((1 - y) / 2) * frame.height];
  }
}
