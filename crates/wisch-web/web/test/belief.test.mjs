// The belief at the end of a round against the ground truth.
import assert from "node:assert/strict";
import { test } from "node:test";
import { compareWithTruth, countInCells, isComparable, spreadOf } from "../src/belief.ts";
import { Recording } from "../src/store.ts";
import { lines, polished, sample } from "./sample.mjs";

const pieces = sample();
const open = (change = (piece) => piece) => Recording.parse(lines(pieces.map(change)));
const only = (kind, number, change) => (piece) => (piece.piece === kind && piece.round === number ? { ...piece, ...change } : piece);
const GOAL = pieces.find(({ piece }) => piece === "round").goal;

test("numbers of particles in the goal area and elsewhere are those of the density and of the truth", () => {
  const [x, y] = GOAL.place.map((v) => Math.round(1e4 * v));
  const density = { cell: 0.002, places: [x, y, -x, -y], expected: [6.2, 4], goal: 6.1 };
  const actual = [x, y, x, y, x, y, x, y, -x, -y, -x, -y, -x, -y];
  const change = (piece) => only("truth", 1, { particles: actual, performance: 0.5 })(only("interpreted", 1, { density, estimate: { mean: 0.62, low: 0.55, high: 0.7 } })(piece));
  const [round] = open(change).rounds;
  assert.deepEqual(compareWithTruth(round), [
    ["In the goal area", "6", "4", "2 particles"], ["Elsewhere on the surface", "4", "3", "1 particle"], ["Area that holds 90\u202f% of the dirt", "0 cm\u00b2", "0 cm\u00b2", ""],
    ["Performance", "62.0\u202f%", "50.0\u202f%", "12.0 points, outside the interval"],
  ]);
  const cells = open((piece) => only("interpreted", 1, { density: { ...density, goal: undefined }, particles: [x, y, 0, 0] })(change(piece))).rounds[0];
  assert.deepEqual(compareWithTruth(cells).slice(0, 1), [["Left on the surface", "10", "7", "3 particles"]], "cells on the edge of the goal say too little");
  const thinned = open((piece) => only("truth", 1, { remaining: 70 })(only("interpreted", 1, { density: { ...density, remaining: 68.4 } })(change(piece)))).rounds[0];
  assert.deepEqual(compareWithTruth(thinned).slice(0, -1), [["Left on the surface", "68", "70", "2 particles"]], "a part of the particles is not compared with all");
  const skimmed = open((piece) => only("round", 1, { goal: { kind: "skimmed" } })(change(piece))).rounds[0];
  assert.deepEqual(compareWithTruth(skimmed)[0], ["Left on the surface", "10", "7", "3 particles"]);
  const inside = open((piece) => only("truth", 1, { performance: 0.56 })(change(piece))).rounds[0];
  assert.match(compareWithTruth(inside)[3][3], /^6\.0 points, inside/);
  const tie = open((piece) => only("truth", 1, { performance: 0.5625 })(change(piece))).rounds[0];
  assert.deepEqual(compareWithTruth(tie)[3].slice(1), ["62.0\u202f%", "56.2\u202f%", "5.8 points, inside the interval"], "the difference of what is shown");
});

test("a wider belief covers more area", () => {
  assert.equal(spreadOf([]), 0);
  assert.equal(spreadOf([0, 0]), 0);
  assert.equal(spreadOf([10]), 1);
  assert.equal(spreadOf(Array.from({ length: 10 }, () => 1)), 9);
  assert.equal(spreadOf([0.1, 0.8, 0.1, 9]), 1, "the fewest cells");
  const [first, second] = open().rounds.map(({ interpreted }) => spreadOf(interpreted.density.expected));
  assert.ok(first > 1.3 * second, `${first} cells after the push, ${second} later`);
  assert.deepEqual(countInCells([50, 50, 99, 1, 150, 50, -951, 50], { cell: 0.01, places: [50, 50], expected: [1] }).sort(), [1, 1, 2]);
});

test("without a density the typical sample is compared, and said to be one", () => {
  const [round] = open(only("interpreted", 1, { density: undefined })).rounds;
  const rows = compareWithTruth(round);
  assert.deepEqual(rows.map(([quantity]) => quantity), ["In the goal area (sample)", "Elsewhere on the surface (sample)", "Performance"]);
  const total = (column) => rows.slice(0, 2).reduce((sum, row) => sum + Number(row[column]), 0);
  assert.deepEqual([total(1), total(2)], [300, 300]);
  assert.deepEqual(rows.slice(0, 2).map((row) => row[3]), ["", ""], "one sample is no error of the belief");
});

test("passes are compared place by place", () => {
  const recording = Recording.parse(lines(polished(pieces)));
  // Estimated 0 to 4 passes in 32 columns, true 0 to 5: 12, 16 and 4 of them have too little, enough and too much, and 10, 12 and 10.
  assert.deepEqual(compareWithTruth(recording.rounds[1]).slice(0, 2), [
    ["Mean passes", "2.00", "2.50", "0.50"], ["Places whose mean is in the band", "50.0\u202f%", "37.5\u202f%", "192 of 768 places"],
  ]);
});

test("only a round with a result and the truth of the same places is comparable", () => {
  const comparable = (change) => open(change).rounds.map(isComparable);
  assert.deepEqual(comparable(), [true, true]);
  assert.deepEqual(comparable(only("truth", 2, { particles: null })), [true, false]);
  assert.deepEqual(Recording.parse(lines(pieces.filter(({ piece }) => piece !== "interpreted"))).rounds.map(isComparable), [false, false]);
  const old = polished(pieces).map(({ treatment, treated, ...piece }) => (piece.piece === "truth" ? { ...piece, particles: [1, 2] } : piece));
  assert.deepEqual(Recording.parse(lines(old)).rounds.map(isComparable), [false, false], "the places of a treated surface are no dirt");
  for (const density of [{ cell: 0, places: [], expected: [] }, { cell: 0.01, places: [1, 2, 3], expected: [1] }, { cell: 0.01, places: [1, 2], expected: ["<b>"] }, []]) {
    assert.equal(open(only("interpreted", 1, { density })).broken, 1, "a piece with a wrong density is left out");
  }
});
