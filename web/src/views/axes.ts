import { Matrix4, Vector3 } from "three";
import { pageTurn, toPage } from "../model/frames";

/**
 * The core frame as seen from the page's: a pure rotation. Everything in the room hangs below one
 * group with this matrix, so that the views speak core coordinates.
 */
export const CORE_IN_PAGE = new Matrix4().makeBasis(
  new Vector3(...toPage([1, 0, 0])),
  new Vector3(...toPage([0, 1, 0])),
  new Vector3(...toPage([0, 0, 1])),
);

/** A GLB (y up, front along +z) as seen from its box (front along +x, z up). */
export const MODEL_IN_BOX = CORE_IN_PAGE.clone()
  .invert()
  .multiply(new Matrix4().makeRotationY(pageTurn(0)));
