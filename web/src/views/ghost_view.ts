import { Group, type Material, MeshStandardMaterial } from "three";
import { ghostBox, shownRefusal } from "../model/ghost";
import { hangs } from "../model/hanging";
import type { Placing, State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { FloorArrow } from "./arrow";
import { BoxLines } from "./box_lines";
import { ContactShadows } from "./contact_shadows";
import { Glide } from "./glide";
import { ACCENT, FORBIDDEN } from "./palette";
import type { Eye, Part } from "./part";
import { SolidModel } from "./solid_model";
import type { Solids } from "./solids";

const OPACITY = 0.62;
const OVER_MAP = 3; // render order; the map shows through the ghost
const ARROW_GAP = 0.06; // metres before the front
const ABOVE_FLOOR = 0.012;

/** The object on its way into the room: translucent, with a crisp edge and the way it faces. */
export class GhostView implements Part {
  readonly root = new Group();
  readonly #solids: Solids;
  readonly #glide = new Glide();
  readonly #arrow = new FloorArrow();
  readonly #lines = new BoxLines();
  readonly #shadow = new ContactShadows(1);
  readonly #translucent = new Map<Material, Material>();
  #model: SolidModel | null = null;
  #category = "";
  #box: BoxRecord | null = null;

  constructor(solids: Solids) {
    this.#solids = solids;
    this.root.add(this.#arrow, this.#lines.root, this.#shadow.mesh);
    this.root.visible = false;
  }

  show(state: State): void {
    const { placing } = state;
    this.root.visible = placing?.pose != null;
    if (!placing?.pose) {
      this.#glide.reset();
      return;
    }
    if (!this.#model || placing.category !== this.#category) {
      this.#renew(placing);
    }
    this.#glide.to(placing.pose, placing.alternative === null);
    this.#box = ghostBox(state);
    const color = shownRefusal(state) === null ? ACCENT : FORBIDDEN;
    this.#arrow.material.color.set(color);
    if (this.#box) {
      this.#lines.show(this.#box, { color, width: 1.8, dashed: false, fill: 0.06 });
      this.#model?.show(this.#box, placing.asset ? this.#solids.get(placing.asset) : null);
      this.#shadow.show([this.#box]);
      this.#arrow.visible = !hangs(this.#box, state.scene);
    }
    this.#place();
  }

  update(eye: Eye): boolean {
    if (!this.root.visible || !this.#glide.advance(eye.elapsed)) {
      return false;
    }
    this.#place();
    return true;
  }

  dispose(): void {
    this.#model?.dispose();
    this.#lines.dispose();
    this.#arrow.dispose();
    this.#shadow.dispose();
    for (const material of this.#translucent.values()) {
      material.dispose();
    }
  }

  #renew(placing: Placing): void {
    this.#model?.dispose();
    this.#category = placing.category;
    this.#model = new SolidModel((material) => this.#translucentOf(material), OVER_MAP);
    this.root.add(this.#model.root);
  }

  #translucentOf(material: Material): Material {
    const known = this.#translucent.get(material);
    if (known) {
      return known;
    }
    const clear = material.clone();
    clear.transparent = true;
    clear.opacity = OPACITY;
    if (clear instanceof MeshStandardMaterial) {
      clear.emissive.set(ACCENT);
      clear.emissiveIntensity = 0.08;
    }
    this.#translucent.set(material, clear);
    return clear;
  }

  /** Moves everything to where the glide is. */
  #place(): void {
    const { center, heading } = this.#glide;
    const size = this.#box?.size;
    const ahead = (size?.[0] ?? 0) / 2 + ARROW_GAP;
    const floor = center.z - (size?.[2] ?? 0) / 2;
    this.#lines.root.position.set(center.x, center.y, center.z);
    this.#lines.root.rotation.z = heading;
    this.#model?.root.position.copy(this.#lines.root.position);
    this.#model?.root.rotation.copy(this.#lines.root.rotation);
    this.#arrow.rotation.z = heading;
    this.#arrow.position.set(
      center.x + Math.cos(heading) * ahead,
      center.y + Math.sin(heading) * ahead,
      (floor < 0.3 ? 0 : floor) + ABOVE_FLOOR,
    );
  }
}
