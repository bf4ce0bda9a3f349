import { BufferAttribute, BufferGeometry, Line, LineBasicMaterial } from "three";
import type { Ray } from "../views/picking";

const LENGTH = 2.5; // metres

/** Where a controller points. */
export class Beam {
  readonly root: Line<BufferGeometry, LineBasicMaterial>;
  readonly #ends = new BufferAttribute(new Float32Array(6), 3);

  constructor() {
    const geometry = new BufferGeometry().setAttribute("position", this.#ends);
    this.root = new Line(geometry, new LineBasicMaterial({ color: "#ffffff", toneMapped: false }));
    this.root.frustumCulled = false;
    this.root.visible = false;
  }

  show(ray: Ray | null): void {
    this.root.visible = ray !== null;
    if (ray === null) return;
    const [[x, y, z], [dx, dy, dz]] = [ray.origin, ray.direction];
    this.#ends.setXYZ(0, x, y, z);
    this.#ends.setXYZ(1, x + dx * LENGTH, y + dy * LENGTH, z + dz * LENGTH);
    this.#ends.needsUpdate = true;
  }

  dispose(): void {
    this.root.removeFromParent();
    this.root.geometry.dispose();
    this.root.material.dispose();
  }
}
