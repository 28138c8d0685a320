// The force along the path, and arrows of pushes.
import assert from "node:assert/strict";
import test from "node:test";
import { Vector3 } from "three";
import { Path } from "../src/scene/path.ts";
import { makeArrow, strongestSample } from "../src/scene/marks.ts";
import { lift } from "../src/scene/bend.ts";
import { Recording } from "../src/store.ts";
import { sample } from "./sample.mjs";

globalThis.document = { documentElement: {} };
globalThis.getComputedStyle = () => ({ getPropertyValue: () => "#123456" });

const pieces = sample();
const plan = pieces.find(({ piece }) => piece === "round");
const pipe = { kind: "cylinder", radius_m: 0.5, axis_rad: Math.PI / 2 };

/** A round whose tool follows x [m] at places with a normal force [N], a height [m] and a force across [N]. */
function roundOf(samples, change = {}) {
  const recording = new Recording();
  const surface = { ...plan.surface, pose: [0, 0, 0, 0, 0, 0, 1], ...change.surface };
  recording.apply(pieces[0]);
  recording.apply({ ...plan, phases: [], ...change, surface });
  const each = (of) => samples.map(of);
  recording.apply({
    piece: "samples", round: 1, t: each((_, i) => i / 10), q: {}, normal: each(({ force = 0 }) => force), height: each(({ height = 0 }) => height),
    tool: each(({ x, height = 0 }) => [...lift(surface.shape, x, 0, height), 0, 0, 0, 1]).flat(), force: each(({ force = 0, across = 0 }) => [0, across, force]).flat(),
  });
  assert.equal(recording.broken, 0);
  recording.close();
  return recording.rounds[0];
}

function ribbonOf(round) {
  const path = new Path(round);
  path.show(1e9, { path: true, ribbon: true });
  return path.ribbon;
}

/** Corners of a segment. */
const cornersOf = ({ mesh }, i) => [0, 1, 2, 3].map((k) => new Vector3().fromBufferAttribute(mesh.geometry.getAttribute("position"), 4 * i + k));

const forces = [0, 8, 8, 8, 8, 12, 12, 4, 4, 4, 0, 0, 0, 0, 8, 8, 8, 8].map((force, i) => ({ x: 0.01 * i, force }));

test("the band breaks where contact is lost, and its degrees compare the force with the target", () => {
  const ribbon = ribbonOf(roundOf(forces));
  assert.deepEqual(ribbon.degrees, [1, 1, 1, 2, 2, 0, 0, 0, 1, 1, 1]);
  assert.deepEqual(ribbon.times.map((t) => Math.round(10 * t)), [2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 17]);
  const widths = ribbon.degrees.map((_, i) => cornersOf(ribbon, i)[2].distanceTo(cornersOf(ribbon, i)[3]));
  assert.ok(Math.abs(widths[4] / widths[1] - 1.5) < 1e-6 && Math.abs(widths[7] / widths[1] - 0.5) < 1e-6, `${widths}`);
});

test("an unmeasured force is no force of 0 N", () => {
  const ribbon = ribbonOf(roundOf(forces.map((one, i) => (i === 3 ? { ...one, force: null } : one)), { kind: "logged", contacts: [[0.1, 0.9]] }));
  assert.deepEqual(ribbon.degrees, [1, 2, 2, 0, 0, 0]);
  assert.ok([...ribbon.mesh.geometry.getAttribute("position").array].every(Number.isFinite));
});

test("without a known target no degree is stated", () => {
  for (const press_force of [undefined, null, -3]) assert.ok(ribbonOf(roundOf(forces, { press_force })).degrees.every((degree) => degree === 3));
});

test("a peak while the tool rests belongs to the next segment", () => {
  const [first, second] = ribbonOf(roundOf([[0, 8], [0, 13], [0, 8], [0.01, 8], [0.02, 8]].map(([x, force]) => ({ x, force })))).degrees;
  assert.deepEqual([first, second], [2, 1]);
});

test("the band lies on a curved surface, whatever the height of the tool", () => {
  const rows = Array.from({ length: 31 }, (_, i) => 0.01 * i - 0.05);
  const mesh = {
    kind: "mesh", points: rows.flatMap((x) => [...lift(pipe, x, -0.1, 0), ...lift(pipe, x, 0.1, 0)]), places: rows.flatMap((x) => [x, -0.1, x, 0.1]),
    triangles: rows.slice(1).flatMap((_, i) => [2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3]),
  };
  for (const shape of [pipe, mesh, { kind: "cone", radius_m: 0.8, half_angle_rad: 0.4, axis_rad: 0 }]) {
    const ribbon = ribbonOf(roundOf(forces.map((one) => ({ ...one, height: 0.006 })), { surface: { shape } }));
    assert.ok(ribbon.degrees.length > 5);
    const middle = cornersOf(ribbon, 3).slice(2).reduce((sum, corner) => sum.addScaledVector(corner, 0.5), new Vector3());
    assert.ok(middle.distanceTo(new Vector3(...lift(shape, 0.05, 0, 0))) < 0.003, `${middle.toArray()}`);
  }
});

test("the selected part is lit, also after the shown time", () => {
  const path = new Path(roundOf(forces));
  const counts = (time) => {
    path.show(time, { path: true, ribbon: true });
    const { mesh } = path.ribbon;
    const drawn = mesh.visible ? mesh.geometry.drawRange.count / 6 : 0;
    const opacities = mesh.geometry.getAttribute("color");
    return { drawn, lit: Array.from({ length: drawn }, (_, i) => opacities.getW(4 * i)).filter((opacity) => opacity === 1).length };
  };
  assert.deepEqual(counts(0.45), { drawn: 3, lit: 3 });
  path.ribbon.select([0.35, 0.75]);
  assert.deepEqual(counts(0.45), { drawn: 6, lit: 4 });
  path.ribbon.select(null);
  assert.deepEqual(counts(9), { drawn: 11, lit: 11 });
  path.show(9, { path: true, ribbon: false });
  assert.equal(path.ribbon.mesh.visible, false);
});

test("the arrow of a push is the strongest force, dashed for a true push", () => {
  const round = roundOf([1, 2, 9, 3].map((across) => ({ x: 0, height: 0.2, across })));
  assert.equal(strongestSample(round, 0, 0.3), 2);
  assert.equal(strongestSample(round, 0, 0.1), 1);
  const [solid, dashed] = [makeArrow(round, 2, false), makeArrow(round, 2, true)];
  assert.equal(solid.length, 6 * 5);
  assert.ok(dashed.length > solid.length);
  const along = new Vector3(...solid.slice(3, 6)).sub(new Vector3(...solid.slice(0, 3))).normalize();
  assert.ok(along.distanceTo(new Vector3(0, 1, 0)) < 1e-6);
  assert.equal(strongestSample(roundOf([{ x: 0, across: 0.4 }]), 0, 1), -1, "noise is no push");
});
