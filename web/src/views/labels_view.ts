import { Group, Vector3 } from "three";
import { topOf } from "../model/footprints";
import type { State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { hideOverlaps, type LabelBox } from "./label_layout";
import { categoryColor, type Look } from "./palette";
import { type Eye, metersPerPixel, type Part } from "./part";
import { TextSprite } from "./text_sprite";

const ABOVE = 0.12; // metres over the top

interface Label extends LabelBox {
  readonly sprite: TextSprite;
}

/** The names of the furniture; those that would cover others are left out. */
export class LabelsView implements Part {
  readonly root = new Group();
  readonly #labels = new Map<string, Label>();
  readonly #place = new Vector3();
  #order: Label[] = [];
  #look: Look;
  #boxes: readonly BoxRecord[] | null = null;
  #selected: string | null = null;
  #on = false;

  constructor(look: Look) {
    this.#look = look;
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
    this.#removeOld(new Set(this.#boxes.map(({ id }) => id)));
    this.#order = ranked(this.#boxes, selected).map((box) => this.#write(box, box.id === selected));
  }

  update(eye: Eye): boolean {
    if (!this.#on) {
      return false;
    }
    for (const label of this.#order) {
      label.sprite.getWorldPosition(this.#place);
      const scale = metersPerPixel(eye, this.#place);
      this.#place.project(eye.camera);
      // Half the height of the picture is one unit of y; x is stretched by the aspect.
      const aspect = eye.camera.projectionMatrix.elements;
      const stretch = (aspect[5] ?? 1) / (aspect[0] ?? 1);
      label.x = (this.#place.x * stretch * eye.pixels) / 2;
      label.y = (this.#place.y * eye.pixels) / 2;
      label.sprite.scale.set(label.width * scale, label.height * scale, 1);
    }
    hideOverlaps(this.#order);
    for (const label of this.#order) {
      label.sprite.visible = label.shown;
    }
    return false;
  }

  dispose(): void {
    this.#removeOld(new Set());
  }

  #write(box: BoxRecord, selected: boolean): Label {
    const label = this.#labels.get(box.id) ?? this.#add(box.id);
    label.sprite.position.set(box.center[0], box.center[1], topOf(box) + ABOVE);
    label.sprite.write(box.label || box.category, {
      size: selected ? 14 : 12,
      bold: selected,
      color: this.#look.labelText,
      background: this.#look.label,
      chip: categoryColor(box.category),
    });
    label.width = label.sprite.extent.width;
    label.height = label.sprite.extent.height;
    return label;
  }

  #add(id: string): Label {
    const sprite = new TextSprite();
    const label = { sprite, x: 0, y: 0, width: 0, height: 0, shown: true };
    this.#labels.set(id, label);
    this.root.add(sprite);
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

/** The selected first, then from the biggest to the smallest. */
function ranked(boxes: readonly BoxRecord[], selected: string | null): readonly BoxRecord[] {
  const weight = (box: BoxRecord) =>
    box.id === selected ? Number.POSITIVE_INFINITY : box.size[0] * box.size[1] * box.size[2];
  return boxes.toSorted((a, b) => weight(b) - weight(a));
}
