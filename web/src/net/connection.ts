/**
 * A socket that comes back.
 *
 * It is not believed to be open because it says so: a phone that slept holds dead sockets. On a
 * `probe` (the page is seen again, the network is back) the server has three seconds to answer.
 */
import { type ClientMessage, SUBPROTOCOL } from "./protocol.gen";

/** As much of a WebSocket as is used, so that tests can make their own. */
export type Socket = Pick<
  WebSocket,
  "binaryType" | "close" | "onclose" | "onmessage" | "onopen" | "send"
>;

export type OpenSocket = (url: string, subprotocol: string) => Socket;

export interface Listener {
  /** The socket is open: say hello. */
  opened(): void;
  text(text: string): void;
  binary(bytes: ArrayBuffer): void;
  /** It is gone and will be tried again. */
  lost(): void;
  /** The server closed it for good, and says why. */
  refused(code: number, reason: string): void;
}

export interface Settings {
  readonly url: string;
  readonly open: OpenSocket;
  readonly listener: Listener;
  /** From 0 to 1, evenly: spreads the returns of many pages over time. */
  readonly random: () => number;
}

const FIRST_DELAY = 500; // milliseconds
const MAX_DELAY = 10_000; // milliseconds
const ANSWER_LIMIT = 3_000; // milliseconds, for the answer to a ping
const OPEN_LIMIT = 15_000; // milliseconds, from connecting to the first message
const LAST_CHANCE = 1_000; // milliseconds
const HEARTBEAT = 20_000; // milliseconds
/** The server's closing codes from here to here are for good; the reason is a sentence. */
const FOR_GOOD = [4400, 4403] as const;

type Timer = ReturnType<typeof setTimeout>;

export class Connection {
  readonly #settings: Settings;
  #socket: Socket | null = null;
  #alive = false;
  #stopped = true;
  #attempts = 0;
  #nonce = 0;
  #retry: Timer | undefined;
  #limit: Timer | undefined;
  #heartbeat: Timer | undefined;

  constructor(settings: Settings) {
    this.#settings = settings;
  }

  start(): void {
    this.#stopped = false;
    this.#connect();
    this.#heartbeat = setInterval(() => this.#socket !== null && this.probe(), HEARTBEAT);
  }

  stop(): void {
    this.#stopped = true;
    clearInterval(this.#heartbeat);
    this.#drop();
  }

  /** Sends a message; false when there is nobody to send it to. */
  send(message: ClientMessage): boolean {
    if (this.#socket === null || !this.#alive) return false;
    this.#socket.send(JSON.stringify(message));
    return true;
  }

  /** Is anybody there? Asked when the page is seen again; without a socket, one is opened now. */
  probe(): void {
    if (this.#stopped) return;
    if (this.#socket === null) {
      this.#connect();
    } else if (this.#alive) {
      this.#nonce += 1;
      this.send({ type: "ping", nonce: this.#nonce });
      if (this.#limit === undefined) this.#await(ANSWER_LIMIT);
    }
  }

  #connect(): void {
    this.#drop();
    const { open, url, listener } = this.#settings;
    const socket = open(url, SUBPROTOCOL);
    this.#socket = socket;
    socket.binaryType = "arraybuffer";
    this.#await(OPEN_LIMIT);
    socket.onopen = () => {
      this.#alive = true;
      listener.opened();
    };
    socket.onmessage = ({ data }: MessageEvent<unknown>) => {
      this.#heard();
      if (typeof data === "string") listener.text(data);
      else if (data instanceof ArrayBuffer) listener.binary(data);
    };
    socket.onclose = ({ code, reason }) => {
      if (code >= FOR_GOOD[0] && code <= FOR_GOOD[1]) {
        this.stop();
        listener.refused(code, reason);
      } else {
        this.#gone();
      }
    };
  }

  /**
   * Gives up unless something is heard in time. A page that was busy runs its timers before it reads
   * its sockets, so at the end there is a moment to read what has come meanwhile.
   */
  #await(limit: number): void {
    this.#limit = setTimeout(() => {
      this.#limit = setTimeout(() => this.#gone(), LAST_CHANCE);
    }, limit - LAST_CHANCE);
  }

  /** Whatever the server says, it is there. */
  #heard(): void {
    this.#attempts = 0;
    clearTimeout(this.#limit);
    this.#limit = undefined;
  }

  #gone(): void {
    this.#drop();
    const longest = Math.min(MAX_DELAY, FIRST_DELAY * 2 ** this.#attempts);
    this.#attempts += 1;
    this.#retry = setTimeout(() => this.#connect(), longest * (0.5 + this.#settings.random() / 2));
    this.#settings.listener.lost();
  }

  #drop(): void {
    clearTimeout(this.#retry);
    clearTimeout(this.#limit);
    this.#limit = undefined;
    this.#alive = false;
    const socket = this.#socket;
    this.#socket = null;
    if (socket === null) return;
    socket.onopen = null;
    socket.onmessage = null;
    socket.onclose = null;
    socket.close();
  }
}
