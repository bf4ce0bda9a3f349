import type { TemplateResult } from "lit";
import { describe, expect, test } from "vitest";
import type { State } from "../../../web/src/model/state";
import { arDoor } from "../../../web/src/ui/ar";
import type { Page } from "../../../web/src/ui/page";
import { allPlaced, seeInRoom } from "../../../web/src/ui/quick_look";
import { begin, box, play } from "../rooms";
import { sitDown, wordsOf } from "./desk";

const SOFA = box("sofa", { category: "Sofa", placed: true });
const room = play(
  begin([box("table"), SOFA]),
  { type: "models", boxes: { table: "aa", sofa: "bb" } },
  { type: "connection", connection: { status: "online", session: "s 1" } },
);

const pageOf = (state: State, quickLook: boolean): Page => {
  const { page } = sitDown(state);
  return { ...page, services: { ...page.services, quickLook } };
};
const linkOf = (template: unknown): unknown => (template as TemplateResult).values?.[0];
const isNothing = (template: unknown): boolean => typeof template === "symbol";

describe("where the system has a viewer", () => {
  const page = pageOf(room, true);

  test("what was placed can be seen in the room by its model", () => {
    expect(linkOf(seeInRoom(page, SOFA))).toBe("/usdz/bb.usdz");
    expect(wordsOf(seeInRoom(page, SOFA))).toBe("See it in your room");
  });

  test("what stands there anyway, or has no model yet, cannot", () => {
    expect(isNothing(seeInRoom(page, box("table")))).toBe(true);
    expect(isNothing(seeInRoom(page, { ...SOFA, id: "new" }))).toBe(true);
  });

  test("all that was placed can be seen once the server has it", () => {
    expect(linkOf(allPlaced(page))).toBe("/usdz/sessions/s%201.usdz");
    for (const connection of [{ unsent: 1 }, { status: "offline" as const }, { session: null }]) {
      const waiting = play(room, { type: "connection", connection });
      expect(isNothing(allPlaced(pageOf(waiting, true)))).toBe(true);
    }
    const bare = play(room, { type: "remove-box", id: "sofa" });
    expect(isNothing(allPlaced(pageOf(bare, true)))).toBe(true);
  });

  test("whoever asks for the camera is told of it, and why there is none", () => {
    const words = wordsOf(
      arDoor(pageOf(play(room, { type: "ar-support", support: "missing" }), true)),
    );
    expect(words).toMatch(/can't show your room .* press “See it in your room”/);
    expect(words).toContain("See all you placed in your room");
  });
});

test("without a viewer there is a file for a device that has one", () => {
  const page = pageOf(room, false);
  expect(isNothing(seeInRoom(page, SOFA))).toBe(true);
  expect(wordsOf(allPlaced(page))).toBe("What you placed, for iPhones (USDZ)");
  const refused = pageOf(play(room, { type: "ar-support", support: "missing" }), false);
  expect(wordsOf(arDoor(refused))).not.toContain("See it in your room”");
});
