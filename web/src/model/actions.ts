/** Everything that can happen to the state: `reduce` says what comes of it. */
import type {
  Answer,
  BoxRecord,
  Comfort,
  Graph,
  Inspected,
  Matters,
  ModelName,
  OpeningRecord,
  RoomRecord,
  SceneRecord,
  Weighing,
} from "../net/protocol.gen";
import type {
  Ar,
  ArSupport,
  CameraMode,
  Connection,
  HeatMap,
  Layer,
  Lists,
  Mode,
  Notice,
  Point,
  Pose,
  Probe,
  Selection,
  Tool,
  Vector3,
} from "./state";

/** Heat maps that came ahead of their answer. */
export interface MapsAction {
  readonly type: "maps";
  readonly ask: string;
  readonly revision: number;
  readonly heatMaps: readonly HeatMap[];
}

export type Action =
  // the room
  | { readonly type: "open-scene"; readonly scene: SceneRecord }
  | { readonly type: "new-room" }
  | { readonly type: "edit-room"; readonly room: RoomRecord; readonly done: boolean }
  | { readonly type: "edit-box"; readonly box: BoxRecord; readonly done: boolean }
  | {
      readonly type: "edit-opening";
      readonly opening: "door" | "window";
      readonly value: OpeningRecord;
      readonly done: boolean;
    }
  | {
      readonly type: "move-corner";
      readonly index: number;
      readonly to: Point;
      readonly done: boolean;
    }
  | { readonly type: "nudge"; readonly by: Point }
  | { readonly type: "turn"; readonly by: number }
  | { readonly type: "delete-selected" }
  | { readonly type: "remove-box"; readonly id: string }
  | { readonly type: "duplicate-selected" }
  | { readonly type: "undo" }
  | { readonly type: "redo" }
  // drawing: the view reports where the pointer is on the floor (snapping is the reducer's)
  | { readonly type: "choose-tool"; readonly tool: Tool }
  | { readonly type: "draw-down"; readonly at: Point; readonly free: boolean }
  | { readonly type: "draw-move"; readonly at: Point; readonly free: boolean }
  | { readonly type: "draw-up"; readonly at: Point; readonly free: boolean }
  /** The other end of the side of a box that was begun. */
  | { readonly type: "draw-side"; readonly at: Point; readonly free: boolean }
  | { readonly type: "draw-height"; readonly height: number; readonly done: boolean }
  | { readonly type: "close-outline" }
  | { readonly type: "remove-last-corner" }
  | { readonly type: "select"; readonly selection: Selection | null }
  | { readonly type: "cycle-selection"; readonly by: 1 | -1 }
  // placing
  | {
      readonly type: "place";
      readonly category: string;
      readonly item: string | null;
      readonly size: Vector3 | null;
      readonly mode: Mode;
      readonly view: Point;
    }
  | { readonly type: "set-mode"; readonly mode: Mode; readonly view: Point }
  | { readonly type: "set-size"; readonly size: Vector3 | null }
  | { readonly type: "choose-model"; readonly model: ModelName }
  /** A rule that does not count for this object. */
  | { readonly type: "relax"; readonly rule: Comfort }
  /** Which thing matters most to the place, or never mind. */
  | { readonly type: "what-matters"; readonly on: boolean }
  | { readonly type: "show-alternative"; readonly rank: number }
  | { readonly type: "drag-ghost"; readonly pose: Pose; readonly done: boolean }
  | { readonly type: "confirm" }
  /** The server does not say in time whether the ghost may stand there. */
  | { readonly type: "stop-waiting" }
  | { readonly type: "cancel" }
  // what is shown
  | { readonly type: "set-camera"; readonly camera: CameraMode }
  | { readonly type: "toggle-layer"; readonly layer: Layer }
  | { readonly type: "set-heat-opacity"; readonly opacity: number }
  | { readonly type: "toggle-relation"; readonly relation: string }
  | { readonly type: "probe"; readonly probe: Probe | null }
  | { readonly type: "toggle-help" }
  | { readonly type: "touched" }
  | { readonly type: "notify"; readonly tone: Notice["tone"]; readonly text: string }
  | { readonly type: "dismiss-notice" }
  // the room seen through the camera
  | { readonly type: "ar-support"; readonly support: ArSupport }
  | { readonly type: "enter-ar"; readonly room: Ar["room"]; readonly granted: readonly string[] }
  | { readonly type: "change-ar"; readonly change: Partial<Ar> }
  | { readonly type: "leave-ar" }
  /** Takes over what the device knows of the room; its pieces are then to be checked. */
  | { readonly type: "use-found" }
  /** The piece in question stays, or it goes. */
  | { readonly type: "check-piece"; readonly keep: boolean }
  // what came over the socket
  | { readonly type: "connection"; readonly connection: Partial<Connection> }
  | { readonly type: "lists"; readonly lists: Lists }
  | { readonly type: "resumed"; readonly scene: SceneRecord }
  | { readonly type: "models"; readonly boxes: Readonly<Record<string, string>> }
  | MapsAction
  | { readonly type: "answer"; readonly answer: Answer }
  | { readonly type: "inspected"; readonly inspected: Inspected; readonly pose: Pose }
  | { readonly type: "weighing"; readonly weighing: Weighing }
  | { readonly type: "matters"; readonly matters: Matters }
  | { readonly type: "ask-refused"; readonly text: string }
  | { readonly type: "graph"; readonly graph: Graph };
