import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { AssetCache } from "../../../web/src/net/assets";
import { Connection } from "../../../web/src/net/connection";
import { Live } from "../../../web/src/net/live";
import type { ClientMessage, Problem, Welcome } from "../../../web/src/net/protocol.gen";
import { createStore } from "../../../web/src/store";
import { answer, begin, box } from "../rooms";
import { frame, HEAT_MAP } from "./frames";
import { network } from "./sockets";

const WELCOME: Welcome = {
  type: "welcome",
  session: "s1",
  revision: 0,
  resumed: false,
  scene: null,
  categories: [],
  catalogue: [],
  rooms: [{ id: "studio", name: "Studio", kind: "sample", boxes: 3, area: 20 }],
  models: ["paper"],
};
const DIGEST = "0123456789abcdef0123456789abcdef";

function start(session: string | null = null, joining = false) {
  const net = network();
  const store = createStore(begin([box("table")]));
  const assets = new AssetCache(async () => null);
  const remembered: string[] = [];
  const replaced: string[] = [];
  const live = new Live({
    store,
    assets,
    send: (message: ClientMessage) => connection.send(message),
    session,
    joining,
    remember: (id) => remembered.push(id),
    replaced: (id) => replaced.push(id),
  });
  const connection = new Connection({
    url: "ws://room/socket",
    open: net.open,
    listener: live,
    random: () => 1,
  });
  connection.start();
  return { ...net, store, assets, remembered, replaced };
}

/** Connected, the first scene uploaded and acknowledged as revision 1. */
function online() {
  const started = start();
  const socket = started.last();
  socket.open();
  socket.says(WELCOME);
  socket.says({ type: "ack", seq: 1, revision: 1 });
  return { ...started, socket };
}

const place = { category: "Sofa", item: null, size: null, mode: "scenegen", view: [2, 2] } as const;
const problem = (change: Partial<Problem>): Problem => ({
  type: "problem",
  code: "bad_scene",
  text: "That box is too big. Make it smaller.",
  path: null,
  seq: null,
  ...change,
});

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

describe("beginning", () => {
  test("hello comes first, and nothing else before the welcome", () => {
    const { last } = start("s0");
    last().open();
    expect(last().sent).toEqual([{ type: "hello", session: "s0", revision: 0, assets: [] }]);
  });

  test("after the welcome the scene on this device is uploaded", () => {
    const { last, store, remembered } = start();
    last().open();
    last().says(WELCOME);
    expect(
      last()
        .of("put_scene")
        .map(({ scene }) => scene),
    ).toEqual([store.getState().scene]);
    expect(store.getState().connection).toMatchObject({
      status: "online",
      session: "s1",
      unsent: 1,
    });
    expect(store.getState().lists.rooms).toHaveLength(1);
    expect(remembered).toEqual(["s1"]);
  });

  test("the phone is the truth: what the server holds instead is replaced", () => {
    const { last, store } = start("s1");
    const mine = store.getState().scene;
    last().open();
    last().says({ ...WELCOME, resumed: true, revision: 4, scene: { ...mine, id: "theirs" } });
    expect(last().of("put_scene")).toHaveLength(1);
    expect(store.getState().scene).toBe(mine);
  });

  test("on another device's link its room is taken over, and not sent back", () => {
    const { last, store } = start("s1", true);
    const theirs = { ...store.getState().scene, id: "theirs" };
    last().open();
    last().says({ ...WELCOME, resumed: true, revision: 4, scene: theirs });
    expect(store.getState().scene).toEqual(theirs);
    expect(last().of("put_scene")).toEqual([]);
  });

  test("a link whose room is gone says so", () => {
    const { last, store } = start("s1", true);
    last().open();
    last().says(WELCOME);
    expect(store.getState().notice?.text).toMatch(/gone/);
    expect(last().of("put_scene")).toHaveLength(1);
  });
});

