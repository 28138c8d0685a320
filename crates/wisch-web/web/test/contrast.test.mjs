import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { REACH_BANDS } from "../src/bases.ts";
import { LEAST_LIGHT } from "../src/scene/grains.ts";
import { BLINDNESS, blend, contrast, difference, differenceOfLab, lit, seenWith } from "./colours.mjs";

const colourBlocks = (css, name) => [...css.matchAll(/\{([^{}]*)\}/g)].map(([, block]) => Object.fromEntries([...block.matchAll(/--([\w-]+):\s*(#[0-9a-f]{6})\b/g)].map(([, each, value]) => [each, value])))
  // System colours have no values.
  .filter((colours) => colours[name]);
const blocks = colourBlocks(readFileSync("src/style/page.css", "utf8"), "paper");
/** Colours of the two compared recordings of the studio, and those of the figures by their names. */
const compared = colourBlocks(readFileSync("src/studio/studio.css", "utf8"), "first");
const figures = [...readFileSync("../../wisch-report/src/draw/palette.rs", "utf8").matchAll(/\("([\w-]+)", "(#[0-9a-f]{6})", "(#[0-9a-f]{6})"\)/g)];
blocks.forEach((colours, i) => Object.assign(colours, compared[i], { node: figures.find(([, name]) => name === "node")[2 + i] }));
const THEMES = [["light", blocks[0]], ["dark", blocks[1]]];

/** WCAG 2.2: contrast of 4.5 for text, and of 3 for marks with a meaning. */
const TEXT = [["ink", "paper"], ["ink", "card"], ["ink", "lane"], ["ink", "round"], ["ink", "wiping"], ["ink", "hover"], ["quiet", "paper"], ["quiet", "card"], ["quiet", "hover"], ["quiet", "lane"], ["paper", "accent"], ["paper", "bad"], ["bad", "card"], ["good", "good-ground"], ["bad", "bad-ground"], ["target", "paper"], ["target", "card"], ["paper", "first"], ["paper", "second"]];
const TRACKS = [1, 2, 3, 4, 5, 6].map((i) => `track-${i}`);
const MARK_CONTRAST = 3;
/** Least differences (CIEDE2000) of marks: for all eyes, and for those of the three common colour blindnesses. */
const APART = 20;
const APART_BLIND = 10;

/** Opacity of the goal area in the scene and in pictures, and light on the board in a shadow. */
const GOAL_IN_SCENE = 0.22;
const GOAL_IN_PICTURE = 0.25;
const SHADOW = 0.82;

/** What marks lie on: the board in the scene, also in the goal and in a shadow; the rest of the scene; pictures of the board; lanes. */
const grounds = (c) => ({
  board: [c["surface-3d"], c["sheet-3d"]].flatMap((board) => [board, blend(c.goal, board, GOAL_IN_SCENE), lit(board, SHADOW)]),
  scene: [c.scene, c["scene-low"], c.carrier, c.obstacle],
  picture: [c.paper, c.card, c.ground, blend(c.goal, c.ground, GOAL_IN_PICTURE)],
  lanes: [c.paper, c.lane, c.card],
});
const LIES_ON = {
  believed: ["board", "picture", "lanes"], estimated: ["board", "picture", "lanes"], actual: ["board", "picture", "lanes"], seen: ["board", "picture"],
  found: ["board", "scene"], contact: ["board", "scene", "lanes"], pushed: ["board", "scene", "lanes"], lifted: ["board", "scene"], force: ["board", "scene", "lanes"],
  collision: ["board", "scene", "lanes"], hand: ["board", "scene", "lanes"], event: ["board", "scene", "lanes"],
  "force-little": ["board", "scene"], "force-target": ["board", "scene"], "force-much": ["board", "scene"],
  tool: ["board", "scene"], stroke: ["board", "picture"], chosen: ["board", "picture"], rejected: ["board", "scene"], quiet: ["scene"], ink: ["scene"], "goal-line": ["board", "picture"], target: ["lanes"], height: ["lanes"], "by-touch": ["lanes"], cursor: ["lanes"],
  first: ["lanes"], second: ["lanes"], node: ["picture"], ...Object.fromEntries(TRACKS.map((track) => [track, ["board", "scene", "lanes"]])),
};

/** Marks of different meaning that appear in the same place. */
const PLACES = {
  "on the board": ["believed", "estimated", "actual", "seen", "contact", "lifted", "pushed", "force", "tool", "collision", "event", "goal-line", "rejected"],
  "along the path": ["force-little", "force-target", "force-much", "contact", "lifted", "pushed", "force", "collision", "rejected", "chosen"],
  "strokes of the plan": ["stroke", "chosen"],
  "outlines of the board": ["found", "actual", "goal-line"],
  "lane of performance": ["believed", "estimated", "actual", "by-touch", "target", "cursor"],
  "lane of events": ["collision", "hand", "event", "actual", "height", "cursor"],
  "lane of contact": ["contact", "pushed", "cursor"],
  "queried trajectories": [...TRACKS, "contact", "lifted", "pushed"],
  "curves of compared recordings": ["first", "second", "target", "cursor"],
  "figures of a plan": ["node", "believed", "estimated", "actual", "goal-line", "tool"],
  "lane of force": ["force", "collision", "pushed", "target", "cursor"],
};

/** Names that mean the same, and so have one colour. */
const SAME = [["hand", "pushed"], ["found", "estimated"], ["stroke", "believed"], ["goal-line", "target"], ["node", "contact"]];

test("the difference of colours is that of the published pairs", () => {
  // Sharma, Wu and Dalal (2005), table 1, pairs 1, 7, 17, 25 and 34.
  const pairs = [
    [[50, 2.6772, -79.7751], [50, 0, -82.7485], 2.0425], [[50, 0, 0], [50, -1, 2], 2.3669], [[50, 2.5, 0], [73, 25, -18], 27.1492],
    [[60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644], [[2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082],
  ];
  for (const [a, b, expected] of pairs) assert.ok(Math.abs(differenceOfLab(a, b) - expected) < 1e-4, `${a} and ${b}: ${differenceOfLab(a, b)}`);
});

test("each colour has one light and one dark value", () => {
  assert.equal(blocks.length, 2);
  assert.deepEqual(Object.keys(blocks[0]).sort(), Object.keys(blocks[1]).sort());
});

for (const [theme, colours] of THEMES) {
  test(`${theme}: text and marks stand out from all that they lie on`, () => {
    for (const [front, ground] of TEXT) assert.ok(contrast(colours[front], colours[ground]) >= 4.5, `${front} on ${ground}: ${contrast(colours[front], colours[ground]).toFixed(2)}`);
    const faint = Object.entries(LIES_ON).flatMap(([mark, places]) => places.flatMap((place) => grounds(colours)[place].map((ground) => [mark, place, ground, contrast(colours[mark], ground)])));
    assert.deepEqual(faint.filter(([, , , least]) => !(least >= MARK_CONTRAST)), []);
    // The side of a crumb that the sun does not reach.
    for (const ground of grounds(colours).board) assert.ok(contrast(lit(colours.believed, LEAST_LIGHT), ground) >= MARK_CONTRAST, `crumbs on ${ground}: ${contrast(lit(colours.believed, LEAST_LIGHT), ground).toFixed(2)}`);
  });

  test(`${theme}: marks of different meaning differ, also for colour-blind eyes`, () => {
    const alike = [];
    for (const [place, marks] of Object.entries(PLACES)) marks.forEach((a, i) => marks.slice(i + 1).forEach((b) => {
      const all = difference(colours[a], colours[b]);
      if (!(all >= APART)) alike.push([place, a, b, all]);
      for (const blindness of BLINDNESS) {
        const less = difference(seenWith(blindness, colours[a]), seenWith(blindness, colours[b]));
        if (!(less >= APART_BLIND)) alike.push([place, a, b, blindness, less]);
      }
    }));
    assert.deepEqual(alike, []);
    for (const [a, b] of SAME) assert.equal(colours[a], colours[b], `${a} means what ${b} means`);
  });

  test(`${theme}: all shades of a density stand out from pictures and legends, and from each other`, () => {
    const shares = [1, ...[...readFileSync("src/style/story.css", "utf8").matchAll(/\.w-density-\d \{ fill: color-mix\(in srgb, var\(--estimated\) (\d+)%, var\(--ink\)\)/g)].map(([, share]) => share / 100)];
    assert.equal(shares.length, 3);
    const shades = shares.map((share) => blend(colours.estimated, colours.ink, share));
    for (const shade of shades) for (const ground of grounds(colours).picture) assert.ok(contrast(shade, ground) >= MARK_CONTRAST, `${shade} on ${ground}`);
    for (const [i, shade] of shades.slice(1).entries()) assert.ok(difference(shade, shades[i]) >= 5, `${shade} and ${shades[i]}`);
  });

  test(`${theme}: too little, allowed and too much of a map differ for all eyes`, () => {
    const names = Object.keys(colours).filter((one) => /^(little|allowed|much)-/.test(one));
    assert.equal(names.length, 9);
    const degree = (one) => one.split("-")[0];
    for (const eyes of [null, ...BLINDNESS]) {
      const seen = (one) => (eyes ? seenWith(eyes, colours[one]) : colours[one]);
      for (const a of names) {
        for (const b of names.filter((other) => other > a)) {
          const least = degree(a) === degree(b) ? 5 : eyes ? APART_BLIND : APART;
          const found = difference(seen(a), seen(b));
          assert.ok(found >= least, `${a} and ${b}, ${eyes ?? "usual eyes"}: ${found}`);
        }
      }
    }
  });
}

test("each band of the base poses differs from the next, for all eyes", () => {
  for (const [theme, colours] of THEMES) for (const eyes of [null, ...BLINDNESS]) for (let i = 1; i < REACH_BANDS; i++) {
    const [a, b] = [i, i + 1].map((band) => (eyes ? seenWith(eyes, colours[`band-${band}`]) : colours[`band-${band}`]));
    assert.ok(difference(a, b) >= 3, `${theme}: bands ${i} and ${i + 1}, ${eyes ?? "usual eyes"}: ${difference(a, b)}`);
  }
});

test("figures and page have the same colours by the same names", () => {
  const [common, other] = [[], []];
  for (const [, name, light, dark] of figures) {
    if (!blocks[0][name]) continue;
    common.push(name);
    if (light !== blocks[0][name] || dark !== blocks[1][name]) other.push([name, light, blocks[0][name], dark, blocks[1][name]]);
  }
  assert.deepEqual(other, []);
  for (const name of ["paper", "ink", "believed", "estimated", "actual", "contact", "pushed", "collision", "goal", "target", "tool", "surface-3d"]) assert.ok(common.includes(name), `the figures have no ${name}`);
});
