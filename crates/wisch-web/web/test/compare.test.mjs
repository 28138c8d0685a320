// What differs between two recordings, and their curves on a common clock.
import assert from "node:assert/strict";
import { test } from "node:test";
import { contactWay, differencesOf, envelopeOf } from "../src/studio/compare.ts";
import { Recording } from "../src/store.ts";
import { endText, stateOf } from "../src/words.ts";
import { lines, sample } from "./sample.mjs";

const parts = sample();
const whole = Recording.parse(lines(parts));

/** The first round alone, by another tool. */
const short = Recording.parse(lines(parts.filter(({ round = 1, piece }) => round <= 1 && piece !== "ended").map((one) =>
  (one.piece === "head" ? { ...one, task: { ...one.task, tool: "cloth" } } : one))));

test("differences are stated with their sign and unit", () => {
  const rows = new Map(differencesOf(whole, short).map(({ label, texts, by }) => [label, { texts, by }]));
  assert.deepEqual(rows.get("Tool"), { texts: [whole.head.task.tool, "cloth"], by: "differs" });
  assert.equal(rows.get("Medium").by, "");
  assert.deepEqual(rows.get("Rounds").texts, [String(whole.rounds.length), "1"]);
  assert.match(rows.get("Duration").by, /^\u2212\d+\.\d\u202fs$/);
  assert.match(rows.get("Way in contact").by, /^\u2212\d+\.\d\d\u202fm$/);
  assert.match(rows.get("Estimated, last round").texts[0], /^\d+\u202f% \(90\u202f%: \d+\u202f% to \d+\u202f%\)$/);
  assert.equal(rows.get("Result").texts[1], "ended early");
  for (const { by } of differencesOf(whole, whole)) assert.equal(by, "");
});

test("what both recordings lack is unknown, not the same", () => {
  const blind = Recording.parse(lines(parts.filter(({ piece }) => piece !== "truth")));
  const rows = new Map(differencesOf(blind, blind).map(({ label, by }) => [label, by]));
  assert.deepEqual([rows.get("True, last round"), rows.get("Medium")], ["\u2013", ""]);
  assert.equal(differencesOf(short, whole).find(({ label }) => label === "Rounds").by, "+1");
});

test("a performance that is unknown has no difference", () => {
  const unknown = Recording.parse(lines(parts.map((one) => (one.piece === "ended" ? { ...one, met: false, verdict: "performance unknown" } : one))));
  const row = differencesOf(unknown, short).find(({ label }) => label.startsWith("Estimated"));
  assert.match(row.texts[0], /^performance unknown \(/);
  assert.equal(row.by, "differs");
});

test("all parts state alike how a run ended, and a plan that nobody executed neither met nor missed its goal", () => {
  const change = (pick, more) => Recording.parse(lines(parts.map((one) => (one.piece === pick ? { ...one, ...more } : one))));
  const result = (recording) => differencesOf(recording, recording).find(({ label }) => label === "Result").texts[0];
  const stopped = change("ended", { met: false, badge: "protective stop" });
  assert.deepEqual(stateOf(stopped), { state: "unmet", text: "protective stop" });
  assert.equal(result(stopped), "protective stop");
  assert.deepEqual(stopped.rounds.map((round) => endText(stopped, round)), [stopped.rounds[0].interpreted.verdict, "protective stop"]);
  const bare = parts.filter(({ piece }) => ["head", "round", "ended"].includes(piece));
  for (const met of [true, false]) {
    const planned = Recording.parse(lines(bare.map((one) => ({ ...one, ...(one.piece === "round" ? { kind: "planned" } : one.piece === "ended" ? { met, verdict: null, badge: null } : {}) }))));
    assert.deepEqual(stateOf(planned), { state: "planned", text: "planned only" });
    assert.equal(result(planned), "planned only");
    assert.equal(endText(planned, planned.rounds[0]), "planned only");
  }
});

test("the way in contact is that of the strokes", () => {
  const bare = { ...parts[0] };
  assert.equal(contactWay(Recording.parse(lines([bare]))), null);
  const way = contactWay(whole);
  assert.ok(way > 0.3 && way < 5, `${way} m`);
  assert.ok(contactWay(short) < way);
});

test("curves lie on the common clock", () => {
  const duration = 2 * whole.duration;
  const curve = envelopeOf(whole, ({ normal }) => normal, duration, 100);
  assert.equal(curve.length, 100);
  assert.deepEqual(curve.slice(52), Array(48).fill(null), "nothing after the end");
  const most = Math.max(...curve.flatMap((range) => range?.[1] ?? []));
  assert.equal(most, Math.max(...whole.rounds.map(({ normal }) => normal.largest)));
});
