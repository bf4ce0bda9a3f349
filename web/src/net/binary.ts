/** Binary frames: u32 little-endian header length | JSON header padded to 4 bytes | payload. */
import type { HeatMap } from "../model/state";
import type { FrameHeader, HeatMapHeader } from "./protocol.gen";

const LENGTH_BYTES = 4;

export interface Frame {
  readonly header: FrameHeader;
  /** A copy: the frame itself can be let go. */
  readonly payload: Uint8Array<ArrayBuffer>;
}

/** The parts of a frame; null if it is none. */
export function parseFrame(bytes: ArrayBuffer): Frame | null {
  if (bytes.byteLength < LENGTH_BYTES) return null;
  const end = LENGTH_BYTES + new DataView(bytes).getUint32(0, true);
  if (end > bytes.byteLength) return null;
  const text = new TextDecoder().decode(new Uint8Array(bytes, LENGTH_BYTES, end - LENGTH_BYTES));
  const header = parseHeader(text);
  return header === null ? null : { header, payload: new Uint8Array(bytes.slice(end)) };
}

/** The heat map of a frame; null if its payload is not rows × columns bytes. */
export function heatMapOf(header: HeatMapHeader, values: Frame["payload"]): HeatMap | null {
  const [rows, columns] = header.shape;
  if (values.length !== rows * columns) return null;
  const { surface, origin, cell, min, max } = header;
  return { surface, origin, cell, rows, columns, min, max, values };
}

function parseHeader(text: string): FrameHeader | null {
  try {
    return JSON.parse(text) as FrameHeader;
  } catch {
    return null;
  }
}
