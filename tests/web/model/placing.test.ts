import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import { refusalOf } from "../../../web/src/model/ghost";
import type { HeatMap, State } from "../../../web/src/model/state";
import type { Inspected } from "../../../web/src/net/protocol.gen";
import { answer, begin, box, placement, play } from "../rooms";

const MAP: HeatMap = {
  surface: "floor",
  origin: [0, 0],
  cell: 0.1,
  rows: 1,
  columns: 1,
  min: 0,
  max: 1,
  values: new Uint8Array([255]),
};
const place = (change: Partial<Action & { readonly type: "place" }> = {}): Action => ({
  type: "place",
  category: "Sofa",
  item: null,
  size: null,
  mode: "scenegen",
  view: [2.5, 1],
  ...change,
});
const answered = (state: State, revision = 1, change: Parameters<typeof answer>[2] = {}): State =>
  play(
    state,
    { type: "maps", ask: state.placing?.ask ?? "none", revision, heatMaps: [MAP] },
    { type: "answer", answer: answer(state.placing?.ask ?? "none", revision, change) },
  );
const asking = play(begin(), place());
const offered = answered(asking);
const dragTo = (x: number, y: number, heading = 0): Action => ({
  type: "drag-ghost",
  pose: { center: [x, y, 0.4], heading },
  done: true,
});

describe("SceneGen", () => {
  test("until the answer is there the ghost stands nowhere", () => {
    expect(asking.placing).toMatchObject({ pose: null, alternative: 1, computing: true });
  });

  test("the answer puts it on placement 1, with the server's size and model", () => {
    expect(offered.placing).toMatchObject({
      pose: { center: [1, 1, 0.4], heading: 0 },
      alternative: 1,
      computing: false,
      size: [0.9, 2, 0.8],
      asset: "0123456789abcdef0123456789abcdef",
    });
    expect(offered.placing?.heatMaps).toEqual([MAP]);
  });

  test("another alternative is shown by its rank", () => {
    const second = play(offered, { type: "show-alternative", rank: 2 });
    expect(second.placing).toMatchObject({ alternative: 2, pose: { center: [4, 3, 0.4] } });
  });

  test("an alternative that is not on offer changes nothing", () => {
    expect(play(offered, { type: "show-alternative", rank: 5 }).placing).toBe(offered.placing);
  });

  test("an answer to another ask is dropped", () => {
    const stale = play(offered, { type: "answer", answer: answer("ask-0", 9) });
    expect(stale.placing).toBe(offered.placing);
  });

  test("an answer of an older revision than the last is dropped", () => {
    const newer = answered(asking, 7);
    expect(answered(newer, 6).placing).toBe(newer.placing);
  });

  test("maps follow a drag ahead of their answer, and never go back", () => {
    const [older, newer] = [
      { ...MAP, min: 1 },
      { ...MAP, min: 2 },
    ];
    const ask = offered.placing?.ask ?? "";
    const ahead = play(offered, { type: "maps", ask, revision: 5, heatMaps: [newer] });
    expect(ahead.placing?.heatMaps).toEqual([newer]);
    const late = play(ahead, { type: "maps", ask, revision: 4, heatMaps: [older] });
    expect(late.placing).toBe(ahead.placing);
    const other = play(ahead, { type: "maps", ask: "ask-0", revision: 9, heatMaps: [older] });
    expect(other.placing).toBe(ahead.placing);
    const again = play(ahead, { type: "set-size", size: [1, 2.4, 0.9] });
    const anew = { type: "maps", ask: again.placing?.ask ?? "", revision: 1 } as const;
    expect(play(again, { ...anew, heatMaps: [older] }).placing?.heatMaps).toEqual([older]);
  });

  test("after an edit the old map stays while the new one is computed", () => {
    const edited = play(offered, { type: "edit-box", box: box("table"), done: true });
    expect(edited.placing).toMatchObject({ computing: true, heatMaps: [MAP] });
  });

  test("an answer to a room that has changed since is shown, as still computing", () => {
    const ahead = play(asking, { type: "connection", connection: { revision: 5 } });
    expect(answered(ahead, 4).placing).toMatchObject({ computing: true, alternative: 1 });
    expect(answered(ahead, 5).placing).toMatchObject({ computing: false });
  });

  test("after an edit that the server refused, the last answer is the newest there will be", () => {
    const edited = play(
      offered,
      { type: "edit-box", box: box("table"), done: true },
      { type: "connection", connection: { unsent: 1, revision: 1 } },
    );
    expect(edited.placing?.computing).toBe(true);
    const refused = play(edited, { type: "connection", connection: { unsent: 0 } });
    expect(refused.placing?.computing).toBe(false);
    const accepted = play(edited, { type: "connection", connection: { unsent: 0, revision: 2 } });
    expect(accepted.placing?.computing).toBe(true);
  });

  test("the ghost follows its alternative to the newer answer", () => {
    const second = play(offered, { type: "show-alternative", rank: 2 });
    const moved = [placement(1), placement(2, { center: [3, 2, 0.4] })];
    expect(answered(second, 2, { placements: moved }).placing).toMatchObject({
      alternative: 2,
      pose: { center: [3, 2, 0.4] },
    });
  });

  test("where the new answer has fewer alternatives the ghost goes to the first", () => {
    const second = play(offered, { type: "show-alternative", rank: 2 });
    expect(answered(second, 2, { placements: [placement(1)] }).placing).toMatchObject({
      alternative: 1,
      pose: { center: [1, 1, 0.4] },
    });
  });

  test("where there is no good place the ghost stands nowhere", () => {
    const none = answered(asking, 1, {
      placements: [],
      no_good_place: { rule: "room", text: "No free wall is wide enough.", remedy: null },
    });
    expect(none.placing).toMatchObject({ pose: null, alternative: 1 });
  });

  test("a dragged ghost stays where the person put it, whatever the answers say", () => {
    const dragged = play(offered, dragTo(3, 2));
    expect(dragged.placing?.alternative).toBeNull();
    expect(answered(dragged, 2).placing?.pose?.center).toEqual([3, 2, 0.4]);
  });

  test("what the server says of a pose counts only while the ghost is off the alternatives", () => {
    const inspected: Inspected = {
      type: "inspected",
      id: "i",
      ask: asking.placing?.ask ?? "",
      revision: 1,
      allowed: true,
      score: 0,
      likelihood: 0.5,
      sentence: "In the middle of the room.",
      reasons: [],
      rule: "",
      costs: [],
      elsewhere: null,
    };
    const pose = { center: [3, 2, 0.4], heading: 0 } as const;
    const said: Action = { type: "inspected", inspected, pose };
    const dragged = play(offered, dragTo(3, 2), said);
    expect(dragged.placing?.inspected).toBe(inspected);
    expect(play(offered, said).placing?.inspected).toBeNull();
    const back = play(dragged, { type: "show-alternative", rank: 1 });
    expect(back.placing?.inspected).toBeNull();
  });
});

