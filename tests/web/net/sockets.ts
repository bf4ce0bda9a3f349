/** A socket without a network: tests open it, speak for the server and close it. */
import type { OpenSocket, Socket } from "../../../web/src/net/connection";
import type { ClientMessage, ServerMessage } from "../../../web/src/net/protocol.gen";

export class FakeSocket implements Socket {
  binaryType: BinaryType = "blob";
  onopen: Socket["onopen"] = null;
  onmessage: Socket["onmessage"] = null;
  onclose: Socket["onclose"] = null;
  closed = false;
  readonly sent: ClientMessage[] = [];

  send(data: unknown): void {
    this.sent.push(JSON.parse(String(data)) as ClientMessage);
  }

  close(): void {
    this.closed = true;
  }

  open(): void {
    this.onopen?.call(this as unknown as WebSocket, {} as Event);
  }

  says(message: ServerMessage | ArrayBuffer): void {
    const data = message instanceof ArrayBuffer ? message : JSON.stringify(message);
    this.onmessage?.call(this as unknown as WebSocket, { data } as MessageEvent);
  }

  drops(code = 1006, reason = ""): void {
    this.onclose?.call(this as unknown as WebSocket, { code, reason } as CloseEvent);
  }

  /** The messages of one type, in order. */
  of<T extends ClientMessage["type"]>(type: T): Extract<ClientMessage, { readonly type: T }>[] {
    return this.sent.filter(
      (message): message is Extract<ClientMessage, { readonly type: T }> => message.type === type,
    );
  }
}

export interface Network {
  readonly sockets: FakeSocket[];
  readonly open: OpenSocket;
  last(): FakeSocket;
}

export function network(): Network {
  const sockets: FakeSocket[] = [];
  return {
    sockets,
    open: () => {
      const socket = new FakeSocket();
      sockets.push(socket);
      return socket;
    },
    last() {
      const socket = sockets.at(-1);
      if (socket === undefined) throw new Error("no socket was opened");
      return socket;
    },
  };
}
