/** The only thing that makes a new state. */
import type { SceneRecord } from "../net/protocol.gen";
import type { Action } from "./actions";
import { answered, askRefused, inAnotherRoom, inspected, mapped } from "./answers";
import {
  carried,
  changeAr,
  checkPiece,
  elsewhere,
  enterAr,
  leaveAr,
  typingStopped,
  useFound,
} from "./ar";
import { confirm, followedUp, stopWaiting } from "./confirming";
import {
  chooseTool,
  closeOutline,
  drawDown,
  drawHeight,
  drawMove,
  drawSide,
  drawUp,
  newRoom,
  removeLastCorner,
} from "./drawing";
import {
  deleteSelected,
  duplicateSelected,
  editBox,
  editOpening,
  editRoom,
  moveCorner,
  nudge,
  takeAway,
  turn,
} from "./editing";
import { edited, redo, undo } from "./history";
import { notified, silenced } from "./notices";
import {
  dragGhost,
  nudgeGhost,
  place,
  setMode,
  setSize,
  showAlternative,
  turnGhost,
} from "./placing";
import { connected, graphed, modelled, resumed } from "./received";
import { cycleSelection, select, valid } from "./selecting";
import { cancel, show, toggleRelation } from "./showing";
import type { State } from "./state";
import { chooseModel, matters, relax, weighing, whatMatters } from "./wondering";

/** What happens by itself: the invitation to begin stays. */
const BY_ITSELF: ReadonlySet<Action["type"]> = new Set([
  "notify",
  "dismiss-notice",
  "probe",
  "connection",
  "lists",
  "resumed",
  "models",
  "maps",
  "answer",
  "inspected",
  "weighing",
  "matters",
  "ask-refused",
  "stop-waiting",
  "graph",
  "ar-support",
] as const);

export function reduce(state: State, action: Action): State {
  const next = typingStopped(state, followedUp(state, followed(state, changed(state, action))));
  return next.welcome && !BY_ITSELF.has(action.type) ? { ...next, welcome: false } : next;
}

function changed(state: State, action: Action): State {
  switch (action.type) {
    case "open-scene":
      return openScene(state, action.scene);
    case "new-room":
      return silenced(newRoom(state));
    case "edit-room":
      return editRoom(state, action.room, action.done);
    case "edit-box":
      return editBox(state, action.box, action.done);
    case "edit-opening":
      return editOpening(state, action.opening, action.value, action.done);
    case "move-corner":
      return moveCorner(state, action.index, action.to, action.done);
    case "nudge":
      return state.placing === null ? nudge(state, action.by) : nudgeGhost(state, action.by);
    case "turn":
      return state.placing === null ? turn(state, action.by) : turnGhost(state, action.by);
    case "remove-box":
      return takeAway(state, action.id);
    case "delete-selected":
      return deleteSelected(state);
    case "duplicate-selected":
      return duplicateSelected(state);
    case "undo":
      return silenced(undo(state));
    case "redo":
      return silenced(redo(state));
    case "choose-tool":
      return silenced(chooseTool(state, action.tool));
    case "draw-down":
      return drawDown(state, action.at, action.free);
    case "draw-move":
      return drawMove(state, action.at, action.free);
    case "draw-up":
      return drawUp(state, action.at, action.free);
    case "draw-side":
      return drawSide(state, action.at, action.free);
    case "draw-height":
      return drawHeight(state, action.height, action.done);
    case "close-outline":
      return closeOutline(state);
    case "remove-last-corner":
      return removeLastCorner(state);
    case "select":
      return select(state, action.selection);
    case "cycle-selection":
      return cycleSelection(state, action.by);
    case "place":
      return silenced(carried(place(state, action)));
    case "set-mode":
      return carried(setMode(state, action.mode, action.view));
    case "set-size":
      return setSize(state, action.size);
    case "choose-model":
      return chooseModel(state, action.model);
    case "relax":
      return relax(state, action.rule);
    case "what-matters":
      return whatMatters(state, action.on);
    case "show-alternative":
      return unprobed(showAlternative(state, action.rank));
    case "drag-ghost":
      return unprobed(dragGhost(state, action.pose));
    case "confirm":
      return confirm(state);
    case "stop-waiting":
      return stopWaiting(state);
    case "cancel":
      return cancel(state);
    case "set-camera":
      return show(state, { camera: action.camera });
    case "toggle-layer":
      return show(state, { [action.layer]: !state.shown[action.layer] });
    case "set-heat-opacity":
      return show(state, { heatOpacity: Math.min(1, Math.max(0, action.opacity)) });
    case "toggle-relation":
      return toggleRelation(state, action.relation);
    case "probe":
      return { ...state, probe: action.probe };
    case "toggle-help":
      return { ...state, help: !state.help };
    case "touched":
      return state;
    case "notify":
      return notified(state, action.tone, action.text);
    case "dismiss-notice":
      return silenced(state);
    case "ar-support":
      return { ...state, arSupport: action.support };
    case "enter-ar":
      return enterAr(state, action.room, action.granted);
    case "change-ar":
      return changeAr(state, action.change);
    case "leave-ar":
      return leaveAr(state);
    case "use-found":
      return useFound(state);
    case "check-piece":
      return checkPiece(state, action.keep);
    case "connection":
      return connected(state, action.connection);
    case "lists":
      return { ...state, lists: action.lists };
    case "resumed":
      return resumed(state, action.scene);
    case "models":
      return modelled(state, action.boxes);
    case "maps":
      return mapped(state, action);
    case "answer":
      return answered(state, action.answer);
    case "inspected":
      return inspected(state, action.inspected, action.pose);
    case "weighing":
      return weighing(state, action.weighing);
    case "matters":
      return matters(state, action.matters);
    case "ask-refused":
      return askRefused(state, action.text);
    case "graph":
      return graphed(state, action.graph);
  }
}

/** Another scene, as one step; a file may leave its id to whoever opens it. */
function openScene(state: State, opened: SceneRecord): State {
  const scene = opened.id === "" ? { ...opened, id: `room-${state.nextId}` } : opened;
  const nextId = state.nextId + 1;
  return { ...edited(state, scene, true), nextId, tool: "select", draft: null, notice: null };
}

/** What follows from a change of the scene, whoever made it. */
function followed(before: State, after: State): State {
  const { scene, placing } = after;
  if (scene === before.scene) return after;
  const selection = valid(scene, after.selection);
  if (scene.id !== before.scene.id) {
    const other = inAnotherRoom({ ...after, selection, models: {}, graph: null, probe: null });
    return elsewhere(before, other);
  }
  if (placing === null) return { ...after, selection };
  const computing = placing.problem === null;
  return { ...after, selection, placing: { ...placing, computing, weigh: null } };
}

/** What was told of a spot is old once the ghost has gone elsewhere. */
function unprobed(state: State): State {
  return state.probe === null ? state : { ...state, probe: null };
}
