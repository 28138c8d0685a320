// The first view of a recording, tested with rays through the robot's triangles; the view itself is chosen with boxes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { BoxGeometry, Material, Mesh, MeshBasicMaterial, PerspectiveCamera, Raycaster, Vector2, Vector3 } from "three";
import { Recording } from "../src/store.ts";
import { chain, cutDashes } from "../src/scene/lines.ts";
import { Robot } from "../src/scene/robot.ts";
import { Shots } from "../src/scene/shots.ts";
import { Still } from "../src/scene/surface.ts";
import { chooseDirection, fit, isBetween, blocksOf } from "../src/scene/viewpoint.ts";
import { lines, sample } from "./sample.mjs";

// Materials ask the page for its colours.
globalThis.document ??= { documentElement: {}, createElement: () => ({ getContext: () => ({ createImageData: (w, h) => ({ data: new Uint8ClampedArray(4 * w * h) }), putImageData: () => {} }) }) };
globalThis.getComputedStyle ??= () => ({ getPropertyValue: () => "#808080" });

const ASPECT = 16 / 9;
const camera = new PerspectiveCamera(36, ASPECT, 0.02, 200);
camera.up.set(0, 0, 1);
const high = Math.tan((camera.fov * Math.PI) / 360);
const angles = { high, wide: high * ASPECT };

function open(pieces) {
  const recording = Recording.parse(lines(pieces));
  const look = new MeshBasicMaterial();
  const robot = new Robot(recording.head, recording.meshes, { body: look, arm: look, joint: look, ring: look, handle: look, collision: look, tool: look, coloured: () => look });
  const [round] = recording.rounds;
  const still = new Still(round, recording);
  const shots = new Shots(recording, robot, still);
  const stand = (time) => {
    const { q, tool } = recording.at(round.start + time);
    robot.show(round.plan.root, q, tool);
    robot.group.updateMatrixWorld(true);
  };
  const place = (points) => {
    const { target, eye } = fit(points, shots.from, angles);
    camera.position.copy(eye);
    camera.lookAt(target);
    camera.updateMatrixWorld(true);
  };
  return { recording, robot, round, still, shots, stand, place };
}

/** The part of the picture that the box around points covers, and the largest distance of a point from the middle [half pictures]. */
function covered(points) {
  const seen = points.map((point) => point.clone().project(camera));
  const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
  return { share: ((Math.max(...xs) - Math.min(...xs)) * (Math.max(...ys) - Math.min(...ys))) / 4, out: Math.max(...xs.map(Math.abs), ...ys.map(Math.abs)) };
}

const corners = ({ plan: { surface } }) => [0, 2, 4, 6].map((i) => new Vector3(surface.rings[0][i] / 1e4, surface.rings[0][i + 1] / 1e4, 0).add(new Vector3(...surface.pose)));

test("the first view is of the surface, and the arm does not hide the tool at a stroke", () => {
  const { recording, robot, round, shots, stand, place } = open(sample());
  place(shots.surface());
  const { share, out } = covered(corners(round));
  assert.ok(share >= 0.12, `the surface covers ${share.toFixed(3)} of the picture`);
  assert.ok(out <= 1, "the surface is cut");
  for (const stroke of round.plan.phases.filter(({ contact }) => contact)) {
    stand((stroke.start + stroke.end) / 2);
    const middle = robot.toolPlace.addScaledVector(new Vector3(0, 0, 1), 0.02);
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(...middle.clone().project(camera).toArray().slice(0, 2)), camera);
    // What holds the tool covers its back from every side.
    const [first] = ray.intersectObjects([...robot.links.filter((_, i) => i !== recording.head.tool.link), robot.tool], true);
    assert.equal(first?.object, robot.tool, `hidden at stroke ${stroke.stroke + 1}`);
  }
});

test("a view of all has the robot, the table and the surface", () => {
  const { robot, round, still, shots, stand, place } = open(sample());
  for (const time of [0, 5, round.length]) {
    place(shots.all(time));
    stand(time);
    const points = [];
    for (const group of [robot.group, still.bodies]) group.traverse((mesh) => {
      if (!(mesh instanceof Mesh)) return;
      const at = mesh.geometry.getAttribute("position");
      for (let i = 0; i < at.count; i += 7) points.push(new Vector3().fromBufferAttribute(at, i).applyMatrix4(mesh.matrixWorld));
    });
    const { out } = covered(points);
    assert.ok(out <= 1, `cut at ${time} s: ${out}`);
    assert.ok(out > 0.75, `too far at ${time} s: ${out}`);
  }
});

