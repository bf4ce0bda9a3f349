/** The models of furniture, by digest: pushed over the socket, or fetched when one is missing. */
import type { Assets } from "../contract";

/** The server pushes models by itself; only what is later than this is fetched, milliseconds. */
const PATIENCE = 1500;

/** A GLB's bytes, or null when it cannot be had now. */
export type FetchAsset = (digest: string) => Promise<ArrayBuffer | null>;

export class AssetCache implements Assets {
  readonly #bytes = new Map<string, ArrayBuffer>();
  readonly #listeners = new Set<(digest: string) => void>();
  /** What was asked for: once, until the server is back. */
  readonly #wanted = new Set<string>();
  readonly #fetchAsset: FetchAsset;

  constructor(fetchAsset: FetchAsset) {
    this.#fetchAsset = fetchAsset;
  }

  /** The digests that are here; the server need not send them again. */
  get digests(): readonly string[] {
    return [...this.#bytes.keys()];
  }

  get(digest: string): ArrayBuffer | undefined {
    const bytes = this.#bytes.get(digest);
    if (bytes === undefined) void this.#want(digest);
    return bytes;
  }

  put(digest: string, bytes: ArrayBuffer): void {
    if (this.#bytes.has(digest)) return;
    this.#bytes.set(digest, bytes);
    for (const listener of this.#listeners) listener(digest);
  }

  subscribe(listener: (digest: string) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** The server is back: what it could not give then, it may give now. */
  retry(): void {
    const missing = [...this.#wanted].filter((digest) => !this.#bytes.has(digest));
    this.#wanted.clear();
    for (const digest of missing) void this.#want(digest);
  }

  async #want(digest: string): Promise<void> {
    if (this.#wanted.has(digest)) return;
    this.#wanted.add(digest);
    await new Promise((resolve) => setTimeout(resolve, PATIENCE));
    if (this.#bytes.has(digest)) return;
    const bytes = await this.#fetchAsset(digest);
    if (bytes !== null) this.put(digest, bytes);
  }
}
