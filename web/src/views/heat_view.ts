import {
  BufferGeometry,
  DataTexture,
  Float32BufferAttribute,
  Group,
  Mesh,
  NearestFilter,
  RedFormat,
  ShapeUtils,
  UnsignedByteType,
  Vector2,
} from "three";
import { shownMaps } from "../model/showing";
import type { HeatMap, State } from "../model/state";
import type { BoxRecord, RoomRecord } from "../net/protocol.gen";
import { heatTexture } from "./cividis";
import { brightest, type Patch, patchesOf } from "./heat_layout";
import { HeatMaterial } from "./heat_material";
import { approach, reducedMotion } from "./motion";
import type { Eye, Part } from "./part";

const WASH = 9; // metres a second that the map spreads over the room
const SHIMMER = 0.25; // seconds until the shimmer is there or gone
const FAR = 1000; // metres; beyond every room
const EDGE = 0.6; // metres over which the edge of the wash fades, as in the shader

interface Sheet {
  readonly mesh: Mesh<BufferGeometry, HeatMaterial>;
  readonly texture: DataTexture;
}

/** The heat maps, on the floor, on the walls, or on top of the furniture. */
export class HeatView implements Part {
  readonly root = new Group();
  readonly #colors = heatTexture();
  #sheets: Sheet[] = [];
  #maps: readonly HeatMap[] = [];
  #room: RoomRecord | null = null;
  #boxes: readonly BoxRecord[] = [];
  #computing = false;
  #clock = 0;
  #shimmer = 0;
  #front = FAR;
  /** How far the wash has to go to cover the biggest map, metres. */
  #reach = 0;

  constructor() {
    this.root.visible = false;
  }

  show(state: State): void {
    const { placing, scene, shown } = state;
    const maps = shownMaps(state);
    const visible = maps.length > 0;
    if (visible && !this.root.visible) {
      this.#front = reducedMotion() ? FAR : 0;
    }
    this.root.visible = visible;
    this.#computing = visible && (placing?.computing ?? false);
    if (maps !== this.#maps || scene.room !== this.#room || this.#boxesMatter(maps, scene.boxes)) {
      this.#maps = maps;
      this.#room = scene.room;
      this.#boxes = scene.boxes;
      this.#rebuild(maps, scene.room, scene.boxes);
    }
    for (const { mesh } of this.#sheets) {
      mesh.material.set("opacity", shown.heatOpacity);
    }
  }

  update(eye: Eye): boolean {
    if (!this.root.visible) {
      return false;
    }
    this.#clock += eye.elapsed;
    this.#shimmer = approach(this.#shimmer, this.#computing ? 1 : 0, eye.elapsed, SHIMMER);
    this.#front = this.#front > this.#reach ? FAR : this.#front + WASH * eye.elapsed;
    for (const { mesh } of this.#sheets) {
      mesh.material.set("clock", this.#clock);
      mesh.material.set("shimmer", reducedMotion() ? this.#shimmer / 2 : this.#shimmer);
      mesh.material.set("front", this.#front);
    }
    const shimmers = this.#shimmer > 0 && !(reducedMotion() && this.#computing);
    return shimmers || this.#front < FAR;
  }

  dispose(): void {
    this.#clear();
    this.#colors.dispose();
  }

  #boxesMatter(maps: readonly HeatMap[], boxes: readonly BoxRecord[]): boolean {
    return boxes !== this.#boxes && maps.some(({ surface }) => surface === "tops");
  }

  #rebuild(maps: readonly HeatMap[], room: RoomRecord, boxes: readonly BoxRecord[]): void {
    this.#clear();
    const spans = maps.map(({ columns, rows, cell }) => Math.hypot(columns, rows) * cell);
    this.#reach = Math.max(0, ...spans) + EDGE;
    for (const map of maps) {
      const texture = textureOf(map);
      const cells = new Vector2(map.columns, map.rows);
      const material = new HeatMaterial(texture, this.#colors, cells);
      material.washFrom(brightest(map));
      material.set("front", this.#front);
      const mesh = new Mesh(geometryOf(map, patchesOf(map, room, boxes)), material);
      mesh.renderOrder = 2;
      this.#sheets.push({ mesh, texture });
      this.root.add(mesh);
    }
  }

  #clear(): void {
    for (const { mesh, texture } of this.#sheets) {
      mesh.removeFromParent();
      mesh.geometry.dispose();
      mesh.material.dispose();
      texture.dispose();
    }
    this.#sheets = [];
  }
}

/** The raw bytes, row 0 first: not flipped, not filtered (the shader does that). */
function textureOf(map: HeatMap): DataTexture {
  const { values, columns, rows } = map;
  const texture = new DataTexture(values, columns, rows, RedFormat, UnsignedByteType);
  texture.magFilter = NearestFilter;
  texture.minFilter = NearestFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

function geometryOf(map: HeatMap, patches: readonly Patch[]): BufferGeometry {
  const positions: number[] = [];
  const uvs: number[] = [];
  const places: number[] = [];
  const indices: number[] = [];
  for (const { corners, uvs: own } of patches) {
    const first = positions.length / 3;
    positions.push(...corners.flat());
    uvs.push(...own.flat());
    for (const [u, v] of own) {
      places.push(map.origin[0] + u * map.columns * map.cell);
      places.push(map.origin[1] + v * map.rows * map.cell);
    }
    const flat = own.map(([u, v]) => new Vector2(u * map.columns, v * map.rows));
    const triangles =
      map.surface === "walls"
        ? [
            [0, 1, 2],
            [0, 2, 3],
          ]
        : ShapeUtils.triangulateShape(flat, []);
    indices.push(...triangles.flat().map((index) => first + index));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.setAttribute("uv", new Float32BufferAttribute(uvs, 2));
  geometry.setAttribute("place", new Float32BufferAttribute(places, 2));
  geometry.setIndex(indices);
  return geometry;
}
