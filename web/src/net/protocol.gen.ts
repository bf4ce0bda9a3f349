// Generated from server/protocol.py by `python -m server.typescript`. Do not edit.
// Core frame: metres, z up, headings in radians anticlockwise from +x.

export const MAX_BOXES = 500;
export const SUBPROTOCOL = "scenegen.1";
export const CLOSE_WRONG_PROTOCOL = 4400;
export const CLOSE_TOO_MANY_ERRORS = 4401;
export const CLOSE_REPLACED = 4402;
export const CLOSE_TOO_MANY_SESSIONS = 4403;
export const MAX_TEXT_BYTES = 1000000;
export const MAX_ERRORS = 20;
export const MAX_MESSAGES_A_SECOND = 240;
export const MAX_SESSIONS_AN_ADDRESS = 32;
export const MAX_CORNERS = 200;

export type ModelName = "paper" | "scenegen";
export type Surface = "floor" | "tops" | "walls";
export type Comfort = "path" | "window";

/** A door or window: a segment on the outline from `bottom` to `top`, metres. */
export interface OpeningRecord {
  readonly id: string;
  readonly start: readonly [number, number];
  readonly end: readonly [number, number];
  readonly bottom: number;
  readonly top: number;
}

/** The outline of a room: corners in order, metres, with its doors and windows. */
export interface RoomRecord {
  readonly corners: readonly (readonly [number, number])[];
  readonly height: number;
  readonly doors: readonly OpeningRecord[];
  readonly windows: readonly OpeningRecord[];
  readonly room_type: string;
}

/** A piece of furniture: center of the box, full size (depth, width, height), heading. */
export interface BoxRecord {
  readonly id: string;
  readonly category: string;
  readonly center: readonly [number, number, number];
  readonly size: readonly [number, number, number];
  readonly heading?: number;
  readonly label?: string;
  readonly front_known?: boolean;
  readonly front_from_wall?: boolean;
  readonly parent?: string | null;
  readonly placed?: boolean;
  readonly item?: string | null;
}

/** A scene file. */
export interface SceneRecord {
  readonly format: "scenegen.scene";
  readonly version: 1;
  readonly id: string;
  readonly name: string;
  readonly source: string;
  readonly room: RoomRecord;
  readonly boxes: readonly BoxRecord[];
}

/**
 * The first message on a socket: start a session, or go on with one.
 *
 * What outlives a socket is the scene; asks and watched graphs are sent again after it.
 */
export interface Hello {
  readonly type: "hello";
  /** The session to resume; null starts a new one. */
  readonly session: string | null;
  /** The last revision the page saw acknowledged. */
  readonly revision: number;
  /** Models the page already has; they are not sent again. */
  readonly assets: readonly string[];
}

/** Replace everything: a scene was opened, or the page re-uploads after a mismatch. */
export interface PutScene {
  readonly type: "put_scene";
  readonly seq: number;
  readonly scene: SceneRecord;
}

/** Replace the outline, doors and windows. */
export interface PutRoom {
  readonly type: "put_room";
  readonly seq: number;
  readonly room: RoomRecord;
}

/**
 * Add boxes, or replace those with their ids; all of them, or none if one is refused.
 *
 * Sent again and again while a box is dragged, with what stands on it.
 */
export interface PutBoxes {
  readonly type: "put_boxes";
  readonly seq: number;
  readonly boxes: readonly BoxRecord[];
}

/** Remove a box; removing one that is not there is no error. */
export interface RemoveBox {
  readonly type: "remove_box";
  readonly seq: number;
  readonly id: string;
}

/** What is to be placed, and how. */
export interface Query {
  readonly category: string;
  /** Depth, width, height in metres; null for the usual size of the category. */
  readonly size: readonly [number, number, number] | null;
  /** A catalogue item to show; its own size then counts when `size` is null. */
  readonly item: string | null;
  readonly model: ModelName;
  readonly count: number;
  /** Rules that do not count this time. */
  readonly relaxed: readonly Comfort[];
}

/** Keep answering this query after every edit until the next ask; null stops. */
export interface Ask {
  readonly type: "ask";
  /** Chosen by the page; answers carry it. */
  readonly id: string;
  readonly query: Query | null;
}

/** What about this very pose, for the query of the current ask? Newest wins. */
export interface Inspect {
  readonly type: "inspect";
  readonly id: string;
  readonly center: readonly [number, number, number];
  readonly heading: number;
}

