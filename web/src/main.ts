/** Wires the parts of the page together; each does its own work. */
import { rememberedScene, rememberedSession, rememberSession, sceneKeeper } from "./memory";
import { emptyScene, initialState } from "./model/initial";
import { AssetCache } from "./net/assets";
import { Connection } from "./net/connection";
import { Live } from "./net/live";
import type { ClientMessage, SceneRecord } from "./net/protocol.gen";
import { createServices, fetchRoom } from "./services";
import { createStore, type Store } from "./store";
import { floating } from "./ui/floating";
import { mountUi } from "./ui/ui";
import { Stage } from "./views/stage";
import { type ArEntry, createAr } from "./xr/entry";
import { quickLook } from "./xr/support";

const FIRST_ROOM = "living-room";
const PROBES: readonly (readonly [EventTarget, string])[] = [
  [document, "visibilitychange"],
  [window, "pageshow"],
  [window, "online"],
];

async function start(): Promise<void> {
  const scene = rememberedScene() ?? (await firstScene());
  const store = createStore(initialState(scene, Date.now()));
  const assets = new AssetCache(fetchAsset);
  const stage = new Stage(element("stage"), store.dispatch, assets);
  let probe = (): void => {};
  const ar: ArEntry = createAr({
    stage,
    store,
    changed: () => probe(),
    floating: (state) => floating({ state, ar, dispatch: store.dispatch, viewPoint }),
  });
  const viewPoint = () => ar.viewPoint() ?? stage.viewPoint();
  const ui = mountUi(
    element("ui"),
    store.dispatch,
    createServices(store, { viewPoint, quickLook: quickLook(document.createElement("a")) }, ar),
  );
  const keep = sceneKeeper();
  store.subscribe((state) => {
    stage.show(state);
    ui.show(state);
    keep(state.scene);
  });
  stage.show(store.getState());
  ui.show(store.getState());
  probe = connect(store, assets);
}

/** Keeps a socket to the server for as long as the page lives; returns how to ask if it is there. */
function connect(store: Store, assets: AssetCache): () => void {
  const joined = takeSharedSession();
  const live = new Live({
    store,
    assets,
    send: (message: ClientMessage) => connection.send(message),
    session: joined ?? rememberedSession(),
    joining: joined !== null,
    remember: rememberSession,
    replaced: shareSession,
  });
  const connection = new Connection({
    url: socketUrl(),
    open: (url, subprotocol) => new WebSocket(url, subprotocol),
    listener: live,
    random: Math.random,
  });
  for (const [target, event] of PROBES) {
    target.addEventListener(event, () => connection.probe());
  }
  connection.start();
  return () => connection.probe();
}

/** The session of a shared link, taken out of the address so that a reload does not join again. */
function takeSharedSession(): string | null {
  const url = new URL(location.href);
  const session = url.searchParams.get("session");
  url.searchParams.delete("session");
  if (session !== null) history.replaceState(null, "", url);
  return session;
}

/** Makes the address one that joins the session, so that a reload takes over its newest room. */
function shareSession(session: string): void {
  const url = new URL(location.href);
  url.searchParams.set("session", session);
  history.replaceState(null, "", url);
}

/** The socket beside the page, with whatever else its address says (the key of a network). */
function socketUrl(): string {
  const url = new URL(`/socket${location.search}`, location.href);
  url.protocol = location.protocol === "https:" ? "wss:" : "ws:";
  return url.href;
}

async function firstScene(): Promise<SceneRecord> {
  return (await fetchRoom(FIRST_ROOM)) ?? emptyScene("room-1");
}

async function fetchAsset(digest: string): Promise<ArrayBuffer | null> {
  try {
    const response = await fetch(`/assets/${digest}.glb`);
    return response.ok ? await response.arrayBuffer() : null;
  } catch {
    return null;
  }
}

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`The page has no element "${id}".`);
  return found;
}

void start();
