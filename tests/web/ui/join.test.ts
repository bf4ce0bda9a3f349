import { expect, test } from "vitest";
import type { JoinInfo } from "../../../web/src/contract";
import { joinDialog, openJoin } from "../../../web/src/ui/join";
import { begin } from "../rooms";
import { sitDown, wordsOf } from "./desk";

const WAY: JoinInfo = {
  address: "http://192.168.1.5:8001/#secret&session=s1",
  text: "Scan this with a phone in the same network.",
  picture: "/join.svg?session=s1",
};

/** What the dialog says at once, and once the server has answered. */
async function said(answer: JoinInfo | null): Promise<readonly [string, string]> {
  const desk = sitDown(begin());
  const { page } = desk;
  openJoin({ ...page, services: { ...page.services, fetchJoin: async () => answer } });
  expect(desk.local.joinDoor).toBe(true);
  const first = wordsOf(joinDialog(desk.page));
  await new Promise((done) => setTimeout(done));
  return [first, wordsOf(joinDialog(desk.page))];
}

test("a phone gets the code and the address", async () => {
  const [first, then] = await said(WAY);
  expect(first).toMatch(/One moment/);
  expect(then).toContain(WAY.text);
  expect(then).toContain(WAY.address);
});

test("where nobody can join the reason stands there, and no code", async () => {
  const [, then] = await said({ ...WAY, address: null, text: "For phones: make run LAN=1" });
  expect(then).toBe("Open on your phone For phones: make run LAN=1");
});

test("without the server there is a sentence", async () => {
  const [, then] = await said(null);
  expect(then).toMatch(/can't be reached now/);
});
