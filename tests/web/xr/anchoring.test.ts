import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Anchoring, turnOfView } from "../../../web/src/xr/anchoring";

/** A pose in the frame of the device. */
interface Pose {
  readonly position: { readonly x: number; readonly y: number; readonly z: number };
  readonly orientation: { readonly y: number; readonly w: number };
}

class Transform implements Pose {
  readonly position: Pose["position"];
  readonly orientation: Pose["orientation"];

  constructor(position: Pose["position"], orientation: Pose["orientation"]) {
    this.position = position;
    this.orientation = orientation;
  }
}

beforeEach(() => vi.stubGlobal("XRRigidTransform", Transform));
afterEach(() => vi.unstubAllGlobals());

/** A device that makes an anchor when told to, and learns where it really stands. */
function device() {
  const offsets: Pose[] = [];
  const asked: { pose: Pose; arrive(): Promise<void>; deleted: boolean }[] = [];
  const base = {
    getOffsetReferenceSpace: (offset: Pose) => {
      offsets.push(offset);
      return { offset };
    },
  } as unknown as XRReferenceSpace;
  const frame = {
    createAnchor(pose: Pose) {
      let resolve = (_: unknown): void => {};
      const promise = new Promise<unknown>((done) => {
        resolve = done;
      });
      const record = {
        pose,
        deleted: false,
        async arrive() {
          resolve({
            anchorSpace: record,
            delete: () => {
              record.deleted = true;
            },
          });
          await promise;
        },
      };
      asked.push(record);
      return promise;
    },
    getPose: (space: { pose: Pose }) => ({ transform: space.pose }),
  } as unknown as XRFrame;
  return { base, frame, asked, offsets };
}

const at = (x: number): Pose => ({ position: { x, y: 0, z: 0 }, orientation: { y: 0, w: 1 } });
const last = (offsets: readonly Pose[]): number | undefined => offsets.at(-1)?.position.x;

test("the room follows its anchor when the device learns better", async () => {
  const { base, frame, asked, offsets } = device();
  const anchoring = new Anchoring(base, true, () => {});
  anchoring.stand([1, 0, 0], 0);
  anchoring.update(frame);
  await asked[0]?.arrive();
  anchoring.update(frame);
  expect(offsets).toHaveLength(1); // nothing has moved
  if (asked[0]) asked[0].pose = at(1.05);
  anchoring.update(frame);
  expect(last(offsets)).toBe(1.05);
});

test("an anchor that comes after the room was moved on is let go", async () => {
  const { base, frame, asked, offsets } = device();
  const anchoring = new Anchoring(base, true, () => {});
  anchoring.stand([1, 0, 0], 0);
  anchoring.update(frame);
  anchoring.move({ at: [2, 0], turn: 0 });
  anchoring.update(frame);
  await asked[1]?.arrive();
  await asked[0]?.arrive();
  anchoring.update(frame);
  expect(last(offsets)).toBe(3);
  expect(asked.map(({ deleted }) => deleted)).toEqual([true, false]);
  anchoring.dispose();
  expect(asked[1]?.deleted).toBe(true);
});

test("without anchors the room stays where it was put", () => {
  const { base, frame, asked, offsets } = device();
  const anchoring = new Anchoring(base, false, () => {});
  anchoring.stand([1, 0, 0], 0);
  anchoring.update(frame);
  expect(asked).toEqual([]);
  expect(last(offsets)).toBe(1);
});

test("a new room lies before the person: its y axis points where the view does", () => {
  // A view along the device's −z (its pose is not turned at all) looks along the core's +y.
  const straight = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  expect(turnOfView({ matrix: straight })).toBeCloseTo(0, 9);
  // Turned to the left by a quarter, it looks along the device's −x.
  const left = new Float32Array([0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]);
  expect(turnOfView({ matrix: left })).toBeCloseTo(Math.PI / 2, 9);
});
