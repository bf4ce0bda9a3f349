/**
 * Everything the page knows, as one frozen value.
 *
 * `reduce(state, action)` is the only thing that makes a new state. The scene on this device is
 * the truth; the outbox compares it with what the server has acknowledged and sends the rest.
 * Coordinates are in the core frame: metres, z up, headings anticlockwise from +x; only
 * `model/frames.ts` knows the y-up frame of three.js.
 */
import type {
  Answer,
  BoxRecord,
  CatalogueItem,
  CategoryInfo,
  Comfort,
  Graph,
  Inspected,
  Matters,
  ModelName,
  OpeningRecord,
  Placement,
  RoomInfo,
  SceneRecord,
  Surface,
} from "../net/protocol.gen";
import type { Side } from "./sizes";

export type Point = readonly [number, number];
export type Vector3 = readonly [number, number, number];

export type Tool = "select" | "room" | "box" | "door" | "window";
export type CameraMode = "orbit" | "top" | "walk";
export type Mode = "manual" | "scenegen";
export type Layer = "heat" | "graph" | "labels";

/** What is being drawn, before it becomes part of the scene. */
export type Draft =
  | { readonly kind: "room"; readonly corners: readonly Point[]; readonly pointer: Point | null }
  | {
      readonly kind: "box-floor";
      readonly start: Point;
      readonly end: Point;
      readonly heading: number;
      /** The other end of the side that was marked first, if it was: then the end lies across it. */
      readonly side?: Point;
    }
  | { readonly kind: "box-height"; readonly box: BoxRecord }
  | {
      readonly kind: "opening";
      readonly opening: "door" | "window";
      readonly start: Point;
      readonly end: Point;
    };

/** What of the scene is selected. */
export type Selection =
  | { readonly kind: "box"; readonly id: string }
  | { readonly kind: "door" | "window"; readonly id: string }
  | { readonly kind: "corner"; readonly index: number };

export interface Pose {
  readonly center: Vector3;
  readonly heading: number;
}

/** A heat map as it came over the socket: row 0 at the smallest y (floor, tops) or at the floor. */
export interface HeatMap {
  readonly surface: Surface;
  readonly origin: Point;
  readonly cell: number;
  readonly rows: number;
  readonly columns: number;
  readonly min: number;
  readonly max: number;
  readonly values: Uint8Array<ArrayBuffer>;
}

/** "What matters most?", asked of the places on offer. */
export interface Weigh {
  readonly id: string;
  readonly done: number;
  /** Things to be tried; 0 until the server has said. */
  readonly total: number;
  /** Null until it is found out. */
  readonly result: Matters | null;
}

/** An object on its way into the room. */
export interface Placing {
  /** The id of the ask; answers that carry another are stale. */
  readonly ask: string;
  readonly mode: Mode;
  readonly category: string;
  readonly item: string | null;
  /** What the user typed; null for the usual size. */
  readonly wishedSize: Vector3 | null;
  /** Rules that the person chose to live without. */
  readonly relaxed: readonly Comfort[];
  /** The size in force (the server's once it has answered). */
  readonly size: Vector3;
  /** The GLB of the object, once known. */
  readonly asset: string | null;
  /** Where the ghost stands; null until there is somewhere. */
  readonly pose: Pose | null;
  /** Which alternative the ghost stands on; null once it was dragged away. */
  readonly alternative: number | null;
  /** Waiting for the first or a newer answer; the old map stays meanwhile. */
  readonly computing: boolean;
  readonly answer: Answer | null;
  /** By surface; those of a stale ask or revision never get here. */
  readonly heatMaps: readonly HeatMap[];
  /** The ask and the revision of the scene that the heat maps are of. */
  readonly mapsOf: { readonly ask: string; readonly revision: number } | null;
  /** What the server says of a pose that is none of the alternatives, and of which one. */
  readonly inspected: Inspected | null;
  readonly inspectedPose: Pose | null;
  /** To be placed here as soon as the server has said whether it may stand here. */
  readonly confirming: boolean;
  /** Why the server cannot answer this ask; null if it can. */
  readonly problem: string | null;
  /** What the person wants to know of the answer; null for nothing. */
  readonly weigh: Weigh | null;
}

