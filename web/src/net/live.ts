/** The page's state and the server kept together: edits and questions out, what comes back in. */
import type { HeatMap, State } from "../model/state";
import type { Store } from "../store";
import type { AssetCache } from "./assets";
import { heatMapOf, parseFrame } from "./binary";
import type { Listener } from "./connection";
import { endingOf } from "./endings";
import {
  acknowledged,
  adopted,
  advance,
  EMPTY_OUTBOX,
  forgotten,
  lost,
  mismatched,
  unsent,
} from "./outbox";
import {
  type Ack,
  CLOSE_REPLACED,
  type ClientMessage,
  type HeatMapHeader,
  type Inspected,
  type Maps,
  type Problem,
  type ServerMessage,
  type Welcome,
} from "./protocol.gen";
import { askedOf, inspectionDone, NO_QUESTIONS, poseInspected } from "./questions";

/** What came too fast is sent again after this, milliseconds. */
const PAUSE = 500;
/** So long a confirmation waits for what the server says of the place, milliseconds. */
const PATIENCE = 6000;

export interface Ties {
  readonly store: Store;
  readonly assets: AssetCache;
  readonly send: (message: ClientMessage) => boolean;
  /** The session to go on with, as this device remembers it. */
  readonly session: string | null;
  /** True when the session was begun on another device: its room is taken over. */
  readonly joining: boolean;
  readonly remember: (session: string) => void;
  /** The session was opened elsewhere: its newest room is there, no longer here. */
  readonly replaced: (session: string) => void;
}

interface Arrived {
  readonly header: HeatMapHeader;
  readonly map: HeatMap;
}

export class Live implements Listener {
  readonly #ties: Ties;
  #outbox = EMPTY_OUTBOX;
  #questions = NO_QUESTIONS;
  #session: string | null;
  #joining: boolean;
  #revision = 0;
  #welcomed = false;
  #heatMaps: readonly Arrived[] = [];
  #patience: ReturnType<typeof setTimeout> | null = null;

  constructor(ties: Ties) {
    this.#ties = ties;
    this.#session = ties.session;
    this.#joining = ties.joining;
    ties.store.subscribe((state) => this.#update(state));
  }

  opened(): void {
    const assets = this.#ties.assets.digests;
    this.#ties.send({ type: "hello", session: this.#session, revision: this.#revision, assets });
  }

  text(text: string): void {
    this.#receive(JSON.parse(text) as ServerMessage);
  }

  binary(bytes: ArrayBuffer): void {
    const frame = parseFrame(bytes);
    if (frame === null) return;
    const { header, payload } = frame;
    switch (header.type) {
      case "heat_map": {
        const map = heatMapOf(header, payload);
        if (map !== null) this.#heatMaps = [...this.#heatMaps, { header, map }];
        return;
      }
      case "asset":
        this.#ties.assets.put(header.digest, payload.buffer);
        return;
    }
  }

  lost(): void {
    this.#welcomed = false;
    this.#outbox = lost(this.#outbox);
    this.#questions = NO_QUESTIONS;
    this.#heatMaps = [];
    this.#connection("offline");
  }

  refused(code: number, reason: string): void {
    this.lost();
    if (code === CLOSE_REPLACED && this.#session !== null) this.#ties.replaced(this.#session);
    const ended = endingOf(code, reason);
    this.#ties.store.dispatch({ type: "connection", connection: { ended } });
  }

  #receive(message: ServerMessage): void {
    const { dispatch } = this.#ties.store;
    switch (message.type) {
      case "welcome":
        this.#welcome(message);
        break;
      case "ack":
        this.#acknowledge(message);
        break;
      case "models":
        dispatch({ type: "models", boxes: message.boxes });
        break;
      case "maps":
        this.#maps(message);
        break;
      case "answer":
        dispatch({ type: "answer", answer: message });
        break;
      case "inspected":
        this.#inspected(message);
        break;
      case "weighing":
        dispatch({ type: "weighing", weighing: message });
        break;
      case "matters":
        dispatch({ type: "matters", matters: message });
        break;
      case "graph":
        dispatch({ type: "graph", graph: message });
        break;
      case "problem":
        this.#refusedOne(message);
        break;
      case "pong":
        break;
    }
  }

  /** The phone is the truth: unless the server holds just what it acknowledged, all is sent. */
  #welcome(message: Welcome): void {
    const { store, assets, remember } = this.#ties;
    const same = message.resumed && message.revision === this.#revision;
    if (!same) this.#outbox = mismatched(this.#outbox);
    if (this.#joining) this.#join(message);
    this.#joining = false;
    this.#session = message.session;
    this.#revision = message.revision;
    remember(message.session);
    assets.retry();
    const { categories, catalogue, rooms } = message;
    store.dispatch({ type: "lists", lists: { categories, catalogue, rooms } });
    this.#welcomed = true;
    this.#connection("online");
    this.#update(store.getState());
  }

  #join({ scene }: Welcome): void {
    if (scene === null) {
      this.#problem("The room of that link is gone. Here is the one you had last.");
      return;
    }
    this.#outbox = adopted(this.#outbox, scene);
    this.#ties.store.dispatch({ type: "resumed", scene });
  }

