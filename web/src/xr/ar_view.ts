import { Group, PerspectiveCamera } from "three";
import type { FloatingContent } from "../contract";
import type { Ar, Point, State } from "../model/state";
import type { Store } from "../store";
import { CORE_IN_PAGE } from "../views/axes";
import type { Pad } from "../views/pad";
import type { Ray } from "../views/picking";
import { Sight } from "../views/sight";
import type { Lent, Stage } from "../views/stage";
import { Aim } from "./aim";
import { Anchoring } from "./anchoring";
import { Beam } from "./beam";
import { Daylight } from "./daylight";
import { FloatingPanel } from "./floating_panel";
import { Hand } from "./hand";
import { Hits } from "./hits";
import { KnownRoom } from "./known_room";
import { pointAt } from "./marking";
import { rayOf } from "./rays";
import { RealThings } from "./real_things";
import { grantedFeatures } from "./session_init";
import { SettingUp } from "./setting_up";

const FIRST_STEP = 1 / 60; // seconds, before the first frame
const MAX_STEP = 0.25; // seconds; a longer pause is not caught up with
const LOST = 0.5; // seconds without a pose until it is said

export interface Ties {
  readonly stage: Stage;
  readonly store: Store;
  /** Called whenever the session is seen again or ends: sockets may have died. */
  changed(): void;
  /** What stands in for the panels where the page is not seen. */
  floating(state: State): FloatingContent;
}

/** What the session has once its frame of reference is known. */
interface Place {
  readonly anchoring: Anchoring;
  readonly setUp: SettingUp;
}

/** The room in place, from the beginning of a session to its end. */
export class ArView {
  readonly #ties: Ties;
  readonly #session: XRSession;
  readonly #lent: Lent;
  readonly #camera = new PerspectiveCamera(60, 1, 0.05, 40);
  readonly #root = new Group();
  readonly #things = new RealThings();
  readonly #daylight = new Daylight();
  readonly #hits = new Hits();
  readonly #known: KnownRoom;
  readonly #aim: Aim;
  readonly #hand: Hand;
  readonly #pressed = new Set<XRInputSource>();
  readonly #listening = new AbortController();
  readonly #stop: () => void;
  #place: Place | null = null;
  /** Only where the page's own panels are not seen. */
  #panel: FloatingPanel | null = null;
  #beam: Beam | null = null;
  #state: State;
  #ray: Ray | null = null;
  /** The floor in the middle of the view, and the eye: in the device's frame. */
  #floor: XRRigidTransform | null = null;
  #viewer: XRRigidTransform | null = null;
  #last = 0;
  #unseen = 0;

  constructor(ties: Ties, session: XRSession) {
    const { store, stage } = ties;
    this.#ties = ties;
    this.#session = session;
    this.#state = store.getState();
    this.#lent = stage.lend();
    this.#known = new KnownRoom(store.dispatch);
    this.#aim = new Aim(store.dispatch, this.#lent.guide);
    this.#hand = new Hand(this.#pad(), store.dispatch, this.#state);
    this.#root.matrixAutoUpdate = false;
    this.#root.matrix.copy(CORE_IN_PAGE);
    this.#root.add(this.#aim.root, this.#things.root);
    this.#lent.scene.add(this.#root, this.#daylight.root);
    this.#stop = store.subscribe((state) => this.#show(state));
  }