describe("Manual", () => {
  const byHand = play(begin(), place({ mode: "manual", size: [0.9, 2, 0.8], view: [2.5, 1] }));

  test("the ghost stands where the view meets the floor, its back to the nearest wall", () => {
    expect(byHand.placing?.pose?.center).toEqual([2.5, 1, 0.4]);
    expect(byHand.placing?.pose?.heading).toBeCloseTo(Math.PI / 2, 12);
    expect(byHand.placing?.alternative).toBeNull();
  });

  test("an answer does not move it", () => {
    expect(answered(byHand).placing?.pose?.center).toEqual([2.5, 1, 0.4]);
  });

  test("the alternatives are not shown", () => {
    const state = answered(byHand);
    expect(play(state, { type: "show-alternative", rank: 2 }).placing).toBe(state.placing);
  });

  test("changing to SceneGen keeps the object and its size, and shows placement 1", () => {
    const toggled = play(answered(byHand), { type: "set-mode", mode: "scenegen", view: [0, 0] });
    expect(toggled.placing).toMatchObject({
      ask: byHand.placing?.ask,
      category: "Sofa",
      wishedSize: [0.9, 2, 0.8],
      alternative: 1,
      pose: { center: [1, 1, 0.4] },
    });
  });

  test("changing back puts it where the view is now", () => {
    const toggled = play(
      answered(byHand),
      { type: "set-mode", mode: "scenegen", view: [0, 0] },
      { type: "set-mode", mode: "manual", view: [3, 2] },
    );
    expect(toggled.placing).toMatchObject({ alternative: null, pose: { center: [3, 2, 0.4] } });
  });

  test("a picture hangs on the nearest wall at the height of the eyes", () => {
    const picture = play(
      begin(),
      place({ mode: "manual", category: "Picture", size: [0.04, 0.8, 0.6], view: [2.5, 1] }),
    );
    expect(picture.placing?.pose?.center).toEqual([2.5, 0.02, 1.5]);
  });

  test("a TV stands on the sideboard that it is put over, and hangs where there is none", () => {
    const sideboard = box("s", {
      category: "Storage",
      center: [2.5, 2, 0.3],
      size: [0.4, 1.6, 0.6],
    });
    const tv = { mode: "manual", category: "TV", size: [0.1, 1.2, 0.7] } as const;
    const onTop = play(begin([sideboard]), place({ ...tv, view: [2.5, 2] }));
    expect(onTop.placing?.pose?.center[2]).toBeCloseTo(0.95, 12);
    const hung = play(begin([sideboard]), place({ ...tv, view: [1, 3.5] }));
    expect(hung.placing?.pose?.center).toEqual([1, 3.95, 1.1]);
  });

  test("a TV that is dragged along its wall keeps its height, in the room it stands", () => {
    const tv = place({ mode: "manual", category: "TV", size: [0.1, 1.2, 0.7], view: [1, 3.5] });
    const hung = play(begin(), tv);
    const slid = play(hung, {
      type: "drag-ghost",
      pose: { center: [3, 3.95, 1.3], heading: -Math.PI / 2 },
      done: true,
    });
    expect(slid.placing?.pose?.center[2]).toBe(1.3);
    expect(play(hung, dragTo(2.5, 2)).placing?.pose?.center[2]).toBeCloseTo(0.35, 12);
  });

  test("a picture that was pulled off its wall hangs again on the next one", () => {
    const picture = place({ mode: "manual", category: "Picture", size: [0.04, 0.8, 0.6] });
    const off = play(begin(), picture, dragTo(2.5, 2));
    expect(refusalOf(off)).toMatch(/^It has to hang on a wall/);
    const back = play(off, { type: "nudge", by: [-2.48, 0] });
    expect(back.placing?.pose?.center).toEqual([0.02, 2, 1.5]);
    expect(refusalOf(back)).toBeNull();
  });

  test("a lamp stands on the table that it is put over, and comes down beside it", () => {
    const table = box("table", { center: [2.5, 2, 0.4], size: [0.8, 1.2, 0.8] });
    const lamp = place({
      mode: "manual",
      category: "Decor",
      size: [0.2, 0.2, 0.4],
      view: [2.5, 2],
    });
    const onTop = play(begin([table]), lamp);
    expect(onTop.placing?.pose?.center[2]).toBeCloseTo(1.0, 12);
    const beside = play(onTop, dragTo(1, 1));
    expect(beside.placing?.pose?.center[2]).toBeCloseTo(0.2, 12);
  });
});

