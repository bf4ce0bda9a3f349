/** The three lengths of a thing, changed one at a time. */
import type { BoxRecord } from "../net/protocol.gen";
import type { Vector3 } from "./state";

/** What the lengths of a size are called, in its order. */
export const LENGTHS = ["Depth", "Width", "Height"] as const;

/** Which of them, as an index. */
export const SIDES = [0, 1, 2] as const;
export type Side = (typeof SIDES)[number];

/** The size with another of its lengths, metres. */
export function withLength(size: Vector3, side: Side, length: number): Vector3 {
  const [depth, width, height] = size;
  switch (side) {
    case 0:
      return [length, width, height];
    case 1:
      return [depth, length, height];
    case 2:
      return [depth, width, length];
  }
}

/** The box with another of its lengths, metres; another height leaves its underside where it is. */
export function sized(box: BoxRecord, side: Side, length: number): BoxRecord {
  const [x, y, z] = box.center;
  const up = side === 2 ? (length - box.size[2]) / 2 : 0;
  return { ...box, size: withLength(box.size, side, length), center: [x, y, z + up] };
}
