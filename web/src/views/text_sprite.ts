import {
  CanvasTexture,
  LinearFilter,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector3,
} from "three";
import { type Eye, metersPerPixel } from "./part";

const FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, sans-serif";
const DENSITY = 2; // canvas pixels per CSS pixel

export interface TextLook {
  /** CSS pixels. */
  readonly size: number;
  readonly color: string;
  readonly background: string;
  /** A dot before the text. */
  readonly chip?: string;
  readonly bold?: boolean;
  /** A line round the label. */
  readonly border?: string;
}

/** A short text on a rounded ground that keeps its size on the screen. */
export class TextSprite extends Sprite {
  /** CSS pixels. */
  readonly extent = { width: 0, height: 0 };
  readonly #canvas = document.createElement("canvas");
  readonly #world = new Vector3();
  #drawn = "";

  constructor() {
    super(new SpriteMaterial({ depthTest: false, depthWrite: false, toneMapped: false }));
    this.renderOrder = 20;
    this.visible = false;
  }

  /** Shows a text at a place of the core frame. */
  write(text: string, look: TextLook): void {
    this.visible = true;
    const drawn = `${text}|${look.size}|${look.color}|${look.background}|${look.chip}|${look.bold}|${look.border}`;
    if (drawn !== this.#drawn) {
      this.#drawn = drawn;
      this.#draw(text, look);
    }
  }

  /** Fits the sprite to the eye; call before each frame. */
  fit(eye: Eye): void {
    if (this.visible) {
      const scale = metersPerPixel(eye, this.getWorldPosition(this.#world));
      this.scale.set(this.extent.width * scale, this.extent.height * scale, 1);
    }
  }

  override dispose(): void {
    this.removeFromParent();
    this.material.map?.dispose();
    this.material.dispose();
  }

  #draw(text: string, look: TextLook): void {
    const context = this.#canvas.getContext("2d");
    if (!context) {
      return;
    }
    const font = `${look.bold ? 600 : 500} ${look.size}px ${FONT}`;
    context.font = font;
    const padding = look.size * 0.55;
    const chip = look.chip ? look.size * 0.95 : 0;
    const height = Math.ceil(look.size * 1.75);
    const width = Math.ceil(Math.max(height, context.measureText(text).width + 2 * padding + chip));
    this.extent.width = width;
    this.extent.height = height;
    this.#canvas.width = width * DENSITY;
    this.#canvas.height = height * DENSITY;
    context.scale(DENSITY, DENSITY);
    context.fillStyle = look.background;
    context.beginPath();
    context.roundRect(0.75, 0.75, width - 1.5, height - 1.5, height / 2);
    context.fill();
    if (look.border) {
      context.strokeStyle = look.border;
      context.lineWidth = 1.5;
      context.stroke();
    }
    drawText(context, text, look, font, (width - chip) / 2 + chip, height / 2);
    if (look.chip) {
      drawChip(
        context,
        look.chip,
        look.color,
        padding + look.size * 0.3,
        height / 2,
        look.size * 0.36,
      );
    }
    this.#upload();
  }

  /** A texture cannot change its size on the graphics card: a new one. */
  #upload(): void {
    this.material.map?.dispose();
    const texture = new CanvasTexture(this.#canvas);
    texture.colorSpace = SRGBColorSpace;
    texture.minFilter = LinearFilter;
    texture.generateMipmaps = false;
    this.material.map = texture;
    this.material.needsUpdate = true;
  }
}

function drawText(
  context: CanvasRenderingContext2D,
  text: string,
  look: TextLook,
  font: string,
  x: number,
  y: number,
): void {
  context.font = font;
  context.fillStyle = look.color;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, x, y + look.size * 0.04);
}

function drawChip(
  context: CanvasRenderingContext2D,
  color: string,
  line: string,
  x: number,
  y: number,
  radius: number,
): void {
  context.fillStyle = color;
  context.strokeStyle = line;
  context.lineWidth = 0.75;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.globalAlpha = 0.5;
  context.stroke();
}
