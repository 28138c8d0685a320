// The page of the studio on a minimal document: which requests it sends to its server, and when.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawAnswers } from "../src/studio/answers.ts";
import { startStudio } from "../src/studio/main.ts";
import { readRecording } from "../src/studio/server.ts";
import { badge } from "../src/studio/side.ts";
import { makeStrip } from "../src/studio/strip.ts";

class Fake extends EventTarget {
  children = [];
  dataset = {};
  style = {};
  value = "";
  hidden = false;
  own = "";
  attributes = new Map();
  classList = { add() {}, remove() {}, toggle() {} };
  setAttribute(name, value) { this.attributes.set(name, value); }
  removeAttribute(name) { this.attributes.delete(name); }
  toggleAttribute() {}
  append(...children) { this.children.push(...children); }
  replaceChildren(...children) { this.children = children; }
  querySelector() { return null; }
  querySelectorAll() { return []; }
  focus() {}
  click() { this.dispatchEvent(new Event("click")); }
  get textContent() { return this.own + this.children.map((child) => (typeof child === "string" ? child : child.textContent)).join(""); }
  set textContent(text) {
    this.own = text;
    this.children = [];
  }
  /** This element and its descendants. */
  *all() {
    yield this;
    for (const child of this.children) if (child instanceof Fake) yield* child.all();
  }
}

const OVERVIEW = { memory: "episodes", list: { episodes: [], total: 0, broken: [] }, runs: [], scenarios: [], limits: { answers: 1, seconds: 1 } };
const WORDS = { predicates: [], builtins: [], classes: [], properties: [], individuals: [], examples: [] };
const ANSWERS = { columns: [], units: [], names: {}, rows: [[]], about: [[]], holds: true, more: false, seconds: 0, printed: "", remarks: [], view: null };

/** Opens the page at an address; `asked` collects its queries. */
async function open(hash) {
  const asked = [];
  const window = new EventTarget();
  Object.assign(globalThis, {
    window, addEventListener: window.addEventListener.bind(window), location: { hash, pathname: "/" },
    document: Object.assign(new Fake(), { documentElement: new Fake(), createElement: () => new Fake(), createElementNS: () => new Fake() }),
    history: { replaceState() {}, pushState() {} },
    matchMedia: () => Object.assign(new EventTarget(), { matches: false }),
    EventSource: class extends EventTarget {},
    fetch: async (path, { body } = {}) => {
      if (path === "api/ask") asked.push(JSON.parse(body).query);
      return Response.json(path === "api/ask" ? ANSWERS : path === "api/vocabulary" ? WORDS : OVERVIEW);
    },
  });
  const root = new Fake();
  startStudio(root, new Fake());
  const rest = () => new Promise((done) => setTimeout(done, 20));
  await rest();
  const find = (wanted) => [...root.all()].find(wanted);
  return { asked, root, rest, find, go: async (to) => {
    location.hash = to;
    window.dispatchEvent(new Event("hashchange"));
    await rest();
  } };
}

const TELL = "tell(has_type(x, semco:'Sponge'))";

test("a query in the address is filled in, and runs only when the user asks it", async () => {
  const page = await open(`#q=${encodeURIComponent(TELL)}`);
  const field = page.find(({ attributes }) => attributes.get("aria-label") === "Query in Prolog");
  assert.equal(field.value, TELL);
  assert.deepEqual(page.asked, []);
  assert.match(page.root.textContent, /Press Ask to run it/);
  page.find((one) => one.textContent === "Ask" && one.attributes.get("class")?.includes("s-primary")).click();
  await page.rest();
  assert.deepEqual(page.asked, [TELL]);
  assert.doesNotMatch(page.root.textContent, /Press Ask to run it/);
});

test("a query that the address gets later does not run by itself", async () => {
  const page = await open("");
  await page.go(`#q=${encodeURIComponent(TELL)}`);
  const field = page.find(({ attributes }) => attributes.get("aria-label") === "Query in Prolog");
  assert.equal(field.value, TELL);
  assert.deepEqual(page.asked, []);
});

test("a recording is read line by line, however the response is split", async () => {
  const text = '{"piece":"head","title":"Küche"}\n{"piece":"samples"}\n{"piece":"ended"}';
  const bytes = new TextEncoder().encode(text);
  for (const size of [1, 2, 7, bytes.length]) {
    const pieces = [];
    for (let at = 0; at < bytes.length; at += size) pieces.push(bytes.slice(at, at + size));
    globalThis.fetch = async () => new Response(new ReadableStream({
      pull(controller) {
        const piece = pieces.shift();
        if (piece) controller.enqueue(piece);
        else controller.close();
      },
    }));
    const lines = [];
    await readRecording("20261122-010000-abcd", (line) => lines.push(line));
    assert.deepEqual(lines, text.split("\n"));
  }
});

