import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { toCore, toPage } from "../model/frames";
import type { CameraMode, Vector3 as Place, Point, State } from "../model/state";
import type { RoomRecord } from "../net/protocol.gen";
import {
  frameRoom,
  freePart,
  type Insets,
  NO_INSETS,
  type Viewpoint,
  viewDirection,
} from "./framing";
import { easeOut, reducedMotion } from "./motion";
import { boundsOf, middleOf } from "./outline";
import { directionToFront, hungAlternative, roundTo } from "./turning";
import { Walk } from "./walk";

const FOV = 36; // degrees; little distortion
const VERTICAL = (FOV * Math.PI) / 180; // radians
const NEAR = 0.05;
const FAR = 120;
const PLAN_HEIGHT = 50; // metres over the floor
const PLAN_MARGIN = 1.14; // how much more than the room the plan shows
const TURN = 0.18; // seconds to turn to another wall
const SWAY = 0.38; // radians to each side that the opening view turns
const SWAY_SPEED = 0.16; // radians a second, of the swing's phase

/** The three ways to look at the room: from around, from above, from within. */
export class Cameras {
  readonly #element: HTMLElement;
  readonly #orbitCamera = new PerspectiveCamera(FOV, 1, NEAR, FAR);
  readonly #planCamera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 100);
  readonly #walkCamera = new PerspectiveCamera(62, 1, NEAR, FAR);
  readonly #orbit: OrbitControls;
  readonly #plan: OrbitControls;
  readonly #walk: Walk;
  readonly #ray = new Vector3();
  #mode: CameraMode = "orbit";
  #insets: Insets = NO_INSETS;
  #room: RoomRecord | null = null;
  #scene = "";
  #untouched = true;
  /** From where the room is looked at after a turn; null as it opens. */
  #direction: Place | null = null;
  #turn: { readonly from: Viewpoint; readonly to: Viewpoint } | null = null;
  #turned = 1;
  #seen = "";
  #swinging = false;
  #phase = 0;
  #swung = 0;
  #held = false;

