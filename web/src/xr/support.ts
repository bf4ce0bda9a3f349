/** Whether this browser can show the real room, and why not. */
import type { ArSupport } from "../model/state";

export interface Surroundings {
  readonly isSecureContext: boolean;
  readonly xr: Pick<XRSystem, "isSessionSupported"> | undefined;
}

export async function arSupport({ isSecureContext, xr }: Surroundings): Promise<ArSupport> {
  if (!isSecureContext) return "insecure";
  if (xr === undefined) return "missing";
  try {
    return (await xr.isSessionSupported("immersive-ar")) ? "yes" : "missing";
  } catch {
    return "refused"; // a frame or a policy forbids it
  }
}

/** Whether a link to a model opens it in the real room, in a viewer of the system's own. */
export function quickLook({ relList }: Pick<HTMLAnchorElement, "relList">): boolean {
  return relList.supports("ar");
}
