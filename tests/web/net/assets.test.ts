import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { AssetCache } from "../../../web/src/net/assets";

const GLB = new ArrayBuffer(4);

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

describe("models", () => {
  test("one that was pushed is there, and those who wait are told", () => {
    const assets = new AssetCache(async () => null);
    const told: string[] = [];
    const stop = assets.subscribe((digest) => told.push(digest));
    assets.put("a", GLB);
    expect(assets.get("a")).toBe(GLB);
    expect(assets.digests).toEqual(["a"]);
    stop();
    assets.put("b", GLB);
    expect(told).toEqual(["a"]);
  });

  test("one that does not come by itself is fetched, once", async () => {
    const fetched: string[] = [];
    const assets = new AssetCache(async (digest) => {
      fetched.push(digest);
      return GLB;
    });
    expect(assets.get("a")).toBeUndefined();
    expect(assets.get("a")).toBeUndefined();
    await vi.advanceTimersByTimeAsync(2_000);
    expect(fetched).toEqual(["a"]);
    expect(assets.get("a")).toBe(GLB);
  });

  test("one that comes by itself in time is not fetched", async () => {
    const fetchAsset = vi.fn(async () => GLB);
    const assets = new AssetCache(fetchAsset);
    assets.get("a");
    assets.put("a", GLB);
    await vi.advanceTimersByTimeAsync(2_000);
    expect(fetchAsset).not.toHaveBeenCalled();
  });

  test("one that could not be had is tried again when the server is back", async () => {
    const answers = [null, GLB];
    const assets = new AssetCache(async () => answers.shift() ?? null);
    assets.get("a");
    await vi.advanceTimersByTimeAsync(2_000);
    expect(assets.get("a")).toBeUndefined();
    assets.retry();
    await vi.advanceTimersByTimeAsync(2_000);
    expect(assets.get("a")).toBe(GLB);
  });
});
