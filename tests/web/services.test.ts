import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { createServices } from "../../web/src/services";
import { createStore } from "../../web/src/store";
import { NO_AR } from "./no_ar";
import { begin, play, room } from "./rooms";

const OTHER = { ...room(), id: "studio", name: "Studio" };
const asked: { path: string; body: unknown }[] = [];
let saved: string[] = [];

/** What the server answers to whatever it is asked. */
function server(answer: () => Response): void {
  vi.stubGlobal("fetch", async (path: string, options?: { readonly body?: string }) => {
    asked.push({ path, body: options?.body === undefined ? null : JSON.parse(options.body) });
    return answer();
  });
}
const offline = (): Response => {
  throw new TypeError("Failed to fetch");
};
const json = (value: unknown, status = 200): Response =>
  new Response(JSON.stringify(value), { status });

function services(state = begin()) {
  const store = createStore(state);
  return { store, ...createServices(store, { viewPoint: () => [1, 2], quickLook: false }, NO_AR) };
}

beforeEach(() => {
  asked.length = 0;
  saved = [];
  const link = { href: "", download: "", click: () => saved.push(link.download) };
  vi.stubGlobal("document", { createElement: () => link });
});
afterEach(() => {
  vi.unstubAllGlobals();
});

describe("opening a room of the list", () => {
  test("the room is opened", async () => {
    server(() => json(OTHER));
    const { openRoom, store } = services();
    await openRoom("studio");
    expect(asked).toEqual([{ path: "/rooms/studio.json", body: null }]);
    expect(store.getState().scene).toEqual(OTHER);
  });

  test.each([
    ["offline", offline],
    ["unknown", () => json({ text: "There is no such room." }, 404)],
  ])("%s, a sentence says so and the room stays", async (_, answer) => {
    server(answer);
    const { openRoom, store } = services();
    await openRoom("studio");
    expect(store.getState().scene.id).toBe("test-room");
    expect(store.getState().notice?.text).toMatch(/can't be opened now/);
  });
});

describe("asking what is known", () => {
  test("the server's answer is handed on", async () => {
    const known = { sources: [], categories: [] };
    server(() => json(known));
    expect(await services().fetchKnowledge()).toEqual(known);
    expect(asked).toEqual([{ path: "/knowledge.json", body: null }]);
  });

  test.each([
    ["offline", offline],
    ["a server that fails", () => json({ text: "Try again." }, 500)],
    ["an answer cut short", () => new Response('{"sources": [')],
  ])("%s gives nothing", async (_, answer) => {
    server(answer);
    expect(await services().fetchKnowledge()).toBeNull();
  });
});

describe("opening a file", () => {
  const file = new File([JSON.stringify(OTHER)], "studio.json");

  test("the scene is opened as the server has read it", async () => {
    server(() => json({ ...OTHER, name: "As read" }));
    const { openSceneFile, store } = services();
    await openSceneFile(file);
    expect(asked).toEqual([{ path: "/scenes/check", body: OTHER }]);
    expect(store.getState().scene.name).toBe("As read");
  });

  test("a file that is no scene is told in the server's words", async () => {
    server(() => json({ text: "This is JSON, but not a scene file." }, 422));
    const { openSceneFile, store } = services();
    await openSceneFile(file);
    expect(store.getState().notice?.text).toBe("This is JSON, but not a scene file.");
    expect(store.getState().scene.id).toBe("test-room");
  });

  test("offline a sentence says what to do", async () => {
    server(offline);
    const { openSceneFile, store } = services();
    await openSceneFile(file);
    expect(store.getState().notice?.text).toMatch(/Try again when you are online/);
  });
});

describe("saving and exporting", () => {
  test("a scene is saved under the name of the room", () => {
    const { saveScene } = services(
      play(begin(), { type: "open-scene", scene: { ...OTHER, name: "Ana's room, 2nd floor!" } }),
    );
    saveScene();
    expect(saved).toEqual(["ana-s-room-2nd-floor.json"]);
  });

  test("a room is exported as a model", async () => {
    server(() => new Response("glTF"));
    const { exportRoom, store } = services();
    await exportRoom();
    expect(asked).toEqual([{ path: "/export/room.glb", body: store.getState().scene }]);
    expect(saved).toEqual(["my-room.glb"]);
  });

  test("a map is exported with its question", async () => {
    server(() => new Response("PNG"));
    const state = play(begin(), {
      type: "place",
      category: "Sofa",
      item: null,
      size: null,
      mode: "scenegen",
      view: [1, 1],
    });
    await services(state).exportHeatMap();
    expect(asked).toMatchObject([
      {
        path: "/export/heat-map.png",
        body: { scene: { id: "test-room" }, query: { category: "Sofa" } },
      },
    ]);
    expect(saved).toEqual(["my-room-map.png"]);
  });

  test("without an object there is no map to export", async () => {
    const { exportHeatMap, store } = services();
    await exportHeatMap();
    expect(store.getState().notice?.text).toBe("Choose something to place first.");
  });

  test("an export that fails without words gets some", async () => {
    server(() => new Response("Internal Server Error", { status: 500 }));
    const { exportRoom, store } = services();
    await exportRoom();
    expect(saved).toEqual([]);
    expect(store.getState().notice?.text).toMatch(/could not do that \(500\)/);
  });
});

describe("joining with a phone", () => {
  test("the server is asked for the way to this very room", async () => {
    const join = { address: "http://192.168.1.5:8001/#secret&session=s1", text: "Scan this." };
    server(() => json(join));
    const state = play(begin(), { type: "connection", connection: { session: "s1" } });
    expect(await services(state).fetchJoin()).toEqual({
      ...join,
      picture: "/join.svg?session=s1",
    });
    expect(asked).toEqual([{ path: "/join.json?session=s1", body: null }]);
  });

  test("offline there is no way", async () => {
    server(offline);
    expect(await services().fetchJoin()).toBeNull();
  });
});