test("an undecidable episode is neither met nor missed", () => {
  const state = (met, verdict, performance) => badge({ met, verdict, performance }).attributes.get("data-state");
  assert.equal(state(true, "goal met", 0.97), "met");
  assert.equal(state(false, "no progress", 0.4), "unmet");
  assert.equal(state(false, "performance unknown", 0.4), "unknown");
  assert.equal(state(false, "undecided by touch", 0.9), "unknown");
  assert.equal(state(false, "cannot be told", 0.4), "unknown");
  assert.equal(state(false, "cannot be told", null), "unknown");
  assert.equal(state(false, "unknowable by touch", 0.9), "unknown");
  assert.equal(state(false, null, null), "none");
});

test("the list has a run's ending, not the verdict on its last round", async () => {
  await open("");
  const made = badge({ met: false, verdict: "wipe again", badge: "undecided by touch", performance: 0.9 });
  assert.deepEqual(["data-state", "title"].map((name) => made.attributes.get(name)), ["unknown", "undecided by touch"]);
  assert.equal(badge({ met: false, verdict: "wipe again", performance: 0.9 }).attributes.get("title"), "not met");
});

test("a table of answers names individuals as the timeline does, with units in its head", async () => {
  await open("");
  const mention = { episode: "20261122-010000-abcd", task: "board", begun: 1795777372, class: "Stroke", interval: [0, 1] };
  const name = "semco:Stroke_20261122-010000-abcd-10";
  const parts = drawAnswers({
    ...ANSWERS, columns: ["Stroke", "P", "F", "Tilt", "D", "N", "Slope"], units: [null, "share", "N", "rad", "m", null, "m per episode"],
    names: { [name]: "round 1, stroke 3" }, rows: [[name, 0.725, 7.456, 0.0349, 0.00699, 3, -0.002]], about: [[mention]], remarks: [],
  }, { show() {}, clear() {} });
  const all = parts.flatMap((part) => [...part.all()]);
  const texts = (width) => all.filter(({ attributes }) => width(attributes)).map(({ textContent }) => textContent);
  assert.deepEqual(texts((attributes) => attributes.get("scope") === "col"), ["show", "Stroke", "P [%]", "F [N]", "Tilt [\u00b0]", "D [mm]", "N", "Slope [mm per episode]", "Episode"]);
  assert.deepEqual(texts((attributes) => attributes.get("class") === "s-number"), ["72.5", "7.46", "2", "6.99", "3", "\u22122"]);
  assert.deepEqual(texts((attributes) => attributes.get("title") === name), ["round 1, stroke 3"]);
  assert.match(texts((attributes) => attributes.get("title") === mention.episode).join(), /^board, 27 Nov, /);
  assert.deepEqual(all.filter(({ attributes }) => attributes.get("class") === "s-number").map(({ attributes }) => attributes.get("title")), ["0.725", "7.456 N", "0.0349 rad", "0.00699 m", "3", "-0.002 m per episode"]);
});

test("the strip of an episode shows its rounds and events in their places, and its estimate", async () => {
  await open("");
  const event = (name, start, end, count = 1) => ({ class: name, start, end, count });
  const episode = { seconds: 20, round_starts: [0, 15], events: [event("HumanCollision", 5, 6, 2), event("ContactLoss", 10, 12), event("Unknown", 1, 2)], performance: 0.9, low: 0.8, high: 1, target: 0.95 };
  const [time, estimate] = makeStrip(episode).children;
  const places = time.children.map(({ attributes }) => [attributes.get("x"), attributes.get("width")]);
  assert.deepEqual(places, [["0.00%", "75.00%"], ["75.00%", "25.00%"], ["25.00%", "5.00%"], ["50.00%", "10.00%"], ["25.00%", undefined], ["50.00%", undefined]]);
  assert.equal(time.attributes.get("aria-hidden"), "true", "the line below has the events in words");
  assert.equal(estimate.attributes.get("aria-label"), "estimated 90\u202f% (90\u202f%: 80\u202f% to 100\u202f%), target 95\u202f%");
  assert.equal(makeStrip({ ...episode, performance: null }).children.length, 1);
  assert.equal(makeStrip({ ...episode, seconds: 0 }), null);
});
