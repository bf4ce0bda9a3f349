/** The lengths that are shown: where, and what they say. Pure; core frame, metres. */
import { draftBox } from "../model/drawing";
import { bottomOf, floorPoint, headingOf, topOf } from "../model/footprints";
import { add, between, direction, distance, leftOf, scale, sides } from "../model/geometry";
import type { Point, State, Vector3 } from "../model/state";
import { formatLength } from "../model/units";
import type { BoxRecord, OpeningRecord } from "../net/protocol.gen";
import type { Note } from "./notes";

const ABOVE = 0.03; // metres over the floor
const CLEAR = 0.24; // metres from the sides of a box
const OVER = 0.5; // metres over the top of a box, above its handle

/** What has its lengths shown: what is being drawn, else what is selected. */
export function notesOf(state: State): readonly Note[] {
  const { draft, selection, scene } = state;
  switch (draft?.kind) {
    case "room":
      return outlineNotes(draft.pointer ? [...draft.corners, draft.pointer] : draft.corners, false);
    case "box-floor":
      return sideNotes(draftBox(state, draft));
    case "box-height":
      return boxNotes(draft.box);
    case "opening":
      return [lengthNote(draft.start, draft.end, 1)];
    case undefined:
      break;
  }
  switch (selection?.kind) {
    case undefined:
      return [];
    case "box": {
      const box = scene.boxes.find(({ id }) => id === selection.id);
      return box ? boxNotes(box) : [];
    }
    case "corner":
      return outlineNotes(scene.room.corners, true);
    case "door":
    case "window": {
      const openings = selection.kind === "door" ? scene.room.doors : scene.room.windows;
      const opening = openings.find(({ id }) => id === selection.id);
      return opening ? [openingNote(opening)] : [];
    }
  }
}

function outlineNotes(corners: readonly Point[], closed: boolean): readonly Note[] {
  const walls = sides(corners);
  return (closed ? walls : walls.slice(0, -1))
    .filter(([a, b]) => distance(a, b) > 0.05)
    .map(([a, b]) => lengthNote(a, b, ABOVE));
}

function lengthNote(a: Point, b: Point, height: number): Note {
  const [x, y] = between(a, b, 0.5);
  return { text: formatLength(distance(a, b)), at: [x, y, height] };
}

/** Width behind the box and depth on its right, clear of the handles. */
function sideNotes(box: BoxRecord): readonly Note[] {
  const ahead = direction(headingOf(box));
  const [depth, width] = box.size;
  const beside = (toward: Point, reach: number): Vector3 => {
    const [x, y] = add(floorPoint(box), scale(toward, reach + CLEAR));
    return [x, y, bottomOf(box) + ABOVE];
  };
  return [
    { text: formatLength(width), at: beside(scale(ahead, -1), depth / 2) },
    { text: formatLength(depth), at: beside(scale(leftOf(ahead), -1), width / 2) },
  ];
}

function boxNotes(box: BoxRecord): readonly Note[] {
  const over: Vector3 = [box.center[0], box.center[1], topOf(box) + OVER];
  return [{ text: formatLength(box.size[2]), at: over }, ...sideNotes(box)];
}

function openingNote({ start, end, bottom, top }: OpeningRecord): Note {
  return lengthNote(start, end, (bottom + top) / 2);
}
