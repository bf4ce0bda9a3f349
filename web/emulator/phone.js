/**
 * A phone with a camera, emulated in the browser: what iwer lacks of one, in small shims.
 *
 * A classic script, run before the page's own after iwer's and @iwer/sem's (their UMD builds, whose
 * globals are IWER and IWER_SEM). It turns touches of the window into screen input of the XR
 * session, as Chrome on Android does, and has: dom-overlay, beforexrselect, transient hit tests,
 * light estimation, loss of tracking. See README.md. Checked with iwer 2.5.0, @iwer/sem 2.4.0.
 */
(() => {
  const FOV = (66 * Math.PI) / 180; // radians, upright, as the cameras of phones have it
  const ALWAYS = ["viewer", "local", "local-floor", "hit-test"];
  const OPTIONAL = ["dom-overlay", "anchors"];

  function install(features = OPTIONAL) {
    keepTransparent();
    const device = new IWER.XRDevice(config(features), { fovy: FOV });
    device.ipd = 0;
    device.stereoEnabled = false;
    device.installRuntime({ forceInstall: true });
    device.installSEM(IWER_SEM.SyntheticEnvironmentModule);
    const state = { lost: false, overlay: null };
    offsetSpaces();
    seeWithOneEye(device, state);
    overlayDom(device, state);
    testHitsOfFingers(device);
    estimateLight();
    touchTheScreen(device, state);
    return phone(device, state);
  }

  /** A Quest 3 that shows no page in front of the room; its right controller does what is done. */
  function installHeadset() {
    keepTransparent();
    const device = new IWER.XRDevice(IWER.metaQuest3);
    device.installRuntime({ forceInstall: true });
    device.installSEM(IWER_SEM.SyntheticEnvironmentModule);
    offsetSpaces();
    const hand = device.controllers.right;
    const pull = (value) => hand.updateButtonValue("trigger", value);
    return {
      ...phone(device, { lost: false }),
      point(target) {
        const { x, y, z } = hand.position;
        hand.quaternion.set(...turnToward(subtract(target, [x, y, z])));
      },
      /** Holds the controller somewhere. */
      reach: (at) => hand.position.set(...at),
      pull: () => pull(1),
      release: () => pull(0),
    };
  }

  function config(features) {
    return {
      name: "Phone",
      controllerConfig: undefined,
      supportedSessionModes: ["inline", "immersive-ar"],
      supportedFeatures: [...ALWAYS, ...features],
      supportedFrameRates: [60],
      isSystemKeyboardSupported: true,
      internalNominalFrameRate: 60,
      environmentBlendModes: { "immersive-ar": "alpha-blend" },
      interactionMode: "screen-space",
      userAgent: navigator.userAgent,
    };
  }

  /** What tests do with the phone. Places are in the device's frame: metres, y up. */
  function phone(device, state) {
    return {
      device,
      /** Stands in a room: JSON as @iwer/sem's captures have it. */
      enter(room) {
        device.sem.loadEnvironment(room);
        device.sem.meshesVisible = false;
        device.sem.planesVisible = true;
        device.sem.boundingBoxesVisible = true;
      },
      /** Holds the phone at a place and points its middle at another. */
      look(eye, target) {
        device.position.set(...eye);
        device.quaternion.set(...turnToward(subtract(target, eye)));
      },
      /** The system shows something else, or the page again: "visible", "visible-blurred", "hidden". */
      show: (visibility) => device.updateVisibilityState(visibility),
      /** Tracking is lost, or found again. */
      lose(lost) {
        state.lost = lost;
      },
      /** Whether a touch is still on its way through the frames. */
      get touched() {
        return fingersOf(device).length > 0;
      },
      get presenting() {
        return device.activeSession !== undefined;
      },
    };
  }

  /** The camera's image lies behind the page's picture, so that one must let it through. */
  function keepTransparent() {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (type, options) {
      return getContext.call(this, type, type === "webgl2" ? { ...options, alpha: true } : options);
    };
  }

  /** iwer 2.5.0 takes the transform for its matrix. */
  function offsetSpaces() {
    XRReferenceSpace.prototype.getOffsetReferenceSpace = function (offset) {
      return new XRReferenceSpace("local-floor", this, offset.matrix);
    };
  }

  /** iwer always has two eyes. A phone without tracking has no pose. */
  function seeWithOneEye(device, state) {
    const { getViewerPose } = XRFrame.prototype;
    XRFrame.prototype.getViewerPose = function (space) {
      if (state.lost) return null;
      const pose = getViewerPose.call(this, space);
      const views = pose.views.slice(0, 1);
      Object.defineProperty(pose, "views", { value: views });
      return pose;
    };
  }

  /** The overlay is in front of the picture; a touch of it asks first (beforexrselect). */
  function overlayDom(device, state) {
    const { requestSession } = XRSystem.prototype;
    XRSystem.prototype.requestSession = async function (mode, init = {}) {
      const session = await requestSession.call(this, mode, init);
      if (!session.enabledFeatures.includes("dom-overlay")) return session;
      state.overlay = init.domOverlay.root;
      Object.defineProperty(session, "domOverlayState", { value: { type: "screen" } });
      device.canvasContainer.style.zIndex = "-1";
      device.canvasContainer.style.pointerEvents = "none";
      session.addEventListener("end", () => {
        state.overlay = null;
      });
      return session;
    };
  }

  /** Hit tests along the rays of fingers, by a hit test of one's own for each of them. */
  function testHitsOfFingers(device) {
    const sources = new WeakMap();
    XRSession.prototype.requestHitTestSourceForTransientInput = async function () {
      const source = { cancel() {} };
      sources.set(source, this);
      return source;
    };
    XRFrame.prototype.getHitTestResultsForTransientInput = function (source) {
      if (!sources.has(source)) throw new DOMException("Not a source", "InvalidStateError");
      return fingersOf(device).map(({ inputSource }) => ({
        inputSource,
        results: hitsAlong(device, this, inputSource.targetRaySpace),
      }));
    };
  }

  /** What the emulated room says that a ray meets: its results, nearest first. */
  function hitsAlong(device, frame, space) {
    const { matrix } = frame.getPose(space, new XRSpace(undefined)).transform;
    return device.sem.computeHitTestResults(matrix).map((found) => {
      const at = new XRSpace(undefined, found);
      return { getPose: (base) => frame.getPose(at, base), createAnchor: () => Promise.reject() };
    });
  }

  function estimateLight() {
    XRSession.prototype.requestLightProbe = async function () {
      if (!this.enabledFeatures.includes("light-estimation")) {
        throw new DOMException("No light estimation", "NotSupportedError");
      }
      return new EventTarget();
    };
    XRFrame.prototype.getLightEstimate = () => ({
      sphericalHarmonicsCoefficients: Float32Array.from({ length: 27 }, (_, i) => (i < 3 ? 1.2 : 0)),
      primaryLightDirection: { x: 0.3, y: 0.9, z: 0.3, w: 0 },
      primaryLightIntensity: { x: 2, y: 1.9, z: 1.7, w: 1 },
    });
  }

  const FINGER = "finger ";

  function fingersOf(device) {
    return Object.entries(device.controllers)
      .filter(([name]) => name.startsWith(FINGER))
      .map(([, finger]) => finger);
  }

  /** Touches become screen input: there for one frame before it selects, as on Android. */
  function touchTheScreen(device, state) {
    const down = ({ pointerId, clientX, clientY, target }) => {
      if (device.activeSession === undefined || isKept(state, target)) return;
      const name = FINGER + pointerId;
      const leave = () => delete device.controllers[name];
      device.controllers[name] = finger(device, [clientX, clientY], leave);
    };
    const move = ({ pointerId, clientX, clientY }) =>
      device.controllers[FINGER + pointerId]?.move(clientX, clientY);
    const up = ({ pointerId }) => device.controllers[FINGER + pointerId]?.lift();
    addEventListener("pointerdown", down, true);
    addEventListener("pointermove", move, true);
    addEventListener("pointerup", up, true);
    addEventListener("pointercancel", up, true);
  }

  /** Whether the overlay keeps a touch for itself. Without an overlay nothing can. */
  function isKept({ overlay }, target) {
    if (overlay === null || !overlay.contains(target)) return false;
    return !target.dispatchEvent(
      new Event("beforexrselect", { bubbles: true, cancelable: true, composed: true }),
    );
  }

  function finger(device, first, leave) {
    let place = first;
    let step = "touched"; // then "held", "lifted"
    let lifted = false;
    const inputSource = new XRInputSource("none", "screen", ["generic-touchscreen"], undefined);
    const ray = { get: () => new XRSpace(device.viewerSpace, rayThrough(place)) };
    Object.defineProperty(inputSource, "targetRaySpace", ray);
    const tell = (frame, type) =>
      frame.session.dispatchEvent(new XRInputSourceEvent(type, { frame, inputSource }));
    return {
      inputSource,
      connected: true,
      move(clientX, clientY) {
        place = [clientX, clientY];
      },
      lift() {
        lifted = true;
      },
      onFrameStart(frame) {
        if (step === "lifted") {
          leave();
        } else if (step === "held" && lifted) {
          tell(frame, "select");
          tell(frame, "selectend");
          step = "lifted";
        } else if (step === "touched" && frame.session.inputSources.includes(inputSource)) {
          tell(frame, "selectstart");
          step = "held";
        }
      },
    };
  }

  /** The pose, within the view, whose −z goes through a point of the window. */
  function rayThrough([x, y]) {
    const tall = Math.tan(FOV / 2);
    const wide = (tall * innerWidth) / innerHeight;
    const direction = [((x / innerWidth) * 2 - 1) * wide, (1 - (y / innerHeight) * 2) * tall, -1];
    const [ux, uy, uz, w] = turnToward(direction);
    return rotation(ux, uy, uz, w);
  }

  const subtract = (a, b) => a.map((one, i) => one - b[i]);

  /** The quaternion that turns −z toward a direction and leaves the horizon level. */
  function turnToward([x, y, z]) {
    const yaw = Math.atan2(-x, -z) / 2;
    const pitch = Math.atan2(y, Math.hypot(x, z)) / 2;
    const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    return [cy * sp, sy * cp, -sy * sp, cy * cp];
  }

  /** The matrix of a quaternion, column by column. */
  function rotation(x, y, z, w) {
    return new Float32Array([
      1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0,
      2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0,
      2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0,
      0, 0, 0, 1,
    ]);
  }

  globalThis.installPhone = install;
  globalThis.installHeadset = installHeadset;
})();
