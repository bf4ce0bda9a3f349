import { DirectionalLight, Group, HemisphereLight } from "three";
import type { State } from "../model/state";
import type { RoomRecord } from "../net/protocol.gen";
import { boundsOf, middleOf } from "./outline";
import type { Look } from "./palette";
import type { Part } from "./part";

const SHADOW_PIXELS = 2048;
const SUN = [-0.42, -0.55, 1] as const; // where the sun stands, seen from the room

/** Daylight, or dusk: a sky, a sun whose shadow is fitted to the room. */
export class Lights implements Part {
  readonly root = new Group();
  readonly #sky = new HemisphereLight();
  readonly #sun = new DirectionalLight();
  #room: RoomRecord | null = null;

  constructor(look: Look) {
    this.#sky.position.set(0, 0, 1);
    this.#sun.castShadow = true;
    this.#sun.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.#sun.shadow.radius = 5;
    this.#sun.shadow.bias = -0.0004;
    this.#sun.shadow.normalBias = 0.02;
    this.#sun.shadow.intensity = 0.72;
    this.root.add(this.#sky, this.#sun, this.#sun.target);
    this.relight(look);
  }

  relight(look: Look): void {
    const [sky, ground, intensity] = look.hemisphere;
    this.#sky.color.set(sky);
    this.#sky.groundColor.set(ground);
    this.#sky.intensity = intensity;
    this.#sun.color.set(look.sun[0]);
    this.#sun.intensity = look.sun[1];
  }

  show(state: State): void {
    // The real floor takes no shadows; what stands on it has one of its own.
    this.#sun.castShadow = state.ar === null;
    if (state.scene.room !== this.#room) {
      this.#room = state.scene.room;
      this.#fit(this.#room);
    }
  }

  dispose(): void {
    this.#sun.dispose();
    this.#sky.dispose();
  }

  #fit(room: RoomRecord): void {
    const [low, high] = boundsOf(room.corners);
    const [x, y] = middleOf(room.corners);
    const radius = Math.hypot(high[0] - low[0], high[1] - low[1], room.height) / 2 + 0.2;
    this.#sun.target.position.set(x, y, room.height / 2);
    this.#sun.position.set(...SUN).setLength(radius * 2);
    this.#sun.position.add(this.#sun.target.position);
    const { camera } = this.#sun.shadow;
    camera.left = -radius;
    camera.right = radius;
    camera.top = radius;
    camera.bottom = -radius;
    camera.near = radius * 0.5;
    camera.far = radius * 3.5;
    camera.updateProjectionMatrix();
  }
}
