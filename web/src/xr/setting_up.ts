import { ROOM_CAPTURE } from "../model/ar";
import { distance } from "../model/geometry";
import type { Ar, Point, State } from "../model/state";
import type { Store } from "../store";
import type { Ray } from "../views/picking";
import { alongWall, fits, type Move, relativeTo } from "./alignment";
import { type Anchoring, turnOfView } from "./anchoring";
import { pointAt } from "./marking";

const BUZZ = 15; // milliseconds; never the only sign

/** The first steps: the floor, then where the room lies on it. */
export class SettingUp {
  readonly #anchoring: Anchoring;
  readonly #store: Store;
  /** How else the drawn room fits its two corners, beginning with how it lies now. */
  #ways: readonly Move[] = [];

  constructor(anchoring: Anchoring, store: Store) {
    this.#anchoring = anchoring;
    this.#store = store;
  }

  /** The floor is where the surface is; a new room begins there. `viewer` is in the device's frame. */
  floor({ position }: XRRigidTransform, viewer: XRRigidTransform): void {
    const { ar } = this.#store.getState();
    if (ar === null) return;
    this.#anchoring.stand([position.x, position.y, position.z], turnOfView(viewer));
    navigator.vibrate?.(BUZZ);
    this.#change({ step: ar.room === "new" ? "ready" : "line-up", corner: null });
    if (ar.room === "new") this.#store.dispatch({ type: "new-room" });
  }

  /** One of the two corners that tell where the drawn room lies. */
  corner(ray: Ray): void {
    const state = this.#store.getState();
    const at = pointAt(state, ray);
    if (at === null || state.ar === null) return;
    navigator.vibrate?.(BUZZ);
    if (state.ar.corner === null) {
      this.#change({ corner: at });
      return;
    }
    const [best, ...others] = fits(state.scene.room, eyeOf(ray), state.ar.corner, at);
    if (best === undefined) return;
    this.#ways = [best, ...others].map((way) => relativeTo(best, way));
    this.#anchoring.move(best);
    this.#change({ step: "ready", corner: null });
  }

  /** Asks for the floor again, and for two corners of the room if it has been outlined. */
  again(): void {
    const { tool, draft } = this.#store.getState();
    const room = tool === "room" && draft !== null ? "new" : "known";
    this.#change({ step: "floor", room, surface: false, corner: null });
  }

  /** The device has begun to count from somewhere else. */
  reset(): void {
    const { ar } = this.#store.getState();
    if (ar?.step !== "ready") return;
    this.again();
    const text = "The device has lost its place. Show it the floor and the room again.";
    this.#store.dispatch({ type: "notify", tone: "problem", text });
  }

  /** The next of the ways in which the room fits its corners. */
  turnRound(): void {
    const [now, next, ...others] = this.#ways;
    if (now === undefined || next === undefined) return;
    this.#ways = [next, ...others, now].map((way) => relativeTo(next, way));
    this.#anchoring.move(next);
  }

  /** A new room runs along its first wall: so its sides are level with the axes. */
  firstWall({ draft, scene, ar }: State): void {
    if (draft?.kind !== "room" || scene.boxes.length > 0 || ar?.step !== "ready") return;
    const [one, two, ...others] = draft.corners;
    if (one === undefined || two === undefined || others.length > 0) return;
    if (one[0] === 0 && one[1] === 0 && two[1] === 0) return;
    this.#anchoring.move(alongWall([one, two]));
    const { dispatch } = this.#store;
    dispatch({ type: "remove-last-corner" });
    dispatch({ type: "remove-last-corner" });
    const wall: readonly Point[] = [
      [0, 0],
      [distance(one, two), 0],
    ];
    for (const at of wall) {
      dispatch({ type: "draw-down", at, free: true });
      dispatch({ type: "draw-up", at, free: true });
    }
  }

  /** Leaves the picture to the device until it has seen the room; it does so once a session. */
  capture(session: XRSession): void {
    const { ar } = this.#store.getState();
    const granted = ar?.granted.filter((feature) => feature !== ROOM_CAPTURE) ?? [];
    this.#change({ granted });
    session.initiateRoomCapture?.().catch(() => {
      const text = "The device could not look round the room. Outline it yourself.";
      this.#store.dispatch({ type: "notify", tone: "problem", text });
    });
  }

  #change(change: Partial<Ar>): void {
    this.#store.dispatch({ type: "change-ar", change });
  }
}

function eyeOf({ origin }: Ray): Point {
  return [origin[0], origin[1]];
}
