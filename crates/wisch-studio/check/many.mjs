// Many pages that follow one live run: `node many.mjs [10]`, with the programs named as in `run`. At the end, each page must hold
// every piece of the kept episode, and its console must be silent.
import { chromium } from "playwright-core";
import assert from "node:assert/strict";
import { loadavg } from "node:os";
import { begin } from "./studio.mjs";

const count = Number(process.argv[2] ?? 10);
const RUN_MS = 500_000;
const studio = await begin();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || "/usr/bin/chromium",
  // Software rendering, as in a browser without a graphics card.
  args: ["--no-sandbox", "--enable-unsafe-swiftshader"],
});
const complaints = [];

async function open() {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
  page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.goto(studio.url);
  return page;
}

/** Returns a summary of the recording that a page shows. */
const known = (page) => page.evaluate(() => {
  const { recording } = window.wisch.stage.shown[0];
  return {
    rounds: recording.rounds.map((round) => [round.number, round.count, round.t.last, round.judged?.verdict]),
    stages: recording.stages.length, broken: recording.broken, unknown: recording.unknown,
    // The kept recording does not contain the name of its episode.
    ended: { ...recording.ended, episode: null },
  };
});

try {
  const first = await open();
  await first.click("text=Start a task");
  await first.click('[data-task="chopping-board"]');
  await first.waitForFunction(() => location.hash.startsWith("#run="), null, { timeout: 60_000 });
  const begun = Date.now();
  const pages = [first, ...(await Promise.all(Array.from({ length: count - 1 }, open)))];
  await Promise.all(pages.map((page) => page.waitForFunction(() => window.wisch?.stage.shown[0]?.recording.rounds.length, null, { timeout: RUN_MS })));
  const here = (Date.now() - begun) / 1000;
  const frames = () => Promise.all(pages.map((page) => page.evaluate(() => [performance.now(), window.wisch.stage.shown[0].view.stage.drawn])));
  const before = await frames();
  await Promise.all(pages.map((page) => page.waitForFunction(() => window.wisch.stage.shown[0].recording.ended, null, { timeout: RUN_MS })));
  const after = await frames();
  const rates = after.map(([now, drawn], i) => (1000 * (drawn - before[i][1])) / (now - before[i][0]));
  await Promise.all(pages.map((page) => page.waitForFunction(() => location.hash.startsWith("#episode="), null, { timeout: 60_000 })));
  const all = await Promise.all(pages.map(known));
  const kept = await open();
  await kept.waitForFunction(() => window.wisch?.stage.shown[0]?.recording.ended && location.hash !== "", null, { timeout: 60_000 }).catch(() => {});
  const whole = await known(kept);
  assert.equal(all.length, count);
  for (const one of all) assert.deepEqual(one, whole, "a page lacks something");
  assert.equal(whole.broken + whole.unknown, 0);
  assert.deepEqual(complaints, [], "the console is silent");
  console.log({
    pages: count, allHereSeconds: here, runSeconds: (Date.now() - begun) / 1000, samples: whole.rounds.map(([, samples]) => samples),
    framesPerSecond: rates.map((rate) => Math.round(10 * rate) / 10).join(" "), load: loadavg().map((load) => load.toFixed(1)).join(" "),
  });
} finally {
  console.error(complaints.slice(0, 5));
  await browser.close();
  await studio.end();
}
