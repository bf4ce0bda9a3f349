import { DoubleSide, Group, Mesh, MeshBasicMaterial, RingGeometry } from "three";
import type { Vector3 } from "../model/state";

const RADIUS = 0.05; // metres for each metre of distance, so that it looks as big from everywhere
const LEAST = 0.03; // metres
const MOST = 0.2; // metres
const ABOVE = 0.008; // metres over the floor

/** The ring where the phone points. White in dark, to be seen on every floor. */
export class Reticle {
  readonly root = new Group();
  readonly #parts = [
    ring(0.72, 1.28, "#101010", 0.55, 9),
    ring(0.82, 1.18, "#ffffff", 1, 10),
    dot(),
  ];

  constructor() {
    this.root.add(...this.#parts);
    this.hide();
  }

  /**
   * Shows it at a place of the core frame, as far away as that is from the eye: on the floor, or on
   * the wall that faces along a heading.
   */
  show([x, y, z]: Vector3, distance: number, wall: number | null): void {
    this.root.visible = true;
    this.root.rotation.set(0, wall === null ? 0 : Math.PI / 2, wall ?? 0, "ZYX");
    const [out, up] = wall === null ? [0, ABOVE] : [ABOVE, 0];
    this.root.position.set(x + Math.cos(wall ?? 0) * out, y + Math.sin(wall ?? 0) * out, z + up);
    this.root.scale.setScalar(Math.min(Math.max(distance * RADIUS, LEAST), MOST));
  }

  hide(): void {
    this.root.visible = false;
  }

  dispose(): void {
    this.root.removeFromParent();
    for (const { geometry, material } of this.#parts) {
      geometry.dispose();
      material.dispose();
    }
  }
}

function ring(inner: number, outer: number, color: string, opacity: number, order: number) {
  return flat(new RingGeometry(inner, outer, 40), color, opacity, order);
}

function dot() {
  return flat(new RingGeometry(0, 0.14, 16), "#ffffff", 1, 10);
}

function flat(geometry: RingGeometry, color: string, opacity: number, order: number) {
  const material = new MeshBasicMaterial({
    color,
    opacity,
    transparent: true,
    depthTest: false,
    depthWrite: false,
    side: DoubleSide,
    forceSinglePass: true, // it is flat: two passes would renew its program every frame
    toneMapped: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = order;
  return mesh;
}
