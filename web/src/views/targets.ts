/** What a pointer points at. Pure; core frame. */
import { topOf } from "../model/footprints";
import { distance, nearestOn } from "../model/geometry";
import { ghostBox } from "../model/ghost";
import { hangs, turnedTo } from "../model/hanging";
import { shownMaps } from "../model/showing";
import type { HeatMap, Point, Probe, State, Vector3 } from "../model/state";
import type { BoxRecord, OpeningRecord } from "../net/protocol.gen";
import { likelihoodOf, placeOnMap, valueAt } from "./heat_layout";
import { firstBox, meetBox, meetFloor, meetLevel, meetWall, pointOn, type Ray } from "./picking";

export type Target =
  | { readonly kind: "ghost"; readonly box: BoxRecord; readonly distance: number }
  | { readonly kind: "alternative"; readonly rank: number }
  | { readonly kind: "box"; readonly box: BoxRecord; readonly distance: number }
  | {
      readonly kind: "opening";
      readonly opening: "door" | "window";
      readonly value: OpeningRecord;
    };

const GROWN = 0.04; // metres that thin things are easier to hit by
const ON_PLAN = 0.25; // metres from its wall that a door is hit from above
const FLAT = 0.3; // height of what counts as an alternative's place, metres

/** The first thing on the ray; null for the bare room. */
export function targetAt(state: State, ray: Ray): Target | null {
  const ghost = ghostBox(state);
  const ghostDistance = ghost && meetBox(ray, ghost, GROWN);
  const inSight = state.scene.boxes.filter(
    (box) => !hangs(box, state.scene) || turnedTo(box, ray.origin) > 0,
  );
  const first = firstBox(ray, inSight);
  const nearer = first === null || (ghostDistance !== null && ghostDistance <= first.distance);
  if (ghost && ghostDistance !== null && nearer) {
    return { kind: "ghost", box: ghost, distance: ghostDistance };
  }
  const rank = alternativeAt(state, ray, first?.distance ?? Number.POSITIVE_INFINITY);
  if (rank !== null) {
    return { kind: "alternative", rank };
  }
  if (first) {
    return { kind: "box", ...first };
  }
  return openingAt(state, ray);
}

function alternativeAt(state: State, ray: Ray, limit: number): number | null {
  const { placing } = state;
  if (placing?.mode !== "scenegen") {
    return null;
  }
  const { category, size } = placing;
  const [depth, width, height] = size;
  let best: { rank: number; distance: number } | null = null;
  for (const { rank, center, heading } of placing.answer?.placements ?? []) {
    const low = hangs({ id: "", category, center, size }, state.scene)
      ? height
      : Math.min(FLAT, height);
    const foot: Vector3 = [center[0], center[1], center[2] - height / 2 + low / 2];
    const flat = {
      id: "",
      category,
      center: foot,
      size: [depth, width, low],
      heading,
    } as const;
    const reached = rank === placing.alternative ? null : meetBox(ray, flat);
    if (reached !== null && reached < limit && (best === null || reached < best.distance)) {
      best = { rank, distance: reached };
    }
  }
  return best?.rank ?? null;
}

/** The door or window where the ray meets a wall, or beside which it meets the floor. */
function openingAt(state: State, ray: Ray): Target | null {
  const { room } = state.scene;
  const hit = meetWall(ray, room);
  const floor = meetLevel(ray, 0);
  const near = (opening: OpeningRecord, at: Point) =>
    distance(at, nearestOn(at, [opening.start, opening.end]));
  const isHit = (opening: OpeningRecord) =>
    (hit !== null &&
      near(opening, [hit.at[0], hit.at[1]]) < 0.02 &&
      hit.at[2] >= opening.bottom &&
      hit.at[2] <= opening.top) ||
    (floor !== null && near(opening, floor) < ON_PLAN && (hit === null || opening.bottom === 0));
  const door = room.doors.find(isHit);
  if (door) {
    return { kind: "opening", opening: "door", value: door };
  }
  const window = room.windows.find(isHit);
  return window ? { kind: "opening", opening: "window", value: window } : null;
}

/** The value of the heat map under the ray; null where no map lies. */
export function probeAt(state: State, ray: Ray): Probe | null {
  for (const map of shownMaps(state)) {
    const probe = probeMap(state, ray, map);
    if (probe) {
      return probe;
    }
  }
  return null;
}

function probeMap(state: State, ray: Ray, map: HeatMap): Probe | null {
  const { room, boxes } = state.scene;
  const probe = (at: Vector3, wall: number): Probe => ({
    surface: map.surface,
    at,
    likelihood: likelihoodOf(valueAt(map, placeOnMap(map, room, at, wall))),
  });
  switch (map.surface) {
    case "floor": {
      const at = meetFloor(ray, room);
      return at && probe([at[0], at[1], 0], 0);
    }
    case "tops": {
      const hit = firstBox(ray, boxes);
      const [x, y] = hit ? pointOn(ray, hit.distance) : [0, 0];
      return hit && probe([x, y, topOf(hit.box)], 0);
    }
    case "walls": {
      const hit = meetWall(ray, room);
      return hit && probe(hit.at, hit.wall);
    }
  }
}
