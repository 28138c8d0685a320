// Drives the studio as a user would: from an empty memory to the comparison of two runs.
import { chromium } from "playwright-core";
import assert from "node:assert/strict";
import { join } from "node:path";
import { begin } from "./studio.mjs";

const pictures = process.argv[2];
/** Maximum duration of a run [ms]. */
const RUN_MS = 300_000;
const SECOND_TASK = process.env.SECOND_TASK ?? "failure-human-push";

const studio = await begin();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-precise-memory-info"],
});
const complaints = [];
const figures = {};

/** Opens a page; collects the errors of its console. */
async function open(hash = "", options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.goto(studio.url + hash);
  return page;
}

const shoot = (page, name) => page.screenshot({ path: join(pictures, `${name}.png`) });
const clock = (page) => page.evaluate(() => window.wisch.stage.time);
const frames = (page) => page.evaluate(() => window.wisch.stage.shown[0]?.view.stage?.drawn ?? 0);
const ended = (page) => page.waitForFunction(() => window.wisch.stage.shown[0]?.recording.ended, null, { timeout: RUN_MS });
const step = (words) => console.log(`- ${words}`);

async function start(page, task) {
  await page.click("text=Start a task");
  await page.click(`[data-task="${task}"]`);
  await page.waitForFunction(() => location.hash.startsWith("#run="), null, { timeout: 30_000 });
}

async function example(page, number) {
  if (!(await page.isVisible(".s-chips"))) await page.click(".s-examples summary");
  await page.click(`[data-example="${number}"]`);
}

async function drag(page, selector, from, to) {
  const { x, y, width, height } = await page.locator(selector).first().boundingBox();
  const at = ([u, v]) => [x + u * width, y + v * height];
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at(to), { steps: 6 });
  await page.mouse.up();
}

