import { Group } from "three";
import { topOf } from "../model/footprints";
import type { State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { hideOverlaps, type LabelBox } from "./label_layout";
import { categoryColor, type Look } from "./palette";
import type { Eye, Part } from "./part";
import { layOut, type SpriteLabel, spriteLabel } from "./sprite_labels";

const ABOVE = 0.12; // metres over the top

/** The names of the furniture; what is selected has its lengths instead, covered names are left out. */
export class LabelsView implements Part {
  readonly root = new Group();
  readonly #labels = new Map<string, SpriteLabel>();
  readonly #taken: readonly (readonly LabelBox[])[];
  #order: SpriteLabel[] = [];
  #look: Look;
  #boxes: readonly BoxRecord[] | null = null;
  #selected: string | null = null;
  #on = false;

  /** `taken` is where other texts are, which names make way for. */
  constructor(look: Look, taken: readonly (readonly LabelBox[])[]) {
    this.#look = look;
    this.#taken = taken;
  }

  relight(look: Look): void {
    this.#look = look;
    this.#boxes = null;
  }

  show(state: State): void {
    this.#on = state.shown.labels && state.draft === null;
    this.root.visible = this.#on;
    const selected = state.selection?.kind === "box" ? state.selection.id : null;
    if (state.scene.boxes === this.#boxes && selected === this.#selected) {
      return;
    }
    this.#boxes = state.scene.boxes;
    this.#selected = selected;
    const others = this.#boxes.filter(({ id }) => id !== selected);
    this.#removeOld(new Set(others.map(({ id }) => id)));
    this.#order = biggestFirst(others).map((box) => this.#write(box));
  }

  update(eye: Eye): boolean {
    if (!this.#on) {
      return false;
    }
    for (const label of this.#order) {
      layOut(label, eye);
    }
    hideOverlaps(this.#order, this.#taken);
    for (const label of this.#order) {
      label.sprite.visible = label.shown;
    }
    return false;
  }

  dispose(): void {
    this.#removeOld(new Set());
  }

  #write(box: BoxRecord): SpriteLabel {
    const label = this.#labels.get(box.id) ?? this.#add(box.id);
    label.sprite.position.set(box.center[0], box.center[1], topOf(box) + ABOVE);
    label.sprite.write(box.label || box.category, {
      size: 12,
      color: this.#look.labelText,
      background: this.#look.label,
      chip: categoryColor(box.category),
    });
    return label;
  }

  #add(id: string): SpriteLabel {
    const label = spriteLabel();
    this.#labels.set(id, label);
    this.root.add(label.sprite);
    return label;
  }

  #removeOld(kept: ReadonlySet<string>): void {
    for (const [id, { sprite }] of this.#labels) {
      if (!kept.has(id)) {
        sprite.dispose();
        this.#labels.delete(id);
      }
    }
  }
}

function biggestFirst(boxes: readonly BoxRecord[]): readonly BoxRecord[] {
  const volume = ({ size }: BoxRecord) => size[0] * size[1] * size[2];
  return boxes.toSorted((a, b) => volume(b) - volume(a));
}
