import { defineConfig } from "vitest/config";

const SERVER = "http://localhost:8000";
const SERVED_BY_PYTHON = [
  "/rooms",
  "/assets",
  "/scenes",
  "/export",
  "/knowledge",
  "/usdz",
  "/join",
  "/health",
];

export default defineConfig({
  root: "web",
  server: {
    proxy: {
      ...Object.fromEntries(SERVED_BY_PYTHON.map((path) => [path, SERVER])),
      "/socket": { target: SERVER, ws: true },
    },
  },
  build: {
    outDir: "dist",
    emptyOutDir: true,
    // three is most of the bytes and seldom changes: a chunk of its own stays in the cache.
    chunkSizeWarningLimit: 800,
    rolldownOptions: {
      output: {
        codeSplitting: { groups: [{ name: "three", test: /node_modules[\\/]three/ }] },
      },
    },
  },
  test: {
    root: ".",
    include: ["tests/web/**/*.test.ts"],
    environment: "node",
    // Kept for the next file: starting a thread costs more than the tests in it.
    pool: "threads",
    isolate: false,
  },
});
