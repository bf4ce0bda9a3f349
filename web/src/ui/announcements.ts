/** What a screen reader is told when the state changes. */
import { selectedBox } from "../model/selecting";
import type { State } from "../model/state";
import { arAnnouncement } from "./ar_words";
import { boxInWords, placedInWords, sceneInWords } from "./whereabouts";
import { counted, ended, inSentence } from "./words";

/** The sentence for the step from one state to the next; null when nothing is worth saying. */
export function announcement(before: State, after: State): string | null {
  return (
    notice(before, after) ??
    arAnnouncement(before, after) ??
    room(before, after) ??
    placed(before, after) ??
    placing(before, after) ??
    boxes(before, after) ??
    selection(before, after) ??
    drawing(before, after) ??
    connection(before, after)
  );
}

function notice(before: State, after: State): string | null {
  const { notice } = after;
  return notice === null || notice.id === before.notice?.id ? null : notice.text;
}

function room(before: State, after: State): string | null {
  if (before.scene.id === after.scene.id) return null;
  return `Opened: ${sceneInWords(after.scene)}.`;
}

function placed(before: State, after: State): string | null {
  if (before.placing === null || after.placing !== null) return null;
  const box = after.scene.boxes.find(
    ({ id, placed }) => placed === true && !before.scene.boxes.some((old) => old.id === id),
  );
  if (box === undefined) return "Canceled.";
  return placedInWords(box, after.scene.room, sentenceOf(before));
}

function placing(before: State, after: State): string | null {
  const { placing } = after;
  if (placing === null) return null;
  const name = inSentence(placing.category);
  if (before.placing?.category !== placing.category) return `Placing: ${name}.`;
  const { answer, alternative, inspected, problem } = placing;
  if (problem !== before.placing.problem && problem !== null) return problem;
  if (answer !== before.placing.answer && answer !== null && placing.mode === "scenegen") {
    if (answer.no_good_place !== null && answer.placements.length === 0) {
      return answer.no_good_place.text;
    }
    return `${counted(answer.placements.length, "good place")}. ${sentenceOf(after)}`;
  }
  if (alternative !== before.placing.alternative && alternative !== null) {
    const index = answer?.placements.findIndex(({ rank }) => rank === alternative) ?? -1;
    return `Place ${index + 1}: ${sentenceOf(after)}`;
  }
  if (inspected !== before.placing.inspected && inspected !== null) {
    return ended(inspected.sentence);
  }
  return null;
}

function boxes(before: State, after: State): string | null {
  const { boxes } = after.scene;
  const old = before.scene.boxes;
  const way = stepped(before, after);
  if (way !== null) return `${way}. ${sceneInWords(after.scene)}.`;
  const gone = old.find(({ id }) => !boxes.some((box) => box.id === id));
  if (gone !== undefined) return `${gone.category} deleted.`;
  const added = boxes.find(({ id }) => !old.some((box) => box.id === id));
  if (added !== undefined) return `Added: ${boxInWords(added, after.scene.room)}.`;
  const changed =
    [selectedBox(after), ...boxes].find((box) => box !== undefined && !old.includes(box)) ??
    undefined;
  return changed === undefined ? null : `${boxInWords(changed, after.scene.room)}.`;
}

/** Whether the scene is the one before, or the one that was undone. */
function stepped(before: State, after: State): "Undone" | "Redone" | null {
  if (after.scene === before.scene) return null;
  if (after.scene === before.past.at(-1) && after.past.length < before.past.length) return "Undone";
  return after.scene === before.future[0] ? "Redone" : null;
}

function selection(before: State, after: State): string | null {
  const { selection, scene } = after;
  if (selection === before.selection || selection === null) return null;
  if (selection.kind === "corner") return `Corner ${selection.index + 1} selected.`;
  if (selection.kind !== "box") return `${selection.kind === "door" ? "Door" : "Window"} selected.`;
  const box = scene.boxes.find(({ id }) => id === selection.id);
  return box === undefined ? null : `Selected: ${boxInWords(box, scene.room)}.`;
}

function drawing(before: State, after: State): string | null {
  const corners = (state: State): number =>
    state.draft?.kind === "room" ? state.draft.corners.length : 0;
  if (corners(after) > 0 && corners(after) !== corners(before)) {
    return `${counted(corners(after), "corner")}.`;
  }
  if (before.draft?.kind === "room" && before.scene.room !== after.scene.room) {
    return `Room drawn: ${sceneInWords(after.scene)}.`;
  }
  return null;
}

function connection(before: State, after: State): string | null {
  const { ended } = after.connection;
  if (ended !== before.connection.ended && ended !== null) return ended;
  const [was, is] = [before.connection.status, after.connection.status];
  if (was === is) return null;
  if (is === "offline") return "The connection is gone. You can go on; I'll catch up.";
  return is === "online" && was === "offline" ? "Connected again." : null;
}

/** What is said of the place the ghost stands on. */
function sentenceOf({ placing }: State): string {
  const chosen = placing?.answer?.placements.find(({ rank }) => rank === placing.alternative);
  return ended(chosen?.sentence ?? placing?.inspected?.sentence ?? "");
}
