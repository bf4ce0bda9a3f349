import { Group } from "three";
import type { Placing, State } from "../model/state";
import type { Placement } from "../net/protocol.gen";
import { BoxLines } from "./box_lines";
import { hangs } from "./hanging";
import { ACCENT, type Look } from "./palette";
import type { Eye, Part } from "./part";
import { TextSprite } from "./text_sprite";

const ABOVE = 0.01; // metres over what the places stand on
const FLAT = 0.001; // metres; only the footprint is drawn

/** The other places on offer: faint footprints with their numbers, to be clicked. */
export class AlternativesView implements Part {
  readonly root = new Group();
  #look: Look;
  #places: { readonly lines: BoxLines; readonly number: TextSprite }[] = [];

  constructor(look: Look) {
    this.#look = look;
  }

  relight(look: Look): void {
    this.#look = look;
  }

  show(state: State): void {
    const { placing } = state;
    const placements = placing?.mode === "scenegen" ? (placing.answer?.placements ?? []) : [];
    while (this.#places.length < placements.length) {
      this.#add();
    }
    this.#places.forEach(({ lines, number }, i) => {
      const placement = placements[i];
      if (!placement || !placing || placement.rank === placing.alternative) {
        lines.hide();
        number.visible = false;
      } else {
        this.#showPlace(lines, number, placement, placing);
      }
    });
  }

  update(eye: Eye): boolean {
    for (const { number } of this.#places) {
      number.fit(eye);
    }
    return false;
  }

  dispose(): void {
    for (const { lines, number } of this.#places) {
      lines.dispose();
      number.dispose();
    }
    this.#places = [];
  }

  #add(): void {
    const place = { lines: new BoxLines(), number: new TextSprite() };
    this.#places.push(place);
    this.root.add(place.lines.root, place.number);
  }

  #showPlace(
    lines: BoxLines,
    number: TextSprite,
    placement: Placement,
    { category, size }: Placing,
  ): void {
    const { center, heading, rank } = placement;
    const bottom = center[2] - size[2] / 2;
    const onWall = hangs({ id: "", category, center, size });
    const [depth, width, height] = size;
    lines.show(
      onWall
        ? { id: "", category, heading, center, size }
        : {
            id: "",
            category,
            heading,
            center: [center[0], center[1], bottom + ABOVE],
            size: [depth, width, FLAT],
          },
      { color: ACCENT, width: 1.6, dashed: false, fill: onWall ? 0 : 0.1 },
    );
    number.position.set(center[0], center[1], onWall ? center[2] : bottom + Math.min(0.25, height));
    number.write(String(rank), {
      size: 15,
      bold: true,
      color: this.#look.labelText,
      background: this.#look.label,
      border: ACCENT,
    });
  }
}
