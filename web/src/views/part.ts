import type { Camera, Object3D, Vector3 } from "three";
import type { View } from "../contract";

/**
 * Who looks, in the frame that is about to be drawn. The page's cameras and an XR session both
 * make one, so that the views need not know who drives the loop.
 */
export interface Eye {
  readonly camera: Camera;
  /** Height of the picture in CSS pixels. */
  readonly pixels: number;
  /** Seconds since the last frame. */
  readonly elapsed: number;
}

/** A view with something in the room; its root stands in the core frame. */
export interface Part extends View {
  readonly root: Object3D;
  /** Brings what moves up to date before a frame; true while it wants another. Allocates nothing. */
  update?(eye: Eye): boolean;
}

/** How many metres one CSS pixel covers at a point of the world. */
export function metersPerPixel(eye: Eye, world: Vector3): number {
  const { camera } = eye;
  const view = camera.matrixWorldInverse.elements;
  const projection = camera.projectionMatrix.elements;
  const depth = -(
    (view[2] ?? 0) * world.x +
    (view[6] ?? 0) * world.y +
    (view[10] ?? 0) * world.z +
    (view[14] ?? 0)
  );
  const perspective = projection[11] === -1;
  return (2 * (perspective ? Math.max(depth, 0.01) : 1)) / ((projection[5] ?? 1) * eye.pixels);
}
