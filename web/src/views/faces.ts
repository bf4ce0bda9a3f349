import { BufferAttribute, BufferGeometry, Color } from "three";

type Corner = readonly [number, number, number];

/** Flat colored faces, gathered and then made into one geometry: one draw call. */
export class Faces {
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #colors: number[] = [];
  readonly #color = new Color();

  /** A flat four-sided face, corners anticlockwise as seen from its front. */
  quad(a: Corner, b: Corner, c: Corner, d: Corner, ...colors: readonly string[]): void {
    const normal = normalOf(a, b, d);
    const paint = [0, 1, 2, 3].map((i) => colors[i] ?? colors[0] ?? "#ffffff");
    const corners = [a, b, c, d];
    for (const i of [0, 1, 2, 0, 2, 3]) {
      this.#positions.push(...(corners[i] ?? a));
      this.#normals.push(...normal);
      this.#color.set(paint[i] ?? "#ffffff");
      this.#colors.push(this.#color.r, this.#color.g, this.#color.b);
    }
  }

  /** A block between two values of each of three axes that `at` maps to points. */
  block(
    at: (u: number, v: number, w: number) => Corner,
    [u0, u1]: readonly [number, number],
    [v0, v1]: readonly [number, number],
    [w0, w1]: readonly [number, number],
    color: string,
  ): void {
    this.quad(at(u0, v0, w0), at(u1, v0, w0), at(u1, v0, w1), at(u0, v0, w1), color);
    this.quad(at(u1, v1, w0), at(u0, v1, w0), at(u0, v1, w1), at(u1, v1, w1), color);
    this.quad(at(u0, v1, w0), at(u0, v0, w0), at(u0, v0, w1), at(u0, v1, w1), color);
    this.quad(at(u1, v0, w0), at(u1, v1, w0), at(u1, v1, w1), at(u1, v0, w1), color);
    this.quad(at(u0, v0, w1), at(u1, v0, w1), at(u1, v1, w1), at(u0, v1, w1), color);
    this.quad(at(u0, v1, w0), at(u1, v1, w0), at(u1, v0, w0), at(u0, v0, w0), color);
  }

  /** The geometry of all faces so far. */
  geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", floats(this.#positions));
    geometry.setAttribute("normal", floats(this.#normals));
    geometry.setAttribute("color", floats(this.#colors));
    return geometry;
  }
}

function floats(values: readonly number[]): BufferAttribute {
  return new BufferAttribute(new Float32Array(values), 3);
}

function normalOf(a: Corner, b: Corner, d: Corner): Corner {
  const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [vx, vy, vz] = [d[0] - a[0], d[1] - a[1], d[2] - a[2]];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}
