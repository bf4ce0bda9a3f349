import type { Vector3 } from "../model/state";
import { type Alignment, type Move, moved } from "./alignment";

const DRIFT = 0.002; // metres that the room's anchor must have moved to be followed
const TURN = 0.001; // radians

/**
 * Keeps the room's frame where it belongs in the device's frame. Where there are anchors, one stands
 * in the room's origin, and the frame follows it when the device learns more of the room.
 */
export class Anchoring {
  readonly #base: XRReferenceSpace;
  readonly #hasAnchors: boolean;
  readonly #place: (space: XRReferenceSpace) => void;
  #alignment: Alignment = { at: [0, 0, 0], turn: 0 };
  #space: XRReferenceSpace;
  #anchor: XRAnchor | null = null;
  #wanted = false;

  /** `place` is told of each new frame of the room; anchors are used where they are granted. */
  constructor(
    base: XRReferenceSpace,
    hasAnchors: boolean,
    place: (space: XRReferenceSpace) => void,
  ) {
    this.#base = base;
    this.#hasAnchors = hasAnchors;
    this.#place = place;
    this.#space = base;
  }

  /** The frame of the device. */
  get base(): XRReferenceSpace {
    return this.#base;
  }

  /** The frame of the room: the page's axes. */
  get space(): XRReferenceSpace {
    return this.#space;
  }

  /** Moves the frame within itself: its new origin and x axis are given as they are now. */
  move(by: Move): void {
    this.#align(moved(this.#alignment, by));
    this.#wanted = this.#hasAnchors;
  }

  /** Puts the origin on the floor, at a place of the device's frame; +y points along `ahead`. */
  stand(at: Vector3, ahead: number): void {
    this.#align({ at, turn: ahead });
    this.#wanted = this.#hasAnchors;
  }

  /** Follows the anchor; asks for one in each new place. */
  update(frame: XRFrame): void {
    if (this.#wanted) this.#renew(frame);
    const pose = this.#anchor && frame.getPose(this.#anchor.anchorSpace, this.#base);
    if (pose) this.#follow(pose.transform);
  }

  dispose(): void {
    this.#anchor?.delete();
    this.#anchor = null;
  }

  #renew(frame: XRFrame): void {
    this.#wanted = false;
    this.dispose();
    const asked = this.#alignment;
    frame.createAnchor?.(transformOf(asked), this.#base)?.then(
      (anchor) => {
        // It may come when the room has been moved on, and another one was asked for.
        if (this.#alignment === asked) this.#anchor = anchor;
        else anchor.delete();
      },
      () => {}, // without an anchor the room stays where it was put
    );
  }

  #follow({ position, orientation }: XRRigidTransform): void {
    if (this.#wanted) return; // it still stands where the room was
    const { at, turn } = this.#alignment;
    const now = 2 * Math.atan2(orientation.y, orientation.w);
    const gone = Math.hypot(position.x - at[0], position.y - at[1], position.z - at[2]);
    const turned = Math.abs(Math.atan2(Math.sin(now - turn), Math.cos(now - turn)));
    if (gone > DRIFT || turned > TURN) {
      this.#align({ at: [position.x, position.y, position.z], turn: now });
    }
  }

  #align(alignment: Alignment): void {
    this.#alignment = alignment;
    this.#space = this.#base.getOffsetReferenceSpace(transformOf(alignment));
    this.#place(this.#space);
  }
}

/** The turn of a frame whose +y (in the core's axes) points where a view along −z does. */
export function turnOfView({ matrix }: Pick<XRRigidTransform, "matrix">): number {
  const [x, z] = [-(matrix[8] ?? 0), -(matrix[10] ?? 0)];
  return Math.atan2(-z, x) - Math.PI / 2;
}

function transformOf({ at: [x, y, z], turn }: Alignment): XRRigidTransform {
  const half = turn / 2;
  return new XRRigidTransform({ x, y, z }, { x: 0, y: Math.sin(half), z: 0, w: Math.cos(half) });
}
