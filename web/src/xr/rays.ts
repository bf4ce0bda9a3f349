/** What the device's poses mean in the core frame. Pure. */
import { toCore } from "../model/frames";
import type { Vector3 } from "../model/state";
import type { Ray } from "../views/picking";

/** As much of an XRRigidTransform as is read: its matrix, column by column. */
export type Placed = Pick<XRRigidTransform, "matrix">;

const UPRIGHT = 0.8; // of the surface's normal along the upright axis; a steeper one is no floor

/** The ray of a hand or of the view: along −z of its pose. */
export function rayOf({ matrix }: Placed): Ray {
  const [x, y, z] = [matrix[8] ?? 0, matrix[9] ?? 0, matrix[10] ?? 0];
  const length = Math.hypot(x, y, z) || 1;
  return {
    origin: placeOf({ matrix }),
    direction: toCore([-x / length, -y / length, -z / length]),
  };
}

export function placeOf({ matrix }: Placed): Vector3 {
  return toCore([matrix[12] ?? 0, matrix[13] ?? 0, matrix[14] ?? 0]);
}

/** Whether a surface that was hit is level: its y axis is its normal. */
export function isLevel({ matrix }: Placed): boolean {
  return Math.abs(matrix[5] ?? 0) > UPRIGHT;
}