  constructor(element: HTMLElement, changed: () => void) {
    this.#element = element;
    this.#orbit = orbitControls(this.#orbitCamera, element);
    this.#planCamera.up.set(...toPage([0, 1, 0]));
    this.#plan = planControls(this.#planCamera, element);
    this.#walk = new Walk(this.#walkCamera, element, changed);
    for (const controls of [this.#orbit, this.#plan]) {
      controls.addEventListener("change", changed);
      controls.addEventListener("start", () => {
        this.#untouched = false;
        this.#turn = null;
      });
    }
  }

  get active(): PerspectiveCamera | OrthographicCamera {
    if (this.#mode === "top") {
      return this.#planCamera;
    }
    return this.#mode === "walk" ? this.#walkCamera : this.#orbitCamera;
  }

  show(state: State): void {
    const { room, id } = state.scene;
    const other = this.#room === null || id !== this.#scene;
    if (other || (room !== this.#room && this.#untouched && state.beforeDrag === null)) {
      this.#room = room;
      this.#scene = id;
      this.#direction = null;
      this.frame();
    }
    this.#room = room;
    this.#swinging = state.welcome && !reducedMotion();
    if (state.shown.camera !== this.#mode) {
      this.#mode = state.shown.camera;
      this.#enter();
    }
    this.#turnToFront(state);
    this.hold(this.#held);
  }

  /** Keeps the cameras still while an object is dragged. */
  hold(held: boolean): void {
    this.#held = held;
    this.#orbit.enabled = !held && this.#mode === "orbit";
    this.#plan.enabled = !held && this.#mode === "top";
    this.#walk.enabled = !held && this.#mode === "walk";
  }

  setInsets(insets: Insets): void {
    this.#insets = insets;
    this.resize();
  }

  /** Fits the pictures to the element; a view that nobody has changed is framed anew. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#element;
    const free = freePart(Math.max(1, width), Math.max(1, height), this.#insets);
    for (const camera of [this.#orbitCamera, this.#walkCamera]) {
      camera.aspect = free.width / free.height;
      camera.setViewOffset(free.width, free.height, -free.x, -free.y, width, height);
    }
    const aspect = free.width / free.height;
    this.#planCamera.left = -aspect;
    this.#planCamera.right = aspect;
    this.#planCamera.setViewOffset(free.width, free.height, -free.x, -free.y, width, height);
    if (this.#untouched) {
      this.frame();
    }
  }

  /** Shows the whole room. */
  frame(): void {
    const room = this.#room;
    if (!room) {
      return;
    }
    this.#untouched = true;
    this.#swung = 0;
    this.#phase = 0;
    const { aspect } = this.#orbitCamera;
    // From the window's shape: a panel that opens must not turn the room round.
    const { clientWidth, clientHeight } = this.#element;
    const opening = viewDirection(room, clientWidth / Math.max(1, clientHeight));
    this.#turn = null;
    this.#look(frameRoom(room, this.#direction ?? opening, VERTICAL, aspect));
    this.#orbit.maxDistance = 3 * this.#orbitCamera.position.distanceTo(this.#orbit.target);
    this.#orbit.update();
    this.#framePlan(room, aspect);
  }

  /** One step of what moves by itself; true while it does. */
  advance(elapsed: number): boolean {
    switch (this.#mode) {
      case "orbit":
        return this.#swing(elapsed) || this.#goRound(elapsed) || this.#orbit.update(elapsed);
      case "top":
        return this.#plan.update(elapsed);
      case "walk":
        return this.#walk.advance(elapsed);
    }
  }

  /** Where the middle of the free part of the picture meets the floor, core frame. */
  viewPoint(): Point {
    if (this.#mode !== "walk") {
      const { x, y, z } = this.#mode === "top" ? this.#plan.target : this.#orbit.target;
      const [cx, cy] = toCore([x, y, z]);
      return [cx, cy];
    }
    const { position } = this.#walkCamera;
    const ahead = this.#walkCamera.getWorldDirection(this.#ray);
    const drop = ahead.y < -0.2 ? -position.y / ahead.y : 2.5;
    const [x, y] = toCore([position.x + ahead.x * drop, 0, position.z + ahead.z * drop]);
    return [x, y];
  }

  dispose(): void {
    this.#orbit.dispose();
    this.#plan.dispose();
    this.#walk.dispose();
  }

  #look({ position, target }: Viewpoint): void {
    this.#orbitCamera.position.set(...toPage(position));
    this.#orbit.target.set(...toPage(target));
  }

  /** Turns the room once for each place that hangs where its front is not seen. */
  #turnToFront(state: State): void {
    const box = hungAlternative(state);
    const seen = box === null ? "" : `${state.placing?.ask} ${state.placing?.alternative}`;
    if (seen === this.#seen || this.#held || state.beforeDrag !== null) {
      return;
    }
    this.#seen = seen;
    const [eye, goal] = [this.#orbitCamera.position, this.#orbit.target];
    const from = {
      position: toCore([eye.x, eye.y, eye.z]),
      target: toCore([goal.x, goal.y, goal.z]),
    };
    const direction = box === null ? null : directionToFront(box, from);
    if (direction === null || this.#room === null || this.#mode !== "orbit") {
      return;
    }
    this.#direction = direction;
    this.frame();
    if (!reducedMotion()) {
      const to = frameRoom(this.#room, direction, VERTICAL, this.#orbitCamera.aspect);
      this.#turn = { from, to };
      this.#turned = 0;
      this.#look(from);
    }
  }

  /** One step of the turn; true while there is more to go. */
  #goRound(elapsed: number): boolean {
    if (this.#turn === null) {
      return false;
    }
    this.#turned = Math.min(1, this.#turned + elapsed / TURN);
    this.#look(roundTo(this.#turn.from, this.#turn.to, easeOut(this.#turned)));
    this.#orbit.update();
    if (this.#turned === 1) {
      this.#turn = null;
    }
    return true;
  }

  #framePlan(room: RoomRecord, aspect: number): void {
    const [low, high] = boundsOf(room.corners);
    const [x, y] = middleOf(room.corners);
    const tall = Math.max(high[1] - low[1], (high[0] - low[0]) / aspect) * PLAN_MARGIN;
    this.#planCamera.top = 1;
    this.#planCamera.bottom = -1;
    this.#planCamera.zoom = 2 / Math.max(tall, 0.5);
    this.#planCamera.position.set(...toPage([x, y, PLAN_HEIGHT]));
    this.#plan.target.set(...toPage([x, y, 0]));
    this.#planCamera.updateProjectionMatrix();
    this.#plan.update();
  }

  #enter(): void {
    if (this.#mode === "walk" && this.#room) {
      const ahead = this.#orbitCamera.getWorldDirection(this.#ray);
      const [x, y] = toCore([ahead.x, 0, ahead.z]);
      this.#walk.stand(entry(this.#room, [x, y]), Math.atan2(y, x));
      this.#element.focus({ preventScroll: true });
    }
  }

  /** Swings slowly to and fro round the room while the page waits for its first touch. */
  #swing(elapsed: number): boolean {
    if (!this.#swinging) {
      return false;
    }
    this.#phase += SWAY_SPEED * elapsed;
    const angle = SWAY * Math.sin(this.#phase);
    const turn = angle - this.#swung;
    this.#swung = angle;
    const { position } = this.#orbitCamera;
    const { x, z } = this.#orbit.target;
    const [dx, dz] = [position.x - x, position.z - z];
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    position.x = x + dx * cos + dz * sin;
    position.z = z - dx * sin + dz * cos;
    this.#orbit.update();
    return true;
  }
}

/** Where a person stands first: a step back from the middle, so that the room is in view. */
function entry(room: RoomRecord, [dx, dy]: Point): Point {
  const [x, y] = middleOf(room.corners);
  const [low, high] = boundsOf(room.corners);
  const length = Math.hypot(dx, dy) || 1;
  const back = Math.min(high[0] - low[0], high[1] - low[1]) * 0.38;
  return [x - (dx / length) * back, y - (dy / length) * back];
}

function orbitControls(camera: PerspectiveCamera, element: HTMLElement): OrbitControls {
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = !reducedMotion();
  controls.dampingFactor = 0.12;
  controls.minDistance = 0.8;
  controls.maxPolarAngle = Math.PI / 2 - 0.04;
  controls.zoomToCursor = false;
  return controls;
}

function planControls(camera: OrthographicCamera, element: HTMLElement): OrbitControls {
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = !reducedMotion();
  controls.dampingFactor = 0.15;
  controls.enableRotate = false;
  controls.screenSpacePanning = true;
  controls.mouseButtons.LEFT = MOUSE.PAN;
  controls.touches.ONE = TOUCH.PAN;
  controls.minZoom = 0.02;
  controls.maxZoom = 4;
  controls.zoomToCursor = true;
  controls.enabled = false;
  return controls;
}
