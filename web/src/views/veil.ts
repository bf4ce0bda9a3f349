import { Color, Mesh, PlaneGeometry, ShaderMaterial } from "three";
import type { State } from "../model/state";
import { approach } from "./motion";
import type { Look } from "./palette";
import type { Eye, Part } from "./part";

const CHOOSING = 0.35; // opacity while the tool for rooms is in hand
const DRAWING = 0.78; // once a new outline has begun
const FADE = 0.16; // seconds
const OVER_ROOM = 5; // render order: after the room and its map, before lines and handles

/** A veil over the whole picture that lets the old room step back while a new one is drawn. */
export class Veil implements Part {
  readonly root: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly #color = { value: new Color() };
  readonly #opacity = { value: 0 };
  #goal = 0;

  constructor(look: Look) {
    const material = new ShaderMaterial({
      vertexShader: "void main() { gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }",
      fragmentShader: `
        uniform vec3 color;
        uniform float opacity;
        void main() {
          gl_FragColor = vec4(color, opacity);
          #include <colorspace_fragment>
        }`,
      uniforms: { color: this.#color, opacity: this.#opacity },
      transparent: true,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    this.root = new Mesh(new PlaneGeometry(1, 1), material);
    this.root.frustumCulled = false;
    this.root.renderOrder = OVER_ROOM;
    this.root.visible = false;
    this.relight(look);
  }

  relight(look: Look): void {
    this.#color.value.set(look.background);
  }

  show({ tool, draft, ar }: State): void {
    const begun = draft?.kind === "room" && draft.corners.length > 0;
    this.#goal = ar !== null ? 0 : begun ? DRAWING : tool === "room" ? CHOOSING : 0;
  }

  update(eye: Eye): boolean {
    const opacity = approach(this.#opacity.value, this.#goal, eye.elapsed, FADE);
    this.#opacity.value = opacity;
    this.root.visible = opacity > 0;
    return opacity !== this.#goal;
  }

  dispose(): void {
    this.root.geometry.dispose();
    this.root.material.dispose();
  }
}
