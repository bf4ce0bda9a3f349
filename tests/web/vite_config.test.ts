import { expect, test } from "vitest";
import app from "../../server/app.py?raw";
import config from "../../vite.config";

test("the page under development gets all that the server serves", () => {
  const served = [...app.matchAll(/Route\("(\/[^"]*)"/g)].map(([, path]) => path ?? "");
  expect(served).toContain("/rooms");
  const passedOn = Object.keys(config.server?.proxy ?? {});
  const missing = served.filter((path) => !passedOn.some((start) => path.startsWith(start)));
  expect(missing).toEqual([]);
});
