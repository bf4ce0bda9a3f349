/** A camera view that is never there. */
import type { ArControls } from "../../web/src/contract";

export const NO_AR: ArControls = {
  start: async () => {},
  end: () => {},
  mark: () => {},
  lineUp: () => {},
  turnRound: () => {},
  capture: () => {},
};
