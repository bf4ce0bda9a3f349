import { Color, Group } from "three";
import { relationLook } from "../model/relation_looks";
import type { State, Vector3 } from "../model/state";
import type { Graph, GraphEdge, GraphNode } from "../net/protocol.gen";
import { arc, crest, edgesOf, isLonely, lanes, placesOf, toldOf } from "./graph_layout";
import type { LabelBox } from "./label_layout";
import { Notes } from "./notes";
import type { Look } from "./palette";
import type { Eye, Part } from "./part";
import { Strokes } from "./strokes";
import { TextSprite } from "./text_sprite";

const CROWD = 18; // whole lines; more of them are drawn the fainter
const FAINTEST = 0.16; // opacity
const WHITE = new Color("#ffffff");

/** The scene graph over the room; one node's own relations when it is selected or hovered. */
export class GraphView implements Part {
  readonly root = new Group();
  readonly #strokes = new Map<string, Strokes>();
  readonly #nodes: TextSprite[] = [];
  readonly #notes = new Notes();
  readonly #taken: readonly (readonly LabelBox[])[];
  #look: Look;
  #state: State | null = null;
  #hover: string | null = null;
  #drawn: readonly unknown[] = [];

  /** `taken` is where handles are, which texts make way for. */
  constructor(look: Look, taken: readonly (readonly LabelBox[])[]) {
    this.#look = look;
    this.#taken = taken;
    this.root.add(this.#notes.root);
    this.root.visible = false;
  }

  relight(look: Look): void {
    this.#look = look;
    this.#drawn = [];
    this.#clearStrokes();
  }

  show(state: State): void {
    this.#state = state;
    const { graph, shown, selection } = state;
    this.root.visible = shown.graph && graph !== null;
    if (!this.root.visible || graph === null) {
      return;
    }
    const chosen = selection?.kind === "box" ? selection.id : this.#hover;
    const node = chosen === null ? null : (graph.nodes.find(isBox(chosen))?.id ?? null);
    const drawn = [graph, shown.hiddenRelations, node];
    if (drawn.some((part, i) => part !== this.#drawn[i])) {
      this.#drawn = drawn;
      this.#draw(graph, shown.hiddenRelations, node);
    }
  }

  /** Which box the pointer is over. */
  hover(id: string | null): void {
    this.#hover = id;
    if (this.#state) {
      this.show(this.#state);
    }
  }

  update(eye: Eye): boolean {
    if (this.root.visible) {
      this.#notes.fit(eye, this.#taken);
      for (const node of this.#nodes) {
        node.fit(eye);
      }
    }
    return false;
  }

  dispose(): void {
    this.#clearStrokes();
    for (const part of [...this.#nodes, this.#notes]) {
      part.dispose();
    }
  }

  #clearStrokes(): void {
    for (const strokes of this.#strokes.values()) {
      strokes.dispose();
    }
    this.#strokes.clear();
  }

  #draw(graph: Graph, hidden: readonly string[], node: string | null): void {
    const edges = edgesOf(graph, hidden, node);
    const places = placesOf(graph);
    const lane = lanes(edges);
    const byRelation = new Map<string, Vector3[]>();
    edges.forEach((edge, i) => {
      const [from, to] = [places.get(edge.source), places.get(edge.target)];
      if (from && to) {
        const ends = byRelation.get(edge.relation) ?? [];
        byRelation.set(edge.relation, ends.concat(arc(from, to, lane[i] ?? 0)));
      }
    });
    this.#stroke(
      byRelation,
      node === null ? Math.max(FAINTEST, Math.min(0.7, CROWD / edges.length)) : 1,
    );
    this.#notes.show(node === null ? [] : notesOf(toldOf(edges, node), edges, lane, places), {
      size: 12,
      color: this.#look.labelText,
      background: this.#look.label,
    });
    const signs = graph.nodes.filter((one) => one.kind !== "object" && !isLonely(graph, one));
    this.#showNodes(signs, places);
  }

  #stroke(byRelation: ReadonlyMap<string, Vector3[]>, opacity: number): void {
    for (const relation of byRelation.keys()) {
      if (!this.#strokes.has(relation)) {
        const { color, dash } = relationLook(relation);
        const strokes = new Strokes({
          color: lighter(color, this.#look),
          width: 2,
          ...(dash && { dash }),
        });
        this.#strokes.set(relation, strokes);
        this.root.add(strokes.root);
      }
    }
    for (const [relation, strokes] of this.#strokes) {
      strokes.opacity = opacity;
      strokes.show(byRelation.get(relation) ?? []);
    }
  }

  #showNodes(nodes: readonly GraphNode[], places: ReadonlyMap<string, Vector3>): void {
    while (this.#nodes.length < nodes.length) {
      const sprite = new TextSprite();
      this.#nodes.push(sprite);
      this.root.add(sprite);
    }
    this.#nodes.forEach((sprite, i) => {
      const node = nodes[i];
      sprite.visible = node !== undefined;
      if (node) {
        sprite.position.set(...(places.get(node.id) ?? node.center));
        sprite.write(node.kind === "group" ? `all ${node.name}` : node.name, {
          size: 11,
          color: this.#look.labelText,
          background: this.#look.label,
          border: node.kind === "room" ? "#56b4e9" : "#8a8a8a",
        });
      }
    });
  }
}

function lighter(color: string, { lighterLines }: Look): string {
  return `#${new Color(color).lerp(WHITE, lighterLines).getHexString()}`;
}

function isBox(id: string): (node: GraphNode) => boolean {
  return (node) => node.kind === "object" && node.id === `object:${id}`;
}

function notesOf(
  told: readonly GraphEdge[],
  edges: readonly GraphEdge[],
  lane: readonly number[],
  places: ReadonlyMap<string, Vector3>,
) {
  return told.flatMap((edge) => {
    const [from, to] = [places.get(edge.source), places.get(edge.target)];
    const at = lane[edges.indexOf(edge)] ?? 0;
    return from && to ? [{ text: edge.text, at: crest(from, to, at) }] : [];
  });
}