describe("editing", () => {
  test("an edit is sent, acknowledged and no longer unsent", () => {
    const { socket, store } = online();
    store.dispatch({ type: "edit-box", box: box("chair"), done: true });
    expect(socket.of("put_boxes")).toMatchObject([{ seq: 2, boxes: [{ id: "chair" }] }]);
    expect(store.getState().connection.unsent).toBe(1);
    socket.says({ type: "ack", seq: 2, revision: 2 });
    expect(store.getState().connection).toMatchObject({ revision: 2, unsent: 0 });
  });

  test("edits made offline are sent on coming back, in the same session", () => {
    const { socket, store, last } = online();
    socket.drops();
    expect(store.getState().connection.status).toBe("offline");
    store.dispatch({ type: "edit-box", box: box("chair"), done: true });
    expect(store.getState().connection.unsent).toBe(1);
    vi.advanceTimersByTime(500);
    last().open();
    expect(last().of("hello")).toMatchObject([{ session: "s1", revision: 1 }]);
    last().says({ ...WELCOME, resumed: true, revision: 1 });
    expect(last().of("put_scene")).toEqual([]);
    expect(last().of("put_boxes")).toMatchObject([{ boxes: [{ id: "chair" }] }]);
    expect(store.getState().connection.status).toBe("online");
  });

  test("a server that was started anew gets everything again", () => {
    const { socket, last } = online();
    socket.drops();
    vi.advanceTimersByTime(500);
    last().open();
    last().says({ ...WELCOME, session: "s2" });
    expect(last().of("put_scene")).toHaveLength(1);
  });

  test("an edit that is refused is told in the server's words, and not sent again", () => {
    const { socket, store } = online();
    store.dispatch({ type: "edit-box", box: box("chair"), done: true });
    socket.says(problem({ seq: 2 }));
    expect(store.getState().notice?.text).toBe("That box is too big. Make it smaller.");
    expect(socket.of("put_boxes")).toHaveLength(1);
    expect(store.getState().connection.unsent).toBe(0);
  });

  test("an edit that came too fast is sent again a moment later, without a word", () => {
    const { socket, store } = online();
    store.dispatch({ type: "edit-box", box: box("chair"), done: true });
    socket.says(problem({ seq: 2, code: "too_fast" }));
    vi.advanceTimersByTime(500);
    expect(socket.of("put_boxes").map(({ seq }) => seq)).toEqual([2, 3]);
    expect(store.getState().notice).toBeNull();
  });
});

describe("placing", () => {
  test("heat maps that come before their answer are shown with it", () => {
    const { socket, store } = online();
    store.dispatch({ type: "place", ...place });
    const [ask] = socket.of("ask");
    const id = ask?.id ?? "";
    socket.says(frame({ ...HEAT_MAP, ask: id }, [1, 2, 3, 4, 5, 6]));
    socket.says(frame({ ...HEAT_MAP, ask: "older" }, [1, 2, 3, 4, 5, 6]));
    expect(store.getState().placing?.heatMaps).toEqual([]);
    socket.says({ type: "maps", ask: id, revision: 1 });
    socket.says(answer(id, 1));
    expect(store.getState().placing?.heatMaps).toMatchObject([{ surface: "floor", rows: 2 }]);
    expect(store.getState().placing?.pose?.center).toEqual([1, 1, 0.4]);
  });

  test("each inspection waits for the one before", () => {
    const { socket, store } = online();
    store.dispatch({ type: "place", ...place });
    const id = socket.of("ask")[0]?.id ?? "";
    socket.says(answer(id, 1));
    for (const x of [1, 2, 3]) {
      store.dispatch({
        type: "drag-ghost",
        pose: { center: [x, 2, 0.4], heading: 0 },
        done: false,
      });
    }
    expect(socket.of("inspect").map(({ center }) => center[0])).toEqual([1]);
    socket.says({
      type: "inspected",
      id: socket.of("inspect")[0]?.id ?? "",
      ask: id,
      revision: 1,
      allowed: true,
      score: 0,
      likelihood: 0.4,
      sentence: "In the middle of the room.",
      reasons: [],
      rule: "",
      costs: [],
      elsewhere: null,
    });
    expect(socket.of("inspect").map(({ center }) => center[0])).toEqual([1, 3]);
    expect(store.getState().placing?.inspected?.likelihood).toBe(0.4);
  });

  test("what was asked is asked again on a new socket", () => {
    const { socket, store, last } = online();
    store.dispatch({ type: "place", ...place });
    socket.drops();
    vi.advanceTimersByTime(500);
    last().open();
    last().says({ ...WELCOME, resumed: true, revision: 1 });
    expect(
      last()
        .of("ask")
        .map(({ id }) => id),
    ).toEqual(socket.of("ask").map(({ id }) => id));
  });
});

describe("models", () => {
  test("one that is pushed is kept and named in the next hello", () => {
    const { socket, assets, store, last } = online();
    socket.says(frame({ type: "asset", digest: DIGEST }, [103, 108, 84, 70]));
    socket.says({ type: "models", revision: 1, boxes: { table: DIGEST } });
    expect(new Uint8Array(assets.get(DIGEST) ?? new ArrayBuffer(0))).toEqual(
      new Uint8Array([103, 108, 84, 70]),
    );
    expect(store.getState().models).toEqual({ table: DIGEST });
    socket.drops();
    vi.advanceTimersByTime(500);
    last().open();
    expect(last().of("hello")[0]?.assets).toEqual([DIGEST]);
  });
});

