/** Which labels are shown when they would cover one another. Pure; CSS pixels. */

export interface LabelBox {
  x: number;
  y: number;
  width: number;
  height: number;
  shown: boolean;
}

const GAP = 3; // pixels between labels

/** Shows the first label, and of the others each that covers none shown before it; in place. */
export function hideOverlaps(labels: readonly LabelBox[]): void {
  for (let i = 0; i < labels.length; i++) {
    const label = labels[i];
    if (label) {
      label.shown = !coversOneBefore(label, labels, i);
    }
  }
}

function coversOneBefore(label: LabelBox, labels: readonly LabelBox[], count: number): boolean {
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
