import {
  BoxGeometry,
  Color,
  Euler,
  Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { bottomOf, footprint, headingOf, topOf } from "../model/footprints";
import { sides } from "../model/geometry";
import type { Vector3 as Place, State } from "../model/state";
import {
  type BoxRecord,
  MAX_BOXES,
  type OpeningRecord,
  type RoomRecord,
} from "../net/protocol.gen";
import { Lines } from "../views/lines";
import { categoryColor } from "../views/palette";
import type { Part } from "../views/part";

const DASH = 0.08; // metres
const ABOVE = 0.006; // metres over the floor
const FLOOR_LINE = "#ffffff";
const FIRST = -10; // render order: what hides is drawn before all else

/**
 * What is really there needs no picture: dashed edges show that it is known, and it hides what
 * stands behind it. The lines of everything are one draw call, and so is all that hides.
 */
export class RealThings implements Part {
  readonly root = new Group();
  readonly #material = new LineMaterial({
    linewidth: 2.5,
    vertexColors: true,
    dashed: true,
    dashSize: DASH,
    gapSize: DASH * 0.6,
    transparent: true,
  });
  readonly #lines = new Lines(new LineSegmentsGeometry(), this.#material);
  readonly #hiding = new InstancedMesh(
    new BoxGeometry(1, 1, 1),
    new MeshBasicMaterial({ colorWrite: false }),
    MAX_BOXES,
  );
  #shown: State["scene"] | null = null;

  constructor() {
    this.#material.toneMapped = false;
    this.#lines.frustumCulled = false;
    this.#lines.renderOrder = 4;
    this.#hiding.frustumCulled = false;
    this.#hiding.renderOrder = FIRST;
    this.#hiding.count = 0;
    this.root.add(this.#lines, this.#hiding);
  }

  show({ scene, ar, draft }: State): void {
    this.root.visible = ar?.step === "ready";
    this.#hiding.visible = ar?.occlusion ?? false;
    this.#lines.visible = draft?.kind !== "room";
    if (scene === this.#shown) return;
    this.#shown = scene;
    const real = scene.boxes.filter(({ placed }) => placed !== true);
    this.#drawLines(real, scene.room);
    this.#hide(real);
  }

  dispose(): void {
    this.root.removeFromParent();
    this.#lines.geometry.dispose();
    this.#material.dispose();
    this.#hiding.geometry.dispose();
    this.#hiding.material.dispose();
    this.#hiding.dispose();
  }

  #drawLines(boxes: readonly BoxRecord[], room: RoomRecord): void {
    const openings = [...room.doors, ...room.windows].flatMap(frameOf);
    const outline = sides(room.corners).flat();
    const floor = [...outline.map(([x, y]): Place => [x, y, ABOVE]), ...openings];
    const edges = boxes.map(edgesOf);
    const colors = [
      ...floor.map(() => FLOOR_LINE),
      ...boxes.flatMap((box, i) => (edges[i] ?? []).map(() => categoryColor(box.category))),
    ];
    this.#lines.geometry.dispose();
    this.#lines.geometry = new LineSegmentsGeometry()
      .setPositions([...floor, ...edges.flat()].flat())
      .setColors(colors.flatMap((color) => new Color(color).toArray()));
    this.#lines.computeLineDistances();
  }

  #hide(boxes: readonly BoxRecord[]): void {
    const [matrix, turn, at, size] = [
      new Matrix4(),
      new Quaternion(),
      new Vector3(),
      new Vector3(),
    ];
    this.#hiding.count = boxes.length;
    boxes.forEach((box, i) => {
      turn.setFromEuler(new Euler(0, 0, headingOf(box)));
      matrix.compose(at.set(...box.center), turn, size.set(...box.size));
      this.#hiding.setMatrixAt(i, matrix);
    });
    this.#hiding.instanceMatrix.needsUpdate = true;
  }
}

/** The edges of a door or a window. */
function frameOf({ start, end, bottom, top }: OpeningRecord): readonly Place[] {
  const corners: readonly Place[] = [
    [...start, bottom],
    [...end, bottom],
    [...end, top],
    [...start, top],
  ];
  return corners.flatMap((corner, i) => [corner, corners[(i + 1) % 4] ?? corner]);
}

/** The ends of the twelve edges of a box, two by two. */
function edgesOf(box: BoxRecord): readonly Place[] {
  const [low, high] = [bottomOf(box), topOf(box)];
  return sides(footprint(box)).flatMap(([[ax, ay], [bx, by]]): readonly Place[] => [
    [ax, ay, low],
    [bx, by, low],
    [ax, ay, high],
    [bx, by, high],
    [ax, ay, low],
    [ax, ay, high],
  ]);
}
