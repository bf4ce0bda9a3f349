/** Where the buttons of the floating panel are. Pure; pixels from its top left. */

export const LAYOUT = { width: 640, height: 330, top: 92, row: 64, gap: 10, side: 16 } as const;

export interface PlacedButton<Button> {
  readonly button: Button;
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Each row is as wide as the panel. */
export function placedButtons<Button>(
  rows: readonly (readonly Button[])[],
): readonly PlacedButton<Button>[] {
  const { width: whole, top, row, gap, side } = LAYOUT;
  return rows.flatMap((buttons, i) => {
    const width = (whole - 2 * side - gap * (buttons.length - 1)) / buttons.length;
    return buttons.map((button, j) => ({
      button,
      x: side + j * (width + gap),
      y: top + i * (row + gap),
      width,
      height: row,
    }));
  });
}

export function buttonAt<Button>(
  buttons: readonly PlacedButton<Button>[],
  x: number,
  y: number,
): Button | undefined {
  return buttons.find(
    (one) => x >= one.x && x <= one.x + one.width && y >= one.y && y <= one.y + one.height,
  )?.button;
}
