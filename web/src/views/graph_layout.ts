/** Where the nodes of the scene graph float and how its edges bend. Pure; core frame, metres. */
import type { Vector3 } from "../model/state";
import type { Graph, GraphEdge, GraphNode } from "../net/protocol.gen";

const BELONGS = "BelongsTo"; // the relation of an object to its group
const OBJECT = "object:"; // how the ids of the nodes of objects begin
const TOLD: readonly string[] = ["Support", "Facing", "NextTo", "AverageDistance"];
const MOST_TOLD = 4; // edges; more texts than that cover what they are about
const OVER_MEMBERS = 0.75; // how far groups float over the middle of their members
const ROOM_HEIGHT = 2.2; // where the node of the room floats
const BULGE = 0.18; // of its length, how far an edge bends up
const PIECES = 12; // straight pieces of a bent edge

/** Where each node floats; a group of one is where its member is. */
export function placesOf(graph: Graph): ReadonlyMap<string, Vector3> {
  const lonely = new Set(graph.nodes.filter((node) => isLonely(graph, node)).map(({ id }) => id));
  return new Map(
    graph.nodes.map((node) => [node.id, lonely.has(node.id) ? node.center : placeOf(node)]),
  );
}

/** Whether the node is a group with a single member: not worth a sign of its own. */
export function isLonely(graph: Graph, node: GraphNode): boolean {
  const members = graph.edges.filter(
    ({ relation, target }) => relation === BELONGS && target === node.id,
  );
  return node.kind === "group" && members.length < 2;
}

function placeOf({ kind, center }: GraphNode): Vector3 {
  switch (kind) {
    case "object":
      return center;
    case "group":
      return [center[0], center[1], center[2] + OVER_MEMBERS];
    case "room":
      return [center[0], center[1], ROOM_HEIGHT];
  }
}

/** The edges that are shown: all that are switched on, or those of one node alone. */
export function edgesOf(
  graph: Graph,
  hidden: readonly string[],
  node: string | null,
): readonly GraphEdge[] {
  return graph.edges.filter(
    ({ relation, source, target }) =>
      !hidden.includes(relation) && (node === null || source === node || target === node),
  );
}

/** The edges from one node to other objects that carry their text: few, the strongest kinds first. */
export function toldOf(edges: readonly GraphEdge[], node: string): readonly GraphEdge[] {
  return edges
    .filter(
      ({ source, target, relation }) =>
        source === node && target.startsWith(OBJECT) && TOLD.includes(relation),
    )
    .toSorted((a, b) => TOLD.indexOf(a.relation) - TOLD.indexOf(b.relation))
    .slice(0, MOST_TOLD);
}

/** A bent edge as the ends of its straight pieces, two by two; `lane` spreads parallel ones. */
export function arc(from: Vector3, to: Vector3, lane: number): readonly Vector3[] {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  const rise = length * BULGE * (1 + lane * 0.45);
  const at = (t: number): Vector3 => [
    from[0] + (to[0] - from[0]) * t,
    from[1] + (to[1] - from[1]) * t,
    from[2] + (to[2] - from[2]) * t + rise * 4 * t * (1 - t),
  ];
  return Array.from({ length: PIECES }, (_, i) => [at(i / PIECES), at((i + 1) / PIECES)]).flat();
}

/** The top of a bent edge, where its text stands. */
export function crest(from: Vector3, to: Vector3, lane: number): Vector3 {
  return arc(from, to, lane)[PIECES] ?? from;
}

/** Which lane each edge takes: edges between the same two nodes bend by different amounts. */
export function lanes(edges: readonly GraphEdge[]): readonly number[] {
  const taken = new Map<string, number>();
  return edges.map(({ source, target }) => {
    const pair = [source, target].sort().join("|");
    const lane = taken.get(pair) ?? 0;
    taken.set(pair, lane + 1);
    return lane;
  });
}
