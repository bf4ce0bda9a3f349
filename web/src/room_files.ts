/** What is wrong with a file that is no room, in words for the person who chose it. */
import { MAX_BOXES } from "./net/protocol.gen";

const CHOOSE =
  "Choose a room that SceneGen has saved, or a scan as JSON (RoomPlan, Quest, MR Utility Kit).";

/**
 * Why the text of a file cannot be a room; null if it may be one.
 *
 * Which form it has, and what is wrong in it, the server says.
 */
export function fileProblem(text: string): string | null {
  const value = parsed(text);
  if (value === undefined) return `This file can't be read, or a part of it is missing. ${CHOOSE}`;
  if (typeof value !== "object" || value === null || Array.isArray(value)) {
    return `There is no room in this file. ${CHOOSE}`;
  }
  const { boxes } = value as { readonly boxes?: unknown };
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
