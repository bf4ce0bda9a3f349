import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import {
  rememberedScene,
  rememberedSession,
  rememberSession,
  sceneKeeper,
  sceneOf,
} from "../../web/src/memory";
import { room } from "./rooms";

/** As much of a browser's storage as is used. */
class Shelf {
  readonly values = new Map<string, string>();
  getItem(key: string): string | null {
    return this.values.get(key) ?? null;
  }
  setItem(key: string, value: string): void {
    this.values.set(key, value);
  }
}

let page: EventTarget;
let local: Shelf;

beforeEach(() => {
  vi.useFakeTimers();
  page = new EventTarget();
  local = new Shelf();
  vi.stubGlobal("localStorage", local);
  vi.stubGlobal("sessionStorage", new Shelf());
  vi.stubGlobal("document", page);
  vi.stubGlobal("addEventListener", page.addEventListener.bind(page));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe("the room of the last visit", () => {
  test("on the first visit there is none", () => {
    expect(rememberedScene()).toBeNull();
  });

  test("it is kept once nothing has changed for a moment", () => {
    const keep = sceneKeeper();
    keep(room());
    expect(rememberedScene()).toBeNull();
    vi.advanceTimersByTime(300);
    expect(rememberedScene()).toEqual(room());
  });

  test("it is kept at once when the page is left", () => {
    const keep = sceneKeeper();
    keep({ ...room(), name: "Left in a hurry" });
    page.dispatchEvent(new Event("pagehide"));
    expect(rememberedScene()?.name).toBe("Left in a hurry");
  });

  test("where storage is full the page goes on without", () => {
    local.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
    const keep = sceneKeeper();
    keep(room());
    vi.advanceTimersByTime(300);
    expect(rememberedScene()).toBeNull();
  });
});

describe("the session", () => {
  test("a new tab goes on with the session of the last", () => {
    rememberSession("s1");
    vi.stubGlobal("sessionStorage", new Shelf());
    expect(rememberedSession()).toBe("s1");
  });

  test("a tab has its own before that of the last", () => {
    rememberSession("s1");
    local.setItem("scenegen.session", "s2");
    expect(rememberedSession()).toBe("s1");
  });
});

describe("the text of a scene", () => {
  test("what files may leave out is filled in", () => {
    const text = JSON.stringify({
      format: "scenegen.scene",
      version: 1,
      room: {
        corners: [
          [0, 0],
          [1, 0],
          [1, 1],
        ],
      },
    });
    expect(sceneOf(text)).toEqual({
      format: "scenegen.scene",
      version: 1,
      id: "",
      name: "",
      source: "",
      room: {
        corners: [
          [0, 0],
          [1, 0],
          [1, 1],
        ],
        height: 2.6,
        doors: [],
        windows: [],
        room_type: "",
      },
      boxes: [],
    });
  });

  test.each([
    ["no JSON", "sofa"],
    ["nothing", "null"],
    ["another format", '{"format":"other","version":1,"room":{"corners":[]}}'],
    ["another version", '{"format":"scenegen.scene","version":2,"room":{"corners":[]}}'],
    ["no room", '{"format":"scenegen.scene","version":1}'],
  ])("%s is no scene", (_, text) => {
    expect(sceneOf(text)).toBeNull();
  });
});
