import { describe, expect, test } from "vitest";
import type { Graph } from "../../../web/src/net/protocol.gen";
import { begin, box, play } from "../rooms";

describe("what is shown", () => {
  test("a layer is switched off and on again", () => {
    const off = play(begin(), { type: "toggle-layer", layer: "heat" });
    expect(off.shown.heat).toBe(false);
    expect(play(off, { type: "toggle-layer", layer: "heat" }).shown.heat).toBe(true);
  });

  test("a relation of the graph is hidden and shown again", () => {
    const hidden = play(begin(), { type: "toggle-relation", relation: "NextTo" });
    expect(hidden.shown.hiddenRelations).toEqual(["NextTo"]);
    const shown = play(hidden, { type: "toggle-relation", relation: "NextTo" });
    expect(shown.shown.hiddenRelations).toEqual([]);
  });

  test("the map is never more than opaque", () => {
    const state = play(begin(), { type: "set-heat-opacity", opacity: 1.4 });
    expect(state.shown.heatOpacity).toBe(1);
  });

  test("the camera is the one that was chosen", () => {
    expect(play(begin(), { type: "set-camera", camera: "top" }).shown.camera).toBe("top");
  });
});

describe("notices", () => {
  test("each has its own id, so the same words can be said twice", () => {
    const once = play(begin(), { type: "notify", tone: "info", text: "Saved." });
    const twice = play(once, { type: "notify", tone: "info", text: "Saved." });
    expect(once.notice?.text).toBe("Saved.");
    expect(twice.notice?.id).not.toBe(once.notice?.id);
    expect(play(twice, { type: "dismiss-notice" }).notice).toBeNull();
  });
});

describe("the invitation to begin", () => {
  test("it goes with the first thing that the person does", () => {
    expect(play(begin(), { type: "touched" }).welcome).toBe(false);
    expect(play(begin(), { type: "choose-tool", tool: "box" }).welcome).toBe(false);
  });

  test("it stays while only the server speaks", () => {
    const state = play(
      begin(),
      { type: "connection", connection: { status: "online", session: "s" } },
      { type: "models", boxes: {} },
      { type: "probe", probe: null },
    );
    expect(state.welcome).toBe(true);
  });
});

describe("Esc leaves the innermost thing", () => {
  test("help first, then the tool, then the selection", () => {
    const deep = play(
      begin([box("table")]),
      { type: "select", selection: { kind: "box", id: "table" } },
      { type: "choose-tool", tool: "door" },
      { type: "toggle-help" },
    );
    const once = play(deep, { type: "cancel" });
    expect([once.help, once.tool]).toEqual([false, "door"]);
    const twice = play(once, { type: "cancel" });
    expect([twice.tool, twice.selection?.kind]).toEqual(["select", "box"]);
    expect(play(twice, { type: "cancel" }).selection).toBeNull();
  });

  test("a drag goes back to where it began", () => {
    const dragging = play(begin([box("table")]), {
      type: "edit-box",
      box: box("table", { center: [4, 3, 0.4] }),
      done: false,
    });
    expect(play(dragging, { type: "cancel" }).scene.boxes).toEqual([box("table")]);
  });
});

describe("what comes over the socket", () => {
  const graph = (revision: number): Graph => ({ type: "graph", revision, nodes: [], edges: [] });

  test("an older graph does not replace a newer one", () => {
    const state = play(
      begin(),
      { type: "graph", graph: graph(3) },
      { type: "graph", graph: graph(2) },
    );
    expect(state.graph?.revision).toBe(3);
  });

  test("in another session an earlier revision is news", () => {
    const state = play(
      begin(),
      { type: "graph", graph: graph(3) },
      { type: "connection", connection: { session: "s2" } },
      { type: "graph", graph: graph(1) },
    );
    expect(state.graph?.revision).toBe(1);
  });

  test("models are kept for boxes that are there, and added to those known", () => {
    const state = play(
      begin([box("a"), box("b")]),
      { type: "models", boxes: { a: "1", gone: "2" } },
      { type: "models", boxes: { b: "3" } },
    );
    expect(state.models).toEqual({ a: "1", b: "3" });
  });

  test("another room forgets the models of the last", () => {
    const state = play(
      begin([box("a")]),
      { type: "models", boxes: { a: "1" } },
      { type: "open-scene", scene: { ...begin([box("a")]).scene, id: "other" } },
    );
    expect(state.models).toEqual({});
  });

  test("a room from another device is shown as it is, with nothing to undo", () => {
    const scene = { ...begin([box("a")]).scene, id: "theirs" };
    const state = play(
      begin(),
      { type: "edit-box", box: box("mine"), done: true },
      { type: "resumed", scene },
    );
    expect(state.scene).toBe(scene);
    expect(state.past).toEqual([]);
  });

  test("news of the connection that says nothing new changes nothing", () => {
    const state = play(begin(), { type: "connection", connection: { status: "online" } });
    expect(play(state, { type: "connection", connection: { status: "online" } })).toBe(state);
  });
});