  #acknowledge({ seq, revision }: Ack): void {
    this.#outbox = acknowledged(this.#outbox, seq);
    this.#revision = revision;
    this.#update(this.#ties.store.getState());
  }

  /** Heat maps come just before the message that says that they are all there. */
  #maps(maps: Maps): void {
    const { ask, revision } = maps;
    const heatMaps = this.#heatMaps
      .filter(({ header }) => header.ask === ask && header.revision === revision)
      .map(({ map }) => map);
    this.#heatMaps = [];
    this.#ties.store.dispatch({ type: "maps", ask, revision, heatMaps });
  }

  /** What came too late, when a newer answer had already made it worthless, is dropped. */
  #inspected(message: Inspected): void {
    const pose = poseInspected(this.#questions, message);
    if (pose === null) return;
    this.#questions = inspectionDone(this.#questions);
    this.#ties.store.dispatch({ type: "inspected", inspected: message, pose });
    this.#update(this.#ties.store.getState());
  }

  #refusedOne({ code, text, seq }: Problem): void {
    const { placing } = this.#ties.store.getState();
    const failed = code === "internal" && seq === null && (placing?.computing ?? false);
    if (code === "bad_query" || failed) {
      this.#questions = inspectionDone(this.#questions);
      this.#ties.store.dispatch({ type: "ask-refused", text });
      return;
    }
    if (seq === null) {
      this.#questions = inspectionDone(this.#questions);
    } else if (code === "too_fast") {
      setTimeout(() => {
        this.#outbox = forgotten(this.#outbox, seq);
        this.#update(this.#ties.store.getState());
      }, PAUSE);
      return;
    } else {
      this.#outbox = acknowledged(this.#outbox, seq);
    }
    this.#problem(text);
    this.#update(this.#ties.store.getState());
  }

  /** Sends what the server lacks of this state. */
  #update(state: State): void {
    this.#waitFor(state.placing?.confirming ?? false);
    if (this.#welcomed) {
      const { outbox, edits } = advance(this.#outbox, state.scene);
      const { questions, messages } = askedOf(this.#questions, state);
      this.#outbox = outbox;
      this.#questions = questions;
      for (const message of [...edits, ...messages]) this.#ties.send(message);
    }
    this.#connection(state.connection.status);
  }

  /** A confirmation does not wait for ever. */
  #waitFor(confirming: boolean): void {
    if (!confirming) {
      clearTimeout(this.#patience ?? undefined);
      this.#patience = null;
    } else {
      this.#patience ??= setTimeout(() => {
        this.#ties.store.dispatch({ type: "stop-waiting" });
      }, PATIENCE);
    }
  }

  #connection(status: State["connection"]["status"]): void {
    const { dispatch, getState } = this.#ties.store;
    dispatch({
      type: "connection",
      connection: {
        status,
        session: this.#session,
        revision: this.#revision,
        unsent: unsent(this.#outbox, getState().scene),
      },
    });
  }

  #problem(text: string): void {
    this.#ties.store.dispatch({ type: "notify", tone: "problem", text });
  }
}
