/** Which side of a box is its front, as long as nobody has said. */
import type { BoxRecord } from "../net/protocol.gen";
import { floorPoint, headingOf } from "./footprints";
import { add, direction, distance, nearestOn, scale, wrapped } from "./geometry";
import { usualSize } from "./labels";
import type { State, Vector3 } from "./state";
import { nearestWall } from "./walls";

/** Sides that differ by less than this factor, as a logarithm, are as good as equal. */
const NEARLY_SQUARE = 0.15;

/** The same box, turned by one of some quarters so that its back is nearest to a wall. */
export function backed(
  { scene }: State,
  box: BoxRecord,
  quarters: readonly number[] = [0, 1, 2, 3],
): BoxRecord {
  const [depth, width, height] = box.size;
  const turns = quarters.map((quarter): BoxRecord => {
    const heading = wrapped(headingOf(box) + (quarter * Math.PI) / 2);
    return { ...box, heading, size: quarter % 2 === 0 ? box.size : [width, depth, height] };
  });
  const gap = (turned: BoxRecord): number => {
    const back = add(floorPoint(turned), scale(direction(headingOf(turned)), -turned.size[0] / 2));
    const wall = nearestWall(scene.room, back);
    return wall === undefined ? 0 : distance(back, nearestOn(back, wall.segment));
  };
  return turns.reduce((best, one) => (gap(one) < gap(best) ? one : best));
}

/** A box whose front is a guess, turned so that it is as wide or as deep as its kind: no long sofa. */
export function asItsKind(state: State, box: BoxRecord): BoxRecord {
  if (box.front_from_wall !== true) return box;
  const usual = depthToWidth(usualSize(box.category, state.lists.categories));
  const own = depthToWidth(box.size);
  const differ = usual * own < 0 && Math.min(Math.abs(usual), Math.abs(own)) > NEARLY_SQUARE;
  return differ ? backed(state, box, [1, 3]) : box;
}

/** Who turns a thing where it stands has seen its front: it is no guess from the wall any more. */
export function seen(old: BoxRecord, box: BoxRecord): BoxRecord {
  const stayed = old.center[0] === box.center[0] && old.center[1] === box.center[1];
  if (!stayed || headingOf(old) === headingOf(box)) return box;
  return { ...box, front_known: true, front_from_wall: false };
}

function depthToWidth([depth, width]: Vector3): number {
  return Math.log(depth / width);
}
