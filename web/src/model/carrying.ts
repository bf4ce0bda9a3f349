/**
 * What stands or lies on a thing moves, turns and goes with it: the rules of
 * scenegen_core/scene/resting.py.
 */
import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import { bottomOf, floorPoint, headingOf, isOver, topOf } from "./footprints";
import { add, direction, leftOf, rounded, scale, subtract, wrapped } from "./geometry";
import { RESTS } from "./resting";
import { withoutBoxes } from "./scenes";
import type { Point } from "./state";

/** Whatever is below, these hang. */
const HANGS = "Picture";

/** The scene without a box and what stands on it: what stays where it is while the box is moved. */
export function withoutLoaded(scene: SceneRecord, box: BoxRecord): SceneRecord {
  return withoutBoxes(scene, [box.id, ...loadOf(scene, box).map(({ id }) => id)]);
}

/** The boxes on a box, and those on them in turn. */
export function loadOf(scene: SceneRecord, box: BoxRecord): readonly BoxRecord[] {
  const found = new Set([box]);
  for (const carrier of found) {
    for (const other of scene.boxes) if (isCarried(scene, other, carrier)) found.add(other);
  }
  found.delete(box);
  return [...found];
}

/**
 * What a thing carried, where it is now that the thing has moved, turned or become higher. On a top
 * that changes its depth or width nothing moves aside.
 */
export function taken(
  load: readonly BoxRecord[],
  from: BoxRecord,
  to: BoxRecord,
): readonly BoxRecord[] {
  const up = topOf(to) - topOf(from);
  const isSameShape = from.size[0] === to.size[0] && from.size[1] === to.size[1];
  if (!isSameShape) return up === 0 ? load : load.map((box) => at(box, floorPoint(box), up, 0));
  const by = wrapped(headingOf(to) - headingOf(from));
  const stays = floorPoint(from).every((x, i) => x === to.center[i]) && by === 0 && up === 0;
  if (stays) return load;
  const ahead = direction(by);
  return load.map((box) => {
    const [x, y] = subtract(floorPoint(box), floorPoint(from));
    const turned = add(scale(ahead, x), scale(leftOf(ahead), y));
    return at(box, add(floorPoint(to), turned), up, by);
  });
}

function at(box: BoxRecord, [x, y]: Point, up: number, by: number): BoxRecord {
  const heading = by === 0 ? headingOf(box) : wrapped(headingOf(box) + by);
  return { ...box, center: [rounded(x), rounded(y), rounded(box.center[2] + up)], heading };
}

function isCarried(scene: SceneRecord, box: BoxRecord, carrier: BoxRecord): boolean {
  if (box.id === carrier.id) return false;
  if (box.parent === carrier.id) return true;
  return standsOn(box, carrier) || liesIn(scene, box, carrier);
}

/** What stands on a rug stands on the floor. */
function standsOn(box: BoxRecord, carrier: BoxRecord): boolean {
  const onTop = bottomOf(box) > RESTS && Math.abs(bottomOf(box) - topOf(carrier)) <= RESTS;
  return onTop && box.category !== HANGS && isOver(carrier, floorPoint(box));
}

/** As a cushion on the seat of a sofa, below the top of its back. */
function liesIn(scene: SceneRecord, box: BoxRecord, carrier: BoxRecord): boolean {
  const bottom = bottomOf(box);
  const within = bottomOf(carrier) + RESTS < bottom && bottom < topOf(carrier);
  if (!within || box.category === HANGS || !isOver(carrier, floorPoint(box))) return false;
  return !scene.boxes.some((other) => other.id !== box.id && standsOn(box, other));
}
