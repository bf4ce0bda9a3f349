import { type DataTexture, ShaderMaterial, Vector2 } from "three";

const VERTEX = /* glsl */ `
  attribute vec2 place;
  varying vec2 at;
  varying vec2 where;
  void main() {
    at = uv;
    where = place;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

/**
 * Values are blended only among cells where one can stand, so that the forbidden ones do not
 * darken their neighbors; the edge between the two follows the line halfway and stays sharp.
 * Alpha rises with the value, so that the best spots are the brightest; a thin line runs where
 * the allowed ground ends, and a pale one round the likely part of it.
 */
const FRAGMENT = /* glsl */ `
  const float FAINT = 0.3; // opacity where it can stand but hardly would
  const float STRONG = 1.2; // the brightest part is whole
  const float LIKELY = 0.6; // as in the words of the legend
  uniform sampler2D map;
  uniform sampler2D colors;
  uniform vec2 cells;
  uniform float opacity;
  uniform float clock;
  uniform float shimmer;
  uniform vec2 source;
  uniform float front;
  varying vec2 at;
  varying vec2 where;

  float cell(ivec2 place) {
    ivec2 last = ivec2(cells) - 1;
    return texelFetch(map, clamp(place, ivec2(0), last), 0).r;
  }

  void main() {
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) discard;
    vec2 place = at * cells - 0.5;
    ivec2 low = ivec2(floor(place));
    vec2 part = place - floor(place);
    vec4 values = vec4(
      cell(low), cell(low + ivec2(1, 0)), cell(low + ivec2(0, 1)), cell(low + ivec2(1, 1)));
    vec4 weights = vec4(
      (1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y),
      (1.0 - part.x) * part.y, part.x * part.y);
    vec4 free = step(0.5 / 255.0, values);
    float coverage = dot(weights, free);
    float soft = clamp(fwidth(coverage), 0.01, 0.5);
    float allowed = smoothstep(0.5 - soft, 0.5 + soft, coverage);
    if (allowed <= 0.0) discard;
    float value = (dot(weights * free, values) / max(coverage, 0.001) * 255.0 - 1.0) / 254.0;
    value = clamp(value, 0.0, 1.0);
    float alpha = mix(FAINT, STRONG, smoothstep(0.0, 0.85, value));
    vec3 color = texture2D(colors, vec2(value * 0.996 + 0.002, 0.5)).rgb;
    float rim = 1.0 - smoothstep(0.0, 1.6, (coverage - 0.5) / max(fwidth(coverage), 0.001));
    alpha = max(alpha, rim * 0.55);
    float line = abs(value - LIKELY) / max(fwidth(value), 0.0005);
    float contour = (1.0 - smoothstep(0.6, 1.6, line)) * step(fwidth(value), 0.12);
    color = mix(color, vec3(1.0), contour * 0.45);
    alpha = max(alpha, contour * 0.6);
    float band = sin(dot(where, vec2(1.6, 1.1)) * 1.4 - clock * 3.2);
    alpha *= 1.0 - shimmer * 0.3 * (0.5 + 0.5 * band);
    float distance = length(where - source);
    alpha *= 1.0 - smoothstep(front - 0.6, front, distance);
    gl_FragColor = vec4(color, min(1.0, alpha * opacity) * allowed);
    #include <colorspace_fragment>
  }`;

/** What colors a heat map; palette, opacity and motion change without the server. */
export class HeatMaterial extends ShaderMaterial {
  readonly #source: Vector2;

  constructor(map: DataTexture, colors: DataTexture, cells: Vector2) {
    const source = new Vector2();
    super({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
      toneMapped: false,
      uniforms: {
        map: { value: map },
        colors: { value: colors },
        cells: { value: cells },
        opacity: { value: 1 },
        clock: { value: 0 },
        shimmer: { value: 0 },
        source: { value: source },
        front: { value: 0 },
      },
    });
    this.#source = source;
  }

  /** Sets one of the numbers that change from frame to frame. */
  set(name: "opacity" | "clock" | "shimmer" | "front", value: number): void {
    const uniform = this.uniforms[name];
    if (uniform) {
      uniform.value = value;
    }
  }

  /** Where the wash begins, in the plane of the map, metres. */
  washFrom([x, y]: readonly [number, number]): void {
    this.#source.set(x, y);
  }
}
