/** Binary frames as the server writes them. */
import type { FrameHeader, HeatMapHeader } from "../../../web/src/net/protocol.gen";

export const HEAT_MAP: HeatMapHeader = {
  type: "heat_map",
  ask: "ask-1",
  revision: 1,
  surface: "floor",
  origin: [-1, -2],
  cell: 0.5,
  shape: [2, 3],
  min: -3,
  max: 2,
};

export function frame(header: FrameHeader, payload: readonly number[]): ArrayBuffer {
  const text = JSON.stringify(header);
  const padded = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
  const bytes = new Uint8Array(4 + padded.length + payload.length);
  new DataView(bytes.buffer).setUint32(0, padded.length, true);
  bytes.set(padded, 4);
  bytes.set(payload, 4 + padded.length);
  return bytes.buffer;
}
