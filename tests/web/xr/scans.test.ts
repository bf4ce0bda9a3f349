import { describe, expect, test } from "vitest";
import { toCore } from "../../../web/src/model/frames";
import { outlineProblem } from "../../../web/src/model/outlines";
import type { Vector3 } from "../../../web/src/model/state";
import type { BoxRecord, SceneRecord } from "../../../web/src/net/protocol.gen";
import { foundIn, type Piece } from "../../../web/src/xr/found";
import { room } from "../rooms";

/** Scans of real rooms, as a headset knows them; what our own importer makes of them is the oracle. */
const SCANS = ["living_room", "meeting_room", "music_room", "office_large", "office_small"];

/** What WebXR calls the labels of the scans (there is no word for chairs). */
const LABELS: Readonly<Record<string, string>> = {
  BED: "bed",
  CHAIR: "couch",
  COUCH: "couch",
  FLOOR: "floor",
  LAMP: "lamp",
  OTHER: "other",
  PLANT: "plant",
  SCREEN: "screen",
  STORAGE: "shelf",
  TABLE: "table",
  WALL_ART: "wall art",
};

interface Entity {
  readonly semanticLabel_META: string;
  readonly locatable_META: {
    readonly position: Record<"x" | "y" | "z", number>;
    readonly orientation: Record<"x" | "y" | "z" | "w", number>;
  };
  readonly bounded2D_META?: {
    readonly offset: Record<"x" | "y", number>;
    readonly extent: Record<"width" | "height", number>;
  };
  readonly bounded3D_META?: {
    readonly offset: Record<"x" | "y" | "z", number>;
    readonly extent: Record<"width" | "height" | "depth", number>;
  };
}

function pieceOf(entity: Entity): Piece {
  const { bounded2D_META: flat, bounded3D_META: solid } = entity;
  const label = LABELS[entity.semanticLabel_META] ?? "";
  if (solid !== undefined) {
    const { offset, extent } = solid;
    const corners = [0, 1].flatMap((i) =>
      [0, 1].flatMap((j) =>
        [0, 1].map(
          (k): Vector3 => [
            offset.x + i * extent.width,
            offset.y + j * extent.height,
            offset.z + k * extent.depth,
          ],
        ),
      ),
    );
    return { label, flat: false, points: corners.map((corner) => placed(entity, corner)) };
  }
  if (flat === undefined) return { label: "", flat: true, points: [] };
  const { offset, extent } = flat;
  const corners: readonly Vector3[] = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ].map(([i = 0, j = 0]) => [offset.x + i * extent.width, 0, offset.y + j * extent.height]);
  return { label, flat: true, points: corners.map((corner) => placed(entity, corner)) };
}

/** Turned by the quaternion (v + 2w(q×v) + 2q×(q×v)), shifted, and in the core's axes. */
function placed({ locatable_META: { position, orientation } }: Entity, v: Vector3): Vector3 {
  const q: Vector3 = [orientation.x, orientation.y, orientation.z];
  const once = crossed(q, v).map((part) => 2 * part) as unknown as Vector3;
  const twice = crossed(q, once);
  const shift = [position.x, position.y, position.z];
  return toCore(
    [0, 1, 2].map(
      (i) => (v[i] ?? 0) + orientation.w * (once[i] ?? 0) + (twice[i] ?? 0) + (shift[i] ?? 0),
    ) as unknown as Vector3,
  );
}

function crossed(a: Vector3, b: Vector3): Vector3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

const THIN = 0.04; // metres
const CLOSE = 0.015; // metres; the importer takes turns of less than half a degree for none
const CAPTURES = import.meta.glob<{ readonly spatialEntities: readonly Entity[] }>(
  "../../../node_modules/@iwer/sem/captures/*.json",
  { eager: true, import: "default" },
);
const IMPORTED = import.meta.glob<SceneRecord>("../../../web/public/rooms/scans/*.json", {
  eager: true,
  import: "default",
});

describe.each(SCANS)("the scan %s", (name) => {
  const { spatialEntities } = ending(CAPTURES, `/${name}.json`);
  const scan = ending(IMPORTED, `/scan-${name.replace("_", "-")}.json`);
  const pieces = spatialEntities.map(pieceOf);
  const level = pieces.find(({ label }) => label === "floor")?.points[0]?.[2] ?? 0;
  const found = foundIn(
    pieces.map((piece) => ({
      ...piece,
      points: piece.points.map(([x, y, z]): Vector3 => [x, y, z - level]),
    })),
    room().room,
  );

  test("has every piece that our importer finds in it, to the centimeter", () => {
    const left = [...(found?.boxes ?? [])];
    for (const box of scan.boxes) {
      const at = left.findIndex((one) => one.category === box.category && isAlike(one, box));
      expect(at, `${box.category} of ${box.size.join(" × ")} m`).not.toBe(-1);
      left.splice(at, 1);
    }
  });

  test("has an outline that makes a room", () => {
    expect(outlineProblem(found?.corners ?? [])).toBeNull();
  });
});

/** As long, as wide and as tall; pictures are as thin as each likes. */
function isAlike(one: BoxRecord, other: BoxRecord): boolean {
  const sides = ({ size }: BoxRecord): readonly number[] =>
    [...size].sort((a, b) => a - b).map((side) => Math.max(side, THIN));
  return sides(one).every((side, i) => Math.abs(side - (sides(other)[i] ?? 0)) < CLOSE);
}

function ending<Value>(files: Readonly<Record<string, Value>>, end: string): Value {
  const path = Object.keys(files).find((one) => one.endsWith(end)) ?? "";
  return files[path] as Value;
}
