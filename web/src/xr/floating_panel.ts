import {
  CanvasTexture,
  LinearFilter,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
  Vector3,
} from "three";
import type { FloatingContent, PanelButton } from "../contract";
import type { Vector3 as Place } from "../model/state";
import type { Ray } from "../views/picking";
import { buttonAt, LAYOUT, type PlacedButton, placedButtons } from "./panel_layout";

const METERS = 0.001; // a pixel of the panel
const AHEAD = 0.9; // metres from the eye
const BELOW = 0.32; // metres under the eye
const TURNED = 0.6; // radians; when the eye has turned so far from the panel, it comes along
const FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, sans-serif";

/**
 * The panel of a device that shows nothing of the page in front of the room: one sentence and its
 * buttons, below what is looked at. It keeps its place until the eye turns away from it.
 */
export class FloatingPanel {
  readonly root: Mesh<PlaneGeometry, MeshBasicMaterial>;
  readonly #canvas = document.createElement("canvas");
  readonly #texture = new CanvasTexture(this.#canvas);
  readonly #at = new Vector3();
  #buttons: readonly PlacedButton<PanelButton>[] = [];
  #drawn = "";
  #turn = Number.NaN;

  constructor() {
    this.#canvas.width = LAYOUT.width;
    this.#canvas.height = LAYOUT.height;
    this.#texture.colorSpace = SRGBColorSpace;
    this.#texture.minFilter = LinearFilter;
    const material = new MeshBasicMaterial({
      map: this.#texture,
      transparent: true,
      depthTest: false,
      toneMapped: false,
    });
    const size = [LAYOUT.width * METERS, LAYOUT.height * METERS] as const;
    this.root = new Mesh(new PlaneGeometry(...size), material);
    this.root.renderOrder = 30;
  }

  /** Draws what is new. */
  show(content: FloatingContent): void {
    this.#buttons = placedButtons(content.rows);
    const words = JSON.stringify(content);
    if (words === this.#drawn) return;
    this.#drawn = words;
    this.#draw(content);
    this.#texture.needsUpdate = true;
  }

  /** Stays below what the eye looks at; both in the core frame. */
  follow({ origin, direction }: Ray): void {
    const turn = Math.atan2(direction[1], direction[0]);
    const away = Math.atan2(Math.sin(turn - this.#turn), Math.cos(turn - this.#turn));
    if (Number.isNaN(this.#turn) || Math.abs(away) > TURNED) this.#turn = turn;
    const [x, y, z] = origin;
    this.#at.set(x + Math.cos(this.#turn) * AHEAD, y + Math.sin(this.#turn) * AHEAD, z - BELOW);
    this.root.position.copy(this.#at);
    this.root.rotation.set(0, 0, 0);
    // Upright in the core frame, its face toward the eye, leaning back a little.
    this.root.rotateZ(this.#turn - Math.PI / 2);
    this.root.rotateX(Math.PI / 2 - Math.atan2(BELOW, AHEAD));
  }

  /** The button that a ray meets: null beside the panel, "none" between the buttons. */
  at({ origin, direction }: Ray): PanelButton | "none" | null {
    this.root.updateMatrix();
    const inverse = this.root.matrix.clone().invert();
    const start = new Vector3(...origin).applyMatrix4(inverse);
    const end = new Vector3(...sum(origin, direction)).applyMatrix4(inverse);
    const share = start.z / (start.z - end.z);
    if (!(share > 0)) return null;
    const x = (start.x + (end.x - start.x) * share) / METERS + LAYOUT.width / 2;
    const y = LAYOUT.height / 2 - (start.y + (end.y - start.y) * share) / METERS;
    if (x < 0 || y < 0 || x > LAYOUT.width || y > LAYOUT.height) return null;
    return buttonAt(this.#buttons, x, y) ?? "none";
  }

  dispose(): void {
    this.root.removeFromParent();
    this.root.geometry.dispose();
    this.root.material.dispose();
    this.#texture.dispose();
  }

  #draw({ title }: FloatingContent): void {
    const pen = this.#canvas.getContext("2d");
    if (pen === null) return;
    pen.clearRect(0, 0, LAYOUT.width, LAYOUT.height);
    pen.fillStyle = "rgb(255 255 255 / 0.94)";
    rounded(pen, 0, 0, LAYOUT.width, LAYOUT.height, 28);
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = "#22201c";
    pen.font = `600 26px ${FONT}`;
    linesOf(pen, title).forEach((line, i) => {
      pen.fillText(line, LAYOUT.width / 2, 36 + i * 32);
    });
    for (const { button, x, y, width, height } of this.#buttons) {
      pen.fillStyle = button.primary ? "#2f6fed" : "#efece5";
      rounded(pen, x, y, width, height, 14);
      pen.fillStyle = button.primary ? "#ffffff" : "#22201c";
      pen.font = `600 22px ${FONT}`;
      pen.fillText(button.label, x + width / 2, y + height / 2, width - 12);
    }
  }
}

function rounded(
  pen: CanvasRenderingContext2D,
  x: number,
  y: number,
  width: number,
  height: number,
  radius: number,
): void {
  pen.beginPath();
  pen.roundRect(x, y, width, height, radius);
  pen.fill();
}

/** The title in two lines at most. */
function linesOf(pen: CanvasRenderingContext2D, title: string): readonly string[] {
  const words = title.split(" ");
  const fits = (count: number): boolean =>
    pen.measureText(words.slice(0, count).join(" ")).width < LAYOUT.width - 48;
  let count = words.length;
  while (count > 1 && !fits(count)) count -= 1;
  const [first, second] = [words.slice(0, count), words.slice(count)];
  return second.length === 0 ? [first.join(" ")] : [first.join(" "), second.join(" ")];
}

function sum(a: Place, b: Place): Place {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
