import {
  type BufferGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshStandardMaterial,
  Vector3,
} from "three";
import type { State } from "../model/state";
import type { RoomRecord } from "../net/protocol.gen";
import { Faces } from "./faces";
import { oakTexture } from "./floor_texture";
import { SIDEWAYS } from "./framing";
import { approach } from "./motion";
import { type Panel, type Wall, wallsOf } from "./outline";
import type { Look } from "./palette";
import type { Eye, Part } from "./part";
import { floorOf, lowPart, panelsByWall } from "./room_shapes";
import { addDoor, addGlass, addWall, addWindow, CUT, THICKNESS } from "./walls";

const FADE = 0.16; // seconds until a wall is gone or back
const MARGIN = 0.05; // metres the eye must be behind a wall before it goes

/** What of a wall fades when it stands between the eye and the room. */
interface Upper {
  readonly wall: Wall;
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
  readonly glass: Mesh<BufferGeometry, MeshBasicMaterial> | null;
  opacity: number;
}

/** Floor, walls, doors and windows. There is no ceiling: it would hide the room. */
export class RoomView implements Part {
  readonly root = new Group();
  readonly #oak = oakTexture();
  readonly #floorMaterial = new MeshStandardMaterial({ map: this.#oak, roughness: 0.62 });
  readonly #lowMaterial = new MeshLambertMaterial({ vertexColors: true });
  readonly #eye = new Vector3();
  #room: RoomRecord | null = null;
  #look: Look;
  #plan = false;
  #within = false;
  #fixed: Mesh[] = [];
  #uppers: Upper[] = [];

  constructor(look: Look) {
    this.#look = look;
    this.#floorMaterial.color.set(look.floorTint);
  }

  /** Paints the room again for another time of the day. */
  relight(look: Look): void {
    this.#look = look;
    this.#floorMaterial.color.set(look.floorTint);
    if (this.#room) {
      this.#build(this.#room);
    }
  }

  show(state: State): void {
    this.root.visible = state.ar === null; // there the real room is seen
    this.#plan = state.shown.camera === "top";
    this.#within = state.shown.camera === "walk";
    if (state.scene.room !== this.#room) {
      this.#build(state.scene.room);
    }
  }

  update(eye: Eye): boolean {
    this.#eye.setFromMatrixPosition(eye.camera.matrixWorld);
    this.root.worldToLocal(this.#eye);
    let moving = false;
    for (const upper of this.#uppers) {
      const goal = this.#plan || isInTheWay(upper.wall, this.#eye, this.#within) ? 0 : 1;
      if (upper.opacity !== goal) {
        upper.opacity = approach(upper.opacity, goal, eye.elapsed, FADE);
        setOpacity(upper, upper.opacity);
        moving = true;
      }
    }
    return moving;
  }

  dispose(): void {
    this.#clear();
    this.#oak.dispose();
    this.#floorMaterial.dispose();
    this.#lowMaterial.dispose();
  }

  #build(room: RoomRecord): void {
    const faded = this.#uppers.map((upper) => upper.opacity);
    this.#clear();
    this.#room = room;
    const walls = wallsOf(room.corners, THICKNESS);
    const doors = panelsByWall(walls, room.doors);
    const windows = panelsByWall(walls, room.windows);
    this.#fix(new Mesh(floorOf(room), this.#floorMaterial));
    this.#fix(new Mesh(lowPart(walls, doors, windows, this.#look), this.#lowMaterial));
    this.#uppers = walls.map((wall, i) =>
      this.#upper(wall, room.height, doors[i] ?? [], windows[i] ?? [], faded[i] ?? 1),
    );
  }

  #fix(mesh: Mesh): void {
    mesh.receiveShadow = true;
    this.#fixed.push(mesh);
    this.root.add(mesh);
  }

  #upper(
    wall: Wall,
    height: number,
    doors: readonly Panel[],
    windows: readonly Panel[],
    opacity: number,
  ): Upper {
    const faces = new Faces();
    addWall(faces, wall, [CUT, Math.max(height, CUT * 2)], [...doors, ...windows], this.#look);
    for (const door of doors) {
      addDoor(faces, wall, door, CUT, this.#look);
    }
    for (const window of windows) {
      addWindow(faces, wall, window, this.#look);
    }
    const material = new MeshLambertMaterial({ vertexColors: true, transparent: true });
    const mesh = new Mesh(faces.geometry(), material);
    mesh.receiveShadow = true;
    this.root.add(mesh);
    const upper = { wall, mesh, glass: this.#glass(wall, windows), opacity };
    setOpacity(upper, opacity);
    return upper;
  }

  #glass(wall: Wall, windows: readonly Panel[]): Upper["glass"] {
    if (windows.length === 0) {
      return null;
    }
    const faces = new Faces();
    for (const window of windows) {
      addGlass(faces, wall, window, this.#look);
    }
    const material = new MeshBasicMaterial({
      vertexColors: true,
      transparent: true,
      toneMapped: false,
    });
    const mesh = new Mesh(faces.geometry(), material);
    this.root.add(mesh);
    return mesh;
  }

  #clear(): void {
    for (const mesh of this.#fixed) {
      mesh.removeFromParent();
      mesh.geometry.dispose();
    }
    for (const { mesh, glass } of this.#uppers) {
      for (const part of glass ? [mesh, glass] : [mesh]) {
        part.removeFromParent();
        part.geometry.dispose();
        part.material.dispose();
      }
    }
    this.#fixed = [];
    this.#uppers = [];
  }
}

function setOpacity({ mesh, glass }: Upper, opacity: number): void {
  mesh.material.opacity = opacity;
  mesh.material.depthWrite = opacity === 1;
  mesh.visible = opacity > 0;
  if (glass) {
    glass.material.opacity = opacity;
    glass.visible = opacity > 0;
  }
}

/**
 * Whether the wall would hide the room: the eye sees it from outside, or so much from the side
 * that there is nothing to see on it. For an eye within the room only the first counts.
 */
function isInTheWay(wall: Wall, eye: Vector3, within: boolean): boolean {
  const half = wall.length / 2;
  const x = eye.x - wall.start[0] - wall.along[0] * half;
  const y = eye.y - wall.start[1] - wall.along[1] * half;
  const out = x * wall.outward[0] + y * wall.outward[1];
  return within ? out > MARGIN : out > -SIDEWAYS * Math.hypot(x, y);
}
