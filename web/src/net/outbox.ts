/**
 * What the server has yet to be told of the scene, as a pure value.
 *
 * `advance` compares what the server holds with the scene on this device, by identity of the
 * frozen values, and says what to send. At most one message about a thing is on its way: while a
 * box's edit is not acknowledged, only its newest value waits. Boxes that change together go
 * together. What is lost with a socket is sent again.
 */
import type {
  BoxRecord,
  PutBoxes,
  PutRoom,
  PutScene,
  RemoveBox,
  RoomRecord,
  SceneRecord,
} from "./protocol.gen";

export type Edit = PutScene | PutRoom | PutBoxes | RemoveBox;

/** More changes than this at once are sent as a whole scene. */
const MANY = 50;

/** What the server holds once it has read all that is on its way; null: nobody knows. */
interface Held {
  readonly scene: SceneRecord;
  readonly room: RoomRecord | null;
  readonly boxes: ReadonlyMap<string, BoxRecord | null>;
}

export interface Outbox {
  readonly held: Held | null;
  /** What is on its way, oldest first. */
  readonly onTheWay: readonly Edit[];
  readonly nextSeq: number;
}

/** The server knows nothing yet. */
export const EMPTY_OUTBOX: Outbox = { held: null, onTheWay: [], nextSeq: 1 };

export interface Advanced {
  readonly outbox: Outbox;
  readonly edits: readonly Edit[];
}

/** What to send now so that the server gets to hold this scene. */
export function advance(outbox: Outbox, scene: SceneRecord): Advanced {
  if (outbox.onTheWay.some(({ type }) => type === "put_scene")) return { outbox, edits: [] };
  const { held, nextSeq: seq } = outbox;
  const changes = held === null || !isSameScene(held.scene, scene) ? null : changesOf(held, scene);
  if (changes === null || changes.flatMap(subjectsOf).length > MANY) {
    return sent({ ...outbox, held: holding(scene) }, [{ type: "put_scene", seq, scene }]);
  }
  const edits = free(changes, outbox.onTheWay).map((edit, i) => ({ ...edit, seq: seq + i }));
  return sent({ ...outbox, held: edits.reduce(after, held) }, edits);
}

/** That edit is stored. */
export function acknowledged(outbox: Outbox, seq: number): Outbox {
  const onTheWay = outbox.onTheWay.filter((edit) => edit.seq !== seq);
  return onTheWay.length === outbox.onTheWay.length ? outbox : { ...outbox, onTheWay };
}

/** That edit came too fast: it is to be sent again. (One refused for good is `acknowledged`.) */
export function forgotten(outbox: Outbox, seq: number): Outbox {
  const edit = outbox.onTheWay.find((candidate) => candidate.seq === seq);
  return edit === undefined
    ? outbox
    : { ...acknowledged(outbox, seq), held: without(outbox.held, edit) };
}

/** The socket is gone, and with it perhaps what was on its way. */
export function lost(outbox: Outbox): Outbox {
  return { ...outbox, held: outbox.onTheWay.reduce(without, outbox.held), onTheWay: [] };
}

/** The server holds something else, or nothing: the scene is to be sent as a whole. */
export function mismatched(outbox: Outbox): Outbox {
  return { ...outbox, held: null, onTheWay: [] };
}

/** The scene came from the server. */
export function adopted(outbox: Outbox, scene: SceneRecord): Outbox {
  return { ...outbox, held: holding(scene), onTheWay: [] };
}

/** How many changed things are not acknowledged. */
export function unsent(outbox: Outbox, scene: SceneRecord): number {
  const { held, onTheWay } = outbox;
  if (held === null || !isSameScene(held.scene, scene)) return onTheWay.length + 1;
  const waiting = free(changesOf(held, scene), onTheWay);
  return [...onTheWay, ...waiting].flatMap(subjectsOf).length;
}

/** The changes that are about nothing on its way. */
function free(changes: readonly Edit[], onTheWay: readonly Edit[]): readonly Edit[] {
  const busy = new Set(onTheWay.flatMap(subjectsOf));
  const isFree = (subject: string): boolean => !busy.has(subject);
  return changes.flatMap((edit): readonly Edit[] => {
    if (edit.type !== "put_boxes") return subjectsOf(edit).every(isFree) ? [edit] : [];
    const boxes = edit.boxes.filter(({ id }) => isFree(subjectOf(id)));
    return boxes.length === 0 ? [] : [{ ...edit, boxes }];
  });
}

function sent(outbox: Outbox, edits: readonly Edit[]): Advanced {
  if (edits.length === 0) return { outbox, edits };
  return {
    outbox: {
      ...outbox,
      onTheWay: [...outbox.onTheWay, ...edits],
      nextSeq: outbox.nextSeq + edits.length,
    },
    edits,
  };
}

function isSameScene(held: SceneRecord, scene: SceneRecord): boolean {
  return held.id === scene.id && held.name === scene.name && held.source === scene.source;
}

function holding(scene: SceneRecord): Held {
  return { scene, room: scene.room, boxes: new Map(scene.boxes.map((box) => [box.id, box])) };
}

/** The edits that lead from what is held to the scene, without their numbers yet. */
function changesOf(held: Held, scene: SceneRecord): readonly Edit[] {
  const present = new Set(scene.boxes.map(({ id }) => id));
  const boxes = scene.boxes.filter((box) => held.boxes.get(box.id) !== box);
  const seq = 0;
  return [
    ...(held.room === scene.room ? [] : [{ type: "put_room", seq, room: scene.room } as const]),
    ...(boxes.length === 0 ? [] : [{ type: "put_boxes", seq, boxes } as const]),
    ...[...held.boxes.keys()]
      .filter((id) => !present.has(id))
      .map((id) => ({ type: "remove_box", seq, id }) as const),
  ];
}

/** What an edit is about: two about the same thing are not on their way at once. */
function subjectsOf(edit: Edit): readonly string[] {
  switch (edit.type) {
    case "put_scene":
      return ["scene"];
    case "put_room":
      return ["room"];
    case "put_boxes":
      return edit.boxes.map(({ id }) => subjectOf(id));
    case "remove_box":
      return [subjectOf(edit.id)];
  }
}

function subjectOf(id: string): string {
  return `box ${id}`;
}

/** What is held after an edit. */
function after(held: Held | null, edit: Edit): Held | null {
  if (held === null) return null;
  const boxes = new Map(held.boxes);
  switch (edit.type) {
    case "put_scene":
      return holding(edit.scene);
    case "put_room":
      return { ...held, room: edit.room };
    case "put_boxes":
      for (const box of edit.boxes) boxes.set(box.id, box);
      return { ...held, boxes };
    case "remove_box":
      boxes.delete(edit.id);
      return { ...held, boxes };
  }
}

/** What is held when nobody knows whether an edit arrived. */
function without(held: Held | null, edit: Edit): Held | null {
  if (held === null) return null;
  switch (edit.type) {
    case "put_scene":
      return null;
    case "put_room":
      return { ...held, room: null };
    case "put_boxes":
      return { ...held, boxes: new Map([...held.boxes, ...edit.boxes.map(unknown)]) };
    case "remove_box":
      return { ...held, boxes: new Map([...held.boxes, [edit.id, null]]) };
  }
}

function unknown({ id }: BoxRecord): readonly [string, null] {
  return [id, null];
}
