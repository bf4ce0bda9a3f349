import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Vector3 } from "../model/state";
import { Lines } from "./lines";

export interface StrokeLook {
  readonly color: string;
  /** CSS pixels. */
  readonly width: number;
  /** Metres of line and of gap; none for a whole line. */
  readonly dash?: readonly [line: number, gap: number];
  readonly opacity?: number;
  /** Whether what stands before them hides the lines. */
  readonly hidden?: boolean;
}

/** Straight lines of one look, in one draw call. */
export class Strokes {
  readonly root: Lines;
  readonly #material: LineMaterial;

  constructor(look: StrokeLook) {
    const [dashSize, gapSize] = look.dash ?? [1, 0];
    this.#material = new LineMaterial({
      color: look.color,
      linewidth: look.width,
      dashed: look.dash !== undefined,
      dashSize,
      gapSize,
      transparent: true,
      opacity: look.opacity ?? 1,
      depthTest: look.hidden ?? false,
      depthWrite: false,
    });
    this.#material.toneMapped = false;
    this.root = new Lines(new LineSegmentsGeometry(), this.#material);
    this.root.frustumCulled = false;
    this.root.renderOrder = 8;
    this.root.visible = false;
  }

  /** Shows the lines between the points, two by two. */
  show(ends: readonly Vector3[]): void {
    this.root.visible = ends.length > 0;
    if (ends.length > 0) {
      this.root.geometry.dispose();
      this.root.geometry = new LineSegmentsGeometry().setPositions(new Float32Array(ends.flat()));
      this.root.computeLineDistances();
    }
  }

  set opacity(opacity: number) {
    this.#material.opacity = opacity;
  }

  dispose(): void {
    this.root.removeFromParent();
    this.root.geometry.dispose();
    this.#material.dispose();
  }
}
