import { Group } from "three";
import type { Assets } from "../contract";
import type { Segment } from "../model/geometry";
import type { State } from "../model/state";
import { AlternativesView } from "./alternatives_view";
import { CORE_IN_PAGE } from "./axes";
import { DraftView } from "./draft_view";
import { FurnitureView } from "./furniture_view";
import { GhostView } from "./ghost_view";
import { GraphView } from "./graph_view";
import { HandlesView } from "./handles_view";
import { HeatView } from "./heat_view";
import { LabelsView } from "./labels_view";
import { Lights } from "./lights";
import type { Look } from "./palette";
import type { Eye, Part } from "./part";
import { ProbeView } from "./probe_view";
import { RoomView } from "./room_view";
import { SidesView } from "./sides_view";
import { Solids } from "./solids";
import { Veil } from "./veil";

/**
 * All there is to see, below one group that stands in the core frame. It knows neither the
 * renderer nor who drives the frames, so that an XR session can show the same.
 */
export class Scenery implements Part {
  readonly root = new Group();
  readonly #furniture: FurnitureView;
  readonly #draft: DraftView;
  readonly #graph: GraphView;
  readonly #solids: Solids;
  readonly #lights: Lights;
  readonly #parts: readonly Part[];
  readonly #lit: readonly { relight(look: Look): void }[];
  #state: State | null = null;
  #hovered: string | null = null;

  constructor(assets: Assets, look: Look, changed: () => void) {
    this.root.matrixAutoUpdate = false;
    this.root.matrix.copy(CORE_IN_PAGE);
    this.#solids = new Solids(assets, () => {
      if (this.#state) {
        this.show(this.#state);
        changed();
      }
    });
    const lights = new Lights(look);
    this.#lights = lights;
    const room = new RoomView(look);
    const handles = new HandlesView();
    const alternatives = new AlternativesView(look);
    const sides = new SidesView(look, [alternatives.numbers, handles.boxes]);
    const labels = new LabelsView(look, [alternatives.numbers, handles.boxes, sides.labels]);
    const probe = new ProbeView(look);
    const veil = new Veil(look);
    this.#furniture = new FurnitureView(this.#solids);
    this.#draft = new DraftView(look, [handles.boxes]);
    this.#graph = new GraphView(look, [handles.boxes]);
    this.#parts = [
      lights,
      room,
      this.#furniture,
      new HeatView(),
      alternatives,
      new GhostView(this.#solids),
      handles,
      sides,
      labels,
      this.#graph,
      this.#draft,
      veil,
      probe,
    ];
    this.#lit = [lights, room, alternatives, sides, labels, this.#graph, this.#draft, probe, veil];
    for (const part of this.#parts) {
      this.root.add(part.root);
    }
  }

  show(state: State): void {
    this.#state = state;
    this.root.visible = state.ar === null || state.ar.step === "ready";
    for (const part of this.#parts) {
      part.show(state);
    }
  }

  /** Which box is pointed at; true if that is news. */
  hover(id: string | null): boolean {
    if (id === this.#hovered) {
      return false;
    }
    this.#hovered = id;
    this.#furniture.hover(id);
    this.#graph.hover(id);
    return true;
  }

  /** What the thing that is dragged has snapped to. */
  guide(guides: readonly Segment[]): void {
    this.#draft.guide(guides);
  }

  /** Switches its own lights on or off. */
  light(on: boolean): void {
    this.#lights.root.visible = on;
  }

  /** For another time of the day. */
  relight(look: Look): void {
    for (const part of this.#lit) {
      part.relight(look);
    }
    if (this.#state) {
      this.show(this.#state);
    }
  }

  update(eye: Eye): boolean {
    let moving = false;
    for (const part of this.#parts) {
      moving = (part.update?.(eye) ?? false) || moving;
    }
    return moving;
  }

  dispose(): void {
    for (const part of this.#parts) {
      part.dispose();
    }
    this.#solids.dispose();
    this.root.removeFromParent();
  }
}
