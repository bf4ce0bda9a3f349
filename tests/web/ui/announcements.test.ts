import { describe, expect, test } from "vitest";
import type { Action } from "../../../web/src/model/actions";
import type { State } from "../../../web/src/model/state";
import { announcement } from "../../../web/src/ui/announcements";
import { answer, begin, box, placement, play, room } from "../rooms";

const said = (state: State, ...actions: readonly Action[]): string | null =>
  announcement(state, play(state, ...actions));

const place: Action = {
  type: "place",
  category: "Sofa",
  item: null,
  size: null,
  mode: "scenegen",
  view: [2, 2],
};

function answered(change = {}): readonly [State, Action] {
  const asked = play(begin(), place);
  const value = answer(asked.placing?.ask ?? "", 0, change);
  return [asked, { type: "answer", answer: value }];
}

describe("placing", () => {
  test("says what is being placed", () => {
    expect(said(begin(), place)).toBe("Placing: sofa.");
  });

  test("says how many places there are, and the first", () => {
    const [asked, action] = answered({
      placements: [placement(1, { sentence: "Against the north wall" }), placement(2)],
    });
    expect(said(asked, action)).toBe("2 good places. Against the north wall.");
  });

  test("says why there can be no answer", () => {
    const text = "A sofa cannot be 90 m. Make it smaller.";
    expect(said(play(begin(), place), { type: "ask-refused", text })).toBe(text);
  });

  test("does not count the good places for whoever finds one by hand", () => {
    const [asked, action] = answered();
    const byHand = play(asked, { type: "set-mode", mode: "manual", view: [2, 2] });
    expect(said(byHand, action)).toBeNull();
  });

  test("says why there is none", () => {
    const [asked, action] = answered({
      placements: [],
      no_good_place: { rule: "wall", text: "No free wall is wide enough." },
    });
    expect(said(asked, action)).toBe("No free wall is wide enough.");
  });

  test("says the number and the sentence of another place", () => {
    const [asked, action] = answered({
      placements: [placement(1), placement(2, { sentence: "By the window" })],
    });
    const shown = play(asked, action);
    expect(said(shown, { type: "show-alternative", rank: 2 })).toBe("Place 2: By the window.");
  });

  test("says where it was placed", () => {
    const [asked, action] = answered({
      placements: [placement(1, { center: [2, 2, 0.4], sentence: "Facing the TV" })],
    });
    expect(said(play(asked, action), { type: "confirm" })).toBe("Sofa placed: facing the TV.");
  });

  test("says that it was canceled", () => {
    expect(said(play(begin(), place), { type: "cancel" })).toBe("Canceled.");
  });
});

describe("editing", () => {
  const edited = play(begin([box("a")]), { type: "select", selection: { kind: "box", id: "a" } });

  test("says where a moved thing is now", () => {
    expect(said(edited, { type: "nudge", by: [0.5, 0] })).toBe(
      "Table, 0.80 × 1.2 × 0.80 m, 1.4 m from the south wall, facing east.",
    );
  });

  test("says what was deleted, and what undoing and redoing leave", () => {
    const gone = play(edited, { type: "delete-selected" });
    expect(announcement(edited, gone)).toBe("Table deleted.");
    expect(said(gone, { type: "undo" })).toBe("Undone. My room, 20.0 m², 1 piece.");
    const back = play(gone, { type: "undo" });
    expect(said(back, { type: "redo" })).toBe("Redone. My room, 20.0 m², empty.");
  });

  test("an edit after undoing is an edit", () => {
    const back = play(edited, { type: "delete-selected" }, { type: "undo" });
    expect(said(back, { type: "edit-box", box: box("b"), done: true })).toMatch(/^Added: Table/);
  });

  test("counts the corners of an outline, and says the room it makes", () => {
    const click = (x: number, y: number): readonly Action[] => [
      { type: "draw-down", at: [x, y], free: true },
      { type: "draw-up", at: [x, y], free: true },
    ];
    const drawing = play(
      begin(),
      { type: "choose-tool", tool: "room" },
      ...click(0, 0),
      ...click(3, 0),
    );
    expect(said(drawing, ...click(3, 2))).toBe("3 corners.");
    expect(said(play(drawing, ...click(3, 2), ...click(0, 2)), { type: "close-outline" })).toBe(
      "Room drawn: My room, 6.0 m², empty.",
    );
  });
});

test("says which room was opened", () => {
  const scene = { ...room([box("a")]), id: "other", name: "Bedroom" };
  expect(said(begin(), { type: "open-scene", scene })).toBe("Opened: Bedroom, 20.0 m², 1 piece.");
});

test("says a problem in its own words", () => {
  expect(said(begin(), { type: "notify", tone: "problem", text: "Save it again." })).toBe(
    "Save it again.",
  );
});

test("says when the connection goes and comes back", () => {
  const online = play(begin(), { type: "connection", connection: { status: "online" } });
  const gone: Action = { type: "connection", connection: { status: "offline" } };
  expect(said(online, gone)).toBe("The connection is gone. You can go on; I'll catch up.");
  expect(said(play(online, gone), { type: "connection", connection: { status: "online" } })).toBe(
    "Connected again.",
  );
});

test("says what to do when the connection is closed for good", () => {
  const ended = "This room is open elsewhere. Reload to take it back.";
  expect(said(begin(), { type: "connection", connection: { status: "offline", ended } })).toBe(
    ended,
  );
});

test("says nothing when nothing happened", () => {
  expect(said(begin(), { type: "set-heat-opacity", opacity: 0.4 })).toBeNull();
});
