import { CanvasTexture, RepeatWrapping, SRGBColorSpace } from "three";

/** The side of the square that the texture shows, metres. */
export const FLOOR_TILE = 2.4;

const PIXELS = 1024;
const PLANKS = 16;
const STREAKS = 26;

/** Warm oak planks, drawn once; it repeats without a seam every FLOOR_TILE metres. */
export function oakTexture(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = PIXELS;
  canvas.height = PIXELS;
  const context = canvas.getContext("2d");
  if (context) {
    const chance = sequence(7);
    const height = PIXELS / PLANKS;
    for (let row = 0; row < PLANKS; row++) {
      drawRow(context, row * height, height, chance);
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.repeat.set(1 / FLOOR_TILE, 1 / FLOOR_TILE);
  texture.anisotropy = 8;
  return texture;
}

/** A row of two planks whose joints lie at a random place; the row wraps round at the edge. */
function drawRow(
  context: CanvasRenderingContext2D,
  y: number,
  height: number,
  chance: () => number,
): void {
  const joint = chance() * PIXELS;
  const length = PIXELS * (0.42 + 0.16 * chance());
  for (const [x, width] of [
    [joint, length],
    [joint + length, PIXELS - length],
  ] as const) {
    const paint = plankPaint(chance);
    for (const shift of [0, -PIXELS]) {
      drawPlank(context, x + shift, y, width, height, paint);
    }
  }
}

interface Paint {
  readonly base: string;
  readonly streaks: readonly (readonly [
    y: number,
    thickness: number,
    shade: string,
    bend: number,
  ])[];
}

function plankPaint(chance: () => number): Paint {
  const hue = 32 + 4 * chance();
  const lightness = 68 + 7 * chance();
  const streaks = Array.from({ length: STREAKS }, () => {
    const dark = chance() < 0.6;
    const shade = `hsla(${hue - 4}, ${dark ? 42 : 55}%, ${dark ? 42 : 84}%, ${0.03 + 0.09 * chance()})`;
    return [chance(), 0.5 + 3 * chance() ** 2, shade, (chance() - 0.5) * 10] as const;
  });
  return { base: `hsl(${hue}, ${32 + 8 * chance()}%, ${lightness}%)`, streaks };
}

function drawPlank(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  width: number,
  height: number,
  paint: Paint,
): void {
  context.save();
  context.beginPath();
  context.rect(x, y, width, height);
  context.clip();
  context.fillStyle = paint.base;
  context.fillRect(x, y, width, height);
  for (const [at, thickness, shade, bend] of paint.streaks) {
    context.strokeStyle = shade;
    context.lineWidth = thickness;
    context.beginPath();
    context.moveTo(x, y + at * height);
    context.bezierCurveTo(
      x + width * 0.3,
      y + at * height + bend,
      x + width * 0.7,
      y + at * height - bend,
      x + width,
      y + at * height,
    );
    context.stroke();
  }
  context.strokeStyle = "rgba(92, 62, 34, 0.38)";
  context.lineWidth = 1.6;
  context.strokeRect(x + 0.5, y + 0.5, width - 1, height - 1);
  context.restore();
}

/** Numbers between 0 and 1, the same on every visit (mulberry32). */
function sequence(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