/** Which box matters most to the best place of the current ask? Newest wins; edits end it. */
export interface WhatMatters {
  readonly type: "what_matters";
  readonly id: string;
  /** False: nobody waits for it any more. */
  readonly on: boolean;
}

/** Send the scene graph now and after every edit, or stop. */
export interface WatchGraph {
  readonly type: "watch_graph";
  readonly on: boolean;
}

/** Is anybody there? */
export interface Ping {
  readonly type: "ping";
  readonly nonce: number;
}

/** A category that can be drawn or placed. */
export interface CategoryInfo {
  readonly name: string;
  readonly symmetry: "asymmetric" | "inside facing" | "symmetric";
  /** False for Other. */
  readonly placeable: boolean;
  /** The usual depth, width, height, metres. */
  readonly size: readonly [number, number, number];
  /** How many examples the knowledge has. */
  readonly examples: number;
}

/** A model of the user's own catalogue. */
export interface CatalogueItem {
  readonly id: string;
  readonly name: string;
  readonly category: string;
  readonly size: readonly [number, number, number];
  readonly asset: string;
}

/** A sample room that can be opened by URL: /rooms/{id}.json. */
export interface RoomInfo {
  readonly id: string;
  readonly name: string;
  readonly kind: "sample" | "scan";
  readonly boxes: number;
  readonly area: number;
}

/** The answer to hello. */
export interface Welcome {
  readonly type: "welcome";
  readonly session: string;
  readonly revision: number;
  /** False: this is a new session (or the old one is unknown): upload what you have. */
  readonly resumed: boolean;
  /** What the server holds; null when the page's revision is the same or nothing is held. */
  readonly scene: SceneRecord | null;
  readonly categories: readonly CategoryInfo[];
  readonly catalogue: readonly CatalogueItem[];
  readonly rooms: readonly RoomInfo[];
  readonly models: readonly ModelName[];
}

/** That edit is stored, and made this revision. */
export interface Ack {
  readonly type: "ack";
  readonly seq: number;
  readonly revision: number;
}

/**
 * Which model shows which box, for the boxes whose model is new (after hello: all of them).
 *
 * The bytes come in binary frames, once per digest.
 */
export interface Models {
  readonly type: "models";
  readonly revision: number;
  readonly boxes: Readonly<Record<string, string>>;
}

/** One part of a score; the contributions of a placement add up to its score. */
export interface Reason {
  readonly relation: string;
  readonly group: string;
  readonly contribution: number;
  readonly text: string;
}

/** A pose on offer. */
export interface Placement {
  readonly rank: number;
  readonly center: readonly [number, number, number];
  readonly heading: number;
  /** Log-likelihood above the average possible spot of this room (nats). */
  readonly score: number;
  /** 0 to 1 on the scale of the heat map's legend (0 worst, 1 best). */
  readonly likelihood: number;
  /** A few words that tell it from the others on offer: "by the window". */
  readonly name: string;
  readonly sentence: string;
  readonly reasons: readonly Reason[];
  /** The known rooms that speak loudest for it. */
  readonly rooms: readonly string[];
}

/** The nearest thing that gives a place: a smaller size, one box less, or one rule less. */
export interface Remedy {
  readonly kind: "box" | "rule" | "size";
  readonly text: string;
  /** Where the object would then go. */
  readonly center: readonly [number, number, number];
  readonly heading: number;
  readonly size: readonly [number, number, number] | null;
  /** The id of the box to take away. */
  readonly box: string | null;
  readonly rule: Comfort | null;
}

/** Why there is no place. */
export interface NoGoodPlace {
  readonly rule: string;
  readonly text: string;
  /** null until it is found, and if there is none; the answer then comes once more with it. */
  readonly remedy: Remedy | null;
}

/** The placements for the query of an ask; the heat maps of its revision have come before. */
export interface Answer {
  readonly type: "answer";
  readonly ask: string;
  readonly revision: number;
  readonly category: string;
  readonly size: readonly [number, number, number];
  /** The model that shows the object. */
  readonly asset: string;
  readonly placements: readonly Placement[];
  readonly no_good_place: NoGoodPlace | null;
  readonly elapsed_ms: number;
}

/**
 * The heat maps that came right before it are of this revision; their answer follows.
 *
 * Unless the scene changes again first: while a box is dragged, maps come without answers.
 */
export interface Maps {
  readonly type: "maps";
  readonly ask: string;
  readonly revision: number;
}

