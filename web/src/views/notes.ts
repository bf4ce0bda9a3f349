import { Group } from "three";
import type { Vector3 } from "../model/state";
import { coversAny, coversOne, type LabelBox, NOTHING } from "./label_layout";
import type { Eye } from "./part";
import { layOut, type SpriteLabel, spriteLabel } from "./sprite_labels";
import type { TextLook } from "./text_sprite";

export interface Note {
  readonly text: string;
  readonly at: Vector3;
}

/** Where a text goes that has no room at its place, in its widths and heights; the first first. */
const ASIDE = [
  [0, 0],
  [0, 1.2],
  [0, -1.2],
  [0.8, 0],
  [-0.8, 0],
  [0.8, 1.2],
  [-0.8, 1.2],
] as const;

/** Short texts at places of the room, the first ones first where they would cover one another. */
export class Notes {
  readonly root = new Group();
  readonly #labels: SpriteLabel[] = [];
  #shown: SpriteLabel[] = [];

  show(notes: readonly Note[], look: TextLook): void {
    while (this.#labels.length < notes.length) {
      const label = spriteLabel();
      this.#labels.push(label);
      this.root.add(label.sprite);
    }
    this.#labels.forEach(({ sprite }, i) => {
      const note = notes[i];
      sprite.visible = note !== undefined;
      if (note) {
        sprite.position.set(...note.at);
        sprite.write(note.text, look);
      }
    });
    this.#shown = this.#labels.slice(0, notes.length);
  }

  /** `taken` is where other things are, which notes make way for. */
  fit(eye: Eye, taken: readonly (readonly LabelBox[])[] = NOTHING): void {
    for (let i = 0; i < this.#shown.length; i++) {
      const label = this.#shown[i];
      if (label) {
        layOut(label, eye);
        label.sprite.visible = this.#settle(label, i, taken);
      }
    }
  }

  /** Moves the text aside until it covers nothing; false if it has to go. */
  #settle(label: SpriteLabel, before: number, taken: readonly (readonly LabelBox[])[]): boolean {
    const { x, y } = label;
    for (const [right, up] of ASIDE) {
      label.x = x + right * label.width;
      label.y = y + up * label.height;
      if (!coversOne(label, this.#shown, before) && !coversAny(label, taken)) {
        label.sprite.center.set(0.5 - right, 0.5 - up);
        label.shown = true;
        return true;
      }
    }
    label.shown = false;
    return false;
  }

  dispose(): void {
    for (const { sprite } of this.#labels) {
      sprite.dispose();
    }
    this.root.removeFromParent();
  }
}
