// What answers show in a recording, also in that of an episode that was kept without one.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Recording } from "../src/store.ts";
import { apply, episodeTitle, shownOf, titleOf } from "../src/studio/shown.ts";
import { lines, sample } from "./sample.mjs";

globalThis.document ??= { documentElement: {} };
globalThis.getComputedStyle ??= () => ({ getPropertyValue: () => "#ffbf00" });

const ID = "20261122-010000-abcd";
const POSE = [0, 0, 0.7, 0, 0, 0, 1];
const BEGIN = 1000;

const answers = (view) => ({
  columns: [], units: [], names: {}, rows: [[]], about: [[]], holds: true, more: false, printed: "", remarks: [],
  view: { episodes: [{ id: ID, task: "board", interval: [BEGIN, BEGIN + 10], rounds: [BEGIN], shown: [] }], tracks: [], bodies: [], particles: [], plots: [], left_out: 0, ...view },
});
const body = (kind, time, more = {}) => ({ thing: `semco:${kind}`, kind, episode: ID, round: 1, time: BEGIN + time, pose: POSE, strong: false, colour: null, ...more });

test("robots and tools are ghosts, other things are frames", () => {
  const recording = Recording.parse(lines(sample()));
  const shown = shownOf(answers({ bodies: [body("robot", 1), body("tool", 2, { strong: true }), body("surface", 1), body("frame", 3, { colour: "#0102ff" })] }), null, ID, recording);
  assert.deepEqual(shown.ghosts, [{ time: 1 }, { time: 2, color: "#ffbf00" }]);
  assert.deepEqual(shown.frames, [
    { name: "surface at 1.0 s", time: 1, pose: POSE },
    { name: "frame at 3.0 s", time: 3, pose: POSE, color: "#0102ff" },
  ]);
});

test("a trajectory keeps the samples that the query asked for", () => {
  const recording = Recording.parse(lines(sample()));
  const track = { thing: "semco:sponge", episode: ID, round: 1, interval: [BEGIN + 1, BEGIN + 2], path: [[0, 0, 0], [1, 0, 0]], samples: [[BEGIN + 1.5, 0.5, 0, 0]], strong: false, colour: null };
  const { trajectories } = shownOf(answers({ tracks: [track] }), null, ID, recording);
  assert.deepEqual(trajectories, [{ name: "sponge 1.0 s to 2.0 s", points: [[0, 0, 0], [1, 0, 0]], samples: [[0.5, 0, 0]] }]);
});

/** Returns the time to which a view seeks when it shows an answer. */
function soughtTime(shown) {
  let sought = null;
  const view = new Proxy({}, { get: (_, name) => (name === "seek" ? (time) => { sought = time; } : () => {}) });
  apply(view, shown);
  return sought;
}

test("the clock goes to the queried pose, or else to the start of the queried interval", () => {
  const recording = Recording.parse(lines(sample()));
  const collision = { episode: ID, class: "HumanCollision", interval: [BEGIN + 2, BEGIN + 4] };
  const asked = (view) => ({ ...answers(view), about: [[collision]] });
  const posed = shownOf(asked({ bodies: [body("robot", 3)] }), null, ID, recording);
  assert.deepEqual(posed.intervals, [{ start: 2, end: 4, label: "push or collision" }]);
  assert.equal(soughtTime(posed), 3);
  assert.equal(soughtTime(shownOf(asked({}), null, ID, recording)), 2);
});

test("individuals have the titles of the timeline", () => {
  const names = { "semco:Stroke_20261122-010000-abcd-10": "round 1, stroke 3" };
  assert.equal(titleOf({ names }, "semco:Stroke_20261122-010000-abcd-10"), "round 1, stroke 3");
  assert.equal(titleOf({ names }, "semco:Stroke_20261122-010000-abcd-12"), "Stroke 12");
  assert.equal(titleOf({ names }, "semco:sponge"), "sponge");
  assert.equal(titleOf({ names: { push: "round 1, human collision 2" } }, "push"), "round 1, push or collision 2");
  assert.match(episodeTitle({ task: "board", begun: 1795777372 }), /^board, 27 Nov, \d\d:\d\d$/);
});

test("a logged round has events and contacts without a result", () => {
  const recording = Recording.parse([
    { piece: "head", schema: 1, title: "slide", program: "test", begun: null, task: null, robot: null, tool: { link: null, solid: { kind: "sphere", radius: 0.02, pose: POSE } }, meshes: [] },
    {
      piece: "round", round: 1, kind: "logged", duration: 2, root: null, surface: { pose: POSE, rings: [] }, scene: [], meshes: [], goal: null, strokes: [], phases: [],
      predicted: null, growth: [], particles: [], why: [], events: [{ kind: "human collision", start: 1, end: 1.25, words: "it", by_hand: true }], contacts: [[0.5, 1.5]],
    },
  ].map((piece) => JSON.stringify(piece)).join("\n"));
  assert.equal(recording.broken, 0);
  assert.deepEqual(recording.happenings.map(({ kind, start }) => [kind, start]), [["push or collision", 1]]);
  assert.deepEqual(recording.rounds[0].contacts.contact, [[0.5, 1.5]]);
  assert.equal(recording.rounds[0].contactAt(1.1), "pushed");
  assert.equal(recording.rounds[0].interpreted, null);
});