/** Another pose, and how to get there. */
export interface Elsewhere {
  readonly center: readonly [number, number, number];
  readonly heading: number;
  /** Metres from the pose that was inspected. */
  readonly distance: number;
  /** The way in words: "30 cm further from the door". */
  readonly text: string;
  /** How it stands there. */
  readonly sentence: string;
}

/** What a pose loses to the best one on offer through one relation to a group. */
export interface Cost {
  readonly relation: string;
  readonly group: string;
  /** Nats, negative. */
  readonly difference: number;
  readonly here: string;
  readonly best: string;
}

/** What the query's model says of one pose. */
export interface Inspected {
  readonly type: "inspected";
  readonly id: string;
  readonly ask: string;
  readonly revision: number;
  readonly allowed: boolean;
  /** The rule that forbids it; empty if none does. */
  readonly rule: string;
  readonly score: number | null;
  readonly likelihood: number | null;
  /** Why here, or why not. */
  readonly sentence: string;
  readonly reasons: readonly Reason[];
  /** What it loses most by to the best place, the dearest first. */
  readonly costs: readonly Cost[];
  /** The nearest pose that is allowed, or one that is better; null if there is none. */
  readonly elsewhere: Elsewhere | null;
}

/** How far the search for what matters has come. */
export interface Weighing {
  readonly type: "weighing";
  readonly id: string;
  readonly done: number;
  readonly total: number;
}

/** The box whose removal changes the best place most, and the place without it. */
export interface Counterfactual {
  readonly box: string;
  /** null if there is no place without it. */
  readonly center: readonly [number, number, number] | null;
  readonly heading: number | null;
  readonly text: string;
  /** Metres between the best places with and without it. */
  readonly moved: number;
  /** Radians between them, 0 to π. */
  readonly turned: number;
  /** Nats, without it less with it. */
  readonly score_change: number;
}

/** What matters most; nothing if no box alone changes the place. */
export interface Matters {
  readonly type: "matters";
  readonly id: string;
  readonly ask: string;
  readonly revision: number;
  readonly found: Counterfactual | null;
}

/** A box, a group or the room, as a node of the scene graph. */
export interface GraphNode {
  readonly id: string;
  readonly kind: "group" | "object" | "room";
  readonly name: string;
  readonly center: readonly [number, number, number];
}

/** A relation between two nodes. */
export interface GraphEdge {
  readonly source: string;
  readonly target: string;
  readonly relation: string;
  readonly value: number;
  readonly text: string;
}

/** The spatial scene graph of the room as it is. */
export interface Graph {
  readonly type: "graph";
  readonly revision: number;
  readonly nodes: readonly GraphNode[];
  readonly edges: readonly GraphEdge[];
}

/** Something was refused; says what to do. Nothing else is affected. */
export interface Problem {
  readonly type: "problem";
  readonly code: "bad_json" | "bad_message" | "bad_query" | "bad_scene" | "internal" | "too_fast" | "too_large" | "too_many_boxes";
  readonly text: string;
  /** Where in the message: `$.box.size[2]`. */
  readonly path: string | null;
  /** The edit that was refused, if it was one. */
  readonly seq: number | null;
}

/** Yes. */
export interface Pong {
  readonly type: "pong";
  readonly nonce: number;
}

/**
 * A raster of uint8: 0 nobody can stand there, 1 least to 255 most likely.
 *
 * `floor` and `tops`: the plan; row r, column c is the cell whose corner is origin +
 * cell * (c, r), so row 0 lies at the smallest y. `walls`: the walls unrolled from corner 0 on;
 * the column runs along the outline, the row upwards from the floor.
 */
export interface HeatMapHeader {
  readonly type: "heat_map";
  readonly ask: string;
  readonly revision: number;
  readonly surface: Surface;
  readonly origin: readonly [number, number];
  readonly cell: number;
  /** Rows, columns. */
  readonly shape: readonly [number, number];
  /** The score at value 1. */
  readonly min: number;
  /** The score at value 255. */
  readonly max: number;
}

/** A GLB; y up, origin at the base center (wall objects: back center), front along +z. */
export interface AssetHeader {
  readonly type: "asset";
  readonly digest: string;
}

export type ClientMessage =
  | Hello
  | PutScene
  | PutRoom
  | PutBoxes
  | RemoveBox
  | Ask
  | Inspect
  | WhatMatters
  | WatchGraph
  | Ping;

export type ServerMessage =
  | Welcome
  | Ack
  | Models
  | Maps
  | Answer
  | Inspected
  | Weighing
  | Matters
  | Graph
  | Problem
  | Pong;

export type FrameHeader =
  | HeatMapHeader
  | AssetHeader;
