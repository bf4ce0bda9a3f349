/** What a panel is given: the state, how to change it, and what only the panels need to know. */
import type { JoinInfo, Services } from "../contract";
import type { Action } from "../model/actions";
import type { KnowledgeMarginals } from "../model/knowledge";
import type { Mode, Point, State, Vector3 } from "../model/state";
import type { SceneRecord } from "../net/protocol.gen";

export type SheetHeight = "peek" | "half" | "full";

/** The first minute: the invitation, the first sofa on its way, the three doors, done. */
export type Guide = "invite" | "placing" | "doors" | "done";

/** What was placed last, to place another or to take it back. */
export interface LastPlaced {
  readonly category: string;
  readonly item: string | null;
  readonly size: Vector3 | null;
  readonly mode: Mode;
  readonly sentence: string;
}

/** What the panels know beyond the state. */
export interface Local {
  readonly sheet: SheetHeight;
  /** Whether reasons show their numbers. */
  readonly numbers: boolean;
  /** How the next object is placed. */
  readonly mode: Mode;
  readonly guide: Guide;
  readonly placed: LastPlaced | null;
  /** The rooms of the menu that have been fetched for their plans, by id. */
  readonly plans: Readonly<Record<string, SceneRecord>>;
  /** Where the keyboard draws, core frame, metres. */
  readonly crosshair: Point | null;
  /** The category whose knowledge is shown; null while none is. */
  readonly knowledgeOf: string | null;
  /** The known room whose plan is shown large. */
  readonly plan: string | null;
  /** Whether the way into the camera view stands open. */
  readonly arDoor: boolean;
  /** Whether it is shown how a phone gets here, and how, once it was asked for. */
  readonly joinDoor: boolean;
  readonly join: JoinInfo | "loading" | "out of reach";
  /** What is known of all categories, once it was asked for. */
  readonly knowledge: KnowledgeMarginals | "loading" | "out of reach" | null;
}

export const INITIAL_LOCAL: Local = {
  sheet: "peek",
  numbers: false,
  mode: "scenegen",
  guide: "invite",
  placed: null,
  plans: {},
  crosshair: null,
  knowledgeOf: null,
  plan: null,
  arDoor: false,
  joinDoor: false,
  join: "loading",
  knowledge: null,
};

export interface Page {
  readonly state: State;
  readonly local: Local;
  readonly services: Services;
  dispatch(action: Action): void;
  change(local: Partial<Local>): void;
}
