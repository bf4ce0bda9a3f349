import { type Camera, Color, NeutralToneMapping, PCFShadowMap, Scene, WebGLRenderer } from "three";
import type { Assets, StageView } from "../contract";
import type { Action } from "../model/actions";
import type { Segment } from "../model/geometry";
import type { Point, State, Vector3 } from "../model/state";
import { Cameras } from "./cameras";
import { insetsOf } from "./covered";
import type { Pad } from "./pad";
import { DAY, DUSK, type Look } from "./palette";
import { Pointer } from "./pointer";
import { Resolution } from "./resolution";
import { Scenery } from "./scenery";
import { Sight } from "./sight";

const FIRST_STEP = 1 / 60; // seconds, after a rest
const MAX_STEP = 0.25; // seconds; a longer pause is not caught up with

/** What the last frame cost; for tests. */
export interface StageInfo {
  readonly calls: number;
  readonly triangles: number;
  readonly frames: number;
  readonly geometries: number;
  readonly textures: number;
}

/** What an XR session needs of the picture that it is lent. */
export interface Lent {
  readonly renderer: WebGLRenderer;
  readonly scene: Scene;
  /** Shows how what is dragged has snapped. */
  guide(guides: readonly Segment[]): void;
  /** Lights of the page's own, or none where the real light is known. */
  light(own: boolean): void;
  /** One frame. */
  draw(camera: Camera, elapsed: number): void;
}

/**
 * The three-dimensional room. It draws only when something has changed or moves, and it follows
 * the free part of the window: the panels say in --inset-left, -right, -top, -bottom (pixels) on
 * :root what they cover, and a "resize" event makes the stage look again.
 */
export class Stage implements StageView {
  readonly #host: HTMLElement;
  readonly #renderer: WebGLRenderer;
  readonly #resolution: Resolution;
  readonly #scene = new Scene();
  readonly #cameras: Cameras;
  readonly #scenery: Scenery;
  readonly #sight: Sight;
  readonly #pointer: Pointer;
  readonly #eye: { camera: Camera; pixels: number; elapsed: number };
  readonly #dark = matchMedia("(prefers-color-scheme: dark)");
  readonly #listening = new AbortController();
  readonly #observer: ResizeObserver;
  #request = 0;
  #last = 0;
  #moving = false;
  #frames = 0;
  #isLent = false;

