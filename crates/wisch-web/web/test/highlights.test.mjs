import assert from "node:assert/strict";
import { test } from "node:test";
import { ROWS, tagsOf } from "../src/timeline/highlights.ts";

const measure = (text) => 6 * text.length;
const at = (...list) => list.map(([x, label]) => ({ x, label }));
const overlap = (tags) => tags.some((a, i) => tags.some((b, k) => k > i && a.row === b.row && a.x < b.x + b.width && b.x < a.x + a.width));

test("close names move up a row, and later names return to the first row", () => {
  const tags = tagsOf(at([100, "HumanCollision"], [120, "Unreached"], [400, "Wiping"]), measure, 1000);
  assert.deepEqual(tags.map(({ text, row }) => [text, row]), [["HumanCollision", 0], ["Unreached", 1], ["Wiping", 0]]);
});

test("close equal names become one name with their count", () => {
  const tags = tagsOf(at([100, "HumanCollision"], [130, "HumanCollision"], [150, "HumanCollision"], [700, "HumanCollision"]), measure, 1000);
  assert.deepEqual(tags.map(({ text, x }) => [text, x]), [["HumanCollision \u00d73", 100], ["HumanCollision", 700]]);
});

test("many names neither overlap nor leave the timeline", () => {
  const bands = Array.from({ length: 300 }, (_, i) => ({ x: 50 + ((i * 977) % 900), label: `event ${i % 40} of a long name` }));
  const tags = tagsOf(bands, measure, 960);
  assert.ok(tags.length > 6);
  assert.equal(overlap(tags), false);
  for (const { x, width, row } of tags) assert.ok(x + width <= 960 && row < ROWS);
});
