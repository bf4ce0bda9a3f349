/** Reads the planes and meshes of a frame, where the device has them. */
import { toCore } from "../model/frames";
import type { State, Vector3 } from "../model/state";
import type { Dispatch } from "../store";
import { foundIn, type Piece } from "./found";

const PAUSE = 1; // seconds between two looks

/** Offers what the device knows of the room, once, while nobody has drawn anything in it. */
export class KnownRoom {
  readonly #dispatch: Dispatch;
  #since = 0;
  #isOffered = false;

  constructor(dispatch: Dispatch) {
    this.#dispatch = dispatch;
  }

  look(frame: XRFrame, space: XRSpace, state: State, elapsed: number): void {
    this.#since += elapsed;
    if (this.#isOffered || this.#since < PAUSE) return;
    this.#since = 0;
    const { ar, scene, draft } = state;
    const begun = draft?.kind === "room" && draft.corners.length > 0;
    if (ar?.step !== "ready" || begun || scene.boxes.length > 0) return;
    const found = foundIn(piecesIn(frame, space), scene.room);
    if (found === null) return;
    this.#isOffered = true;
    this.#dispatch({ type: "change-ar", change: { found } });
  }
}

interface Detected {
  readonly semanticLabel?: string | null | undefined;
}

/** All pieces with a label, in the core frame. */
export function piecesIn(frame: XRFrame, space: XRSpace): readonly Piece[] {
  const planes = [...(frame.detectedPlanes ?? [])].map((plane) => ({
    label: labelOf(plane),
    flat: true,
    points: placed(frame, plane.planeSpace, space, cornersOf(plane.polygon)),
  }));
  const meshes = [...(frame.detectedMeshes ?? [])].map((mesh) => ({
    label: labelOf(mesh),
    flat: false,
    points: placed(frame, mesh.meshSpace, space, verticesOf(mesh.vertices)),
  }));
  return [...planes, ...meshes].filter(({ label }) => label !== "");
}

function labelOf({ semanticLabel }: Detected): string {
  return semanticLabel?.toLowerCase() ?? "";
}

function cornersOf(polygon: readonly DOMPointReadOnly[]): readonly Vector3[] {
  return polygon.map(({ x, y, z }) => [x, y, z]);
}

function verticesOf(vertices: Float32Array): readonly Vector3[] {
  return Array.from({ length: vertices.length / 3 }, (_, i) => [
    vertices[3 * i] ?? 0,
    vertices[3 * i + 1] ?? 0,
    vertices[3 * i + 2] ?? 0,
  ]);
}

function placed(
  frame: XRFrame,
  own: XRSpace,
  space: XRSpace,
  points: readonly Vector3[],
): readonly Vector3[] {
  const m = frame.getPose(own, space)?.transform.matrix;
  if (m === undefined) return [];
  const row = (i: number, [x, y, z]: Vector3): number =>
    (m[i] ?? 0) * x + (m[4 + i] ?? 0) * y + (m[8 + i] ?? 0) * z + (m[12 + i] ?? 0);
  return points.map((point) => toCore([row(0, point), row(1, point), row(2, point)]));
}
