import {
  DynamicDrawUsage,
  Euler,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  PlaneGeometry,
  Quaternion,
  ShaderMaterial,
  Vector3,
} from "three";
import { bottomOf, headingOf } from "../model/footprints";
import type { BoxRecord } from "../net/protocol.gen";

const REACH = 0.22; // metres the shadow goes beyond the footprint
const DARKNESS = 0.4; // of the floor directly below
const NO_SHADOW_ABOVE = 0.6; // metres over the floor
const LIFT = 0.004; // metres over the floor, so that the two do not flicker

const VERTEX = /* glsl */ `
  attribute vec3 extent;
  varying vec2 place;
  varying vec3 size;
  void main() {
    place = position.xy * 2.0 * (extent.xy + ${REACH});
    size = extent;
    gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  }`;

const FRAGMENT = /* glsl */ `
  varying vec2 place;
  varying vec3 size;
  void main() {
    vec2 beyond = abs(place) - size.xy + 0.06;
    float outside = length(max(beyond, 0.0));
    float shade = 1.0 - smoothstep(0.0, ${REACH}, outside);
    gl_FragColor = vec4(0.10, 0.07, 0.05, size.z * shade * shade);
  }`;

/** The soft dark edge under everything that stands on the floor, in one draw call. */
export class ContactShadows {
  readonly mesh: InstancedMesh<PlaneGeometry, ShaderMaterial>;
  readonly #extents: InstancedBufferAttribute;
  readonly #matrix = new Matrix4();
  readonly #turn = new Quaternion();
  readonly #angles = new Euler();
  readonly #at = new Vector3();
  readonly #scale = new Vector3();

  constructor(capacity: number) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
      toneMapped: false,
    });
    const geometry = new PlaneGeometry(1, 1);
    this.#extents = new InstancedBufferAttribute(new Float32Array(capacity * 3), 3);
    this.#extents.setUsage(DynamicDrawUsage);
    geometry.setAttribute("extent", this.#extents);
    this.mesh = new InstancedMesh(geometry, material, capacity);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
    this.mesh.count = 0;
  }

  show(boxes: readonly BoxRecord[]): void {
    let count = 0;
    for (const box of boxes.slice(0, this.#extents.count)) {
      const strength = DARKNESS * (1 - bottomOf(box) / NO_SHADOW_ABOVE);
      if (strength > 0) {
        this.#put(count, box, Math.min(strength, DARKNESS));
        count += 1;
      }
    }
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
    this.#extents.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.dispose();
  }

  #put(index: number, box: BoxRecord, strength: number): void {
    const [depth, width] = box.size;
    this.#at.set(box.center[0], box.center[1], LIFT);
    this.#turn.setFromEuler(this.#angles.set(0, 0, headingOf(box)));
    this.#scale.set(depth + 2 * REACH, width + 2 * REACH, 1);
    this.#matrix.compose(this.#at, this.#turn, this.#scale);
    this.mesh.setMatrixAt(index, this.#matrix);
    this.#extents.setXYZ(index, depth / 2, width / 2, strength);
  }
}
