/** Boxes, doors, windows and corners changed, moved, turned, doubled and taken away. */
import {
  type BoxRecord,
  MAX_BOXES,
  type OpeningRecord,
  type RoomRecord,
  type SceneRecord,
} from "../net/protocol.gen";
import { loadOf, taken } from "./carrying";
import { floorPoint, headingOf, isOver, movedTo } from "./footprints";
import { asItsKind, seen } from "./fronts";
import { add, direction, leftOf, roundedPoint, scale, wrapped } from "./geometry";
import { edited } from "./history";
import { nameOf } from "./labels";
import { notified, refused } from "./notices";
import { outlineProblem } from "./outlines";
import {
  boxOf,
  freeId,
  type OpeningKind,
  openingsOf,
  withBox,
  withBoxes,
  withOpening,
  withoutBoxes,
  withoutOpening,
} from "./scenes";
import { selectedBox } from "./selecting";
import type { Point, State } from "./state";
import { snappedToWall, withCorners } from "./walls";

/** A copy stands this far beside the original, beyond its width, metres. */
const BESIDE = 0.1;

/** A box changed, or a new one; one that is gone in the middle of a drag stays gone. */
export function editBox(state: State, box: BoxRecord, done: boolean): State {
  const old = boxOf(state.scene, box.id);
  if (old === undefined) return done ? addBox(state, box) : state;
  const now = box.category === old.category ? seen(old, box) : asItsKind(state, box);
  const scene = withBox(state.scene, letGo(state.scene, now));
  return edited(state, withBoxes(scene, along(state, now)), done);
}

export function addBox(state: State, box: BoxRecord): State {
  if (state.scene.boxes.length >= MAX_BOXES) {
    return refused(state, `A room holds ${MAX_BOXES} things at most. Remove some first.`);
  }
  return edited(state, withBox(state.scene, box), true);
}

/** Whoever takes a thing away from what it stood on has taken it off. */
function letGo(scene: SceneRecord, box: BoxRecord): BoxRecord {
  const parent = box.parent ? boxOf(scene, box.parent) : undefined;
  return parent === undefined || isOver(parent, floorPoint(box)) ? box : { ...box, parent: null };
}

/** What a box carried when it was last at rest, as it is now that the box is another. */
function along({ scene, beforeDrag }: State, box: BoxRecord): readonly BoxRecord[] {
  const rest = beforeDrag ?? scene;
  const from = boxOf(rest, box.id);
  if (from === undefined) return [];
  const load = loadOf(rest, from).filter(({ id }) => boxOf(scene, id) !== undefined);
  return taken(load, from, box);
}

/** The room changed from a panel (height, kind, a typed length); refused if it is no room. */
export function editRoom(state: State, room: RoomRecord, done: boolean): State {
  const problem = outlineProblem(room.corners);
  if (problem !== null) return refused(state, problem);
  return edited(state, { ...state.scene, room }, done);
}

export function editOpening(
  state: State,
  kind: OpeningKind,
  value: OpeningRecord,
  done: boolean,
): State {
  const { room } = state.scene;
  const opening = snappedToWall(room, value);
  return edited(state, { ...state.scene, room: withOpening(room, kind, opening) }, done);
}

/** The corner where it was dragged; it stays where it was while the walls would cross. */
export function moveCorner(state: State, index: number, to: Point, done: boolean): State {
  const { room } = state.scene;
  const corners = room.corners.map((corner, i) => (i === index ? roundedPoint(to) : corner));
  const problem = outlineProblem(corners);
  if (problem === null) {
    return edited(state, { ...state.scene, room: withCorners(room, corners) }, done);
  }
  const closed = edited(state, state.scene, done);
  return done ? refused(closed, problem) : closed;
}

/** What is selected, moved by metres. */
export function nudge(state: State, by: Point): State {
  const { selection, scene } = state;
  if (selection === null) return state;
  switch (selection.kind) {
    case "box": {
      const box = boxOf(scene, selection.id);
      if (box === undefined) return state;
      return editBox(state, movedTo(box, roundedPoint(add(floorPoint(box), by))), true);
    }
    case "door":
    case "window": {
      const opening = openingsOf(scene.room, selection.kind).find(({ id }) => id === selection.id);
      if (opening === undefined) return state;
      const moved = { ...opening, start: add(opening.start, by), end: add(opening.end, by) };
      return editOpening(state, selection.kind, moved, true);
    }
    case "corner": {
      const corner = scene.room.corners[selection.index];
      return corner === undefined
        ? state
        : moveCorner(state, selection.index, add(corner, by), true);
    }
  }
}

/** The selected box turned by radians, anticlockwise. */
export function turn(state: State, by: number): State {
  const box = selectedBox(state);
  if (box === undefined) return state;
  return editBox(state, { ...box, heading: wrapped(headingOf(box) + by) }, true);
}

export function deleteSelected(state: State): State {
  const { selection, scene } = state;
  if (selection === null) return state;
  switch (selection.kind) {
    case "box":
      return removeBox(state, selection.id);
    case "door":
    case "window": {
      const room = withoutOpening(scene.room, selection.kind, selection.id);
      return edited(state, { ...scene, room }, true);
    }
    case "corner":
      return deleteCorner(state, selection.index);
  }
}

/** The box gone, and what stands on it with it. */
export function removeBox(state: State, id: string): State {
  const box = boxOf(state.scene, id);
  if (box === undefined) return state;
  const load = loadOf(state.scene, box);
  const gone = [id, ...load.map((other) => other.id)];
  const next = edited(state, withoutBoxes(state.scene, gone), true);
  const [first] = load;
  if (first === undefined) return next;
  return load.length === 1
    ? notified(next, "info", `With it went ${nameOf(first)}. Undo brings both back.`)
    : notified(next, "info", `With it went the ${load.length} things on it. Undo brings all back.`);
}

/** The same on somebody's advice: what went is said. */
export function takeAway(state: State, id: string): State {
  const box = boxOf(state.scene, id);
  const next = removeBox(state, id);
  if (box === undefined || next.notice !== state.notice) return next;
  return notified(next, "info", `Without ${nameOf(box)} now. Undo brings it back.`);
}

/** The selected box once more, beside it; the copy is selected. */
export function duplicateSelected(state: State): State {
  const box = selectedBox(state);
  if (box === undefined) return state;
  const aside = scale(leftOf(direction(headingOf(box))), box.size[1] + BESIDE);
  const copy = {
    ...movedTo(box, roundedPoint(add(floorPoint(box), aside))),
    id: freeId("box", state.scene.boxes),
  };
  const next = addBox(state, copy);
  if (next.scene === state.scene) return next;
  return { ...next, selection: { kind: "box", id: copy.id } };
}

function deleteCorner(state: State, index: number): State {
  const { room } = state.scene;
  const corners = room.corners.filter((_, i) => i !== index);
  const problem = outlineProblem(corners);
  if (problem !== null) return refused(state, problem);
  const without = { ...room, corners };
  const next = {
    ...without,
    doors: room.doors.map((door) => snappedToWall(without, door)),
    windows: room.windows.map((window) => snappedToWall(without, window)),
  };
  return edited({ ...state, selection: null }, { ...state.scene, room: next }, true);
}
