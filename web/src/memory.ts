/** What this device remembers: the room that was worked on last, and the session. */
import { DEFAULT_HEIGHT } from "./model/initial";
import type { SceneRecord } from "./net/protocol.gen";

const SCENE = "scenegen.scene";
const SESSION = "scenegen.session";
/** What files may leave out. */
const BARE_SCENE = { id: "", name: "", source: "" };
const BARE_ROOM = { height: DEFAULT_HEIGHT, doors: [], windows: [], room_type: "" };
/** Changes are written when this long nothing has changed, milliseconds. */
const CALM = 300;

/** The room of the last visit; null on the first, or if what is stored is of another version. */
export function rememberedScene(): SceneRecord | null {
  const text = read(localStorage, SCENE);
  return text === null ? null : sceneOf(text);
}

/** The scene of a text, what it leaves out filled in; null if it is none. */
export function sceneOf(text: string): SceneRecord | null {
  try {
    const value = JSON.parse(text) as Partial<SceneRecord> | null;
    const known = value?.format === "scenegen.scene" && value.version === 1;
    if (!known || !Array.isArray(value.room?.corners)) return null;
    const { room, boxes = [] } = value as SceneRecord;
    return { ...BARE_SCENE, ...(value as SceneRecord), room: { ...BARE_ROOM, ...room }, boxes };
  } catch {
    return null;
  }
}

/** Writes each scene that it is given, once things are calm or the page is left. */
export function sceneKeeper(): (scene: SceneRecord) => void {
  let waiting: SceneRecord | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const keep = (): void => {
    clearTimeout(timer);
    if (waiting !== null) write(localStorage, SCENE, JSON.stringify(waiting));
    waiting = null;
  };
  addEventListener("pagehide", keep);
  document.addEventListener("visibilitychange", keep);
  return (scene) => {
    waiting = scene;
    clearTimeout(timer);
    timer = setTimeout(keep, CALM);
  };
}

/** The session of this tab, or of the last one: a phone may have thrown the tab away. */
export function rememberedSession(): string | null {
  return read(sessionStorage, SESSION) ?? read(localStorage, SESSION);
}

export function rememberSession(session: string): void {
  write(sessionStorage, SESSION, session);
  write(localStorage, SESSION, session);
}

function read(storage: Storage, key: string): string | null {
  try {
    return storage.getItem(key);
  } catch {
    return null; // storage is switched off: a visit is then always the first
  }
}

function write(storage: Storage, key: string, text: string): void {
  try {
    storage.setItem(key, text);
  } catch {
    // storage is full or switched off: the server still has the scene
  }
}
