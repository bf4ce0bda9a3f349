/** The state that the page starts with, and the room that nobody has drawn yet. */
import type { RoomRecord, SceneRecord } from "../net/protocol.gen";
import type { State } from "./state";

export const DEFAULT_HEIGHT = 2.6; // metres; the same as in scenegen_core
const EMPTY_ROOM: RoomRecord = {
  corners: [
    [0, 0],
    [5, 0],
    [5, 4],
    [0, 4],
  ],
  height: DEFAULT_HEIGHT,
  doors: [],
  windows: [],
  room_type: "",
};

/** A bare rectangle of 5 m by 4 m. */
export function emptyScene(id: string): SceneRecord {
  return {
    format: "scenegen.scene",
    version: 1,
    id,
    name: "My room",
    source: "",
    room: EMPTY_ROOM,
    boxes: [],
  };
}

/** The state on opening the page; `nextId` makes ids differ from those of earlier visits. */
export function initialState(scene: SceneRecord, nextId = 1): State {
  return {
    scene,
    past: [],
    future: [],
    beforeDrag: null,
    nextId,
    tool: "select",
    draft: null,
    selection: null,
    placing: null,
    model: "scenegen",
    shown: {
      camera: "orbit",
      heat: true,
      graph: false,
      labels: true,
      heatOpacity: 0.8,
      hiddenRelations: [],
    },
    connection: { status: "connecting", session: null, revision: 0, unsent: 0, ended: null },
    lists: { categories: [], catalogue: [], rooms: [] },
    models: {},
    graph: null,
    probe: null,
    notice: null,
    help: false,
    welcome: true,
    arSupport: "unknown",
    ar: null,
  };
}
