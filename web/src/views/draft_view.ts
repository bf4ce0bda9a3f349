import { Group } from "three";
import { draftBox } from "../model/drawing";
import { angleOf, direction, leftOf, type Segment, scale, subtract } from "../model/geometry";
import type { Draft, Point, State, Vector3 } from "../model/state";
import { BoxLines } from "./box_lines";
import type { LabelBox } from "./label_layout";
import { notesOf } from "./measures";
import { Notes } from "./notes";
import { ACCENT, type Look } from "./palette";
import type { Eye, Part } from "./part";
import { Strokes } from "./strokes";

const ABOVE = 0.012; // metres over the floor
const SQUARE = 0.16; // side of the mark of a right angle, metres
const STRAIGHT = 0.01; // how far from square still counts, sine of the angle

/** What is being drawn, the lines it snaps to, and lengths: of it, or of what is selected. */
export class DraftView implements Part {
  readonly root = new Group();
  readonly #outline = new Strokes({ color: ACCENT, width: 3 });
  readonly #band = new Strokes({ color: ACCENT, width: 2, dash: [0.1, 0.07] });
  readonly #guides = new Strokes({ color: "#e6399b", width: 1.25 });
  readonly #box = new BoxLines();
  readonly #notes = new Notes();
  readonly #taken: readonly (readonly LabelBox[])[];
  #look: Look;

  /** `taken` is where the handles are, which lengths make way for. */
  constructor(look: Look, taken: readonly (readonly LabelBox[])[]) {
    this.#look = look;
    this.#taken = taken;
    this.root.add(
      this.#outline.root,
      this.#band.root,
      this.#guides.root,
      this.#box.root,
      this.#notes.root,
    );
  }

  relight(look: Look): void {
    this.#look = look;
  }

  show(state: State): void {
    this.#showDraft(state, state.draft);
    this.#notes.show(notesOf(state), {
      size: 13,
      bold: true,
      color: this.#look.labelText,
      background: this.#look.label,
    });
  }

  /** The lines on the floor that what is being dragged has snapped to. */
  guide(guides: readonly Segment[]): void {
    this.#guides.show(guides.flat().map(onFloor));
  }

  update(eye: Eye): boolean {
    this.#notes.fit(eye, this.#taken);
    return false;
  }

  dispose(): void {
    for (const part of [this.#outline, this.#band, this.#guides, this.#box, this.#notes]) {
      part.dispose();
    }
  }

  #showDraft(state: State, draft: Draft | null): void {
    this.#outline.show(draft ? wholeLines(draft) : []);
    this.#band.show(draft?.kind === "room" ? bandOf(draft.corners, draft.pointer) : []);
    const box = draft && draftedBox(state, draft);
    if (box) {
      this.#box.show(box, { color: ACCENT, width: 2.5, dashed: false, fill: 0.22 });
    } else {
      this.#box.hide();
    }
  }
}

function draftedBox(state: State, draft: Draft) {
  switch (draft.kind) {
    case "room":
    case "opening":
      return null;
    case "box-height":
      return draft.box;
    case "box-floor": {
      const box = draftBox(state, draft);
      const flat = 0.004;
      return {
        ...box,
        center: [box.center[0], box.center[1], flat / 2 + ABOVE] as const,
        size: [box.size[0], box.size[1], flat] as const,
      };
    }
  }
}

function onFloor([x, y]: Point): Vector3 {
  return [x, y, ABOVE];
}

function wholeLines(draft: Draft): readonly Vector3[] {
  switch (draft.kind) {
    case "room":
      return draft.corners.flatMap((corner, i) => {
        const next = draft.corners[i + 1];
        return next ? [onFloor(corner), onFloor(next)] : [];
      });
    case "opening":
      return [onFloor(draft.start), onFloor(draft.end)];
    case "box-floor":
    case "box-height":
      return [];
  }
}

/** From the last corner to the pointer; a little square where it turns by a right angle. */
function bandOf(corners: readonly Point[], pointer: Point | null): readonly Vector3[] {
  const last = corners.at(-1);
  if (!last || !pointer) {
    return [];
  }
  return [onFloor(last), onFloor(pointer), ...squareMark(corners.at(-2), last, pointer)];
}

function squareMark(before: Point | undefined, corner: Point, after: Point): readonly Vector3[] {
  if (!before) {
    return [];
  }
  const back = direction(angleOf(subtract(before, corner)));
  const ahead = direction(angleOf(subtract(after, corner)));
  const side = leftOf(back);
  const square = Math.abs(back[0] * ahead[0] + back[1] * ahead[1]) < STRAIGHT;
  if (!square) {
    return [];
  }
  const turn = Math.sign(side[0] * ahead[0] + side[1] * ahead[1]);
  const at = (u: number, v: number): Vector3 => {
    const [bx, by] = scale(back, u * SQUARE);
    const [sx, sy] = scale(side, v * turn * SQUARE);
    return onFloor([corner[0] + bx + sx, corner[1] + by + sy]);
  };
  return [at(1, 0), at(1, 1), at(1, 1), at(0, 1)];
}
