// What the page says of a recording, in words and numbers.
import assert from "node:assert/strict";
import { test } from "node:test";
import { compareWithTruth } from "../src/belief.ts";
import { clockText, fixed, percent } from "../src/dom.ts";
import { Recording } from "../src/store.ts";
import { findIncidents } from "../src/story.ts";
import { findGains, predictWhole } from "../src/strokes.ts";
import { describeRound } from "../src/timeline.ts";
import { describeBegin, describeDetours } from "../src/why.ts";
import { heightText } from "../src/words.ts";
import { lines, sample } from "./sample.mjs";

const parse = (change = (piece) => piece) => Recording.parse(lines(sample().map(change)));

test("ties get an even last digit, as in Rust", () => {
  // format!("{:.1} %", 100.0 * share) of Rust gives these.
  const shares = [[0.9625, "96.2\u202f%"], [0.9675, "96.8\u202f%"], [0.84255, "84.3\u202f%"], [0.1125, "11.2\u202f%"]];
  for (const [share, text] of shares) assert.equal(percent(share, 1), text);
  assert.deepEqual([0.5, 1.5, 2.5, -0.5, -2.5, 1e9 + 0.5].map((value) => fixed(value, 0)), ["0", "2", "2", "0", "\u22122", "1000000000"]);
  assert.deepEqual([fixed(0.125, 2), fixed(0.375, 2), fixed(-0.25, 1), fixed(1e21, 1), fixed(NaN, 1)], ["0.12", "0.38", "\u22120.2", "1e+21", "NaN"]);
});

test("times are rounded in one way, below and above a minute", () => {
  assert.deepEqual([59.25, 60.25, 59.96, 60, 3661.75, -0.25].map((time) => clockText(time)), ["59.2 s", "1:00.2", "1:00.0", "1:00.0", "1:01:01.8", "\u22120.2 s"]);
  assert.deepEqual([59.5, 90.5, 7200].map((time) => clockText(time, 0)), ["1:00", "1:30", "2:00:00"]);
});

test("a tool beside the surface has no height over it", () => {
  const [round] = parse().rounds;
  const { pose, rings } = round.plan.surface;
  const [x, y] = [0, 1].map((axis) => Math.max(...rings[0].filter((_, i) => i % 2 === axis)) / 1e4);
  const at = (dx, dy, contact = "none") => ({ round, height: -0.048, contact, tool: [pose[0] + dx, pose[1] + dy, pose[2], 0, 0, 0, 1] });
  assert.equal(heightText(at(0, 0)), "\u221248.0 mm");
  assert.equal(heightText(at(x + 0.05, 0)), "beside the surface");
  assert.equal(heightText(at(0, y + 0.05)), "beside the surface");
  assert.equal(heightText(at(x + 0.05, 0, "contact")), "\u221248.0 mm", "it presses with its edge");
  assert.equal(heightText({ ...at(0, 0), height: null }), "\u2013");
});

test("a truth outside the interval is unusual, and a collision may be a push", () => {
  const outside = parse((piece) => (piece.piece === "truth" && piece.round === 2 ? { ...piece, performance: 0.01 } : piece)).rounds[1];
  const missed = findIncidents(outside).at(-1);
  assert.match(missed.title, /ground truth lies outside the interval/);
  assert.match(missed.evidence, /^Estimated \d+\.\d\u202f% \(90\u202f%: \d+\.\d\u202f% to \d+\.\d\u202f%\), true 1\.0\u202f%\.$/);
  assert.match(compareWithTruth(outside).at(-1).join(), /outside the interval$/);
  const [first, second] = parse().rounds;
  assert.ok(!findIncidents(second).some(({ title }) => title === missed.title));
  const [push] = first.events.filter(({ kind }) => kind === "collision");
  first.interpreted.incidents = [{ time: push.start, title: "2 collisions", evidence: "At 9.1 s.", effect: "", advice: "" }, { time: null, title: "Less was wiped", evidence: "", effect: "", advice: "" }];
  assert.deepEqual(findIncidents(first).slice(0, 2).map(({ title, evidence }) => [title, evidence]), [["2 pushes or collisions", "At 9.1 s."], ["Less was wiped", ""]]);
  const titled = (title) => findIncidents({ ...first, interpreted: { ...first.interpreted, incidents: [{ title }] } })[0].title;
  assert.deepEqual(["Collision in stroke 3", "2 collisions: in stroke 3 and between strokes", "Human collision"].map(titled), ["Push or collision in stroke 3", "2 pushes or collisions: in stroke 3 and between strokes", "Push or collision"]);
});

