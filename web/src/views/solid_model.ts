import { Color, Group, type Material, Mesh, MeshStandardMaterial } from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";
import { headingOf } from "../model/footprints";
import type { BoxRecord } from "../net/protocol.gen";
import { categoryColor } from "./palette";
import type { Solid } from "./solids";

const ROUNDING = 0.05; // metres
const PALE = new Color("#f3ece1"); // what placeholders are mixed with

/** How a material is shown: as it is, or changed (and then owned by whoever changed it). */
export type Finish = (material: Material) => Material;

const AS_IT_IS: Finish = (material) => material;

/**
 * What stands in a box: its model stretched to fill it, or a rounded block until that is here.
 * The old model stays, stretched, while a new one is on its way.
 */
export class SolidModel {
  readonly root = new Group();
  readonly #finish: Finish;
  /** When it is drawn, among what is translucent. */
  readonly #order: number;
  readonly #body = new Group();
  #solid: Solid | null = null;
  #block: Mesh<RoundedBoxGeometry, MeshStandardMaterial> | null = null;
  #blockSize = "";

  constructor(finish: Finish = AS_IT_IS, order = 0) {
    this.#finish = finish;
    this.#order = order;
    this.root.add(this.#body);
  }

  show(box: BoxRecord, solid: Solid | null): void {
    this.root.position.set(...box.center);
    this.root.rotation.z = headingOf(box);
    if (solid && solid !== this.#solid) {
      this.#fill(solid);
    }
    if (this.#solid) {
      this.#body.scale.set(...box.size);
    } else {
      this.#showBlock(box);
    }
  }

  dispose(): void {
    this.root.removeFromParent();
    this.#removeBlock();
    this.#body.clear();
  }

  #fill(solid: Solid): void {
    this.#removeBlock();
    this.#solid = solid;
    this.#body.clear();
    for (const { geometry, material } of solid) {
      const mesh = new Mesh(geometry, this.#finish(material));
      mesh.renderOrder = this.#order;
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      this.#body.add(mesh);
    }
  }

  #showBlock(box: BoxRecord): void {
    const size = box.size.join();
    if (size === this.#blockSize) {
      return;
    }
    this.#removeBlock();
    this.#blockSize = size;
    const [depth, width, height] = box.size;
    const rounding = Math.min(ROUNDING, Math.min(depth, width, height) / 4);
    const material = new MeshStandardMaterial({
      color: categoryColor(box.category),
      roughness: 0.8,
    });
    material.color.lerp(PALE, 0.45);
    const shown = this.#finish(material) as MeshStandardMaterial;
    this.#block = new Mesh(new RoundedBoxGeometry(depth, width, height, 3, rounding), shown);
    this.#block.renderOrder = this.#order;
    this.#block.castShadow = true;
    this.#block.receiveShadow = true;
    this.root.add(this.#block);
  }

  #removeBlock(): void {
    this.#block?.removeFromParent();
    this.#block?.geometry.dispose();
    this.#block?.material.dispose();
    this.#block = null;
    this.#blockSize = "";
  }
}
