import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const css = readFileSync("src/style/page.css", "utf8");
const blocks = [...css.matchAll(/\{([^{}]*--paper:[^{}]*)\}/g)].map(([, block]) => Object.fromEntries([...block.matchAll(/--([\w-]+):\s*(#[0-9a-f]{6})\b/g)].map(([, name, value]) => [name, value])))
  // System colours have no values.
  .filter(({ paper }) => paper);

const luminance = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
  .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

/** WCAG 2.2: contrast of 4.5 for text, and of 3 for marks with a meaning. */
const TEXT = [["ink", "paper"], ["ink", "card"], ["ink", "lane"], ["ink", "round"], ["ink", "wiping"], ["ink", "hover"], ["quiet", "paper"], ["quiet", "card"], ["quiet", "hover"], ["quiet", "lane"], ["paper", "accent"], ["paper", "bad"], ["good", "good-ground"], ["bad", "bad-ground"], ["target", "paper"]];
const MARKS = ["believed", "estimated", "actual", "seen", "by-touch", "contact", "force", "height", "cursor", "collision", "hand", "event", "pushed", "found"];

test("each colour has one light and one dark value", () => {
  assert.equal(blocks.length, 2);
  assert.deepEqual(Object.keys(blocks[0]).sort(), Object.keys(blocks[1]).sort());
});

for (const [name, block] of [["light", blocks[0]], ["dark", blocks[1]]]) {
  test(`${name}: text and marks stand out`, () => {
    for (const [front, ground] of TEXT) assert.ok(contrast(block[front], block[ground]) >= 4.5, `${front} on ${ground}: ${contrast(block[front], block[ground]).toFixed(2)}`);
    for (const mark of MARKS) assert.ok(contrast(block[mark], block.paper) >= 3, `${mark}: ${contrast(block[mark], block.paper).toFixed(2)}`);
  });
}
