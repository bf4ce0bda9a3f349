import { Group } from "three";
import type { Vector3 } from "../model/state";
import { hideOverlaps, type LabelBox } from "./label_layout";
import type { Eye } from "./part";
import { layOut, type SpriteLabel, spriteLabel } from "./sprite_labels";
import type { TextLook } from "./text_sprite";

export interface Note {
  readonly text: string;
  readonly at: Vector3;
}

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
  fit(eye: Eye, taken?: readonly (readonly LabelBox[])[]): void {
    for (const label of this.#shown) {
      layOut(label, eye);
    }
    hideOverlaps(this.#shown, taken);
    for (const { sprite, shown } of this.#shown) {
      sprite.visible = shown;
    }
  }

  dispose(): void {
    for (const { sprite } of this.#labels) {
      sprite.dispose();
    }
    this.root.removeFromParent();
  }
}
