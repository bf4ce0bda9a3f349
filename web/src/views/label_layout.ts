/** Which labels are shown when they would cover one another. Pure; CSS pixels. */

export interface LabelBox {
  x: number;
  y: number;
  width: number;
  height: number;
  shown: boolean;
}

const GAP = 3; // pixels between labels

export const NOTHING: readonly (readonly LabelBox[])[] = [];

/** Shows each label that covers none shown before it, nor one in any list of `taken`; in place. */
export function hideOverlaps(
  labels: readonly LabelBox[],
  taken: readonly (readonly LabelBox[])[] = NOTHING,
): void {
  for (let i = 0; i < labels.length; i++) {
    const label = labels[i];
    if (label) {
      label.shown = !coversOne(label, labels, i) && !coversAny(label, taken);
    }
  }
}

/** Whether the label covers one that is shown in any of the lists. */
export function coversAny(label: LabelBox, lists: readonly (readonly LabelBox[])[]): boolean {
  for (const list of lists) {
    if (coversOne(label, list, list.length)) {
      return true;
    }
  }
  return false;
}

/** Whether the label covers one that is shown, of the first `count`. */
export function coversOne(label: LabelBox, labels: readonly LabelBox[], count: number): boolean {
  for (let i = 0; i < count; i++) {
    const other = labels[i];
    if (other?.shown && cover(label, other)) {
      return true;
    }
  }
  return false;
}

function cover(a: LabelBox, b: LabelBox): boolean {
  return (
    Math.abs(a.x - b.x) < (a.width + b.width) / 2 + GAP &&
    Math.abs(a.y - b.y) < (a.height + b.height) / 2 + GAP
  );
}
