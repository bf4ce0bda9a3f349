/** The way into the real room. What it needs is fetched when somebody goes there. */
import type { ArControls } from "../contract";
import type { Ar, Point } from "../model/state";
import type { ArView, Ties } from "./ar_view";
import { sessionInit } from "./session_init";
import { arSupport } from "./support";

const NOT_ALLOWED =
  "The browser did not allow the camera. Allow it for this page, then start again.";
const FAILED = "The camera view could not start on this device. You can go on here.";

export interface ArEntry extends ArControls {
  /** Where the phone points on the floor; null while the camera is off. */
  viewPoint(): Point | null;
}

export function createAr(ties: Ties): ArEntry {
  const { xr } = navigator;
  const { dispatch } = ties.store;
  let view: ArView | null = null;
  void arSupport({ isSecureContext, xr }).then((support) =>
    dispatch({ type: "ar-support", support }),
  );

  async function start(room: Ar["room"]): Promise<void> {
    if (xr === undefined || view !== null) return;
    try {
      // Asked for first: it must follow the tap at once.
      const asked = xr.requestSession("immersive-ar", sessionInit(document.body));
      const [session, module] = await Promise.all([asked, import("./ar_view")]);
      session.addEventListener("end", () => {
        view = null;
      });
      view = new module.ArView(ties, session);
      await view.begin(room);
      ties.changed();
    } catch (error) {
      view?.end();
      const refused = error instanceof DOMException && error.name === "NotAllowedError";
      dispatch({ type: "notify", tone: "problem", text: refused ? NOT_ALLOWED : FAILED });
    }
  }

  return {
    start,
    end: () => view?.end(),
    mark: () => view?.mark(),
    lineUp: () => view?.lineUp(),
    turnRound: () => view?.turnRound(),
    capture: () => view?.capture(),
    viewPoint: () => view?.viewPoint() ?? null,
  };
}
