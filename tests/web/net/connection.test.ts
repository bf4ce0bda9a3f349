import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { Connection } from "../../../web/src/net/connection";
import { network } from "./sockets";

function begin(random = 1) {
  const net = network();
  const heard: string[] = [];
  const connection = new Connection({
    url: "ws://room/socket",
    open: net.open,
    random: () => random,
    listener: {
      opened: () => heard.push("opened"),
      text: (text) => heard.push(text),
      binary: (bytes) => heard.push(`${bytes.byteLength} bytes`),
      lost: () => heard.push("lost"),
      refused: (code, reason) => heard.push(`${code} ${reason}`),
    },
  });
  connection.start();
  return { ...net, heard, connection };
}

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

describe("coming back", () => {
  test("each failure doubles the wait, up to ten seconds", () => {
    const { sockets, last } = begin();
    const waits: number[] = [];
    for (let i = 0; i < 7; i += 1) {
      last().drops();
      const opened = sockets.length;
      let waited = 0;
      while (sockets.length === opened) {
        vi.advanceTimersByTime(100);
        waited += 100;
      }
      waits.push(waited);
    }
    expect(waits).toEqual([500, 1000, 2000, 4000, 8000, 10000, 10000]);
  });

  test("chance spreads the wait over its upper half", () => {
    const { sockets, last } = begin(0);
    last().drops();
    vi.advanceTimersByTime(240);
    expect(sockets).toHaveLength(1);
    vi.advanceTimersByTime(20);
    expect(sockets).toHaveLength(2);
  });

  test("once the server has spoken the wait is short again", () => {
    const { sockets, last } = begin();
    last().drops();
    vi.advanceTimersByTime(500);
    last().drops();
    vi.advanceTimersByTime(1000);
    last().open();
    last().says({ type: "pong", nonce: 0 });
    last().drops();
    vi.advanceTimersByTime(500);
    expect(sockets).toHaveLength(4);
  });

  test("a server that never answers is given up after fifteen seconds", () => {
    const { sockets, last, heard } = begin();
    last().open();
    vi.advanceTimersByTime(15_000);
    expect(heard).toEqual(["opened", "lost"]);
    expect(sockets[0]?.closed).toBe(true);
  });

  test("a socket that was given up is no longer listened to", () => {
    const { sockets, last, heard } = begin();
    last().drops();
    sockets[0]?.says({ type: "pong", nonce: 0 });
    sockets[0]?.drops();
    expect(heard).toEqual(["lost"]);
  });
});

describe("being seen again", () => {
  const online = () => {
    const started = begin();
    started.last().open();
    started.last().says({ type: "pong", nonce: 0 });
    return started;
  };

  test("an open socket is not believed: it is asked", () => {
    const { connection, last } = online();
    connection.probe();
    expect(last().of("ping")).toHaveLength(1);
  });

  test("without an answer within three seconds it is dropped and another opened", () => {
    const { connection, sockets, heard } = online();
    connection.probe();
    vi.advanceTimersByTime(2_999);
    expect(heard).not.toContain("lost");
    vi.advanceTimersByTime(1);
    expect(heard).toContain("lost");
    vi.advanceTimersByTime(500);
    expect(sockets).toHaveLength(2);
  });

  test("with an answer it stays", () => {
    const { connection, last, heard } = online();
    connection.probe();
    last().says({ type: "pong", nonce: 1 });
    vi.advanceTimersByTime(3_000);
    expect(heard).not.toContain("lost");
  });

  test("asking again does not put off the limit", () => {
    const { connection, heard } = online();
    connection.probe();
    vi.advanceTimersByTime(2_000);
    connection.probe();
    vi.advanceTimersByTime(1_000);
    expect(heard).toContain("lost");
  });

  test("while it waits to come back, a probe makes it come at once", () => {
    const { connection, sockets, last } = begin();
    last().drops();
    connection.probe();
    expect(sockets).toHaveLength(2);
    vi.advanceTimersByTime(500);
    expect(sockets).toHaveLength(2);
  });

  test("even unasked it is probed now and then", () => {
    const { last } = online();
    vi.advanceTimersByTime(20_000);
    expect(last().of("ping")).toHaveLength(1);
  });
});

describe("closed for good", () => {
  test("the server's sentence is passed on, and it is not tried again", () => {
    const { sockets, last, heard, connection } = begin();
    last().drops(4402, "This room was opened on another device.");
    expect(heard).toEqual(["4402 This room was opened on another device."]);
    vi.advanceTimersByTime(60_000);
    connection.probe();
    expect(sockets).toHaveLength(1);
  });
});

describe("sending", () => {
  test("before the socket is open nothing can be sent", () => {
    const { connection, last } = begin();
    expect(connection.send({ type: "ping", nonce: 1 })).toBe(false);
    last().open();
    expect(connection.send({ type: "ping", nonce: 1 })).toBe(true);
    expect(last().sent).toEqual([{ type: "ping", nonce: 1 }]);
  });

  test("text and bytes are told apart", () => {
    const { last, heard } = begin();
    last().open();
    last().says(new ArrayBuffer(8));
    last().says({ type: "pong", nonce: 3 });
    expect(heard).toEqual(["opened", "8 bytes", '{"type":"pong","nonce":3}']);
    expect(last().binaryType).toBe("arraybuffer");
  });
});