test("a query that the server refuses ends the computing and says why", () => {
  const { socket, store } = online();
  store.dispatch({ type: "place", ...place });
  socket.says(problem({ code: "bad_query", text: "A sofa cannot be 90 m. Make it smaller." }));
  expect(store.getState().placing).toMatchObject({
    computing: false,
    problem: "A sofa cannot be 90 m. Make it smaller.",
  });
  expect(store.getState().notice).toBeNull();
  store.dispatch({ type: "set-size", size: [0.9, 2, 0.8] });
  expect(store.getState().placing).toMatchObject({ computing: true, problem: null });
});

describe("placing it here", () => {
  /** By hand in the free half of the room; the server holds it all as revision 1. */
  function byHand() {
    const started = online();
    const { socket, store } = started;
    store.dispatch({ type: "place", ...place, mode: "manual", view: [2.5, 3.4] });
    const ask = socket.of("ask")[0]?.id ?? "";
    const says = (allowed: boolean, sentence: string): void =>
      socket.says({
        type: "inspected",
        id: socket.of("inspect").at(-1)?.id ?? "",
        ask,
        revision: 1,
        allowed,
        score: null,
        likelihood: null,
        sentence,
        reasons: [],
        rule: "",
        costs: [],
        elsewhere: null,
      });
    return { ...started, ask, says, boxes: () => store.getState().scene.boxes.length };
  }

  test("waits for the server's word, and is done when it says yes", () => {
    const { socket, store, ask, says, boxes } = byHand();
    store.dispatch({ type: "confirm" });
    expect(store.getState().placing?.confirming).toBe(true);
    socket.says(answer(ask, 1));
    expect(boxes()).toBe(1);
    says(true, "In the middle of the room.");
    expect(boxes()).toBe(2);
    expect(store.getState().placing).toBeNull();
  });

  test("is refused in the server's words when it says no, then and for that pose ever after", () => {
    const { socket, store, ask, says, boxes } = byHand();
    socket.says(answer(ask, 1));
    store.dispatch({ type: "confirm" });
    says(false, "It would close the way to the bed.");
    expect(store.getState().notice?.text).toBe("It would close the way to the bed.");
    store.dispatch({ type: "dismiss-notice" });
    store.dispatch({ type: "confirm" });
    expect(store.getState().notice?.text).toBe("It would close the way to the bed.");
    expect(boxes()).toBe(1);
  });

  test("is not done when the ghost was moved on before the word came", () => {
    const { socket, store, ask, says, boxes } = byHand();
    socket.says(answer(ask, 1));
    store.dispatch({ type: "confirm" });
    store.dispatch({ type: "nudge", by: [0.05, 0] });
    says(true, "In the middle of the room.");
    expect(boxes()).toBe(1);
    expect(store.getState().placing?.confirming).toBe(false);
  });

  test("does not wait for ever: in the end the page's own check decides", () => {
    const { socket, store, ask, boxes } = byHand();
    socket.says(answer(ask, 1));
    store.dispatch({ type: "confirm" });
    vi.advanceTimersByTime(60_000);
    expect(boxes()).toBe(2);
  });

  test("offline, and when the connection goes meanwhile, the page's own check decides", () => {
    const { socket, store, boxes } = byHand();
    store.dispatch({ type: "confirm" });
    socket.drops();
    expect(boxes()).toBe(2);
    store.dispatch({ type: "place", ...place, mode: "manual", view: [2.5, 2] });
    store.dispatch({ type: "confirm" });
    expect(store.getState().notice?.text).toMatch(/^It would stand in/);
    expect(boxes()).toBe(2);
  });
});

describe("a connection closed for good", () => {
  test.each([
    [4400, "This page is older than the server. Reload it."],
    [4401, "The server could not understand this page. Reload it to go on."],
    [4402, "This room is open elsewhere. Reload to take it back."],
    [4403, "Too many pages are open. Close some, then reload this one."],
  ])("with %i says what to do, and is not tried again", (code, ended) => {
    const { socket, store, sockets } = online();
    socket.drops(code, "whatever the server says");
    vi.advanceTimersByTime(60_000);
    expect(sockets).toHaveLength(1);
    expect(store.getState().connection).toMatchObject({ status: "offline", ended });
  });

  test("only because it was opened elsewhere, its newest room is there", () => {
    for (const [code, told] of [
      [4400, []],
      [4402, ["s1"]],
    ] as const) {
      const { socket, replaced } = online();
      socket.drops(code, "whatever the server says");
      expect(replaced).toEqual(told);
    }
  });
});
