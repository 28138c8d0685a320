import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const css = readFileSync("src/style/page.css", "utf8");
const blocks = [...css.matchAll(/\{([^{}]*--paper:[^{}]*)\}/g)].map(([, block]) => Object.fromEntries([...block.matchAll(/--([\w-]+):\s*(#[0-9a-f]{6})\b/g)].map(([, name, value]) => [name, value])))
  // System colours have no values.
  .filter(({ paper }) => paper);

const channels = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
const luminance = (hex) => channels(hex).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

/** WCAG 2.2: contrast of 4.5 for text, and of 3 for marks with a meaning. */
const TEXT = [["ink", "paper"], ["ink", "card"], ["ink", "lane"], ["ink", "round"], ["ink", "wiping"], ["ink", "hover"], ["quiet", "paper"], ["quiet", "card"], ["quiet", "hover"], ["quiet", "lane"], ["paper", "accent"], ["paper", "bad"], ["good", "good-ground"], ["bad", "bad-ground"], ["target", "paper"]];
const MARKS = ["believed", "estimated", "actual", "seen", "by-touch", "contact", "force", "height", "cursor", "collision", "hand", "event", "push", "found"];

/** Colours as they are seen (Machado et al. 2009, severity 1), in CIELAB. */
const EYES = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanope: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranope: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanope: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const lab = (hex, eyes) => {
  const linear = channels(hex);
  const [r, g, b] = eyes.map((row) => Math.min(1, Math.max(0, row.reduce((sum, v, i) => sum + v * linear[i], 0))));
  const [x, y, z] = [(0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505, 0.2126 * r + 0.7152 * g + 0.0722 * b, (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089].map((t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
};
const difference = (a, b, eyes) => {
  const [from, to] = [lab(a, eyes), lab(b, eyes)];
  return Math.hypot(...from.map((v, i) => v - to[i]));
};

test("each colour has one light and one dark value", () => {
  assert.equal(blocks.length, 2);
  assert.deepEqual(Object.keys(blocks[0]).sort(), Object.keys(blocks[1]).sort());
});

for (const [name, block] of [["light", blocks[0]], ["dark", blocks[1]]]) {
  test(`${name}: text and marks stand out`, () => {
    for (const [front, ground] of TEXT) assert.ok(contrast(block[front], block[ground]) >= 4.5, `${front} on ${ground}: ${contrast(block[front], block[ground]).toFixed(2)}`);
    for (const mark of MARKS) assert.ok(contrast(block[mark], block.paper) >= 3, `${mark}: ${contrast(block[mark], block.paper).toFixed(2)}`);
  });

  test(`${name}: too little, allowed and too much of a map differ for all eyes`, () => {
    const names = Object.keys(block).filter((one) => /^(little|allowed|much)-/.test(one));
    assert.equal(names.length, 9);
    const degree = (one) => one.split("-")[0];
    for (const [kind, eyes] of Object.entries(EYES)) {
      for (const a of names) {
        for (const b of names.filter((other) => other > a)) {
          const least = degree(a) === degree(b) ? 5 : kind === "usual" ? 20 : 10;
          assert.ok(difference(block[a], block[b], eyes) >= least, `${a} and ${b}, ${kind}`);
        }
      }
    }
  });
}
