// Passes or coat thickness of a treated surface.
import assert from "node:assert/strict";
import { test } from "node:test";
import { checkPiece } from "../src/shape.ts";
import { Recording } from "../src/store.ts";
import { bandText, binOf, binsOf, mapAt, resultValues } from "../src/treated.ts";
import { lines, polished, sample } from "./sample.mjs";

const pieces = polished();
const recording = Recording.parse(lines(pieces));
const { treatment } = pieces.find(({ piece }) => piece === "round");
const ALL = { believed: true, estimated: true, actual: true };

test("values change as the steps say, forwards and backwards", () => {
  const { treated } = recording.rounds[0];
  assert.equal(recording.broken, 0);
  for (const [time, left, right] of [[0, 0, 0], [6, 0, 1.5], [9, 4, 1.5], [5.9, 0, 0], [100, 4, 1.5]]) {
    const values = treated.at(time);
    assert.deepEqual([values[0], values[31]], [left, right], `at ${time}`);
    assert.equal(values.length, 32 * 24);
  }
  assert.equal(treated.at(7), treated.at(8), "the same array until they change");
});

test("passes are binned as whole numbers, and the band includes its ends", () => {
  const bins = binsOf(treatment);
  assert.deepEqual(bins.map(({ degree, label }) => `${degree} ${label}`), ["little 0", "little 1", "allowed 2", "allowed 3", "much 4", "much \u2265 5"]);
  const degree = (value) => bins[binOf(bins, treatment, value)].label;
  assert.deepEqual([0, 0.49, 0.5, 1.49, 1.5, 3.49, 3.5, 4.5, 90].map(degree), ["0", "0", "1", "1", "2", "3", "4", "\u2265 5", "\u2265 5"]);
  assert.equal(bandText(treatment), "2 to 3 passes");
  assert.deepEqual(bins.map(({ colour }) => colour), ["little-2", "little-4", "allowed-1", "allowed-3", "much-1", "much-2"]);
  assert.equal(binsOf({ ...treatment, low: 1, target: 1, high: 2 })[0].colour, "little-2", "a place without a pass does not look like a hole");
  const many = binsOf({ ...treatment, low: 20, target: 20, high: 40 });
  assert.deepEqual(many.map(({ label }) => label), ["0\u20134", "5\u20139", "10\u201314", "15\u201319", "20\u201326", "27\u201333", "34\u201340", "41\u201360", "\u2265 61"]);
});

test("a coat is binned by its thickness", () => {
  const coat = { ...treatment, unit: "\u00b5m", target: 100, low: 80, high: 120, step: 0.5 };
  const bins = binsOf(coat);
  assert.deepEqual(bins.map(({ label }) => label), ["0\u201320", "20\u201340", "40\u201360", "60\u201380", "80\u201393", "93\u2013107", "107\u2013120", "120\u2013160", "\u2265 160"]);
  assert.deepEqual(bins.map(({ colour }) => colour.slice(-1)).join(""), "123412312");
  const degree = (value) => bins[binOf(bins, coat, value)].degree;
  assert.deepEqual([0, 79.9, 160 * 0.5, 240 * 0.5, 120.5].map(degree), ["little", "little", "allowed", "allowed", "much"]);
});

test("the scene shows the prediction in a round, and the result after it", () => {
  const kind = (t, layers = ALL) => {
    const map = mapAt(recording, t, recording.roundAt(t), layers);
    return map && `${map.kind} ${map.values[31].toFixed(1)}`;
  };
  const [first, second] = recording.rounds;
  const contact = second.start + second.plan.phases.find((phase) => phase.contact).start;
  assert.equal(kind(0), "predicted 0.0");
  assert.equal(kind(first.end - 0.1), "predicted 1.5");
  assert.equal(kind(first.end), "true 3.0");
  assert.equal(kind(first.end, { ...ALL, actual: false }), "estimated 2.0");
  assert.equal(kind(first.end, { ...ALL, actual: false, estimated: false }), "predicted 2.0");
  assert.equal(kind(first.end, { believed: false, actual: false, estimated: false }), null);
  assert.equal(kind(contact + 0.1), "predicted 2.0", "the tool changes the surface again");
  assert.equal(kind(recording.duration), "true 5.0");
  assert.equal(kind(recording.duration + 30), "true 5.0", "beside a longer recording");
});

test("a recording without values, or with those of other places, has no map", () => {
  const old = pieces.map(({ treatment, treated, ...piece }) => piece);
  const plain = Recording.parse(lines(old));
  assert.equal(plain.broken, 0);
  assert.equal(mapAt(plain, 5, plain.rounds[0], ALL), null);
  assert.equal(resultValues(treatment, [1, 2, 3]), null);
  assert.equal(resultValues(treatment, undefined), null);
  const dirt = Recording.parse(lines(sample()));
  assert.equal(mapAt(dirt, 5, dirt.rounds[0], ALL), null);
});

test("a treatment that cannot be drawn is refused", () => {
  const round = pieces.find(({ piece }) => piece === "round");
  const wrong = (change) => ({ ...round, treatment: { ...treatment, ...change } });
  checkPiece(wrong({}));
  for (const change of [{ unit: "m" }, { low: 0 }, { high: 1 }, { high: 2.5 }, { low: 1.5 }, { high: 1e7 }, { unit: "\u00b5m", low: 2, high: 2, target: 2 }, { cell: [1] }, { places: [1] }, { steps: [[0, ["a"], [1]]] }, { steps: [[0, [1]]] }, { step: null }]) {
    assert.throws(() => checkPiece(wrong(change)), /lacks a field/, JSON.stringify(change));
  }
});
