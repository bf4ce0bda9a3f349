import { type Object3D, Vector3 } from "three";
import type { LabelBox } from "./label_layout";
import { type Eye, metersPerPixel } from "./part";
import { TextSprite } from "./text_sprite";

/** A text in the room, and the place that it takes on the screen. */
export interface SpriteLabel extends LabelBox {
  readonly sprite: TextSprite;
}

const place = new Vector3();

export function spriteLabel(): SpriteLabel {
  return { sprite: new TextSprite(), x: 0, y: 0, width: 0, height: 0, shown: true };
}

/** Fits the sprite to the eye, and notes where on the screen it is. */
export function layOut(label: SpriteLabel, eye: Eye): void {
  const { sprite } = label;
  label.width = sprite.extent.width;
  label.height = sprite.extent.height;
  const scale = locate(label, sprite, eye);
  sprite.scale.set(label.width * scale, label.height * scale, 1);
}

/** Notes where on the screen the middle of something is; how many metres a pixel is there. */
export function locate(box: LabelBox, thing: Object3D, eye: Eye): number {
  thing.getWorldPosition(place);
  const scale = metersPerPixel(eye, place);
  place.project(eye.camera);
  // Half the height of the picture is one unit of y; x is stretched by the shape of the picture.
  const projection = eye.camera.projectionMatrix.elements;
  const stretch = (projection[5] ?? 1) / (projection[0] ?? 1);
  box.x = (place.x * stretch * eye.pixels) / 2;
  box.y = (place.y * eye.pixels) / 2;
  return scale;
}