export type ConnectionStatus = "connecting" | "online" | "offline";

export interface Connection {
  readonly status: ConnectionStatus;
  readonly session: string | null;
  readonly revision: number;
  /** Edits that are not acknowledged yet. */
  readonly unsent: number;
  /** What to do when the server has closed the connection for good; null while it may come back. */
  readonly ended: string | null;
}

/** A sentence for the person: what happened, or what went wrong and what to do. */
export interface Notice {
  readonly id: number;
  readonly tone: "info" | "success" | "problem";
  readonly text: string;
}

export interface Shown {
  readonly camera: CameraMode;
  readonly heat: boolean;
  readonly graph: boolean;
  readonly labels: boolean;
  readonly heatOpacity: number;
  /** Relations of the graph that are switched off. */
  readonly hiddenRelations: readonly string[];
}

export interface Lists {
  readonly categories: readonly CategoryInfo[];
  readonly catalogue: readonly CatalogueItem[];
  readonly rooms: readonly RoomInfo[];
}

/** The heat map's value under the pointer. */
export interface Probe {
  readonly surface: Surface;
  readonly at: Vector3;
  /** 0 to 1, or null where nobody can stand. */
  readonly likelihood: number | null;
}

/** Why the real room cannot be shown here; "yes" if it can, "unknown" until the browser has said. */
export type ArSupport = "unknown" | "yes" | "insecure" | "missing" | "refused";

/** What the device itself knows of the room, in the core frame. */
export interface Found {
  /** The outline of the floor; null if it is not known. */
  readonly corners: readonly Point[] | null;
  /** On those walls; none where the outline is not known. */
  readonly doors: readonly OpeningRecord[];
  readonly windows: readonly OpeningRecord[];
  readonly boxes: readonly BoxRecord[];
}

/** A length that is being typed on the floating panel. */
export interface Typing {
  readonly side: Side;
  /** Centimetres, as far as they are typed. */
  readonly digits: string;
}

/** The room seen through the camera, while it is. */
export interface Ar {
  /** The floor is looked for, then the corners that place the drawn room, then all is ready. */
  readonly step: "floor" | "line-up" | "ready";
  /** Whether a new room is to be outlined, or the drawn one put where it really is. */
  readonly room: "new" | "known";
  /** Whether the device sees a surface. */
  readonly surface: boolean;
  readonly tracking: "good" | "lost" | "paused";
  /** The features of the session, by their WebXR names. */
  readonly granted: readonly string[];
  /** The first of the two corners that line up the room, once it is marked. */
  readonly corner: Point | null;
  /** How many corners of its foot a box is marked by. */
  readonly marks: 2 | 3;
  /** Whether nearly right angles are made right. */
  readonly square: boolean;
  /** Whether real things hide what stands behind them. */
  readonly occlusion: boolean;
  /** Whether what is placed by hand goes where the phone points. */
  readonly carrying: boolean;
  readonly found: Found | null;
  /** The pieces of those found that nobody has looked at yet, by id. */
  readonly unchecked: readonly string[];
  readonly typing: Typing | null;
}

export interface State {
  readonly scene: SceneRecord;
  readonly past: readonly SceneRecord[];
  readonly future: readonly SceneRecord[];
  /** The scene before the drag that is under way; null when nothing is being dragged. */
  readonly beforeDrag: SceneRecord | null;
  /** The next number for the ids of asks, notices and new rooms. */
  readonly nextId: number;
  readonly tool: Tool;
  readonly draft: Draft | null;
  readonly selection: Selection | null;
  readonly placing: Placing | null;
  /** The model that finds places. */
  readonly model: ModelName;
  readonly shown: Shown;
  readonly connection: Connection;
  readonly lists: Lists;
  /** Which GLB shows which box: id to digest. */
  readonly models: Readonly<Record<string, string>>;
  readonly graph: Graph | null;
  readonly probe: Probe | null;
  readonly notice: Notice | null;
  readonly help: boolean;
  /** True until the person has done something: the camera turns slowly, one button invites. */
  readonly welcome: boolean;
  readonly arSupport: ArSupport;
  /** Null while the room is not seen through the camera. */
  readonly ar: Ar | null;
}

export type { Placement };
