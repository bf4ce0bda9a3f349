/** Scenes with something added, replaced or taken away; ids that are free. */
import type { BoxRecord, OpeningRecord, RoomRecord, SceneRecord } from "../net/protocol.gen";

export type OpeningKind = "door" | "window";

export function boxOf(scene: SceneRecord, id: string): BoxRecord | undefined {
  return scene.boxes.find((box) => box.id === id);
}

export function openingsOf(room: RoomRecord, kind: OpeningKind): readonly OpeningRecord[] {
  return kind === "door" ? room.doors : room.windows;
}

/** The scene with the box added, or put in the place of the one with the same id. */
export function withBox(scene: SceneRecord, box: BoxRecord): SceneRecord {
  return { ...scene, boxes: replaced(scene.boxes, box) };
}

/** The scene with boxes put in the place of those with the same ids. */
export function withBoxes(scene: SceneRecord, boxes: readonly BoxRecord[]): SceneRecord {
  return boxes.reduce(withBox, scene);
}

export function withoutBoxes(scene: SceneRecord, ids: readonly string[]): SceneRecord {
  return { ...scene, boxes: scene.boxes.filter(({ id }) => !ids.includes(id)) };
}

/** The room with the door or window added, or put in the place of the one with the same id. */
export function withOpening(room: RoomRecord, kind: OpeningKind, value: OpeningRecord): RoomRecord {
  return withOpenings(room, kind, replaced(openingsOf(room, kind), value));
}

export function withoutOpening(room: RoomRecord, kind: OpeningKind, id: string): RoomRecord {
  return withOpenings(
    room,
    kind,
    openingsOf(room, kind).filter((opening) => opening.id !== id),
  );
}

/** The first of "box-1", "box-2", … that nothing has. */
export function freeId(stem: string, taken: readonly { readonly id: string }[]): string {
  const ids = new Set(taken.map(({ id }) => id));
  let number = 1;
  while (ids.has(`${stem}-${number}`)) number += 1;
  return `${stem}-${number}`;
}

function withOpenings(
  room: RoomRecord,
  kind: OpeningKind,
  openings: readonly OpeningRecord[],
): RoomRecord {
  return kind === "door" ? { ...room, doors: openings } : { ...room, windows: openings };
}

function replaced<T extends { readonly id: string }>(all: readonly T[], value: T): readonly T[] {
  return all.some(({ id }) => id === value.id)
    ? all.map((old) => (old.id === value.id ? value : old))
    : [...all, value];
}