  /** Shows the room from now on, until the session ends. */
  async begin(room: Ar["room"]): Promise<void> {
    const { xr } = this.#lent.renderer;
    this.#listen(this.#session);
    xr.enabled = true;
    xr.setReferenceSpaceType("local-floor");
    await xr.setSession(this.#session);
    const base = xr.getReferenceSpace() as XRReferenceSpace;
    const granted = grantedFeatures(this.#session);
    const anchoring = new Anchoring(base, granted.includes("anchors"), (space) =>
      xr.setReferenceSpace(space),
    );
    const setUp = new SettingUp(anchoring, this.#ties.store);
    const { signal } = this.#listening;
    base.addEventListener("reset", () => setUp.reset(), { signal });
    this.#place = { anchoring, setUp };
    if (!this.#session.domOverlayState?.type) this.#float();
    this.#ties.store.dispatch({ type: "enter-ar", room, granted });
    xr.setAnimationLoop((now, frame) => frame && this.#frame(now, frame));
    await Promise.all([this.#hits.begin(this.#session), this.#daylight.begin(this.#session)]);
  }

  end(): void {
    void this.#session.end();
  }

  /** Where the middle of the view meets the floor; null while it does not. */
  viewPoint(): Point | null {
    return this.#ray && pointAt(this.#state, this.#ray);
  }

  /** What a tap in the middle of the view does. */
  mark(): void {
    if (this.#ray) this.#tap(this.#ray, this.#floor);
  }

  lineUp(): void {
    this.#place?.setUp.again();
  }

  turnRound(): void {
    this.#place?.setUp.turnRound();
  }

  capture(): void {
    this.#place?.setUp.capture(this.#session);
  }

  /** What is needed where the page is not seen: a panel in the room, and a beam to press with. */
  #float(): void {
    this.#panel = new FloatingPanel();
    this.#beam = new Beam();
    this.#root.add(this.#panel.root, this.#beam.root);
  }

  #pad(): Pad {
    const sight = new Sight(this.#lent.renderer.domElement);
    return {
      element: this.#lent.renderer.domElement,
      ray: (x, y) => sight.ray(this.#camera, x, y),
      place: (at) => sight.place(this.#camera, at),
      hold: () => {},
      hover: () => {},
      guide: (guides) => this.#lent.guide(guides),
    };
  }

  #listen(session: XRSession): void {
    const { signal } = this.#listening;
    const select = (event: XRInputSourceEvent): void => this.#select(event);
    session.addEventListener("selectstart", select, { signal });
    session.addEventListener("selectend", select, { signal });
    session.addEventListener("visibilitychange", () => this.#seen(), { signal });
    session.addEventListener("end", () => this.#dispose(), { signal });
  }

  #show(state: State): void {
    this.#state = state;
    this.#hand.show(state);
    this.#things.show(state);
    this.#place?.setUp.firstWall(state);
    this.#panel?.show(this.#ties.floating(state));
  }

  #seen(): void {
    const seen = this.#session.visibilityState === "visible";
    this.#change({ tracking: seen ? "good" : "paused" });
    this.#ties.changed();
  }

  #select({ type, frame, inputSource }: XRInputSourceEvent): void {
    const ray = this.#rayOf(frame, inputSource);
    if (ray === null || this.#place === null) return;
    const down = type === "selectstart";
    const pressed = down ? (this.#panel?.at(ray) ?? null) : null;
    if (pressed !== null) {
      if (pressed !== "none") pressed.run();
    } else if (this.#state.ar?.step === "ready") {
      if (down) {
        this.#pressed.add(inputSource);
        this.#hand.down(inputSource, ray);
      } else if (this.#pressed.delete(inputSource)) this.#hand.up(inputSource, ray);
    } else if (down) {
      const floor = this.#hits.under(frame, inputSource, this.#place.anchoring.base);
      this.#tap(ray, floor ?? this.#floor);
    }
  }

  #rayOf(frame: XRFrame, input: XRInputSource): Ray | null {
    const pose = this.#place && frame.getPose(input.targetRaySpace, this.#place.anchoring.space);
    return pose ? rayOf(pose.transform) : null;
  }

  /** A controller or a hand points better than the head does. */
  #pointing(frame: XRFrame): Ray | null {
    if (this.#beam === null) return null;
    const all = [...this.#session.inputSources].filter(
      ({ targetRayMode }) => targetRayMode === "tracked-pointer",
    );
    const input = all.find(({ handedness }) => handedness === "right") ?? all[0];
    return input === undefined ? null : this.#rayOf(frame, input);
  }

  /** A tap along a ray that may have met a real surface, in the step that the session is in. */
  #tap(ray: Ray, surface: XRRigidTransform | null): void {
    switch (this.#state.ar?.step) {
      case "floor":
        if (surface && this.#viewer) this.#place?.setUp.floor(surface, this.#viewer);
        return;
      case "line-up":
        this.#place?.setUp.corner(ray);
        return;
      case "ready":
        this.#hand.tap(ray);
        return;
      case undefined:
    }
  }

  #frame(now: number, frame: XRFrame): void {
    const elapsed = this.#last === 0 ? FIRST_STEP : Math.min((now - this.#last) / 1000, MAX_STEP);
    this.#last = now;
    const anchoring = this.#place?.anchoring;
    const pose = anchoring && frame.getViewerPose(anchoring.space);
    this.#track(!pose || pose.emulatedPosition, elapsed);
    if (!anchoring || !pose) return;
    this.#lent.renderer.xr.updateCamera(this.#camera);
    anchoring.update(frame);
    const view = rayOf(pose.transform);
    const ray = this.#pointing(frame) ?? view;
    this.#ray = ray;
    this.#panel?.follow(view);
    this.#beam?.show(ray === view ? null : ray);
    if (this.#state.ar?.step === "floor") this.#find(frame, anchoring, ray);
    else this.#work(frame, anchoring, ray, elapsed);
    this.#shine(frame);
    this.#lent.draw(this.#camera, elapsed);
  }

  /** The floor is looked for. */
  #find(frame: XRFrame, { base, space }: Anchoring, ray: Ray): void {
    this.#viewer = frame.getViewerPose(base)?.transform ?? null;
    this.#floor = this.#hits.inView(frame, base);
    this.#aim.find(this.#hits.inView(frame, space), ray);
    if (this.#floor && !this.#state.ar?.surface) this.#change({ surface: true });
  }

  #work(frame: XRFrame, { space }: Anchoring, ray: Ray, elapsed: number): void {
    for (const input of this.#pressed) {
      const held = this.#rayOf(frame, input);
      if (held) this.#hand.move(input, held);
    }
    this.#aim.point(this.#state, ray);
    if (!this.#hand.pressing) this.#aim.follow(this.#state, ray, elapsed);
    this.#known.look(frame, space, this.#state, elapsed);
  }

  /** The real light, and the real depth, where the device gives them. */
  #shine(frame: XRFrame): void {
    this.#lent.light(!this.#daylight.update(frame));
    const { xr } = this.#lent.renderer;
    const depth = xr.hasDepthSensing() ? xr.getDepthSensingMesh() : null;
    if (depth) depth.visible = this.#state.ar?.occlusion ?? true;
  }

  #track(lost: boolean, elapsed: number): void {
    this.#unseen = lost ? this.#unseen + elapsed : 0;
    const now = this.#state.ar?.tracking;
    if (now === "good" && this.#unseen > LOST) this.#change({ tracking: "lost" });
    if (now === "lost" && !lost) this.#change({ tracking: "good" });
  }

  #change(change: Partial<Ar>): void {
    this.#ties.store.dispatch({ type: "change-ar", change });
  }

  #dispose(): void {
    const { renderer } = this.#lent;
    this.#listening.abort();
    this.#stop();
    this.#hits.end();
    this.#place?.anchoring.dispose();
    this.#aim.dispose();
    this.#things.dispose();
    this.#daylight.dispose();
    this.#panel?.dispose();
    this.#beam?.dispose();
    this.#root.removeFromParent();
    renderer.xr.setAnimationLoop(null);
    renderer.setAnimationLoop(null);
    renderer.xr.enabled = false;
    this.#ties.store.dispatch({ type: "leave-ar" });
    this.#ties.stage.takeBack();
    this.#ties.changed();
  }
}
