// What differs between two recordings, and their curves on a common clock.
import assert from "node:assert/strict";
import { test } from "node:test";
import { contactWay, differencesOf, envelopeOf } from "../src/studio/compare.ts";
import { Recording } from "../src/store.ts";
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
  assert.match(rows.get("Estimated, with 90\u202f% interval").texts[0], /^\d+\u202f% \(\d+\u202f% to \d+\u202f%\)$/);
  assert.equal(rows.get("Result").texts[1], "ended early");
  for (const { by } of differencesOf(whole, whole)) assert.equal(by, "");
});

test("a performance that is unknown has no difference", () => {
  const unknown = Recording.parse(lines(parts.map((one) => (one.piece === "ended" ? { ...one, met: false, verdict: "performance unknown" } : one))));
  const row = differencesOf(unknown, short).find(({ label }) => label.startsWith("Estimated"));
  assert.match(row.texts[0], /^performance unknown \(/);
  assert.equal(row.by, "differs");
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
