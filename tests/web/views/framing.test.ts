import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { toPage } from "../../../web/src/model/frames";
import type { RoomRecord } from "../../../web/src/net/protocol.gen";
import { frameRoom, freePart, viewDirection } from "../../../web/src/views/framing";

const ROOM: RoomRecord = {
  corners: [
    [0, 0],
    [6, 0],
    [6, 2],
    [4, 2],
    [4, 4],
    [0, 4],
  ],
  height: 2.6,
  doors: [],
  windows: [],
  room_type: "",
};
const FOV = 36;

/** Where a floor corner lands in the picture, by three's own camera: −1 to 1 is in view. */
function seen(aspect: number) {
  const direction = viewDirection(ROOM, aspect);
  const { position, target } = frameRoom(ROOM, direction, (FOV * Math.PI) / 180, aspect);
  const camera = new PerspectiveCamera(FOV, aspect, 0.1, 100);
  camera.position.set(...toPage(position));
  camera.lookAt(...toPage(target));
  camera.updateMatrixWorld();
  return ROOM.corners.map(([x, y]) => new Vector3(...toPage([x, y, 0])).project(camera));
}

describe("the first view", () => {
  it.each([
    ["an upright phone", 412 / 640],
    ["a desk with panels", 1050 / 820],
    ["a wide screen", 2.2],
  ])("has the whole floor in the picture of %s", (_name, aspect) => {
    for (const { x, y } of seen(aspect)) {
      expect(Math.abs(x)).toBeLessThan(1);
      expect(Math.abs(y)).toBeLessThan(1);
    }
  });

  it("fills the picture rather than lying lost in it", () => {
    const xs = seen(412 / 640).map(({ x }) => x);
    expect(Math.max(...xs) - Math.min(...xs)).toBeGreaterThan(1.2);
  });

  it("looks along the room on an upright screen", () => {
    const [dx, dy] = viewDirection(ROOM, 0.5);
    expect(Math.abs(dx)).toBeGreaterThan(Math.abs(dy));
  });
});

describe("the free part of the picture", () => {
  it("is what the panels leave", () => {
    expect(freePart(1440, 900, { left: 72, right: 320, top: 56, bottom: 0 })).toEqual({
      x: 72,
      y: 56,
      width: 1048,
      height: 844,
    });
  });

  it("keeps a quarter of the height when a sheet covers everything", () => {
    const free = freePart(400, 800, { left: 0, right: 0, top: 0, bottom: 800 });
    expect(free.height).toBe(200);
    expect(free.y).toBe(0);
  });
});