test("the camera is close at strokes and wide in free motion", () => {
  const { round, shots } = open(sample());
  const [first] = round.plan.phases.filter(({ contact }) => contact);
  assert.match(shots.at(0).key, /free/);
  assert.equal(shots.at(first.start + 0.1).key, shots.at(first.end - 0.1).key);
  assert.match(shots.at(first.start - 0.2).key, /stroke/);
  assert.match(shots.at(round.length).key, /free/);
  const keys = new Set(Array.from({ length: 200 }, (_, i) => shots.at((i / 200) * round.length).key));
  assert.ok(keys.size <= 2 * round.plan.phases.filter(({ contact }) => contact).length + 1, `${keys.size} cuts`);
});

test("collision shapes beside visual ones are shown on request, and hide nothing else", () => {
  const pieces = sample();
  pieces[0] = { ...pieces[0], robot: { ...pieces[0].robot, links: pieces[0].robot.links.map((link) => ({ ...link, visual: true, collision: link.shapes })) } };
  const { robot, stand } = open(pieces);
  stand(2);
  const count = () => blocksOf([robot.group]).length;
  const before = count();
  robot.collisionShown = true;
  assert.equal(count() - before, pieces[0].robot.links.flatMap(({ shapes }) => shapes).length);
  robot.collisionShown = false;
  assert.equal(count(), before);
});

test("a round without samples is seen too", () => {
  const { shots, place, round } = open(sample().filter(({ piece }) => piece === "head" || piece === "round"));
  place(shots.surface());
  assert.ok(covered(corners(round)).share >= 0.12);
});

test("a view is from the front of an upright surface, past what stands before it", () => {
  const wall = [new Vector3(0, 0, 1)];
  const front = chooseDirection([], wall, new Vector3(0, -1, 0), new Vector3(0, 1, 0));
  assert.ok(front.y < -0.3, `${front.toArray()}`);
  const post = new Mesh(new BoxGeometry(0.3, 0.1, 2), new Material());
  post.position.set(0, -0.5, 0.5);
  post.updateMatrixWorld(true);
  const past = chooseDirection([{ blocks: blocksOf([post]), tool: wall }], wall, new Vector3(0, -1, 0), new Vector3(0, -1, 0));
  assert.ok(!isBetween(blocksOf([post])[0], wall[0], wall[0].clone().addScaledVector(past, 1.5)));
});

test("while a run goes on, the followed strokes are the planned ones", () => {
  const pieces = sample();
  const begun = pieces.filter(({ piece, round = 1, t }) => piece === "head" || (round === 1 && (piece === "round" || (piece === "samples" && t[0] < 1))));
  const { round } = open(pieces);
  const [phase] = round.plan.phases.filter(({ contact }) => contact);
  const live = new Recording();
  begun.forEach((piece) => live.apply(piece));
  const shots = new Shots(live, null, new Still(live.rounds[0], live));
  const { points } = shots.at((phase.start + phase.end) / 2);
  const along = (axis) => [Math.min, Math.max].map((most) => most(...points.map((point) => point[axis])));
  for (let time = phase.start; time < phase.end; time += 0.1) {
    const [x, y] = round.toolAt(time);
    for (const [axis, at] of [["x", x], ["y", y]]) {
      const [low, high] = along(axis);
      assert.ok(low < at && at < high, `the tool is at ${axis} ${at} at ${time}, not in ${low} to ${high}`);
    }
  }
});

test("crossing a round's end again and again makes its outlines once", () => {
  const { still, recording, round } = open(sample());
  const found = round.interpreted.found;
  const layers = { strokes: false, found: true, actual: true };
  still.show(layers, null, found, null);
  const count = still.group.children.length;
  for (let k = 0; k < 3; k++) {
    still.show(layers, null, recording.foundAt(0), null);
    assert.equal(still.group.children.filter(({ visible }) => !visible).length, 2, "strokes and the found surface are hidden");
    still.show(layers, null, found, null);
    assert.equal(still.group.children.length, count);
  }
  still.show(layers, null, null, 2);
  const isShown = (object) => object.visible && (!object.parent || isShown(object.parent));
  const widths = [];
  still.group.traverse((object) => { if (object.material?.name === "chosen" && isShown(object)) widths.push(object.material.linewidth); });
  assert.deepEqual(widths, [7], "a chosen stroke is drawn while the others are hidden");
});

test("a hostile outline gets few dashes", () => {
  const ring = [[0, 0, 0], [1e12, 0, 0], [1e12, 1e12, 0]];
  assert.ok(cutDashes(chain(ring, true), [0.015, 0.01]).length / 6 <= 2010);
  assert.equal(cutDashes([0, 0, 0, 0.1, 0, 0], [0.015, 0.01]).length / 6, 4, "and a small one its own");
});
