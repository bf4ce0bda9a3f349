import { Group, Mesh, MeshBasicMaterial, RingGeometry } from "three";
import type { State } from "../model/state";
import type { Look } from "./palette";
import type { Eye, Part } from "./part";
import { TextSprite } from "./text_sprite";

const LIFT = 0.014; // metres over what the map lies on
const TEXT_LIFT = 0.2;

/** How likely the place under the pointer is. */
export class ProbeView implements Part {
  readonly root = new Group();
  readonly #ring = new Mesh(
    new RingGeometry(0.05, 0.065, 32),
    new MeshBasicMaterial({
      color: "#ffffff",
      transparent: true,
      depthWrite: false,
      toneMapped: false,
    }),
  );
  readonly #text = new TextSprite();
  #look: Look;

  constructor(look: Look) {
    this.#look = look;
    this.#ring.renderOrder = 4;
    this.root.add(this.#ring, this.#text);
    this.root.visible = false;
  }

  relight(look: Look): void {
    this.#look = look;
  }

  show({ probe, shown }: State): void {
    this.root.visible = probe !== null && shown.heat;
    if (!probe) {
      return;
    }
    const [x, y, z] = probe.at;
    this.#ring.position.set(x, y, z + LIFT);
    this.#ring.visible = probe.surface !== "walls";
    this.#text.position.set(x, y, z + TEXT_LIFT);
    const { likelihood } = probe;
    this.#text.write(likelihood === null ? "not here" : `${Math.round(likelihood * 100)} of 100`, {
      size: 12,
      color: this.#look.labelText,
      background: this.#look.label,
    });
  }

  update(eye: Eye): boolean {
    if (this.root.visible) {
      this.#text.fit(eye);
    }
    return false;
  }

  dispose(): void {
    this.#ring.geometry.dispose();
    this.#ring.material.dispose();
    this.#text.dispose();
  }
}
