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

/** A quarter of the pipe as facets of 1 cm along its bend. */
function facets() {
  const [points, places, triangles] = [[], [], []];
  for (let i = 0; i <= 80; i++) {
    for (const y of [-0.3, 0, 0.3]) {
      const x = 0.01 * (i - 40);
      places.push(x, y);
      points.push(...lift(pipe, x, y, 0));
      if (i > 0 && y > -0.3) {
        const corner = places.length / 2 - 1;
        triangles.push(corner - 4, corner - 1, corner, corner - 4, corner, corner - 3);
      }
    }
  }
  return { kind: "mesh", points, places, triangles };
}

test("the chart of a mesh lies where the surface does", () => {
  const mesh = facets();
  for (const [x, y, height] of [[-0.31, 0.1, 0.05], [0.123, -0.2, 0], [0.4, 0.3, 0.1]]) {
    const [found, wanted] = [lift(mesh, x, y, height), lift(pipe, x, y, height)];
    assert.ok(Math.hypot(...found.map((at, i) => at - wanted[i])) < 1e-3, `${found} instead of ${wanted}`);
  }
  // Beyond the border, it goes on straight.
  const beyond = lift(mesh, 0.42, 0, 0);
  assert.ok(Math.hypot(...beyond.map((at, i) => at - lift(pipe, 0.42, 0, 0)[i])) < 2e-3);
  const surface = { pose: [1, 0, 0, 0, 0, 0, 1], rings: [], shape: mesh };
  assert.ok(normalUnder(surface, new Vector3(0.7, 0.2, 0.4)).angleTo(normalUnder({ ...surface, shape: pipe }, new Vector3(0.7, 0.2, 0.4))) < 0.02);
  const face = liftGeometry(mesh, new PlaneGeometry(0.6, 0.4)).getAttribute("position");
  assert.ok(face.count > 1000 && face.count < 20000, `${face.count}`);
  for (let i = 0; i < face.count; i++) assert.ok(Math.abs(fromAxis([face.getX(i), face.getY(i), face.getZ(i)], pipe) - 0.5) < 1e-4);
});
