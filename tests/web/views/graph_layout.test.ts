import { describe, expect, it } from "vitest";
import type { Graph } from "../../../web/src/net/protocol.gen";
import {
  arc,
  edgesOf,
  isLonely,
  lanes,
  placesOf,
  toldOf,
} from "../../../web/src/views/graph_layout";

const edge = (source: string, target: string, relation: string) => ({
  source,
  target,
  relation,
  value: 1,
  text: relation,
});

const GRAPH: Graph = {
  type: "graph",
  revision: 1,
  nodes: [
    { id: "object:a", kind: "object", name: "Chair", center: [0, 0, 0.4] },
    { id: "object:b", kind: "object", name: "Chair", center: [2, 0, 0.4] },
    { id: "object:c", kind: "object", name: "TV", center: [1, 3, 1] },
    { id: "group:Chair", kind: "group", name: "Chair", center: [1, 0, 0.4] },
    { id: "group:TV", kind: "group", name: "TV", center: [1, 3, 1] },
    { id: "room", kind: "room", name: "room", center: [1, 1, 0] },
  ],
  edges: [
    edge("object:a", "group:Chair", "BelongsTo"),
    edge("object:b", "group:Chair", "BelongsTo"),
    edge("object:c", "group:TV", "BelongsTo"),
    edge("object:a", "object:c", "Facing"),
    edge("object:c", "object:a", "AverageDistance"),
  ],
};

describe("the scene graph over the room", () => {
  it("lets a group float over its members, but not a group of one", () => {
    const places = placesOf(GRAPH);
    expect(places.get("object:a")).toEqual([0, 0, 0.4]);
    expect(places.get("group:Chair")?.[2]).toBeGreaterThan(0.9);
    expect(places.get("group:TV")).toEqual([1, 3, 1]);
    expect(GRAPH.nodes.filter((node) => isLonely(GRAPH, node)).map(({ id }) => id)).toEqual([
      "group:TV",
    ]);
  });

  it("shows the relations that are switched on, and those of one thing alone when asked", () => {
    expect(edgesOf(GRAPH, ["BelongsTo"], null)).toHaveLength(2);
    expect(edgesOf(GRAPH, [], "object:b").map(({ relation }) => relation)).toEqual(["BelongsTo"]);
  });

  it("bends edges between the same two things by different amounts", () => {
    const [, , , first, second] = lanes(GRAPH.edges);
    expect(first).toBe(0);
    expect(second).toBe(1);
    const top = (lane: number) => Math.max(...arc([0, 0, 0], [2, 0, 0], lane).map(([, , z]) => z));
    expect(top(1)).toBeGreaterThan(top(0));
  });

  it("draws an edge from the one to the other", () => {
    const points = arc([0, 0, 1], [2, 1, 1], 0);
    expect(points[0]).toEqual([0, 0, 1]);
    expect(points.at(-1)).toEqual([2, 1, 1]);
  });

  it("tells what one thing has to do with others, not with groups or the room", () => {
    const edges = [
      edge("object:a", "group:TV", "AverageDistance"),
      edge("object:a", "object:b", "AverageDistance"),
      edge("object:a", "object:c", "Facing"),
      edge("object:b", "object:a", "NextTo"),
      edge("object:a", "room", "RoomPosition"),
    ];
    expect(toldOf(edges, "object:a").map(({ relation }) => relation)).toEqual([
      "Facing",
      "AverageDistance",
    ]);
  });
});
