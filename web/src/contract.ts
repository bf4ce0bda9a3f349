/** What the parts of the page promise one another. */
import type { KnowledgeMarginals } from "./model/knowledge";
import type { Ar, Point, State } from "./model/state";

/** A part of the page that shows the state; it owns what it makes and gives it back. */
export interface View {
  show(state: State): void;
  dispose(): void;
}

/** The three-dimensional room. */
export interface StageView extends View {
  /** Where the middle of the view meets the floor, core frame, metres. */
  viewPoint(): Point;
  /** What is on screen, as a PNG. */
  picture(): Promise<Blob>;
}

/** The room seen through the camera. */
export interface ArControls {
  /** Turns the camera on, for a new room or for the one that is drawn; only right after a tap. */
  start(room: Ar["room"]): Promise<void>;
  end(): void;
  /** Does what a tap in the middle of the view does. */
  mark(): void;
  /** Asks again where the floor and the room are. */
  lineUp(): void;
  /** The room fits its corners in another way too. */
  turnRound(): void;
  /** Has the device look round the room, where it can: what it finds is then on offer. */
  capture(): void;
}

export interface PanelButton {
  readonly label: string;
  readonly primary?: boolean;
  run(): void;
}

/** A sentence and rows of buttons, for devices that show no page in front of the room. */
export interface FloatingContent {
  readonly title: string;
  readonly rows: readonly (readonly PanelButton[])[];
}

/** The address to open on a phone, or null and the reason. */
export interface JoinInfo {
  readonly address: string | null;
  readonly text: string;
  /** Where the code to scan is. */
  readonly picture: string;
}

/** What the panels can have done that is not a change of the state. */
export interface Services {
  viewPoint(): Point;
  saveScene(): void;
  openSceneFile(file: File): Promise<void>;
  openRoom(id: string): Promise<void>;
  exportRoom(): Promise<void>;
  exportHeatMap(): Promise<void>;
  /** What is known of each category; null when the server cannot be reached. */
  fetchKnowledge(): Promise<KnowledgeMarginals | null>;
  /** How a phone goes on with this room; null when the server cannot be reached. */
  fetchJoin(): Promise<JoinInfo | null>;
  /** Whether the browser shows models in the real room by itself (Apple's Quick Look). */
  readonly quickLook: boolean;
  readonly ar: ArControls;
}

/** The models of furniture that have arrived, by digest. */
export interface Assets {
  /** The bytes of a GLB; undefined until they are here (then they are asked for). */
  get(digest: string): ArrayBuffer | undefined;
  /** Called with the digest of each model that arrives; returns how to stop that. */
  subscribe(listener: (digest: string) => void): () => void;
}
