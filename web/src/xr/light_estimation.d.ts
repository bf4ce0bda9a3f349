/** The WebXR Lighting Estimation API, as far as it is used; @types/webxr does not have it. */

interface XRLightProbe extends EventTarget {
  readonly probeSpace: XRSpace;
}

interface XRLightEstimate {
  /** 27 numbers: nine coefficients of red, green and blue. */
  readonly sphericalHarmonicsCoefficients: Float32Array;
  readonly primaryLightDirection: DOMPointReadOnly;
  readonly primaryLightIntensity: DOMPointReadOnly;
}

interface XRSession {
  requestLightProbe?(): Promise<XRLightProbe>;
}

interface XRFrame {
  getLightEstimate?(probe: XRLightProbe): XRLightEstimate | null;
}
