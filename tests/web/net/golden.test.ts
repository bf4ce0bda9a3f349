/** The messages of the golden files, which the server's tests read too. */
import { describe, expect, test } from "vitest";
import { AssetCache } from "../../../web/src/net/assets";
import { Live } from "../../../web/src/net/live";
import type {
  Answer,
  ClientMessage,
  FrameHeader,
  HeatMapHeader,
  Inspected,
  ServerMessage,
} from "../../../web/src/net/protocol.gen";
import { createStore } from "../../../web/src/store";
import { begin, box, play } from "../rooms";
import { frame } from "./frames";

const FILES = import.meta.glob<unknown>("../../golden/messages/*.json", {
  eager: true,
  import: "default",
});

function golden<T>(type: string): T {
  const value = FILES[`../../golden/messages/${type}.json`];
  if (value === undefined) throw new Error(`there is no golden message ${type}`);
  return value as T;
}

/** A page that places the object of the golden ask, connected, and what it has sent. */
function page() {
  const placing = play(begin([box("table")]), {
    type: "place",
    category: "Sofa",
    item: null,
    size: [0.9, 2.1, 0.8],
    mode: "scenegen",
    view: [2, 2],
  }).placing;
  if (placing === null) throw new Error("nothing is being placed");
  const { id: ask } = golden<{ readonly id: string }>("ask");
  const { session } = golden<{ readonly session: string }>("welcome");
  const { connection, ...state } = begin([box("table")]);
  const store = createStore({
    ...state,
    connection: { ...connection, session },
    placing: { ...placing, ask },
  });
  const assets = new AssetCache(async () => null);
  const sent: ClientMessage[] = [];
  const live = new Live({
    store,
    assets,
    send: (message) => sent.push(message) > 0,
    session,
    joining: false,
    replaced: () => {},
    remember: () => undefined,
  });
  const hear = (type: ServerMessage["type"]): void => live.text(JSON.stringify(golden(type)));
  const settled = (): void => {
    const { revision } = golden<Answer>("answer");
    live.text(JSON.stringify({ type: "ack", seq: 1, revision }));
    hear("answer");
  };
  live.opened();
  hear("welcome");
  return { store, assets, sent, live, hear, settled };
}

describe("what the page understands", () => {
  test("the golden welcome: its lists and its session", () => {
    const { categories, rooms, session } = golden<{
      readonly categories: readonly unknown[];
      readonly rooms: readonly unknown[];
      readonly session: string;
    }>("welcome");
    const { store } = page();
    expect(store.getState().lists.categories).toEqual(categories);
    expect(store.getState().lists.rooms).toEqual(rooms);
    expect(store.getState().connection).toMatchObject({ status: "online", session });
  });

  test("the golden heat map and the golden answer belong together", () => {
    const { store, live, hear } = page();
    const header = golden<HeatMapHeader>("heat_map");
    const [rows, columns] = header.shape;
    live.binary(frame(header, Array(rows * columns).fill(7)));
    hear("maps");
    hear("answer");
    const { placing } = store.getState();
    const [first] = golden<Answer>("answer").placements;
    expect(placing?.pose?.center).toEqual(first?.center);
    expect(placing?.heatMaps).toMatchObject([{ rows, columns, surface: header.surface }]);
  });

  test("the golden inspection of a dragged ghost", () => {
    const { store, live, sent, settled } = page();
    settled();
    const pose = { center: [2, 2, 0.4], heading: 0 } as const;
    store.dispatch({ type: "drag-ghost", pose, done: true });
    const id = sent.findLast((message) => message.type === "inspect")?.id;
    const said = { ...golden<Inspected>("inspected"), id };
    live.text(JSON.stringify(said));
    expect(store.getState().placing?.inspected).toEqual(said);
  });

  test("the golden asset, graph and problem", () => {
    const { store, live, hear, assets } = page();
    const asset = golden<FrameHeader & { readonly digest: string }>("asset");
    live.binary(frame(asset, [1, 2, 3]));
    expect(assets.get(asset.digest)?.byteLength).toBe(3);
    hear("graph");
    expect(store.getState().graph).toEqual(golden("graph"));
    hear("problem");
    expect(store.getState().notice?.text).toBe(golden<{ readonly text: string }>("problem").text);
  });
});

describe("what the page says", () => {
  const { store, sent, settled } = page();
  settled();
  store.dispatch({
    type: "drag-ghost",
    pose: { center: [2, 2, 0.4], heading: 0 },
    done: true,
  });
  store.dispatch({ type: "toggle-layer", layer: "graph" });

  test.each(["hello", "put_scene", "ask", "inspect", "watch_graph"])(
    "its %s has the fields of the golden one",
    (type) => {
      const message = sent.find((one) => one.type === type);
      expect(shapeOf(message)).toEqual(shapeOf(golden(type)));
    },
  );
});

/** The names of an object's fields, nested ones too; lists and values are told by their kind. */
function shapeOf(value: unknown): unknown {
  if (Array.isArray(value)) return "list";
  if (value === null || typeof value !== "object") return "value";
  return Object.fromEntries(
    Object.entries(value)
      .filter(([, field]) => field !== undefined)
      .map(([name, field]) => [name, shapeOf(field)]),
  );
}
