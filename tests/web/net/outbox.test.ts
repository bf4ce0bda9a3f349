import { describe, expect, test } from "vitest";
import {
  acknowledged,
  adopted,
  advance,
  type Edit,
  EMPTY_OUTBOX,
  forgotten,
  lost,
  mismatched,
  type Outbox,
  unsent,
} from "../../../web/src/net/outbox";
import type { BoxRecord, SceneRecord } from "../../../web/src/net/protocol.gen";
import { box, room } from "../rooms";

const table = box("table");
const chair = box("chair");
const START = room([table, chair]);
const IN_STEP = adopted(EMPTY_OUTBOX, START);

const withBoxes = (...boxes: readonly BoxRecord[]): SceneRecord => ({ ...START, boxes });
const moved = (x: number): BoxRecord => ({ ...table, center: [x, 2, 0.4] });
const short = (edit: Edit): string =>
  edit.type === "put_boxes"
    ? `put ${edit.boxes.map(({ id }) => id).join(" ")}`
    : edit.type === "remove_box"
      ? `remove ${edit.id}`
      : edit.type;

/** Advances through scenes one by one and lists what was sent. */
function send(outbox: Outbox, ...scenes: readonly SceneRecord[]): { outbox: Outbox; sent: Edit[] } {
  const sent: Edit[] = [];
  let now = outbox;
  for (const scene of scenes) {
    const step = advance(now, scene);
    now = step.outbox;
    sent.push(...step.edits);
  }
  return { outbox: now, sent };
}

describe("what is sent", () => {
  test("a server that knows nothing gets the whole scene", () => {
    expect(advance(EMPTY_OUTBOX, START).edits).toEqual([
      { type: "put_scene", seq: 1, scene: START },
    ]);
  });

  test("of a scene that it holds, nothing is sent", () => {
    expect(advance(IN_STEP, START).edits).toEqual([]);
  });

  test("a moved box is sent alone, not the one beside it", () => {
    const { sent } = send(IN_STEP, withBoxes(moved(3), chair));
    expect(sent).toEqual([{ type: "put_boxes", seq: 1, boxes: [moved(3)] }]);
  });

  test("boxes that move together are sent together", () => {
    const both = withBoxes(moved(3), { ...chair, center: [3, 2, 0.9] });
    expect(send(IN_STEP, both).sent.map(short)).toEqual(["put table chair"]);
  });

  test("a box that is gone is removed", () => {
    expect(send(IN_STEP, withBoxes(chair)).sent.map(short)).toEqual(["remove table"]);
  });

  test("another room is sent without its boxes", () => {
    const lower = { ...START, room: { ...START.room, height: 2.2 } };
    expect(send(IN_STEP, lower).sent.map(short)).toEqual(["put_room"]);
  });

  test("another scene is sent as a whole", () => {
    expect(send(IN_STEP, { ...START, id: "other" }).sent.map(short)).toEqual(["put_scene"]);
  });

  test("many changes at once are sent as a whole", () => {
    const many = withBoxes(table, chair, ...Array.from({ length: 60 }, (_, i) => box(`b${i}`)));
    expect(send(IN_STEP, many).sent.map(short)).toEqual(["put_scene"]);
  });

  test("every edit has its own number, counting up", () => {
    const { sent } = send(IN_STEP, withBoxes(), START);
    expect(sent.map(({ seq }) => seq)).toEqual(sent.map((_, i) => i + 1));
    expect(sent.length).toBeGreaterThan(0);
  });
});

describe("one message at a time about a thing", () => {
  test("while a drag's first move is on its way, only the newest of the others waits", () => {
    const drag = [3, 3.1, 3.2, 3.3].map((x) => withBoxes(moved(x), chair));
    const { outbox, sent } = send(IN_STEP, ...drag);
    expect(sent).toEqual([{ type: "put_boxes", seq: 1, boxes: [moved(3)] }]);
    const last = drag.at(-1) ?? START;
    const next = send(acknowledged(outbox, 1), last);
    expect(next.sent).toMatchObject([
      { type: "put_boxes", seq: 2, boxes: [{ center: [3.3, 2, 0.4] }] },
    ]);
    expect(send(acknowledged(next.outbox, 2), last).sent).toEqual([]);
  });

  test("a box on its way does not hold up another", () => {
    const first = send(IN_STEP, withBoxes(moved(3), chair));
    const both = send(first.outbox, withBoxes(moved(4), { ...chair, label: "armchair" }));
    expect(both.sent.map(short)).toEqual(["put chair"]);
  });

  test("a box put and removed again before the acknowledgement is removed after it", () => {
    const put = send(IN_STEP, withBoxes(table, chair, box("new")));
    const removed = send(put.outbox, START);
    expect(removed.sent).toEqual([]);
    expect(send(acknowledged(removed.outbox, 1), START).sent.map(short)).toEqual(["remove new"]);
  });

  test("edits wait while a whole scene is on its way", () => {
    const whole = send(EMPTY_OUTBOX, START);
    const waiting = send(whole.outbox, withBoxes(moved(3), chair));
    expect(waiting.sent).toEqual([]);
    const next = send(acknowledged(waiting.outbox, 1), withBoxes(moved(3), chair));
    expect(next.sent.map(short)).toEqual(["put table"]);
  });
});