describe("size", () => {
  test("another size is another question, and the old map stays", () => {
    const bigger = play(offered, { type: "set-size", size: [1, 2.4, 0.9] });
    expect(bigger.placing?.ask).not.toBe(offered.placing?.ask);
    expect(bigger.placing).toMatchObject({
      size: [1, 2.4, 0.9],
      wishedSize: [1, 2.4, 0.9],
      computing: true,
      heatMaps: [MAP],
    });
  });

  test("what stands on the floor stays on the floor when it grows", () => {
    const taller = play(offered, { type: "set-size", size: [0.9, 2, 1.0] });
    expect(taller.placing?.pose?.center[2]).toBeCloseTo(0.5, 12);
  });

  test("without a wish it is the usual size of the server's list", () => {
    const known = play(begin(), {
      type: "lists",
      lists: {
        categories: [
          { name: "Sofa", symmetry: "asymmetric", placeable: true, size: [1, 3, 0.7], examples: 1 },
        ],
        catalogue: [],
        rooms: [],
      },
    });
    expect(play(known, place()).placing?.size).toEqual([1, 3, 0.7]);
  });
});

describe("confirming", () => {
  test("the ghost becomes a solid box, selected, in one step of undo", () => {
    const confirmed = play(offered, { type: "confirm" });
    expect(confirmed.scene.boxes).toEqual([
      {
        id: "box-1",
        category: "Sofa",
        center: [1, 1, 0.4],
        size: [0.9, 2, 0.8],
        heading: 0,
        placed: true,
      },
    ]);
    expect(confirmed.placing).toBeNull();
    expect(confirmed.selection).toEqual({ kind: "box", id: "box-1" });
    expect(confirmed.models).toEqual({ "box-1": "0123456789abcdef0123456789abcdef" });
    expect(play(confirmed, { type: "undo" }).scene.boxes).toEqual([]);
  });

  test("without a place there is nothing to confirm", () => {
    expect(play(asking, { type: "confirm" }).placing).toBe(asking.placing);
  });

  test("it is refused where it would stand in a table, and the sentence says so", () => {
    const table = box("table", { center: [3, 2, 0.4] });
    const blocked = play(offered, { type: "edit-box", box: table, done: true }, dragTo(3, 2));
    expect(refusalOf(blocked)).toBe("It would stand in the table.");
    const refused = play(blocked, { type: "confirm" });
    expect(refused.placing).not.toBeNull();
    expect(refused.notice?.text).toBe("It would stand in the table.");
  });

  test("a label says more than the category", () => {
    const labelled = box("b", { category: "Other", label: "Piano", center: [3, 2, 0.4] });
    const refused = play(offered, { type: "edit-box", box: labelled, done: true }, dragTo(3, 2), {
      type: "confirm",
    });
    expect(refused.notice?.text).toBe("It would stand in the piano.");
  });

  test("it is refused in the wall", () => {
    const refused = play(offered, dragTo(0.1, 2), { type: "confirm" });
    expect(refused.notice?.text).toBe("It would stick through a wall or out of the room.");
  });

  test("a chair may stand under the edge of a table, not in its middle", () => {
    const table = box("table", { center: [3, 2, 0.4], size: [1, 1.2, 0.75] });
    const chair = (x: number): Action =>
      place({ mode: "manual", category: "Chair", size: [0.5, 0.5, 0.9], view: [x, 2] });
    const tucked = play(begin([table]), chair(2.45), { type: "confirm" }); // 0.2 m under it
    expect(tucked.scene.boxes).toHaveLength(2);
    const within = play(begin([table]), chair(3), { type: "confirm" });
    expect(within.notice?.text).toBe("It would stand in the table.");
  });

  test("a picture may hang above a sofa", () => {
    const sofa = box("sofa", {
      category: "Sofa",
      center: [2.5, 0.45, 0.4],
      size: [0.9, 2, 0.8],
      heading: Math.PI / 2,
    });
    const picture = place({ mode: "manual", category: "Picture", size: [0.04, 0.8, 0.6] });
    expect(refusalOf(play(begin([sofa]), picture))).toBeNull();
  });

  test("a wardrobe higher than the room is refused", () => {
    const tall = place({ mode: "manual", category: "Storage", size: [0.5, 1, 3], view: [2.5, 2] });
    expect(play(begin(), tall, { type: "confirm" }).notice?.text).toBe(
      "It is too tall for this room.",
    );
  });
});

