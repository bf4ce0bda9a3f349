/** Doors and windows as they are drawn: a stretch of the wall that the drag begins at. */
import { editOpening } from "./editing";
import { add, along, between, distance, scale } from "./geometry";
import { freeId, type OpeningKind, openingsOf } from "./scenes";
import type { Draft, Point, State } from "./state";
import { nearestWall, onWall } from "./walls";

/** A door or window drawn shorter than this was a click: it gets the usual width, metres. */
const MIN_OPENING = 0.2;
/** Usual doors and windows, metres: width, and from where to where above the floor. */
const USUAL = {
  door: { width: 0.9, bottom: 0, top: 2.0 },
  window: { width: 1.2, bottom: 0.9, top: 2.1 },
} as const;

/** The point on the wall nearest to `near`, at the height of `at` along it. */
export function onNearestWall(state: State, at: Point, near: Point): Point {
  const wall = nearestWall(state.scene.room, near);
  if (wall === undefined) return at;
  return add(wall.segment[0], scale(wall.along, along(at, wall.segment) * wall.length));
}

/** The drawn door or window as part of the room, selected. */
export function finishOpening(state: State, draft: Draft & { readonly kind: "opening" }): State {
  const kind: OpeningKind = draft.opening;
  const usual = USUAL[kind];
  const wall = nearestWall(state.scene.room, draft.start);
  if (wall === undefined) return { ...state, draft: null };
  const drawn = distance(draft.start, draft.end);
  const middle = drawn < MIN_OPENING ? draft.start : between(draft.start, draft.end, 0.5);
  const opening = onWall(
    {
      id: freeId(kind, openingsOf(state.scene.room, kind)),
      start: draft.start,
      end: draft.end,
      bottom: usual.bottom,
      top: Math.min(usual.top, state.scene.room.height),
    },
    wall,
    along(middle, wall.segment) * wall.length,
    drawn < MIN_OPENING ? usual.width : drawn,
  );
  const next = editOpening({ ...state, draft: null, tool: "select" }, kind, opening, true);
  return { ...next, selection: { kind, id: opening.id } };
}
