// What each stroke gains and costs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Recording } from "../src/store.ts";
import { findGains } from "../src/strokes.ts";
import { lines, sample } from "./sample.mjs";

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