describe("the keyboard", () => {
  test("arrows and brackets move and turn the ghost, not what is selected", () => {
    const moved = play(
      offered,
      { type: "nudge", by: [0.05, 0] },
      { type: "turn", by: Math.PI / 12 },
    );
    expect(moved.placing?.pose?.center).toEqual([1.05, 1, 0.4]);
    expect(moved.placing?.pose?.heading).toBeCloseTo(Math.PI / 12, 12);
    expect(moved.placing?.alternative).toBeNull();
    expect(moved.past).toEqual([]);
  });

  test("Esc lets the object go", () => {
    expect(play(offered, { type: "cancel" }).placing).toBeNull();
  });
});

describe("another room", () => {
  const other = { ...begin().scene, id: "other" };

  test("opening one while placing asks again about the same object", () => {
    const opened = play(offered, { type: "open-scene", scene: other });
    expect(opened.placing).toMatchObject({
      category: "Sofa",
      pose: null,
      alternative: 1,
      answer: null,
      heatMaps: [],
      computing: true,
    });
    expect(opened.placing?.ask).not.toBe(offered.placing?.ask);
  });

  test("by hand the ghost stands in the middle of it", () => {
    const byHand = play(begin(), place({ mode: "manual" }), { type: "open-scene", scene: other });
    expect(byHand.placing?.pose?.center.slice(0, 2)).toEqual([2.5, 2]);
  });
});

test("in another session the question is asked again, since its revisions start anew", () => {
  const moved = play(offered, { type: "connection", connection: { session: "s2" } });
  expect(moved.placing?.ask).not.toBe(offered.placing?.ask);
  const fresh = play(moved, {
    type: "answer",
    answer: answer(moved.placing?.ask ?? "", 0),
  });
  expect(fresh.placing?.answer?.revision).toBe(0);
});
