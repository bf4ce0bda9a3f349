import type { WebGLRenderer } from "three";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";

/** Lines as wide in an XR session, whose pixels are the device's, as on the page: CSS pixels. */
export class Lines extends LineSegments2 {
  override onBeforeRender(renderer: WebGLRenderer): void {
    super.onBeforeRender(renderer);
    if (renderer.xr.isPresenting) this.material.resolution.set(innerWidth, innerHeight);
  }
}
