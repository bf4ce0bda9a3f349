import { Group, Vector3 } from "three";
import { hangs, turnedTo } from "../model/hanging";
import type { State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { BoxLines } from "./box_lines";
import { ContactShadows } from "./contact_shadows";
import { SIDEWAYS } from "./framing";
import { ACCENT, categoryColor } from "./palette";
import type { Eye, Part } from "./part";
import { SolidModel } from "./solid_model";
import type { Solids } from "./solids";

const MAX_SHADOWS = 512; // boxes; a scene has at most 500

interface Piece {
  readonly model: SolidModel;
  box: BoxRecord;
  digest: string | undefined;
  complete: boolean;
}

/** Everything that stands in the room, really or placed; outlines on what is meant. */
export class FurnitureView implements Part {
  readonly root = new Group();
  readonly #solids: Solids;
  readonly #pieces = new Map<string, Piece>();
  readonly #shadows = new ContactShadows(MAX_SHADOWS);
  readonly #selected = new BoxLines();
  readonly #hovered = new BoxLines();
  readonly #eye = new Vector3();
  readonly #place: [number, number, number] = [0, 0, 0];
  #hung: readonly Piece[] = [];
  #plan = false;
  /** Whether what is really there is seen through the camera. */
  #real = false;
  #state: State | null = null;
  #boxes: readonly BoxRecord[] | null = null;
  #hover: string | null = null;

  constructor(solids: Solids) {
    this.#solids = solids;
    this.root.add(this.#shadows.mesh, this.#selected.root, this.#hovered.root);
  }

  show(state: State): void {
    this.#state = state;
    const { boxes } = state.scene;
    const real = state.ar !== null;
    if (boxes !== this.#boxes || real !== this.#real) {
      this.#boxes = boxes;
      this.#real = real;
      this.#removeOld(new Set(boxes.map(({ id }) => id)));
      this.#shadows.show(real ? boxes.filter(({ placed }) => placed) : boxes);
    }
    for (const box of boxes) {
      this.#showBox(box, state.models[box.id]);
    }
    for (const { box, model } of this.#pieces.values()) {
      model.root.visible = !real || box.placed === true;
    }
    this.#plan = state.shown.camera !== "orbit" || real;
    this.#hung = [...this.#pieces.values()].filter(({ box }) => hangs(box, state.scene));
    this.#outline(state);
  }

  /** What hangs on a wall that is out of sight would show its back: it goes with the wall. */
  update(eye: Eye): boolean {
    this.#eye.setFromMatrixPosition(eye.camera.matrixWorld);
    this.root.worldToLocal(this.#eye).toArray(this.#place);
    for (const { box, model } of this.#hung) {
      const real = this.#real && box.placed !== true;
      model.root.visible = !real && (this.#plan || turnedTo(box, this.#place) > SIDEWAYS);
    }
    return false;
  }

  /** Which box the pointer is over. */
  hover(id: string | null): void {
    this.#hover = id;
    if (this.#state) {
      this.#outline(this.#state);
    }
  }

  dispose(): void {
    this.#removeOld(new Set());
    this.#shadows.dispose();
    this.#selected.dispose();
    this.#hovered.dispose();
  }

  #showBox(box: BoxRecord, digest: string | undefined): void {
    const piece = this.#pieces.get(box.id) ?? this.#add(box);
    if (piece.box === box && piece.digest === digest && piece.complete) {
      return;
    }
    const solid = digest === undefined ? null : this.#solids.get(digest);
    piece.model.show(box, solid);
    piece.box = box;
    piece.digest = digest;
    piece.complete = solid !== null;
  }

  #add(box: BoxRecord): Piece {
    const piece = { model: new SolidModel(), box, digest: undefined, complete: false };
    this.#pieces.set(box.id, piece);
    this.root.add(piece.model.root);
    return piece;
  }

  #removeOld(kept: ReadonlySet<string>): void {
    for (const [id, piece] of this.#pieces) {
      if (!kept.has(id)) {
        piece.model.dispose();
        this.#pieces.delete(id);
      }
    }
  }

  #outline(state: State): void {
    const { selection, scene } = state;
    const selected = selection?.kind === "box" ? selection.id : null;
    const chosen = scene.boxes.find(({ id }) => id === selected);
    const under = scene.boxes.find(({ id }) => id === this.#hover && id !== selected);
    show(this.#selected, chosen, 2.5, 0.16);
    show(this.#hovered, under, 1.5, 0);
  }
}

function show(lines: BoxLines, box: BoxRecord | undefined, width: number, fill: number): void {
  if (!box) {
    lines.hide();
    return;
  }
  const color = box.placed ? ACCENT : categoryColor(box.category);
  lines.show(box, { color, width, dashed: !box.placed, fill });
}
