import { Group, Vector3 } from "three";
import { hangs } from "../model/hanging";
import type { Placing, State } from "../model/state";
import type { Placement, SceneRecord } from "../net/protocol.gen";
import { coversOne } from "./label_layout";
import { ACCENT, type Look } from "./palette";
import type { Eye } from "./part";
import { layOut, type SpriteLabel, spriteLabel } from "./sprite_labels";

const OVER_GHOST = 0.12; // metres
/** Where in a footprint a number may stand, in halves of its depth and width; the first first. */
const SPOTS = [
  [0, 0],
  [0, 0.62],
  [0, -0.62],
  [0.62, 0],
  [-0.62, 0],
  [0.62, 0.7],
  [0.62, -0.7],
] as const;

interface Numbered extends SpriteLabel {
  /** Where it may stand, core frame. */
  readonly places: Vector3[];
}

/** The numbers of the places on offer, each where it covers no other; the chosen one is filled. */
export class NumberLabels {
  readonly root = new Group();
  readonly labels: Numbered[] = [];

  /** Shows a number for each placement, and over the ghost the one that it stands on. */
  show(placements: readonly Placement[], { placing, scene }: State, look: Look): void {
    while (this.labels.length < placements.length) {
      const label = { ...spriteLabel(), places: SPOTS.map(() => new Vector3()) };
      this.labels.push(label);
      this.root.add(label.sprite);
    }
    this.labels.forEach((label, i) => {
      const placement = placements[i];
      label.shown = placement !== undefined && placing !== null;
      label.sprite.visible = label.shown;
      if (placement && placing) {
        const chosen = placement.rank === placing.alternative;
        arrange(label, placement, placing, scene);
        label.sprite.write(String(placement.rank), {
          size: 15,
          bold: true,
          color: chosen ? "#ffffff" : look.labelText,
          background: chosen ? ACCENT : look.label,
          border: ACCENT,
        });
      }
    });
  }

  update(eye: Eye): void {
    for (let i = 0; i < this.labels.length; i++) {
      const label = this.labels[i];
      if (label?.shown) {
        settle(label, this.labels, i, eye);
      }
    }
  }

  dispose(): void {
    for (const { sprite } of this.labels) {
      sprite.dispose();
    }
    this.labels.length = 0;
  }
}

/** Moves the number to its first place where it covers none before it; else to its first. */
function settle(label: Numbered, all: readonly Numbered[], before: number, eye: Eye): void {
  for (const place of label.places) {
    moveTo(label, place, eye);
    if (!coversOne(label, all, before)) {
      return;
    }
  }
  moveTo(label, label.places[0] ?? label.sprite.position, eye);
}

function moveTo(label: Numbered, place: Vector3, eye: Eye): void {
  label.sprite.position.copy(place);
  label.sprite.updateMatrixWorld();
  layOut(label, eye);
}

/** Over the ghost, or within the footprint; on a wall within its height instead of its depth. */
function arrange(
  label: Numbered,
  placement: Placement,
  placing: Placing,
  scene: SceneRecord,
): void {
  const { center, heading } = placement;
  const { category, size } = placing;
  const [depth, width, height] = size;
  const chosen = placement.rank === placing.alternative;
  const onWall = hangs({ id: "", category, center, size }, scene);
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  SPOTS.forEach(([ahead, left], i) => {
    const [u, v] = [onWall ? 0 : (ahead * depth) / 2, (left * width) / 2];
    const x = center[0] + u * cos - v * sin;
    const y = center[1] + u * sin + v * cos;
    const bottom = center[2] - height / 2;
    const z = onWall ? center[2] + (ahead * height) / 2 : bottom;
    label.places[i]?.set(x, y, chosen ? center[2] + height / 2 + OVER_GHOST : z);
  });
}
