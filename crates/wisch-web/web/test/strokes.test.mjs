// What each stroke gains and costs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Recording } from "../src/store.ts";
import { reachBand } from "../src/bases.ts";
import { describeStroke, findGains } from "../src/strokes.ts";
import { lines, polished, sample } from "./sample.mjs";

test("gains of strokes add up to the predicted performance", () => {
  const [round] = Recording.parse(lines(sample())).rounds;
  const gains = findGains(round);
  assert.equal(gains.length, round.plan.strokes.length);
  const sum = gains.reduce((total, { gain }) => total + gain, round.growthAt(0));
  assert.ok(Math.abs(sum - round.growthAt(round.plan.duration)) < 0.02, `${sum}`);
  assert.ok(gains.every(({ way, time }) => way > 0 && time > 0));
  assert.ok(gains.reduce((total, { time }) => total + time, 0) <= round.plan.duration + 1e-6);
});

test("a plan without a prediction has no gains", () => {
  const pieces = sample().map((piece) => (piece.piece === "round" ? { ...piece, growth: [] } : piece));
  assert.deepEqual(findGains(Recording.parse(lines(pieces)).rounds[0]), []);
});

const withRound = (change, pieces = sample()) => Recording.parse(lines(pieces.map((piece) => (piece.piece === "round" ? { ...piece, ...change(piece) } : piece)))).rounds[0];

test("the marginal gain of a stroke is that of the whole plan over the plan without it", () => {
  const round = withRound(() => ({ predicted: 0.953, lost: 0.01, without: [{ stroke: 2, performance: 0.812, lost: 0.01, particles: [0, 0, 900, -600, 910, -600, 0, 10] }], particles: [[0, [], [0, 0, 0, 10, 0, 20, 900, -600]], [1, [0, 1, 2], [900, -600, 900, -610, 0, 0]]] }));
  const gains = findGains(round);
  assert.deepEqual(gains.map(({ marginal }) => marginal?.toFixed(3) ?? null), [null, null, "0.141", null, null]);
  assert.ok(gains.every(({ start }, i) => i === 0 || start > gains[i - 1].start));
  const [differs, takes, heading] = describeStroke(round, { ...gains[2], way: 0.42, time: 3.1 });
  assert.equal(differs, "Predicted without stroke 3: 81.2\u202f% instead of 95.3\u202f%; 1 more of 4 particles stay outside the goal area, and nothing more is lost.");
  assert.equal(takes, "The stroke takes 3.1 s with the way to it, and 0.42 m in contact.");
  assert.equal(heading, "The tool sweeps 90 mm, as wide as it can.");
});

test("a loss that is unknown for the whole plan is not compared", () => {
  const change = { lost: undefined, considered: undefined };
  const round = withRound(() => change);
  assert.match(describeStroke(round, findGains(round)[1])[0], /, and 1\.0\u202f% in all is lost\.$/);
  const chosen = withRound(() => ({ lost: undefined }));
  assert.match(describeStroke(chosen, findGains(chosen)[1])[0], /, and 1\.0\u202f% more is lost\.$/);
});

test("without predictions that leave a stroke out nothing is said about them", () => {
  const round = withRound(() => ({ without: undefined, headings: undefined }));
  const [gain] = findGains(round);
  assert.equal(gain.marginal, null);
  assert.deepEqual(describeStroke(round, gain).length, 1);
});

test("on a treated surface, places with too little and too much are counted", () => {
  const round = withRound((piece) => ({ without: piece.without?.map((one) => ({ ...one, treated: one.treated.map((_, i) => (i < 10 ? 0 : 200)) })) }), polished());
  const [text] = describeStroke(round, findGains(round)[0]);
  assert.match(text, /; \d+ fewer of 768 places get too little, 1 fewer of 768 places get too much\.$/);
});

test("a base pose with all of the path in reach has the last band", () => {
  assert.deepEqual([-0.1, 0, 0.124, 0.125, 0.99, 1, 1.2].map(reachBand), [0, 0, 0, 1, 7, 7, 7]);
});

test("malformed reasons of a plan break their piece and no other", () => {
  for (const wrong of [{ without: [{ stroke: 0 }] }, { bases: { poses: [[0, 0, 0]], chosen: [] } }, { another: { gain: 0.1, line: "x", way: 1 } }, { headings: [1] }]) {
    const recording = Recording.parse(lines(sample().map((piece) => (piece.piece === "round" && piece.round === 1 ? { ...piece, ...wrong } : piece))));
    assert.equal(recording.rounds.length, 1);
    assert.ok(recording.broken > 0);
  }
});
