/** Why the server closes a connection for good, and what to do, in words for the person. */

const ENDINGS: Readonly<Record<number, string>> = {
  4400: "This page is older than the server. Reload it.",
  4401: "The server could not understand this page. Reload it to go on.",
  4402: "This room is open elsewhere. Reload to take it back.",
  4403: "Too many pages are open. Close some, then reload this one.",
};

/** The sentence for a close code; for an unknown one what the server says itself. */
export function endingOf(code: number, reason: string): string {
  return ENDINGS[code] ?? (reason || "The connection was closed. Reload the page.");
}
