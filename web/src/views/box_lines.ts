import { Group, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { headingOf } from "../model/footprints";
import type { BoxRecord } from "../net/protocol.gen";
import { Lines } from "./lines";

const DASH = 0.09; // metres
const SEGMENTS = 12; // edges of a box

export interface LineLook {
  readonly color: string;
  /** CSS pixels. */
  readonly width: number;
  /** Dashed means: really there. */
  readonly dashed: boolean;
  /** How much the footprint on the floor is filled, 0 to 1. */
  readonly fill: number;
  /** Of the lines; whole without. */
  readonly opacity?: number;
}

/** The edges of a box, and its footprint. */
export class BoxLines {
  readonly root = new Group();
  readonly #material = new LineMaterial({ dashSize: DASH, gapSize: DASH * 0.6, transparent: true });
  readonly #lines = new Lines(new LineSegmentsGeometry(), this.#material);
  readonly #footprint = new Mesh(
    new PlaneGeometry(1, 1),
    new MeshBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false }),
  );
  #size: BoxRecord["size"] | null = null;

  constructor() {
    this.#material.toneMapped = false;
    this.#lines.frustumCulled = false;
    this.#lines.renderOrder = 6;
    this.#footprint.renderOrder = 3;
    this.root.add(this.#lines, this.#footprint);
    this.root.visible = false;
  }

  show(box: BoxRecord, look: LineLook): void {
    this.root.visible = true;
    this.root.position.set(...box.center);
    this.root.rotation.z = headingOf(box);
    this.#material.color.set(look.color);
    this.#material.linewidth = look.width;
    this.#material.opacity = look.opacity ?? 1;
    this.#material.dashed = look.dashed;
    this.#footprint.material.color.set(look.color);
    this.#footprint.material.opacity = look.fill;
    this.#footprint.visible = look.fill > 0;
    this.#footprint.scale.set(box.size[0], box.size[1], 1);
    this.#footprint.position.z = -box.size[2] / 2 + 0.006;
    if (this.#size?.some((length, i) => length !== box.size[i]) ?? true) {
      this.#size = box.size;
      this.#rebuild(box.size);
    }
  }

  hide(): void {
    this.root.visible = false;
  }

  dispose(): void {
    this.root.removeFromParent();
    this.#lines.geometry.dispose();
    this.#material.dispose();
    this.#footprint.geometry.dispose();
    this.#footprint.material.dispose();
  }

  /** New edges: scaling old ones would stretch their dashes. */
  #rebuild(size: BoxRecord["size"]): void {
    this.#lines.geometry.dispose();
    this.#lines.geometry = new LineSegmentsGeometry().setPositions(edges(size));
    this.#lines.computeLineDistances();
  }
}

/** The ends of the twelve edges of a box round the origin. */
function edges(size: BoxRecord["size"]): Float32Array {
  const positions = new Float32Array(SEGMENTS * 6);
  let at = 0;
  for (const axis of [0, 1, 2] as const) {
    for (const [u, v] of [
      [-1, -1],
      [-1, 1],
      [1, -1],
      [1, 1],
    ] as const) {
      for (const end of [-1, 1]) {
        const point = [0, 0, 0];
        point[axis] = (end * size[axis]) / 2;
        point[(axis + 1) % 3] = (u * (size[(axis + 1) % 3] ?? 0)) / 2;
        point[(axis + 2) % 3] = (v * (size[(axis + 2) % 3] ?? 0)) / 2;
        positions.set(point, at);
        at += 3;
      }
    }
  }
  return positions;
}
