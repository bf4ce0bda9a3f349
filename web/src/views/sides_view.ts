import { Group } from "three";
import { type Side, sidesOf } from "../model/sides";
import type { State } from "../model/state";
import type { RoomRecord } from "../net/protocol.gen";
import { coversAny, type LabelBox } from "./label_layout";
import type { Look } from "./palette";
import type { Eye, Part } from "./part";
import { layOut, type SpriteLabel, spriteLabel } from "./sprite_labels";

const WAYS = 8; // of the compass

/** Which wall is the north wall: the sides by name, while places are told by them. */
export class SidesView implements Part {
  readonly root = new Group();
  /** Where the names are on the screen; other texts make way for them. */
  readonly labels: readonly SpriteLabel[] = Array.from({ length: WAYS }, spriteLabel);
  readonly #taken: readonly (readonly LabelBox[])[];
  #look: Look;
  #room: RoomRecord | null = null;
  #sides: readonly Side[] = [];
  #on = false;

  /** `taken` is where texts are that the names make way for. */
  constructor(look: Look, taken: readonly (readonly LabelBox[])[]) {
    this.#look = look;
    this.#taken = taken;
    for (const { sprite } of this.labels) {
      this.root.add(sprite);
    }
  }

  relight(look: Look): void {
    this.#look = look;
    this.#room = null;
  }

  show({ scene, shown, placing }: State): void {
    this.#on = shown.labels && placing !== null;
    this.root.visible = this.#on;
    if (this.#on && scene.room !== this.#room) {
      this.#room = scene.room;
      this.#sides = sidesOf(scene.room);
      this.#write();
    }
    if (!this.#on) {
      for (const label of this.labels) {
        label.shown = false;
      }
    }
  }

  update(eye: Eye): boolean {
    if (!this.#on) {
      return false;
    }
    for (let i = 0; i < this.labels.length; i++) {
      const label = this.labels[i];
      const side = this.#sides[i];
      if (label) {
        label.shown = side !== undefined && this.#settle(label, side, eye);
        label.sprite.visible = label.shown;
      }
    }
    return false;
  }

  dispose(): void {
    for (const { sprite } of this.labels) {
      sprite.dispose();
    }
  }

  /** Moves the name along its wall to where it covers nothing; false if there is no such place. */
  #settle(label: SpriteLabel, { places }: Side, eye: Eye): boolean {
    for (const place of places) {
      label.sprite.position.set(place[0], place[1], 0);
      layOut(label, eye);
      if (!coversAny(label, this.#taken)) {
        return true;
      }
    }
    return false;
  }

  #write(): void {
    this.labels.forEach(({ sprite }, i) => {
      const side = this.#sides[i];
      if (side) {
        sprite.write(capital(side.name), {
          size: 11,
          bold: true,
          color: this.#look.labelText,
          background: this.#look.background,
        });
      }
    });
  }
}

function capital(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}