try {
  step("an empty memory says so");
  const page = await open();
  await page.waitForSelector("text=This memory has no runs yet");
  await shoot(page, "01-empty");

  step("two clicks begin a run");
  await page.locator("text=Start a task").first().click();
  await page.waitForSelector("dialog[open]");
  await shoot(page, "02-start");
  await page.click('[data-task="chopping-board"]');
  await page.waitForFunction(() => location.hash.startsWith("#run="), null, { timeout: 30_000 });
  const begun = Date.now();

  step("the run is shown live");
  await page.waitForFunction(() => window.wisch.stage.shown[0]?.recording.rounds[0]?.count > 50, null, { timeout: RUN_MS });
  const [before, drawn, then] = [await clock(page), await frames(page), Date.now()];
  await page.waitForTimeout(2000);
  const [after, more, now] = [await clock(page), await frames(page), Date.now()];
  figures.liveFramesPerSecond = (1000 * (more - drawn)) / (now - then);
  assert.ok(after > before, `the clock goes on: ${before} to ${after}`);
  await shoot(page, "03-live");

  step("the clock can be paused and dragged");
  await page.keyboard.press("Space");
  const paused = await clock(page);
  await page.waitForTimeout(400);
  assert.equal(await clock(page), paused, "paused is paused");
  await drag(page, ".w-timeline", [0.3, 0.5], [0.2, 0.5]);
  const dragged = await clock(page);
  assert.notEqual(dragged, paused, "the timeline drags the clock");
  const still = await frames(page);
  await drag(page, ".w-canvas", [0.5, 0.5], [0.65, 0.45]);
  await page.waitForFunction((still) => window.wisch.stage.shown[0].view.stage.drawn > still, still);

  step("the run ends in the same view, with its summary, as an episode");
  await ended(page);
  figures.runSeconds = (Date.now() - begun) / 1000;
  await page.waitForFunction(() => location.hash.startsWith("#episode="), null, { timeout: 10_000 });
  await page.waitForSelector(".s-story:not([hidden])");
  await page.waitForSelector(".s-list a[aria-current]");
  await shoot(page, "04-ended");
  const first = new URLSearchParams(new URL(page.url()).hash.slice(1)).get("episode");

  step("a second run, in which a person pushes the robot");
  await start(page, SECOND_TASK);
  await ended(page);
  await page.waitForFunction(() => location.hash.startsWith("#episode="), null, { timeout: 10_000 });
  const second = new URLSearchParams(new URL(page.url()).hash.slice(1)).get("episode");
  await page.waitForFunction((id) => document.querySelector(`.s-list [data-key="${id}"] .s-badge`), second);

  step("the paper's query is one click away");
  await page.keyboard.press("/");
  await example(page, 0);
  await page.waitForSelector(".s-table tbody tr", { timeout: 60_000 });
  await page.waitForSelector(".w-named li", { timeout: 10_000 });
  const named = await page.locator(".w-named li").allTextContents();
  assert.ok(named.some((name) => name.startsWith("sponge")) && named.some((name) => name.startsWith("robot at")), named.join("; "));
  assert.match(page.url(), /q=owl_individual_of/);
  await page.waitForFunction((count) => window.wisch.stage.shown[0].view.stage.ghostCount === count, named.filter((name) => name.startsWith("robot at")).length);
  const middle = await page.locator(".w-named li", { hasText: "robot at" }).first().textContent();
  assert.ok(Math.abs((await clock(page)) - Number.parseFloat(middle.slice("robot at ".length))) < 0.06, `the clock is at ${await clock(page)}, not at M: ${middle}`);
  await shoot(page, "05-asked");
  await page.locator(".s-show").first().click();
  await shoot(page, "06-one-answer");

  step("an error is marked at its position in the query");
  await page.fill(".s-query", "low_performance(A P)");
  await page.press(".s-query", "Enter");
  await page.waitForSelector(".s-fault mark");
  assert.ok(await page.isHidden(".s-story"), "an answer closes the summary");
  assert.equal(await page.textContent(".s-fault mark"), "P");
  await shoot(page, "07-error");

  step("names are completed");
  await page.fill(".s-query", "");
  await page.type(".s-query", "final_per");
  await page.waitForSelector(".s-proposals li");
  await shoot(page, "08-completion");
  await page.press(".s-query", "Tab");
  assert.equal(await page.inputValue(".s-query"), "final_performance(Episode, P)");
  await page.fill(".s-query", "owl_individual_of(C, ");
  await page.type(".s-query", "HumanColl");
  await page.press(".s-query", "Tab");
  await page.type(".s-query", ")");
  assert.equal(await page.inputValue(".s-query"), "owl_individual_of(C, semco:'HumanCollision')");
  await page.press(".s-query", "Enter");
  await page.waitForSelector(".s-table tbody tr");

  step("strokes have their numbers on the timeline, and forces their unit");
  await page.fill(".s-query", "mean_force_per_stroke(Stroke, F)");
  await page.press(".s-query", "Enter");
  await page.waitForSelector("text=F [N]");
  assert.match(await page.locator(".s-table tbody tr").first().textContent(), /round 1, stroke 1\d+(\.\d+)?[a-z]/);

  step("a chart is drawn");
  await example(page, 5);
  await page.waitForSelector(".s-plot svg");
  await shoot(page, "09-chart");

  step("particles are shown at their positions");
  await page.fill(".s-query", "show([particles(semco:'breadcrumbs')])");
  await page.press(".s-query", "Enter");
  await page.waitForFunction(() => [...document.querySelectorAll(".w-named li")].some((li) => /^estimated dirt after round/.test(li.textContent)), null, { timeout: 60_000 });
  await page.waitForTimeout(1000);
  await shoot(page, "09-particles");

  step("a deep link is followed");
  const link = await open(`#episode=${second}&t=12.5&q=${encodeURIComponent("human_collision(Motion, C, [S, E])")}`);
  await link.waitForSelector(".s-remark");
  assert.equal(await link.locator(".s-table").count(), 0, "a query in a link waits for the user");
  assert.ok(Math.abs((await clock(link)) - 12.5) < 0.06, `the clock is at ${await clock(link)}`);
  await link.click(".s-ask .s-primary");
  await link.waitForSelector(".s-table tbody tr");
  await link.evaluate((id) => { location.hash = `#episode=${id}&t=3.0`; }, first);
  await link.waitForFunction((id) => window.wisch.stage.shown[0]?.id === id && Math.abs(window.wisch.stage.time - 3) < 0.06, first);
  await link.context().close();

  step("the time to the first frame is measured");
  const quick = await open(`#episode=${first}`);
  await quick.waitForFunction(() => window.wisch?.stage.shown[0]?.view.stage.drawn > 0);
  figures.firstFrameSeconds = await quick.evaluate(() => performance.now() / 1000);
  await quick.context().close();

  step("two runs are compared on one clock");
  await page.click("text=Runs");
  await page.click("text=Compare");
  await shoot(page, "10-picking");
  await page.click(`[data-key="${first}"]`);
  await page.waitForFunction(() => window.wisch.stage.shown.length === 2);
  await page.evaluate(() => window.wisch.stage.shown[0].view.seek(8));
  const times = await page.evaluate(() => window.wisch.stage.shown.map(({ view }) => view.clock.time));
  assert.deepEqual(times, [8, 8]);
  await page.waitForFunction(() => /^#compare=.*t=8\.0$/.test(location.hash), null, { timeout: 5000 });
  await page.waitForSelector('[data-curve="force-B"]', { state: "attached" });
  const differing = await page.locator('.s-compare tr[data-differs="true"] th').allTextContents();
  assert.ok(differing.includes("Events"), differing.join());
  await shoot(page, "11-compare");

  step("a run is stopped");
  await start(page, "chopping-board");
  await page.waitForSelector(".s-stop:not([hidden])");
  await page.waitForFunction(() => window.wisch.stage.shown[0]?.recording.rounds[0]?.count > 20, null, { timeout: RUN_MS });
  await page.click(".s-stop");
  await page.waitForFunction(() => window.wisch.stage.shown[0]?.recording.live === false, null, { timeout: 60_000 });
  // The executed part is interpreted and kept.
  await page.waitForSelector("text='kept as an episode'");
  assert.match(await page.textContent("body"), /the run was stopped/);
  await shoot(page, "12-stopped");

  step("the dark theme");
  await page.goto(`${studio.url}#episode=${second}&t=14`);
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForFunction((id) => window.wisch?.stage.shown[0]?.id === id, second);
  await page.keyboard.press("/");
  await example(page, 0);
  await page.waitForSelector(".w-named li");
  await shoot(page, "13-dark");

  step("a phone");
  const phone = await open(`#episode=${second}&t=14`, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await phone.waitForFunction(() => window.wisch?.stage.shown[0]?.view.stage.drawn > 0);
  await phone.waitForTimeout(500);
  await shoot(phone, "14-phone");
  const wide = () => phone.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok((await wide()) <= 0, "nothing is wider than the phone");
  await phone.click("text=Runs");
  await shoot(phone, "15-phone-runs");
  await phone.click("text=Ask");
  await example(phone, 0);
  await phone.waitForFunction(() => document.querySelector(".s-side")?.dataset.open === "");
  await phone.waitForTimeout(500);
  await shoot(phone, "16-phone-asked");
  assert.ok((await wide()) <= 0, "nothing is wider than the phone");

  assert.deepEqual(complaints, [], "the console is silent");
} catch (error) {
  for (const [i, context] of browser.contexts().entries()) for (const page of context.pages()) await shoot(page, `failed-${i}`).catch(() => {});
  console.error(complaints);
  throw error;
} finally {
  await browser.close();
  const code = await studio.end();
  if (code !== 0) console.error(`the studio ended with ${code}`);
}
console.log(figures, `pictures: ${pictures}`);
