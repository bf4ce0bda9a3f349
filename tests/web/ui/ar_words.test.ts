import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { Ar, State } from "../../../web/src/model/state";
import { announcement } from "../../../web/src/ui/announcements";
import { arHint, markInWords, obstacleInWords } from "../../../web/src/ui/ar_words";
import { hint } from "../../../web/src/ui/hints";
import { begin, box, play } from "../rooms";

const change = (change: Partial<Ar>): Action => ({ type: "change-ar", change });
const entered = play(begin(), { type: "enter-ar", room: "new", granted: [] });
const ready = play(entered, change({ step: "ready" }));
const tool = (name: "room" | "box" | "door"): State =>
  play(ready, { type: "choose-tool", tool: name });
const down = (state: State): State => play(state, { type: "draw-down", at: [1, 1], free: true });
const words = (state: State) => {
  if (state.ar === null) throw new Error("The camera is off.");
  return [arHint(state, state.ar), markInWords(state, state.ar)];
};

describe("what to do next in the camera view", () => {
  test.each([
    ["before a surface is seen", entered, "move your phone", null],
    ["once it is", play(entered, change({ surface: true })), "on the floor", "The floor is here"],
    ["lining up", play(entered, change({ step: "line-up" })), "corner", "The corner is here"],
    [
      "at the second corner",
      play(entered, change({ step: "line-up", corner: [0, 0] })),
      "next corner",
      "The corner is here",
    ],
    ["outlining", tool("room"), "corner of the room", "Corner here"],
    ["marking", tool("box"), "What stands here?", "Corner here"],
    ["its side", down(tool("box")), "other end of that side", "Corner here"],
    [
      "its depth",
      play(down(tool("box")), { type: "draw-side", at: [2, 1], free: true }),
      "back",
      "This deep",
    ],
    ["a door", tool("door"), "door begins", "It begins here"],
    ["the end of a door", down(tool("door")), "door ends", "It ends here"],
    ["paused", play(tool("box"), change({ tracking: "paused" })), "Paused", null],
    ["lost", play(tool("box"), change({ tracking: "lost" })), "lost the room", null],
  ] as const)("%s", (_, state, sentence, button) => {
    const [said, offered] = words(state);
    expect(said).toContain(sentence);
    expect(offered).toBe(button);
    expect(hint(state)).toBe(said);
  });

  test("each step is told to who does not see it, once", () => {
    const seen = play(entered, change({ surface: true }));
    expect(announcement(entered, seen)).toContain("on the floor");
    const lost = play(ready, change({ tracking: "lost" }));
    expect(announcement(ready, lost)).toContain("lost the room");
    expect(announcement(lost, play(lost, change({ occlusion: false })))).toBeNull();
  });

  test("what is not found yet cannot be lost", () => {
    expect(words(play(entered, change({ tracking: "lost" })))[0]).toContain("move your phone");
  });

  test("the end of the camera view is told", () => {
    expect(announcement(ready, play(ready, { type: "leave-ar" }))).toBe("The camera is off.");
  });

  test("the piece in question is named", () => {
    const found = play(
      ready,
      change({ found: { corners: null, doors: [], windows: [], boxes: [box("box-1")] } }),
    );
    expect(announcement(ready, found)).toBe("1 piece found.");
    expect(announcement(found, play(found, { type: "use-found" }))).toBe("Is this a table?");
  });
});

test("where there is no camera view, the reason says what to do", () => {
  expect(obstacleInWords("yes")).toBeNull();
  for (const support of ["insecure", "missing", "refused"] as const) {
    expect(obstacleInWords(support)).toMatch(/\. .*(Open|draw)/);
  }
});
