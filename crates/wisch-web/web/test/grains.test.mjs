// Dirt as solids.
import assert from "node:assert/strict";
import { test } from "node:test";
import { lift } from "../src/scene/bend.ts";
import { Grains, formOf } from "../src/scene/grains.ts";

// Materials ask the page for its colours.
globalThis.document ??= { documentElement: {} };
globalThis.getComputedStyle ??= () => ({ getPropertyValue: () => "#808080" });

const POSE = [0, 0, 0.8, 0, 0, 0, 1];
const SHAPES = {
  plane: null,
  cylinder: { kind: "cylinder", radius_m: 0.3, axis_rad: 0.4 },
  hollow: { kind: "cylinder", radius_m: -0.5, axis_rad: 0 },
  cone: { kind: "cone", radius_m: 0.4, half_angle_rad: 0.5, axis_rad: 1 },
  mesh: { kind: "mesh", points: [-0.2, -0.2, 0, 0.2, -0.2, 0.1, -0.2, 0.2, 0, 0.2, 0.2, 0.1], places: [-0.2, -0.2, 0.2, -0.2, -0.2, 0.2, 0.2, 0.2], triangles: [0, 1, 2, 1, 3, 2] },
};

test("the medium decides the form: crumbs, drops, or as it was for films and unknown media", () => {
  assert.deepEqual(["breadcrumbs", "glass_chippings", "sand", "water", "detergent"].map(formOf), ["crumb", "crumb", "crumb", "drop", "drop"]);
  assert.deepEqual(["dust", "soil", "paint", "polishing_paste", "<b>", "", null, undefined].map(formOf), [null, null, null, null, null, null, null, null]);
});

for (const [name, shape] of Object.entries(SHAPES)) {
  test(`grains stand on a ${name} along its normal, in one mesh, and their shadows lie on it in another`, () => {
    for (const form of ["crumb", "drop"]) {
      const grains = new Grains(form);
      const places = Float32Array.from([0.05, -0.08, -0.1, 0.02, 0, 0]);
      grains.show(places, POSE, shape, 2000);
      const [solids, shadows] = grains.group.children;
      assert.equal(grains.group.children.length, 2);
      assert.ok(solids.visible && shadows.visible);
      const at = solids.geometry.getAttribute("position");
      const corners = solids.geometry.drawRange.count && at.count / 6;
      for (let i = 0; i < 3; i++) {
        const [x, y] = places.slice(2 * i);
        const [foot, top] = [lift(shape, x, y, 0), lift(shape, x, y, 1)];
        const normal = foot.map((v, k) => top[k] - v);
        let [low, high, wide] = [Infinity, -Infinity, 0];
        for (let k = i * corners; k < (i + 1) * corners; k++) {
          const from = [at.getX(k) - foot[0], at.getY(k) - foot[1], at.getZ(k) - foot[2]];
          const height = from.reduce((sum, v, j) => sum + v * normal[j], 0);
          [low, high, wide] = [Math.min(low, height), Math.max(high, height), Math.max(wide, Math.sqrt(Math.max(0, from.reduce((sum, v) => sum + v * v, 0) - height * height)))];
        }
        assert.ok(Math.abs(low) < 1e-6, `its base is ${low} m over the surface`);
        assert.ok(high > 0.3 * wide && high < 0.006, `it is ${high} m high`);
        assert.ok(wide > 0.002 && wide < 0.005, `its radius is ${wide} m`);
      }
      grains.show(null, POSE, shape, 2000);
      assert.equal(grains.group.visible, false);
    }
  });
}

test("many grains are small, have few faces, and grow only on the screen", () => {
  const grains = new Grains("crumb");
  const [solids, shadows] = grains.group.children;
  const faces = (count, pixelsPerMetre) => {
    grains.show(Float32Array.from({ length: 2 * count }, (_, i) => 1e-4 * i), POSE, null, pixelsPerMetre);
    return solids.geometry.drawRange.count / 3 / count;
  };
  const height = () => Math.max(...Array.from({ length: 20 }, (_, i) => solids.geometry.getAttribute("position").getZ(i)));
  assert.ok(faces(100, 2000) > faces(6000, 2000));
  assert.equal(shadows.visible, false);
  assert.equal(faces(6000, 2000), 4);
  const near = height();
  faces(6000, 200);
  assert.ok(height() > 3 * near, "from afar they are larger than on the surface, so that they stay visible");
  const { geometry } = solids;
  faces(6100, 200);
  assert.equal(solids.geometry, geometry, "a few more grains need no new buffers");
});
