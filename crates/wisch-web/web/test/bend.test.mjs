// Positions that are lifted onto a cylinder.
import assert from "node:assert/strict";
import test from "node:test";
import { PlaneGeometry, Vector3 } from "three";
import { lift, liftGeometry, liftLine, normalUnder } from "../src/scene/bend.ts";

const pipe = { kind: "cylinder", radius_m: 0.5, axis_rad: Math.PI / 2 };
const near = (found, wanted) => found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-6, `${found} instead of ${wanted}`));
/** Distance from the axis of a cylinder along y [m]. */
const fromAxis = ([x, , z], { radius_m }) => Math.hypot(x, z + radius_m);

test("a quarter turn about a pipe ends at its side", () => {
  near(lift(pipe, -0.25 * Math.PI, 0.3, 0.1), [-0.6, 0.3, -0.5]);
  near(lift(null, 0.2, 0.3, 0.1), [0.2, 0.3, 0.1]);
  const hollow = { ...pipe, radius_m: -0.5 };
  near(lift(hollow, 0.25 * Math.PI, 0, 0.1), [0.4, 0, 0.5]);
});

test("normals point away from the axis, and into a hollow", () => {
  const surface = (shape) => ({ pose: [1, 0, 0, 0, 0, 0, 1], rings: [], shape });
  near(normalUnder(surface(pipe), new Vector3(1.6, 0.2, -0.5)).toArray(), [1, 0, 0]);
  near(normalUnder(surface({ ...pipe, radius_m: -0.5 }), new Vector3(1.4, 0, 0.5)).toArray(), [-1, 0, 0]);
  near(normalUnder(surface(null), new Vector3(3, 0, -2)).toArray(), [0, 0, 1]);
});

test("lines and faces follow the surface between their corners", () => {
  const ring = liftLine(pipe, [[-0.4, 0, 0], [0.4, 0, 0], [0.4, 0.1, 0]], true);
  assert.ok(ring.length > 60);
  for (const corner of ring) assert.ok(Math.abs(fromAxis(corner, pipe) - 0.5) < 1e-9);
  const face = liftGeometry(pipe, new PlaneGeometry(0.8, 0.4)).getAttribute("position");
  assert.ok(face.count >= 190 && face.count < 1000, `${face.count}`);
  for (let i = 0; i < face.count; i++) assert.ok(Math.abs(fromAxis([face.getX(i), face.getY(i), face.getZ(i)], pipe) - 0.5) < 1e-6);
});
