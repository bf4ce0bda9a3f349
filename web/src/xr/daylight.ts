import { DirectionalLight, Group, LightProbe } from "three";

/** The light of the real room, where the device estimates it: one sun and what comes from around. */
export class Daylight {
  readonly root = new Group();
  readonly #around = new LightProbe();
  readonly #sun = new DirectionalLight();
  #probe: XRLightProbe | null = null;

  constructor() {
    this.root.add(this.#around, this.#sun, this.#sun.target);
    this.root.visible = false;
  }

  async begin(session: XRSession): Promise<void> {
    this.#probe = (await session.requestLightProbe?.().catch(() => null)) ?? null;
  }

  /** Takes over the light of the frame; true while there is an estimate. */
  update(frame: XRFrame): boolean {
    const estimate = this.#probe && frame.getLightEstimate?.(this.#probe);
    if (!estimate) return this.root.visible;
    const { x, y, z } = estimate.primaryLightDirection;
    const color = estimate.primaryLightIntensity;
    const strength = Math.max(1, color.x, color.y, color.z);
    this.#around.sh.fromArray(estimate.sphericalHarmonicsCoefficients);
    this.#sun.color.setRGB(color.x / strength, color.y / strength, color.z / strength);
    this.#sun.intensity = strength;
    this.#sun.position.set(x, y, z);
    this.root.visible = true;
    return true;
  }

  dispose(): void {
    this.root.removeFromParent();
    this.#sun.dispose();
  }
}
