import { describe, expect, test } from "vitest";
import { heatMapOf, parseFrame } from "../../../web/src/net/binary";
import type { HeatMapHeader } from "../../../web/src/net/protocol.gen";
import { frame, HEAT_MAP } from "./frames";

describe("binary frames", () => {
  test("header and payload are told apart, padding included", () => {
    const parsed = parseFrame(frame(HEAT_MAP, [1, 2, 3, 4, 5, 6]));
    expect(parsed?.header).toEqual(HEAT_MAP);
    expect([...(parsed?.payload ?? [])]).toEqual([1, 2, 3, 4, 5, 6]);
  });

  test("the payload is a copy, so the frame can be let go", () => {
    const bytes = frame(HEAT_MAP, [1, 2, 3, 4, 5, 6]);
    const payload = parseFrame(bytes)?.payload;
    new Uint8Array(bytes).fill(0);
    expect([...(payload ?? [])]).toEqual([1, 2, 3, 4, 5, 6]);
  });

  test("a frame that is cut short, or whose header is no JSON, is none", () => {
    expect(parseFrame(new ArrayBuffer(2))).toBeNull();
    expect(parseFrame(new Uint8Array([200, 0, 0, 0, 123]).buffer)).toBeNull();
    expect(parseFrame(new Uint8Array([4, 0, 0, 0, 110, 111, 112, 101]).buffer)).toBeNull();
  });

  test("a heat map keeps its rows in the order of the wire: row 0 first", () => {
    const map = heatMapOf(HEAT_MAP, new Uint8Array([1, 2, 3, 4, 5, 6]));
    expect(map).toMatchObject({ rows: 2, columns: 3, cell: 0.5, origin: [-1, -2] });
    expect(map?.values[1 * 3 + 0]).toBe(4);
  });

  test("a heat map with a byte too few is none", () => {
    const header: HeatMapHeader = { ...HEAT_MAP, shape: [2, 4] };
    expect(heatMapOf(header, new Uint8Array(6))).toBeNull();
  });
});
