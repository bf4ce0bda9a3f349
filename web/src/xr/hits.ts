/** Where the view, or a finger on the screen, meets a real surface. */
import { isLevel } from "./rays";

type Source = XRHitTestSource | XRTransientInputHitTestSource;

export class Hits {
  #view: XRHitTestSource | null = null;
  #fingers: XRTransientInputHitTestSource | null = null;

  /** Begins to look; fingers are looked for where the device has a touchscreen. */
  async begin(session: XRSession): Promise<void> {
    const space = await session.requestReferenceSpace("viewer");
    this.#view = (await session.requestHitTestSource?.({ space })) ?? null;
    const profile = { profile: "generic-touchscreen" };
    this.#fingers =
      (await session.requestHitTestSourceForTransientInput?.(profile)?.catch(() => null)) ?? null;
  }

  end(): void {
    for (const source of [this.#view, this.#fingers] as readonly (Source | null)[]) {
      source?.cancel();
    }
    this.#view = null;
    this.#fingers = null;
  }

  /** The level surface in the middle of the view, in the frame of `space`; null if there is none. */
  inView(frame: XRFrame, space: XRSpace): XRRigidTransform | null {
    return this.#view && levelOf(frame.getHitTestResults(this.#view), space);
  }

  /** The level surface under the finger of an input; null if it cannot be told. */
  under(frame: XRFrame, input: XRInputSource, space: XRSpace): XRRigidTransform | null {
    if (this.#fingers === null) return null;
    const all = frame.getHitTestResultsForTransientInput(this.#fingers);
    const own = all.find(({ inputSource }) => inputSource === input);
    return own === undefined ? null : levelOf(own.results, space);
  }
}

/** The first hit decides: a floor behind a table top is not what is pointed at. */
function levelOf(results: readonly XRHitTestResult[], space: XRSpace): XRRigidTransform | null {
  const transform = results[0]?.getPose(space)?.transform;
  return transform !== undefined && isLevel(transform) ? transform : null;
}
