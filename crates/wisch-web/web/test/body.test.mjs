// The body that is made for robots with collision shapes only: the shipped ones, whose records are in robots.json.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { MeshBasicMaterial, NotEqualStencilFunc, Vector3 } from "three";
import { makeBody } from "../src/scene/body.ts";
import { Robot, collisionOf, makeGhost } from "../src/scene/robot.ts";
import { distanceTo } from "../src/scene/shell.ts";
import { matrix } from "../src/scene/solids.ts";
import { Tree } from "../src/scene/tree.ts";

const heads = Object.values(JSON.parse(readFileSync("test/robots.json", "utf8")));
const look = new MeshBasicMaterial();
const materials = { body: look, arm: look, joint: look, ring: look, handle: look, collision: new MeshBasicMaterial(), tool: look, coloured: () => look };
/** Number of triangles of a robot and its tool, without collision shapes. */
const trianglesOf = ({ tool, parts }) => [tool, ...parts.flat()].reduce((sum, { geometry: { index, attributes } }) => sum + (index ?? attributes.position).count / 3, 0);
/** How far the body may come out of the collision shapes [m]. */
const OUT_M = 0.01;
const MOST_TRIANGLES = 40_000;

const cornersOf = (geometry) => Array.from({ length: geometry.getAttribute("position").count }, (_, i) => new Vector3().fromBufferAttribute(geometry.getAttribute("position"), i));

for (const head of heads) {
  const { robot } = head;
  const body = makeBody(head, head.meshes);
  const stand = (positions) => {
    const tree = new Tree(robot.joints);
    tree.update([0, 0, 0, 0, 0, 0, 1], positions);
    return tree.worldFromLink;
  };

  test(`the shell of ${robot.name} stays in its collision shapes, in all poses`, () => {
    for (let pose = 0; pose < 6; pose++) {
      const worldFromLink = stand(robot.variables.map((_, i) => (pose ? 1.3 * Math.sin(12.9 * pose + 78.2 * i) : 0)));
      const rods = robot.links.flatMap(({ shapes }, i) => shapes.map(({ pose: at, length = 0, radius }) => {
        const [from, to] = [-length / 2, length / 2].map((z) => new Vector3(0, 0, z).applyMatrix4(matrix(at)).applyMatrix4(worldFromLink[i]));
        return { from, to, radius };
      }));
      body.forEach((parts, i) => Object.entries(parts).forEach(([finish, geometry]) => {
        const out = Math.max(...cornersOf(geometry).map((corner) => Math.min(...rods.map((rod) => distanceTo(rod, ...corner.clone().applyMatrix4(worldFromLink[i]))))));
        // What connects hand and tool bridges the gap that the collision shapes leave.
        assert.ok(out < (finish === "handle" ? 0.06 : OUT_M), `${robot.links[i].name}, ${finish}: ${out} m`);
      }));
    }
  });

  test(`${robot.name} has few triangles, housings on the axes of its joints, and its tool in the hand`, () => {
    const made = new Robot(head, head.meshes, materials);
    assert.ok(trianglesOf(made) > 5000 && trianglesOf(made) <= MOST_TRIANGLES, `${trianglesOf(made)} triangles`);
    let housings = 0;
    robot.joints.forEach(({ axis }, i) => {
      const { joint } = body[i + 1];
      if (robot.links[i + 1].shapes.length || !joint) return;
      joint.computeBoundingBox();
      const away = joint.boundingBox.getCenter(new Vector3()).cross(new Vector3(...axis)).length();
      assert.ok(away < 1e-3, `${robot.links[i + 1].name} lies ${away} m beside its axis`);
      housings++;
    });
    if (robot.name === "humanoid") assert.ok(housings >= 8, `${housings} housings`);
    const worldFromLink = stand([]);
    made.tool.geometry.computeBoundingBox();
    const { min, max } = made.tool.geometry.boundingBox;
    const back = new Vector3((min.x + max.x) / 2, (min.y + max.y) / 2, max.z).applyMatrix4(matrix(head.tool.solid.pose)).applyMatrix4(worldFromLink[head.tool.link]);
    const gap = Math.min(...body.flatMap((parts, i) => Object.values(parts).flatMap((geometry) => cornersOf(geometry).map((corner) => corner.applyMatrix4(worldFromLink[i]).distanceTo(back)))));
    assert.ok(gap < 0.04, `${gap} m between hand and tool`);
  });

  test(`${robot.name} shows its collision shapes on request, and only its ghost shares its geometry`, () => {
    const made = new Robot(head, head.meshes, materials);
    const count = () => {
      let shown = 0;
      made.group.traverse(({ material, visible }) => { if (material === materials.collision && visible) shown++; });
      return shown;
    };
    assert.equal(count(), 0);
    made.collisionShown = true;
    assert.equal(count(), robot.links.flatMap(collisionOf).length);
    made.collisionShown = false;
    assert.equal(count(), 0);
    const ghost = new Robot(head, head.meshes, materials, made);
    assert.equal(ghost.parts, made.parts);
    assert.equal(ghost.tool.geometry, made.tool.geometry);
  });
}

test("ghosts are drawn one after the other, after all else, and hide nothing but their own parts", () => {
  const [head] = heads;
  const shared = new Robot(head, head.meshes, materials);
  const looks = [0, 1].map((i) => {
    const meshes = [];
    makeGhost(head, head.meshes, shared, "#ff0000", i, null, head.robot.variables.map(() => 0), null).traverse((one) => { if (one.isMesh) meshes.push(one); });
    return [...new Set(meshes.map(({ material, renderOrder }) => JSON.stringify([material.transparent, material.depthWrite, material.stencilFunc === NotEqualStencilFunc, material.stencilRef, renderOrder])))];
  });
  assert.deepEqual(looks, [["[true,false,true,1,10]"], ["[true,false,true,2,11]"]]);
});

test("a link that ends in one capsule is no hand, unless it holds the tool or is the other arm's end", () => {
  for (const head of heads) {
    const mast = structuredClone(head);
    const { links, joints } = mast.robot;
    for (const [parent, z] of [[0, 1], [joints.length + 1, 0.3]]) {
      joints.push({ parent, pose: [0, 0, z, 0, 0, 0, 1], axis: [0, 0, 1], kind: "fixed", offset: 0, terms: [] });
      links.push({ name: "antenna", arm: false, shapes: [{ kind: "capsule", radius: 0.02, length: 0.2, pose: [0, 0, 0.15, 0, 0, 0, 1] }] });
    }
    const [before, after] = [head, mast].map((one) => makeBody(one, one.meshes).map((parts) => Object.keys(parts).sort().join()));
    assert.deepEqual(after.slice(0, before.length), before);
    if (head.robot.name === "humanoid") assert.equal(before[head.robot.links.findIndex(({ name }) => name === "left_tcp")], "casing,joint,ring", "the other hand");
    assert.equal(after.at(-1), "casing,ring", "a casing without fingers");
  }
});

test("a robot with visual shapes looks as they do", () => {
  const [head] = structuredClone(heads);
  const [first, second] = head.robot.links.filter(({ shapes }) => shapes.length);
  Object.assign(first, { visual: true, collision: first.shapes, shapes: first.shapes.slice(0, 1) });
  const made = new Robot(head, head.meshes, materials);
  const meshes = made.links.flatMap(({ children }) => children);
  assert.equal(meshes.length, head.robot.links.reduce((sum, { shapes }) => sum + shapes.length, 0));
  assert.equal(collisionOf(first).length, 6);
  assert.equal(collisionOf(second), second.shapes);
});
