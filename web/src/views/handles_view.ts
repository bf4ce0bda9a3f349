import {
  CanvasTexture,
  Group,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
} from "three";
import { bottomOf } from "../model/footprints";
import { GHOST, ghostBox } from "../model/ghost";
import type { State } from "../model/state";
import type { BoxRecord } from "../net/protocol.gen";
import { type Spot, spotsOf, TURN_GAP } from "./handle_spots";
import type { LabelBox } from "./label_layout";
import { ACCENT } from "./palette";
import type { Eye, Part } from "./part";
import { locate } from "./sprite_labels";

const KNOB = 26; // CSS pixels seen; 44 can be touched
const DENSITY = 3; // canvas pixels per CSS pixel
const RING_WIDTH = 0.025; // metres

type Kind = Spot["kind"];

/** The handles of what is selected: knobs that keep their size, a ring for turning. */
export class HandlesView implements Part {
  readonly root = new Group();
  readonly #materials = new Map<Kind, SpriteMaterial>();
  /** Where the knobs are on the screen; always the same list. */
  readonly boxes: LabelBox[] = [];
  readonly #knobs: Sprite[] = [];
  readonly #ringMaterial = new MeshBasicMaterial({
    color: ACCENT,
    transparent: true,
    opacity: 0.55,
    depthTest: false,
    depthWrite: false,
    toneMapped: false,
  });
  readonly #ring = new Mesh(new RingGeometry(), this.#ringMaterial);
  #radius = 0;

  constructor() {
    this.#ring.renderOrder = 7;
    this.#ring.visible = false;
    this.root.add(this.#ring);
  }

  show(state: State): void {
    const spots = spotsOf(state);
    while (this.#knobs.length < spots.length) {
      const knob = new Sprite();
      knob.renderOrder = 21;
      this.#knobs.push(knob);
      this.boxes.push({ x: 0, y: 0, width: KNOB, height: KNOB, shown: true });
      this.root.add(knob);
    }
    this.#knobs.forEach((knob, i) => {
      const spot = spots[i];
      knob.visible = spot !== undefined;
      if (spot) {
        knob.material = this.#materialOf(spot.kind);
        knob.position.set(...spot.at);
      }
    });
    const turn = spots.find((spot) => spot.kind === "turn");
    const boxes = turn?.box === GHOST ? [ghostBox(state)] : state.scene.boxes;
    this.#showRing(boxes.find((box) => box !== null && box.id === turn?.box) ?? null);
  }

  update(eye: Eye): boolean {
    for (let i = 0; i < this.#knobs.length; i++) {
      const knob = this.#knobs[i];
      const box = this.boxes[i];
      if (knob && box) {
        box.shown = knob.visible;
        const scale = KNOB * locate(box, knob, eye);
        knob.scale.set(scale, scale, 1);
      }
    }
    return false;
  }

  dispose(): void {
    for (const material of this.#materials.values()) {
      material.map?.dispose();
      material.dispose();
    }
    this.#ring.geometry.dispose();
    this.#ringMaterial.dispose();
    this.root.clear();
  }

  #showRing(box: BoxRecord | null): void {
    this.#ring.visible = box !== null;
    if (!box) {
      return;
    }
    this.#ring.position.set(box.center[0], box.center[1], bottomOf(box) + 0.015);
    const radius = box.size[0] / 2 + TURN_GAP;
    if (radius !== this.#radius) {
      this.#radius = radius;
      this.#ring.geometry.dispose();
      this.#ring.geometry = new RingGeometry(radius - RING_WIDTH / 2, radius + RING_WIDTH / 2, 72);
    }
  }

  #materialOf(kind: Kind): SpriteMaterial {
    const known = this.#materials.get(kind);
    if (known) {
      return known;
    }
    const map = new CanvasTexture(knobPicture(kind));
    map.colorSpace = SRGBColorSpace;
    const material = new SpriteMaterial({
      map,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    this.#materials.set(kind, material);
    return material;
  }
}

/** What is drawn on a knob of 24 by 24. */
const SIGNS: Readonly<Record<Kind, string>> = {
  side: "",
  corner: "",
  end: "",
  height: "M12 6v12M8.500 9.500L12 6l3.500 3.500M8.500 14.500L12 18l3.500-3.500",
  turn: "M17 9a6 6 0 1 0 .8 4.500M17.500 5.500V9.300h-3.800",
};

function knobPicture(kind: Kind): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = KNOB * DENSITY;
  canvas.height = KNOB * DENSITY;
  const context = canvas.getContext("2d");
  if (!context) {
    return canvas;
  }
  context.scale(canvas.width / 24, canvas.height / 24);
  const signed = SIGNS[kind] !== "";
  context.beginPath();
  context.arc(12, 12, signed ? 10.8 : 7, 0, 2 * Math.PI);
  context.fillStyle = "#ffffff";
  context.fill();
  context.strokeStyle = ACCENT;
  context.lineWidth = signed ? 1.4 : 2.2;
  context.stroke();
  context.lineWidth = 1.8;
  context.lineCap = "round";
  context.lineJoin = "round";
  context.stroke(new Path2D(SIGNS[kind]));
  return canvas;
}
