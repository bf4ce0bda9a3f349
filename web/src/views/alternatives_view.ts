import { Group } from "three";
import { hangs } from "../model/hanging";
import type { Placing, State } from "../model/state";
import type { BoxRecord, Placement, SceneRecord } from "../net/protocol.gen";
import { BoxLines } from "./box_lines";
import { NumberLabels } from "./number_labels";
import { ACCENT, type Look } from "./palette";
import type { Eye, Part } from "./part";

const ABOVE = 0.01; // metres over what the places stand on
const FLAT = 0.001; // metres; only the footprint is drawn
const CALM = { color: ACCENT, width: 1.25, dashed: false, fill: 0, opacity: 0.6 } as const;

/** The place on offer if what matters most were not there. */
const OTHERWISE = { color: ACCENT, width: 2, dashed: true, fill: 0.12, opacity: 0.9 } as const;

/** The places on offer: thin footprints with their numbers, to be clicked. */
export class AlternativesView implements Part {
  readonly root = new Group();
  readonly #numbers = new NumberLabels();
  #look: Look;
  #footprints: BoxLines[] = [];
  readonly #otherwise = new BoxLines();

  constructor(look: Look) {
    this.#look = look;
    this.root.add(this.#numbers.root, this.#otherwise.root);
  }

  /** Where the numbers are on the screen; always the same list. */
  get numbers() {
    return this.#numbers.labels;
  }

  relight(look: Look): void {
    this.#look = look;
  }

  show(state: State): void {
    const { placing } = state;
    const placements = placing?.mode === "scenegen" ? (placing.answer?.placements ?? []) : [];
    while (this.#footprints.length < placements.length) {
      const lines = new BoxLines();
      this.#footprints.push(lines);
      this.root.add(lines.root);
    }
    this.#footprints.forEach((lines, i) => {
      const placement = placements[i];
      if (!placement || !placing || placement.rank === placing.alternative) {
        lines.hide();
      } else {
        lines.show(footprintOf(placement, placing, state.scene), CALM);
      }
    });
    this.#showOtherwise(placing);
    this.#numbers.show(placements, state, this.#look);
  }

  #showOtherwise(placing: Placing | null): void {
    const found = placing?.weigh?.result?.found;
    if (!placing || !found?.center || found.heading === null) {
      this.#otherwise.hide();
      return;
    }
    const { category, size } = placing;
    const { center, heading } = found;
    this.#otherwise.show({ id: "otherwise", category, center, size, heading }, OTHERWISE);
  }

  update(eye: Eye): boolean {
    this.#numbers.update(eye);
    return false;
  }

  dispose(): void {
    this.#otherwise.dispose();
    for (const lines of this.#footprints) {
      lines.dispose();
    }
    this.#numbers.dispose();
    this.#footprints = [];
  }
}

/** What is drawn of a place: where it would stand, or all of it on a wall. */
function footprintOf(
  { center, heading }: Placement,
  { category, size }: Placing,
  scene: SceneRecord,
): BoxRecord {
  const whole: BoxRecord = { id: "", category, heading, center, size };
  if (hangs(whole, scene)) {
    return whole;
  }
  const [depth, width, height] = size;
  const bottom = center[2] - height / 2;
  return { ...whole, center: [center[0], center[1], bottom + ABOVE], size: [depth, width, FLAT] };
}