test("the timeline has a text for each round", () => {
  const recording = parse();
  const [first, second] = recording.rounds.map((round) => describeRound(recording, round));
  assert.match(first, /^Round 1, 0\.0 s to \d+\.\d s, 5 strokes, in contact for \d+\.\d s, pushed for \d\.\d s, \d detected events?, force at most \d+\.\d N, predicted \d+\u202f%, estimated \d+/);
  assert.match(second, /^Round 2, .*, 2 strokes, .*\.$/);
  const [planned] = Recording.parse(lines(sample().filter(({ piece }) => piece !== "samples"))).rounds;
  assert.match(describeRound(recording, planned), /, 5 strokes, planned contact for \d+\.\d s, /, "without samples, contact is planned");
  const say = (change) => describeRound(recording, parse((piece) => (piece.piece === "round" ? { ...piece, ...change } : piece)).rounds[1]);
  assert.match(say({ strokes: [[0, 0, 100, 0]] }), /, 1 stroke, /);
  assert.doesNotMatch(say({ kind: "logged", strokes: [] }), /stroke/);
  const logged = sample().filter(({ piece }) => piece !== "samples").map((piece) => (piece.piece === "round" ? { ...piece, kind: "logged", strokes: [], phases: [] } : piece));
  assert.doesNotMatch(describeRound(recording, Recording.parse(lines(logged)).rounds[1]), /stroke,|strokes|contact/, "a log without samples states neither");
});

test("a prediction that begins away from the estimate says why, and a stroke that takes dirt out of the goal area too", () => {
  const [first, second] = parse((piece) => (piece.piece === "round" && piece.round === 2 ? { ...piece, growth: [[0, 0.3], [3, 0.4], [9, 0.9]] } : piece)).rounds;
  const [text] = describeBegin(second, first);
  assert.match(text, /^The prediction begins at 30\.0\u202f%, below the estimate of .* after round 1\. It starts from one random draw from the new belief; .* A push, a collision or hand guiding in round 1 may have left open what was wiped there\.$/);
  assert.deepEqual(describeBegin(first, null), []);
  second.plan.growth = [[0, first.interpreted.estimate.mean + 0.01]];
  assert.deepEqual(describeBegin(second, first), []);
  const strokes = first.plan.phases.filter(({ stroke }) => stroke !== null);
  first.plan.growth = [[0, 0.2], ...strokes.map(({ end }, i) => [end, [0.5, 0.1, 0.4, 0.6, 0.8][i]])];
  const away = () => describeDetours(first, findGains(first), predictWhole(first));
  assert.match(away()[0], /^Stroke 2 is predicted to take dirt out of the goal area, 40\.0 points at most\. .* later strokes bring it back, and the plan reaches \d+\.\d\u202f%\.$/);
  const grow = (levels) => { first.plan.growth = [[0, 0.2], ...strokes.map(({ end }, i) => [end, levels[i]])]; };
  grow([0.5, 0.6, 0.7, 0.8, 0.7]);
  assert.deepEqual(away(), [], "what no later stroke brings back");
  grow([0.5, 0.4, 0.45, 0.6, 0.1]);
  assert.match(away()[0], /^Stroke 2 is predicted to take dirt out of the goal area, 10\.0 points at most\./, "and the last stroke does not");
});
