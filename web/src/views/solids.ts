import {
  Box3,
  type BufferAttribute,
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  type InterleavedBufferAttribute,
  type Material,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  Vector3,
} from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import type { Assets } from "../contract";
import { MODEL_IN_BOX } from "./axes";

/** One draw call of a solid: its vertices fill the unit box from −½ to ½ of a core box. */
export interface Piece {
  readonly geometry: BufferGeometry;
  readonly material: Material;
}

export type Solid = readonly Piece[];

/** The furniture models, each parsed once and shared by everything that shows it. */
export class Solids {
  readonly #assets: Assets;
  readonly #loader = new GLTFLoader();
  readonly #solids = new Map<string, Solid | null>();
  readonly #arrived: () => void;
  readonly #stop: () => void;
  #disposed = false;

  constructor(assets: Assets, arrived: () => void) {
    this.#assets = assets;
    this.#arrived = arrived;
    this.#stop = assets.subscribe((digest) => {
      if (this.#solids.has(digest)) {
        this.#parse(digest);
      }
    });
  }

  /** The solid of a digest; null until it is here, then `arrived` is called. */
  get(digest: string): Solid | null {
    const solid = this.#solids.get(digest);
    if (solid === undefined) {
      this.#solids.set(digest, null);
      this.#parse(digest);
      return null;
    }
    return solid;
  }

  dispose(): void {
    this.#disposed = true;
    this.#stop();
    for (const solid of this.#solids.values()) {
      disposeSolid(solid);
    }
    this.#solids.clear();
  }

  #parse(digest: string): void {
    const bytes = this.#assets.get(digest);
    if (bytes === undefined || this.#solids.get(digest)) {
      return;
    }
    this.#loader.parseAsync(bytes, "").then(
      ({ scene }) => {
        if (this.#disposed || this.#solids.get(digest)) {
          return;
        }
        this.#solids.set(digest, solidOf(scene));
        this.#arrived();
      },
      (error: unknown) => console.error(`The model ${digest} cannot be read:`, error),
    );
  }
}

function disposeSolid(solid: Solid | null): void {
  for (const { geometry, material } of solid ?? []) {
    geometry.dispose();
    if (material instanceof MeshStandardMaterial) {
      material.map?.dispose();
    }
    material.dispose();
  }
}

/** The meshes of a model in the unit box of the core frame, with as few draw calls as can be. */
function solidOf(scene: Object3D): Solid {
  scene.updateMatrixWorld(true);
  const bounds = new Box3().setFromObject(scene, true);
  const size = bounds.getSize(new Vector3());
  const center = bounds.getCenter(new Vector3());
  const toUnit = new Matrix4()
    .copy(MODEL_IN_BOX)
    .scale(new Vector3(1 / (size.x || 1), 1 / (size.y || 1), 1 / (size.z || 1)))
    .multiply(new Matrix4().makeTranslation(-center.x, -center.y, -center.z));
  const plain: BufferGeometry[] = [];
  const others: Piece[] = [];
  scene.traverse((object) => {
    if (!(object instanceof Mesh)) {
      return;
    }
    const material: Material = Array.isArray(object.material)
      ? object.material[0]
      : object.material;
    const geometry: BufferGeometry = object.geometry.clone();
    geometry.applyMatrix4(new Matrix4().multiplyMatrices(toUnit, object.matrixWorld));
    if (material instanceof MeshStandardMaterial && !material.map && !material.transparent) {
      plain.push(painted(geometry, material.color));
    } else {
      // Without anything to be reflected, metal would be black.
      if (material instanceof MeshStandardMaterial) material.metalness = 0;
      others.push({ geometry, material });
    }
  });
  return [...mergedPieces(plain), ...others];
}

function mergedPieces(plain: BufferGeometry[]): Piece[] {
  const geometry = plain.length > 0 ? mergeGeometries(plain) : null;
  if (!geometry) {
    return [];
  }
  const material = new MeshStandardMaterial({ vertexColors: true, roughness: 0.72 });
  return [{ geometry, material }];
}

/** The geometry without its indices, with positions, normals and one color: so any two can merge. */
function painted(geometry: BufferGeometry, color: Color): BufferGeometry {
  const loose = geometry.index ? geometry.toNonIndexed() : geometry;
  const own = loose.getAttribute("color") as BufferAttribute | undefined;
  const count = loose.getAttribute("position").count;
  const colors = new Float32Array(count * 3);
  const paint = new Color();
  for (let i = 0; i < count; i++) {
    paint.setRGB(own?.getX(i) ?? 1, own?.getY(i) ?? 1, own?.getZ(i) ?? 1).multiply(color);
    paint.toArray(colors, i * 3);
  }
  if (!loose.getAttribute("normal")) {
    loose.computeVertexNormals();
  }
  const plain = new BufferGeometry();
  plain.setAttribute("position", copied(loose.getAttribute("position")));
  plain.setAttribute("normal", copied(loose.getAttribute("normal")));
  plain.setAttribute("color", new Float32BufferAttribute(colors, 3));
  return plain;
}

/** The attribute as plain floats, whatever way the file stores it. */
function copied(attribute: BufferAttribute | InterleavedBufferAttribute): BufferAttribute {
  const values = new Float32Array(attribute.count * 3);
  for (let i = 0; i < attribute.count; i++) {
    values[i * 3] = attribute.getX(i);
    values[i * 3 + 1] = attribute.getY(i);
    values[i * 3 + 2] = attribute.getZ(i);
  }
  return new Float32BufferAttribute(values, 3);
}
