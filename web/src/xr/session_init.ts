/** What is asked of the browser to show things in the real room. Pure. */
import { ROOM_CAPTURE } from "../model/ar";

/** Without these nothing can be put anywhere. */
export const REQUIRED = ["hit-test", "local-floor"] as const;

/** Each is used where it is granted, and its absence does no harm. The camera's image is none. */
export const OPTIONAL = [
  "dom-overlay",
  "anchors",
  "plane-detection",
  "mesh-detection",
  "depth-sensing",
  "light-estimation",
] as const;

/** The overlay holds the panels. */
export function sessionInit(overlay: Element): XRSessionInit {
  return {
    requiredFeatures: [...REQUIRED],
    optionalFeatures: [...OPTIONAL],
    domOverlay: { root: overlay },
    // Depth stays on the graphics card, where it hides what stands behind real things.
    depthSensing: {
      usagePreference: ["gpu-optimized"],
      dataFormatPreference: ["luminance-alpha", "float32"],
    },
  };
}

/** The features that a session has; browsers that do not say have at least what is required. */
export function grantedFeatures(session: {
  readonly enabledFeatures?: readonly string[] | undefined;
  readonly initiateRoomCapture?: unknown;
}): readonly string[] {
  const features = session.enabledFeatures ?? REQUIRED;
  return session.initiateRoomCapture === undefined ? features : [...features, ROOM_CAPTURE];
}
