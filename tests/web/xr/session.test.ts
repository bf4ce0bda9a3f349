import { describe, expect, test } from "vitest";
import { grantedFeatures, sessionInit } from "../../../web/src/xr/session_init";
import { arSupport } from "../../../web/src/xr/support";

const system = (answer: () => Promise<boolean>) => ({ isSessionSupported: answer });

describe("what is asked of the browser", () => {
  const init = sessionInit({} as Element);

  test("only that without which nothing can be put anywhere is required", () => {
    expect(init.requiredFeatures).toEqual(["hit-test", "local-floor"]);
  });

  test("everything else is welcome, but the camera's image is not among it", () => {
    expect(init.optionalFeatures).toEqual(
      expect.arrayContaining(["dom-overlay", "anchors", "plane-detection", "mesh-detection"]),
    );
    expect(JSON.stringify(init)).not.toContain("camera");
  });

  test("a browser that does not tell its features has those that were required", () => {
    expect(grantedFeatures({})).toEqual(["hit-test", "local-floor"]);
  });
});

describe("whether there is a camera view", () => {
  test.each([
    ["yes", true, system(async () => true)],
    ["missing", true, system(async () => false)],
    ["missing", true, undefined],
    ["insecure", false, undefined],
    [
      "refused",
      true,
      system(async () => {
        throw new DOMException("policy", "SecurityError");
      }),
    ],
  ] as const)("%s", async (support, isSecureContext, xr) => {
    expect(await arSupport({ isSecureContext, xr })).toBe(support);
  });
});
