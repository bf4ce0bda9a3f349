/** What is selected, and that it is there. */
import type { BoxRecord, SceneRecord } from "../net/protocol.gen";
import { boxOf, openingsOf } from "./scenes";
import type { Selection, State } from "./state";

export function select(state: State, selection: Selection | null): State {
  return { ...state, selection: valid(state.scene, selection) };
}

/** The box that is selected, if it is one. */
export function selectedBox({ scene, selection }: State): BoxRecord | undefined {
  return selection?.kind === "box" ? boxOf(scene, selection.id) : undefined;
}

/** The selection, or null when the scene no longer has what was selected. */
export function valid(scene: SceneRecord, selection: Selection | null): Selection | null {
  if (selection === null) return null;
  switch (selection.kind) {
    case "box":
      return boxOf(scene, selection.id) === undefined ? null : selection;
    case "door":
    case "window": {
      const openings = openingsOf(scene.room, selection.kind);
      return openings.some(({ id }) => id === selection.id) ? selection : null;
    }
    case "corner":
      return scene.room.corners[selection.index] === undefined ? null : selection;
  }
}

/** The next or previous of all boxes, doors and windows, round and round. */
export function cycleSelection(state: State, by: 1 | -1): State {
  const { boxes, room } = state.scene;
  const all: readonly Selection[] = [
    ...boxes.map(({ id }) => ({ kind: "box", id }) as const),
    ...room.doors.map(({ id }) => ({ kind: "door", id }) as const),
    ...room.windows.map(({ id }) => ({ kind: "window", id }) as const),
  ];
  const { selection } = state;
  const at = all.findIndex(
    (one) =>
      one.kind !== "corner" &&
      one.kind === selection?.kind &&
      "id" in selection &&
      one.id === selection.id,
  );
  const start = at === -1 && by === -1 ? 0 : at;
  return {
    ...state,
    selection: all.at((start + by + all.length) % Math.max(1, all.length)) ?? null,
  };
}
