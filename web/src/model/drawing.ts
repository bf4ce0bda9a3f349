/** What a pointer on the floor draws: the outline of a room, boxes, doors and windows. */
import type { BoxRecord, OpeningRecord } from "../net/protocol.gen";
import { addBox } from "./editing";
import { backed } from "./fronts";
import {
  add,
  angleOf,
  between,
  direction,
  distance,
  dot,
  leftOf,
  length,
  rounded,
  roundedPoint,
  scale,
  subtract,
  wrapped,
} from "./geometry";
import { edited } from "./history";
import { emptyScene } from "./initial";
import { likelyCategories } from "./labels";
import { refused } from "./notices";
import { finishOpening, onNearestWall } from "./openings";
import { anticlockwise, assisted, outlineProblem, withNextCorner } from "./outlines";
import { freeId } from "./scenes";
import { snapPoint } from "./snapping";
import type { Draft, Point, State, Tool } from "./state";
import { headingFromWall, snappedToWall } from "./walls";

/** A box drawn with a shorter side was a slip, metres. */
const MIN_SIDE = 0.05;
const TOO_THIN =
  "Drag from one corner of the thing to the opposite one. With Alt held it does not snap.";
/** The height that is offered first for a drawn box: a table's, metres. */
const FIRST_HEIGHT = 0.75;
/** Doors and windows this near to a redrawn wall stay, metres. */
const STAYS = 0.3;

export function chooseTool(state: State, tool: Tool): State {
  return { ...state, tool, draft: tool === "room" ? blankOutline() : null };
}

/** A bare room in place of this one, and the tool to draw its outline. */
export function newRoom(state: State): State {
  const opened = edited(state, emptyScene(`room-${state.nextId}`), true);
  return chooseTool({ ...opened, nextId: state.nextId + 1, selection: null }, "room");
}

export function drawDown(state: State, at: Point, free: boolean): State {
  const { draft } = state;
  if (draft?.kind === "box-height") return finishBox(state, draft.box);
  switch (state.tool) {
    case "select":
      return state;
    case "room":
      return drawMove(state, at, free);
    case "box": {
      const start = snapped(state, at, free);
      const heading = free ? 0 : headingFromWall(state.scene.room, start);
      return {
        ...state,
        selection: null,
        draft: { kind: "box-floor", start, end: start, heading },
      };
    }
    case "door":
    case "window": {
      const start = onNearestWall(state, at, at);
      return { ...state, draft: { kind: "opening", opening: state.tool, start, end: start } };
    }
  }
}

export function drawMove(state: State, at: Point, free: boolean): State {
  const { draft } = state;
  if (draft === null) return state;
  switch (draft.kind) {
    case "room":
      return { ...state, draft: { ...draft, pointer: assisted(draft.corners, at, free) } };
    case "box-floor": {
      const end = snapped(state, at, free);
      return {
        ...state,
        draft: { ...draft, end: draft.side ? across(draft, draft.side, end) : end },
      };
    }
    case "box-height":
      return state;
    case "opening":
      return { ...state, draft: { ...draft, end: onNearestWall(state, at, draft.start) } };
  }
}

export function drawUp(state: State, at: Point, free: boolean): State {
  const moved = drawMove(state, at, free);
  const { draft } = moved;
  if (draft === null) return moved;
  switch (draft.kind) {
    case "room":
      return addCorner(moved, draft);
    case "box-floor": {
      const box = draftBox(moved, draft);
      const thin = Math.min(box.size[0], box.size[1]) < MIN_SIDE;
      return thin
        ? refused({ ...moved, draft: null }, TOO_THIN)
        : { ...moved, draft: { kind: "box-height", box: draft.side ? backed(moved, box) : box } };
    }
    case "box-height":
      return moved;
    case "opening":
      return finishOpening(moved, draft);
  }
}

/** The side from the first corner to here, however it is turned; the next point gives the depth. */
export function drawSide(state: State, at: Point, free: boolean): State {
  const { draft, scene } = state;
  if (draft?.kind !== "box-floor") return state;
  const side = snapped(state, at, free);
  const run = subtract(side, draft.start);
  if (length(run) < MIN_SIDE) return refused(state, "That is the same corner. Mark the next one.");
  const back = headingFromWall(scene.room, between(draft.start, side, 0.5));
  const heading = wrapped(angleOf(run) + quarterTurns(back - angleOf(run)));
  return { ...state, draft: { ...draft, side, end: side, heading } };
}

