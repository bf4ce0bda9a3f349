/** What the panels can have done: files in and out, rooms by name, pictures, a link. */
import type { ArControls, JoinInfo, Services, StageView } from "./contract";
import { sceneOf } from "./memory";
import type { KnowledgeMarginals } from "./model/knowledge";
import type { SceneRecord } from "./net/protocol.gen";
import { queryOf } from "./net/questions";
import { fileProblem } from "./room_files";
import type { Store } from "./store";

const OFFLINE =
  "That needs the server, and it can't be reached now. Try again when you are online.";
const NO_ROOM = "That room can't be opened now. Try again when you are online.";

export function createServices(
  store: Store,
  device: Pick<StageView, "viewPoint"> & Pick<Services, "quickLook">,
  ar: ArControls,
): Services {
  const problem = (text: string): void => store.dispatch({ type: "notify", tone: "problem", text });
  const sceneNow = (): SceneRecord => store.getState().scene;

  async function download(path: string, body: unknown, name: string): Promise<void> {
    const response = await post(path, JSON.stringify(body));
    if (response?.ok) save(await response.blob(), name);
    else problem(response === null ? OFFLINE : await sentenceOf(response));
  }

  return {
    viewPoint: () => device.viewPoint(),
    quickLook: device.quickLook,
    ar,

    saveScene() {
      const text = JSON.stringify(sceneNow(), null, 2);
      save(new Blob([text], { type: "application/json" }), `${fileName(sceneNow())}.json`);
    },

    async openSceneFile(file) {
      const text = await file.text();
      const wrong = fileProblem(text);
      if (wrong !== null) return problem(wrong);
      const response = await post("/scenes/check", text);
      if (response === null) return problem(OFFLINE);
      if (!response.ok) return problem(await sentenceOf(response));
      const scene = (await response.json()) as SceneRecord;
      store.dispatch({ type: "open-scene", scene });
    },

    async openRoom(id) {
      const scene = await fetchRoom(id);
      if (scene === null) problem(NO_ROOM);
      else store.dispatch({ type: "open-scene", scene });
    },

    async exportRoom() {
      await download("/export/room.glb", sceneNow(), `${fileName(sceneNow())}.glb`);
    },

    async exportHeatMap() {
      const { placing, model } = store.getState();
      if (placing === null) return problem("Choose something to place first.");
      const body = { scene: sceneNow(), query: queryOf(placing, model) };
      await download("/export/heat-map.png", body, `${fileName(sceneNow())}-map.png`);
    },

    fetchKnowledge: () => fetchJson<KnowledgeMarginals>("/knowledge.json"),

    async fetchJoin() {
      const { session } = store.getState().connection;
      const query = session === null ? "" : `?session=${encodeURIComponent(session)}`;
      const way = await fetchJson<Omit<JoinInfo, "picture">>(`/join.json${query}`);
      return way && { ...way, picture: `/join.svg${query}` };
    },
  };
}

/** A room that the server offers; null when it cannot be had. */
export async function fetchRoom(id: string): Promise<SceneRecord | null> {
  try {
    const response = await fetch(`/rooms/${encodeURIComponent(id)}.json`);
    return response.ok ? sceneOf(await response.text()) : null;
  } catch {
    return null;
  }
}

async function fetchJson<T>(path: string): Promise<T | null> {
  try {
    const response = await fetch(path);
    return response.ok ? ((await response.json()) as T) : null;
  } catch {
    return null;
  }
}

async function post(path: string, body: string): Promise<Response | null> {
  const headers = { "content-type": "application/json" };
  return fetch(path, { method: "POST", headers, body }).catch(() => null);
}

/** What the server says went wrong. */
async function sentenceOf(response: Response): Promise<string> {
  try {
    const { text } = (await response.json()) as { readonly text: string };
    return text;
  } catch {
    return `The server could not do that (${response.status}). Try again.`;
  }
}

function fileName(scene: SceneRecord): string {
  const plain = (scene.name || "room").toLowerCase().replaceAll(/[^a-z0-9]+/g, "-");
  return plain.replaceAll(/^-|-$/g, "") || "room";
}

function save(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 0);
}