  constructor(host: HTMLElement, dispatch: (action: Action) => void, assets: Assets) {
    this.#host = host;
    this.#renderer = createRenderer();
    this.#resolution = new Resolution(this.#renderer);
    const canvas = this.#renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The room in three dimensions");
    canvas.style.cssText = "display:block;width:100%;height:100%;touch-action:none";
    host.append(canvas);
    const look = this.#look();
    this.#scenery = new Scenery(assets, look, () => {
      this.#renderer.shadowMap.needsUpdate = true;
      this.invalidate();
    });
    this.#scene.add(this.#scenery.root);
    this.#cameras = new Cameras(canvas, () => this.invalidate());
    this.#eye = { camera: this.#cameras.active, pixels: host.clientHeight, elapsed: 0 };
    this.#sight = new Sight(canvas);
    this.#pointer = this.#createPointer(canvas, dispatch);
    this.#relight(look);
    this.#listen(canvas);
    this.#observer = new ResizeObserver(() => this.#resize());
    this.#observer.observe(host);
    this.#resize();
  }

  show(state: State): void {
    this.#cameras.show(state);
    this.#pointer.show(state);
    this.#scenery.show(state);
    this.#renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  viewPoint(): Point {
    return this.#cameras.viewPoint();
  }

  /** Where on the window a place of the core frame is, CSS pixels; null behind the eye. */
  onScreen(at: Vector3): Point | null {
    return this.#sight.place(this.#cameras.active, at);
  }

  /** Draws once more and keeps that frame: a canvas forgets its picture once it is shown. */
  picture(): Promise<Blob> {
    this.#resolution.rested();
    this.#draw(0);
    return new Promise((resolve, reject) => {
      this.#renderer.domElement.toBlob((blob) => {
        if (blob) {
          resolve(blob);
        } else {
          reject(new Error("The picture could not be made; try again."));
        }
      }, "image/png");
    });
  }

  /** What the last frame cost: draw calls, triangles; how many frames there were so far. */
  info(): StageInfo {
    const { render, memory } = this.#renderer.info;
    return {
      calls: render.calls,
      triangles: render.triangles,
      frames: this.#frames,
      geometries: memory.geometries,
      textures: memory.textures,
    };
  }

  /** Has a frame drawn soon. While an XR session shows the room, the session does that. */
  invalidate(): void {
    if (this.#request === 0 && !this.#isLent) {
      this.#request = requestAnimationFrame((now) => this.#frame(now));
    }
  }

  /** Leaves the picture to an XR session, before the camera's image instead of a background. */
  lend(): Lent {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#isLent = true;
    this.#scene.background = null;
    return {
      renderer: this.#renderer,
      scene: this.#scene,
      guide: (guides) => this.#scenery.guide(guides),
      light: (own) => this.#scenery.light(own),
      draw: (camera, elapsed) => {
        this.#eye.pixels = innerHeight;
        this.#render(camera, elapsed);
      },
    };
  }

  takeBack(): void {
    this.#isLent = false;
    this.#moving = false;
    this.#scenery.light(true);
    this.#relight(this.#look());
    this.#resize();
  }

  dispose(): void {
    cancelAnimationFrame(this.#request);
    this.#listening.abort();
    this.#observer.disconnect();
    this.#pointer.dispose();
    this.#cameras.dispose();
    this.#scenery.dispose();
    this.#renderer.dispose();
    this.#renderer.domElement.remove();
  }

  #createPointer(element: HTMLElement, dispatch: (action: Action) => void): Pointer {
    const pad: Pad = {
      element,
      ray: (x, y) => this.#sight.ray(this.#cameras.active, x, y),
      place: (at) => this.onScreen(at),
      hold: (held) => this.#cameras.hold(held),
      hover: (id) => {
        if (this.#scenery.hover(id)) {
          this.invalidate();
        }
      },
      guide: (guides) => {
        this.#scenery.guide(guides);
        this.invalidate();
      },
    };
    return new Pointer(pad, dispatch);
  }

  #frame(now: number): void {
    this.#request = 0;
    const elapsed = this.#moving ? Math.min((now - this.#last) / 1000, MAX_STEP) : FIRST_STEP;
    this.#last = now;
    if (this.#moving) {
      this.#resolution.moved(elapsed);
    }
    this.#moving = this.#draw(elapsed);
    if (this.#moving || this.#resolution.rested()) {
      this.invalidate();
    }
  }

  /** One frame; true while something moves. */
  #draw(elapsed: number): boolean {
    const turning = this.#cameras.advance(elapsed);
    const camera = this.#cameras.active;
    camera.updateMatrixWorld();
    return this.#render(camera, elapsed) || turning;
  }

  #render(camera: Camera, elapsed: number): boolean {
    this.#scene.updateMatrixWorld();
    this.#eye.camera = camera;
    this.#eye.elapsed = elapsed;
    const moving = this.#scenery.update(this.#eye);
    this.#renderer.render(this.#scene, camera);
    this.#frames += 1;
    return moving;
  }

  #listen(canvas: HTMLCanvasElement): void {
    const { signal } = this.#listening;
    window.addEventListener("resize", () => this.#resize(), { signal });
    this.#dark.addEventListener("change", () => this.#relight(this.#look()), { signal });
    // Keys that act on the room give it the focus too; only who came by Tab needs to see that.
    canvas.addEventListener("keyup", ({ key }) => mark(canvas, key === "Tab"), { signal });
    canvas.addEventListener("blur", () => mark(canvas, false), { signal });
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault(), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.#restore(), { signal });
  }

  /** three uploads its own things again. */
  #restore(): void {
    this.#renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  #look(): Look {
    return this.#dark.matches ? DUSK : DAY;
  }

  #relight(look: Look): void {
    this.#scene.background = this.#isLent ? null : new Color(look.background);
    this.#renderer.toneMappingExposure = look.exposure;
    this.#renderer.shadowMap.needsUpdate = true;
    this.#scenery.relight(look);
    this.invalidate();
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#host;
    if (this.#isLent || clientWidth === 0 || clientHeight === 0) {
      return;
    }
    this.#resolution.apply();
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#eye.pixels = clientHeight;
    this.#cameras.setInsets(insetsOf(document.documentElement));
    this.invalidate();
  }
}

function mark(canvas: HTMLCanvasElement, tabbed: boolean): void {
  canvas.toggleAttribute("data-tabbed", tabbed);
}

function createRenderer(): WebGLRenderer {
  const renderer = new WebGLRenderer({
    antialias: devicePixelRatio < 2,
    powerPreference: "high-performance",
  });
  renderer.toneMapping = NeutralToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}
