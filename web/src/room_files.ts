/** What is wrong with a file that is no room, in words for the person who chose it. */
import { MAX_BOXES } from "./net/protocol.gen";

const CHOOSE = "Choose a file that SceneGen has saved.";

/** Why the text of a file cannot be a room; null if it may be one, which the server then checks. */
export function fileProblem(text: string): string | null {
  const value = parsed(text);
  if (value === undefined) return `This file can't be read, or a part of it is missing. ${CHOOSE}`;
  const { format, boxes } = (value ?? {}) as { readonly format?: unknown; boxes?: unknown };
  if (format !== "scenegen.scene") return `There is no room in this file. ${CHOOSE}`;
  if (Array.isArray(boxes) && boxes.length > MAX_BOXES) {
    return `There are ${boxes.length} things in this file; a room holds ${MAX_BOXES} at most.`;
  }
  return null;
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
