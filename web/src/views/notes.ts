import { Group } from "three";
import type { Vector3 } from "../model/state";
import type { Eye } from "./part";
import { type TextLook, TextSprite } from "./text_sprite";

export interface Note {
  readonly text: string;
  readonly at: Vector3;
}

/** Short texts at places of the room; the sprites are used again and again. */
export class Notes {
  readonly root = new Group();
  readonly #sprites: TextSprite[] = [];

  show(notes: readonly Note[], look: TextLook): void {
    while (this.#sprites.length < notes.length) {
      const sprite = new TextSprite();
      this.#sprites.push(sprite);
      this.root.add(sprite);
    }
    this.#sprites.forEach((sprite, i) => {
      const note = notes[i];
      sprite.visible = note !== undefined;
      if (note) {
        sprite.position.set(...note.at);
        sprite.write(note.text, look);
      }
    });
  }

  fit(eye: Eye): void {
    for (const sprite of this.#sprites) {
      sprite.fit(eye);
    }
  }

  dispose(): void {
    for (const sprite of this.#sprites) {
      sprite.dispose();
    }
    this.root.removeFromParent();
  }
}