/** The height of the drawn box, metres; `done` makes it part of the scene. */
export function drawHeight(state: State, height: number, done: boolean): State {
  if (state.draft?.kind !== "box-height") return state;
  const { box } = state.draft;
  const tall = rounded(Math.min(Math.max(height, MIN_SIDE), state.scene.room.height));
  const next: BoxRecord = {
    ...box,
    size: [box.size[0], box.size[1], tall],
    center: [box.center[0], box.center[1], tall / 2],
  };
  if (done) return finishBox(state, next);
  return { ...state, draft: { kind: "box-height", box: next } };
}

/** The outline becomes the room, if it is one; doors and windows stay where there is a wall. */
export function closeOutline(state: State): State {
  if (state.draft?.kind !== "room") return state;
  const problem = outlineProblem(state.draft.corners);
  if (problem !== null) return refused(state, problem);
  const { room } = state.scene;
  const bare = { ...room, corners: anticlockwise(state.draft.corners) };
  const stay = (openings: readonly OpeningRecord[]): readonly OpeningRecord[] =>
    openings
      .map((opening) => ({ opening, moved: snappedToWall(bare, opening) }))
      .filter(({ opening, moved }) => distance(middleOf(opening), middleOf(moved)) < STAYS)
      .map(({ moved }) => moved);
  const outlined = { ...bare, doors: stay(room.doors), windows: stay(room.windows) };
  // In the real room what stands there is marked next.
  const tool = state.ar !== null && state.scene.boxes.length === 0 ? "box" : "select";
  return edited({ ...state, draft: null, tool }, { ...state.scene, room: outlined }, true);
}

export function removeLastCorner(state: State): State {
  if (state.draft?.kind !== "room") return state;
  return { ...state, draft: { ...state.draft, corners: state.draft.corners.slice(0, -1) } };
}

/** The box over the rectangle between two opposite corners, its sides along the heading. */
export function draftBox(state: State, draft: Draft & { readonly kind: "box-floor" }): BoxRecord {
  const ahead = direction(draft.heading);
  const diagonal = subtract(draft.end, draft.start);
  const middle = between(draft.start, draft.end, 0.5);
  return {
    id: freeId("box", state.scene.boxes),
    category: "Other",
    center: [rounded(middle[0]), rounded(middle[1]), FIRST_HEIGHT / 2],
    size: [
      rounded(Math.abs(dot(diagonal, ahead))),
      rounded(Math.abs(dot(diagonal, leftOf(ahead)))),
      FIRST_HEIGHT,
    ],
    heading: draft.heading,
    front_from_wall: true,
  };
}

/** The corner across from the first: beyond the other end of the side, as far as the point is. */
function across(draft: { readonly start: Point }, side: Point, at: Point): Point {
  const run = subtract(side, draft.start);
  const out = leftOf(scale(run, 1 / length(run)));
  return roundedPoint(add(side, scale(out, dot(subtract(at, side), out))));
}

/** The whole right angles nearest to an angle, radians. */
function quarterTurns(angle: number): number {
  return Math.round(angle / (Math.PI / 2)) * (Math.PI / 2);
}

/**
 * The point on what it snaps to. What is marked by three corners stands as it likes: a chair that
 * is pulled askew under a table is near to its edge but not at it, so only the walls count.
 */
function snapped({ scene, ar }: State, at: Point, free: boolean): Point {
  return snapPoint(ar?.marks === 3 ? { ...scene, boxes: [] } : scene, at, free);
}

function blankOutline(): Draft {
  return { kind: "room", corners: [], pointer: null };
}

function addCorner(state: State, draft: Draft & { readonly kind: "room" }): State {
  const corner = draft.pointer;
  if (corner === null) return state;
  if (draft.corners.length >= 3 && corner === draft.corners[0]) return closeOutline(state);
  const corners = withNextCorner(draft.corners, corner);
  if (corners === null) return state;
  if (typeof corners === "string") return refused(state, corners);
  return { ...state, draft: { ...draft, corners } };
}

function finishBox(state: State, box: BoxRecord): State {
  const [category = "Other"] = likelyCategories(box.size, state.lists.categories);
  // In the real room one thing after the other is marked.
  const tool = state.ar === null ? "select" : "box";
  const next = addBox({ ...state, draft: null, tool }, { ...box, category });
  if (next.scene === state.scene) return next;
  return { ...next, selection: { kind: "box", id: box.id } };
}

function middleOf(opening: OpeningRecord): Point {
  return between(opening.start, opening.end, 0.5);
}
