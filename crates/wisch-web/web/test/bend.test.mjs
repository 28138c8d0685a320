// Positions that are lifted onto a cylinder, a cone or a mesh.
import assert from "node:assert/strict";
import test from "node:test";
import { PlaneGeometry, Vector3 } from "three";
import { lift, liftGeometry, liftLine, normalUnder } from "../src/scene/bend.ts";
import { cutDashes } from "../src/scene/lines.ts";

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

/** Widens along x; its apex is 2 m before the origin. */
const funnel = (side) => ({ kind: "cone", radius_m: side * 2 * Math.sin(0.4), half_angle_rad: 0.4, axis_rad: 0 });

test("a cone keeps distances from its apex, and its lines are straight", () => {
  for (const side of [1, -1]) {
    const cone = funnel(side);
    near(lift(cone, 0, 0, 0.1), [0, 0, 0.1]);
    near(lift(cone, 0.5, 0, 0), [0.5, 0, 0]);
    for (const [x, y] of [[0.3, 0.4], [-0.5, -0.6], [1, 1.2]]) {
      const [px, py, pz] = lift(cone, x, y, 0);
      assert.ok(Math.abs(Math.hypot(px + 2, py, pz) - Math.hypot(x + 2, y)) < 1e-9);
      // The line through the apex lifts to a line, and the normal is at right angles to it.
      const [qx, qy, qz] = lift(cone, 2 * x + 2, 2 * y, 0);
      near([qx, qy, qz], [2 * px + 2, 2 * py, 2 * pz]);
      const above = lift(cone, x, y, 0.1);
      const surface = { pose: [0, 0, 0, 0, 0, 0, 1], rings: [], shape: cone };
      const normal = normalUnder(surface, new Vector3(...above));
      near(above, [px + 0.1 * normal.x, py + 0.1 * normal.y, pz + 0.1 * normal.z]);
      assert.ok(Math.abs(normal.dot(new Vector3(px + 2, py, pz))) < 1e-9);
      // Height over the axis, whose direction leans away from the surface.
      const axis = [Math.cos(0.4), 0, -side * Math.sin(0.4)];
      const on = (px + 2) * axis[0] + pz * axis[2];
      assert.ok(Math.abs(on / Math.hypot(px + 2, py, pz) - Math.cos(0.4)) < 1e-9);
    }
  }
});

test("faces of a cone are cut along its lines", () => {
  const cone = funnel(1);
  const flat = new PlaneGeometry(0.8, 1.6);
  const face = liftGeometry(cone, flat).getAttribute("position");
  assert.ok(face.count >= 150 && face.count < 2000, `${face.count}`);
  let area = 0;
  for (let i = 0; i < face.count; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => new Vector3(face.getX(i + k), face.getY(i + k), face.getZ(i + k)));
    area += b.clone().sub(a).cross(c.clone().sub(a)).length() / 2;
    const middle = a.clone().add(b).add(c).divideScalar(3);
    const off = Math.acos(((middle.x + 2) * Math.cos(0.4) - middle.z * Math.sin(0.4)) / Math.hypot(middle.x + 2, middle.y, middle.z)) - 0.4;
    assert.ok(Math.abs(off) < 1e-3, `${off}`);
  }
  // It unrolls without stretch.
  assert.ok(Math.abs(area - 1.28) < 1e-3, `${area}`);
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

test("dashes keep their pattern across corners", () => {
  const cut = cutDashes([0, 0, 0, 0.04, 0, 0, 0.04, 0, 0, 0.04, 0.035, 0], [0.015, 0.01]);
  const dashes = Array.from({ length: cut.length / 6 }, (_, i) => cut.slice(6 * i, 6 * i + 6).map((v) => Math.round(1000 * v)));
  assert.deepEqual(dashes, [[0, 0, 0, 15, 0, 0], [25, 0, 0, 40, 0, 0], [40, 10, 0, 40, 25, 0]]);
});

test("a tiny radius, or a line across a wide mesh, has no more parts than can be drawn", () => {
  for (const shape of [{ ...pipe, radius_m: 1e-9 }, { kind: "cone", radius_m: 1e-9, half_angle_rad: 1e-6, axis_rad: 0 }, { ...facets(), points: [0, 0, 0, 1e6, 0, 0, 0, 1e6, 0], places: [0, 0, 1e6, 0, 0, 1e6], triangles: [0, 1, 2] }]) {
    const side = shape.kind === "mesh" ? 1e6 : 0.3;
    const ring = liftLine(shape, [[0, 0, 0], [side, 0, 0], [side, side, 0]], true);
    assert.ok(ring.length <= 1500, `${shape.kind}: ${ring.length}`);
    const { count } = liftGeometry(shape, new PlaneGeometry(side, side)).getAttribute("position");
    assert.ok(count < 60000, `${shape.kind}: ${count}`);
  }
});