describe("a lost socket", () => {
  test("what was not acknowledged is sent again, with its newest value", () => {
    const { outbox } = send(IN_STEP, withBoxes(moved(3), chair));
    const again = send(lost(outbox), withBoxes(moved(4), chair));
    expect(again.sent).toMatchObject([
      { type: "put_boxes", seq: 2, boxes: [{ center: [4, 2, 0.4] }] },
    ]);
  });

  test("so is a removal", () => {
    const { outbox } = send(IN_STEP, withBoxes(chair));
    expect(send(lost(outbox), withBoxes(chair)).sent.map(short)).toEqual(["remove table"]);
  });

  test("so is a removal that was taken back: the box is put", () => {
    const { outbox } = send(IN_STEP, withBoxes(chair));
    expect(send(lost(outbox), START).sent.map(short)).toEqual(["put table"]);
  });

  test("so are a room and a whole scene", () => {
    const lower = { ...START, room: { ...START.room, height: 2.2 } };
    expect(send(lost(send(IN_STEP, lower).outbox), lower).sent.map(short)).toEqual(["put_room"]);
    expect(send(lost(send(EMPTY_OUTBOX, START).outbox), START).sent.map(short)).toEqual([
      "put_scene",
    ]);
  });

  test("what was acknowledged is not", () => {
    const scene = withBoxes(moved(3), chair);
    const { outbox } = send(IN_STEP, scene);
    expect(send(lost(acknowledged(outbox, 1)), scene).sent).toEqual([]);
  });

  test("edits made meanwhile are sent too", () => {
    const offline = withBoxes(table, chair, box("drawn offline"));
    expect(send(lost(IN_STEP), offline).sent.map(short)).toEqual(["put drawn offline"]);
  });

  test("a server that lost the session gets everything", () => {
    expect(send(mismatched(IN_STEP), START).sent.map(short)).toEqual(["put_scene"]);
  });
});

describe("refusals", () => {
  test("what came too fast is sent again", () => {
    const scene = withBoxes(moved(3), chair);
    const { outbox } = send(IN_STEP, scene);
    expect(send(forgotten(outbox, 1), scene).sent.map(short)).toEqual(["put table"]);
  });

  test("an acknowledgement of something else changes nothing", () => {
    const { outbox } = send(IN_STEP, withBoxes(moved(3), chair));
    expect(acknowledged(outbox, 99)).toBe(outbox);
  });
});

describe("how much is unsent", () => {
  test("nothing, when the server holds the scene", () => {
    expect(unsent(IN_STEP, START)).toBe(0);
  });

  test("what is on its way and what waits behind it count once", () => {
    const { outbox } = send(IN_STEP, withBoxes(moved(3), chair));
    expect(unsent(outbox, withBoxes(moved(4), chair))).toBe(1);
  });

  test("each changed thing counts", () => {
    expect(unsent(IN_STEP, withBoxes(moved(3), { ...chair, label: "x" }, box("new")))).toBe(3);
  });

  test("a scene that nobody holds counts as one", () => {
    expect(unsent(EMPTY_OUTBOX, START)).toBe(1);
  });
});

test("whatever is edited, lost and acknowledged, the server ends up with the scene", () => {
  // A little server that applies what arrives; every third message is lost with its socket.
  let server: { room: unknown; boxes: Map<string, BoxRecord> } | null = null;
  const apply = (edit: Edit): void => {
    if (edit.type === "put_scene") {
      server = { room: edit.scene.room, boxes: new Map(edit.scene.boxes.map((b) => [b.id, b])) };
    } else if (server !== null) {
      if (edit.type === "put_room") server.room = edit.room;
      if (edit.type === "put_boxes") for (const box of edit.boxes) server.boxes.set(box.id, box);
      if (edit.type === "remove_box") server.boxes.delete(edit.id);
    }
  };
  let outbox = EMPTY_OUTBOX;
  let scene = START;
  let count = 0;
  for (let i = 0; i < 200; i += 1) {
    const id = `box-${(i * 7) % 11}`;
    const without = scene.boxes.filter((one) => one.id !== id);
    scene = { ...scene, boxes: i % 4 === 3 ? without : [...without, box(id, { label: `${i}` })] };
    if (i % 25 === 24) scene = { ...scene, room: { ...scene.room, height: 2 + i / 1000 } };
    const step = advance(outbox, scene);
    outbox = step.outbox;
    for (const edit of step.edits) {
      count += 1;
      if (count % 3 === 0) {
        outbox = lost(outbox);
        break;
      }
      apply(edit);
      if (count % 2 === 0) outbox = acknowledged(outbox, edit.seq);
    }
  }
  for (let round = 0; round < 5; round += 1) {
    const step = advance(outbox, scene);
    outbox = step.outbox;
    for (const edit of [...step.edits, ...outbox.onTheWay]) {
      apply(edit);
      outbox = acknowledged(outbox, edit.seq);
    }
  }
  expect(server).not.toBeNull();
  expect(server).toEqual({ room: scene.room, boxes: new Map(scene.boxes.map((b) => [b.id, b])) });
});
