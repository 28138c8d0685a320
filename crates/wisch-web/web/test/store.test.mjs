import assert from "node:assert/strict";
import { test } from "node:test";
import { PlotColumn, lastAtMost } from "../src/columns.ts";
import { trackParticles } from "../src/particles.ts";
import { Recording } from "../src/store.ts";
import { lines, numbers, sample } from "./sample.mjs";

const pieces = sample();
const text = lines(pieces);

test("a recording that arrives piece by piece equals one that is read at once", () => {
  const whole = Recording.parse(text);
  const live = new Recording();
  for (const piece of pieces) live.apply(piece);
  assert.equal(live.live, false);
  for (const t of [0, 3.21, 9.5, 17.31, 17.33, 25, whole.duration]) {
    const [a, b] = [whole.at(t), live.at(t)];
    assert.deepEqual(a.q, b.q);
    assert.deepEqual([a.tool, a.force, a.normal, a.time, a.phase], [b.tool, b.force, b.normal, b.time, b.phase]);
  }
  assert.deepEqual(whole.happenings, live.happenings);
});

test("rounds follow each other on the common clock", () => {
  const { rounds, duration } = Recording.parse(text);
  const [first, second] = pieces.filter(({ piece }) => piece === "interpreted");
  assert.equal(rounds[0].start, 0);
  assert.ok(Math.abs(rounds[1].start - first.duration) < 1e-9);
  assert.ok(Math.abs(duration - first.duration - second.duration) < 1e-9);
});

test("values between two samples are interpolated", () => {
  const recording = Recording.parse(text);
  const [{ t, q, normal, tool }] = pieces.filter(({ piece }) => piece === "samples");
  const share = 0.3;
  const instant = recording.at(t[4] + share * (t[5] - t[4]));
  const between = (a, b) => a + share * (b - a);
  for (const v of [0, 3, 6]) assert.ok(Math.abs(instant.q[v] - between(q[v][4], q[v][5])) < 1e-6);
  assert.ok(Math.abs(instant.normal - between(normal[4], normal[5])) < 1e-6);
  assert.ok(Math.abs(instant.tool[0] - between(tool[28], tool[35])) < 1e-6);
  assert.ok(Math.abs(Math.hypot(...instant.tool.slice(3)) - 1) < 1e-6);
});

test("a variable that a piece leaves out keeps its position", () => {
  const [head, round] = [pieces[0], pieces.find(({ piece }) => piece === "round")];
  const recording = new Recording();
  const some = (t, q) => ({ piece: "samples", round: 1, t, q, tool: t.flatMap(() => [0, 0, 0, 0, 0, 0, 1]), force: t.flatMap(() => [0, 0, 0]), normal: t.map(() => 0), height: t.map(() => 0) });
  [head, round, some([0, 1], Object.fromEntries(Array.from({ length: 7 }, (_, v) => [v, [v, v]]))), some([2, 3], { 3: [30, 40] }), some([4], { 2: [7] })].forEach((piece) => recording.apply(piece));
  assert.deepEqual([...recording.at(3).q], [0, 1, 2, 40, 4, 5, 6]);
  assert.deepEqual([...recording.at(4).q], [0, 1, 7, 40, 4, 5, 6]);
  assert.equal(recording.broken, 0);
});

test("unreadable lines and unknown pieces are counted and skipped", () => {
  const rows = text.trim().split("\n");
  const odd = [rows[0], "{broken", "null", '{"piece":"dance"}', '{"piece":"samples","round":9,"t":[],"q":{},"tool":[],"force":[],"normal":[],"height":[]}', ...rows.slice(1), '{"piece":"samples","round":2,"t":[1]}'];
  const recording = Recording.parse(odd.join("\n"));
  assert.equal(recording.broken, 4);
  assert.equal(recording.unknown, 1);
  assert.equal(recording.rounds.length, 2);
  assert.equal(recording.duration, Recording.parse(text).duration);
});

test("a recording of version 0.2.0 equals the same recording with today's names", () => {
  const earlier = pieces.map((piece) => {
    if (piece.piece === "interpreted") {
      const { by_touch, ...rest } = piece;
      return { ...rest, piece: "judged", felt: by_touch };
    }
    const considered = piece.considered?.map(({ score, ...plan }) => ({ ...plan, worth: score }));
    return considered ? { ...piece, considered } : piece;
  });
  assert.ok(earlier.some((piece) => piece.considered?.some((plan) => "worth" in plan)));
  const [was, is] = [Recording.parse(lines(earlier)), Recording.parse(text)];
  assert.equal(was.broken, 0);
  assert.deepEqual(was.rounds.map(({ interpreted }) => interpreted.by_touch), is.rounds.map(({ interpreted }) => interpreted.by_touch));
  assert.deepEqual(was.rounds.map(({ plan }) => plan.considered?.map((plan) => plan.score)), is.rounds.map(({ plan }) => plan.considered?.map((plan) => plan.score)));
});

test("a killed run ends with its last sample", () => {
  const until = pieces.findIndex(({ piece }) => piece === "interpreted");
  const killed = Recording.parse(lines(pieces.slice(0, until)));
  const last = pieces.slice(0, until).findLast(({ piece }) => piece === "samples").t.at(-1);
  assert.equal(killed.duration, last);
  assert.equal(killed.rounds[0].interpreted, null);
  assert.equal(killed.live, false);
});

test("a plan without execution plays over its planned duration", () => {
  const planned = pieces.filter(({ piece }) => piece === "head" || piece === "round").slice(0, 2).map((piece) => (piece.piece === "round" ? { ...piece, kind: "planned" } : piece));
  const recording = Recording.parse(lines(planned));
  assert.equal(recording.duration, planned[1].duration);
  const { q, tool, normal, performance } = recording.at(recording.duration / 2);
  assert.deepEqual([q.length, tool, normal], [0, null, null]);
  assert.ok(performance > 0);
});

test("random access to particle steps equals replaying all steps", () => {
  const { particles } = pieces.find(({ piece }) => piece === "round");
  let list = [];
  const all = particles.map(([, gone, added]) => {
    list = list.filter((_, i) => !gone.includes(i));
    for (let i = 0; i < added.length; i += 2) list.push([added[i], added[i + 1]]);
    return list.flat();
  });
  const track = trackParticles(particles);
  const random = numbers(3);
  for (let k = 0; k < 300; k++) {
    const i = Math.floor(random() * all.length);
    assert.deepEqual([...track.at(particles[i][0])].map((v) => Math.round(v * 1e4)), all[i]);
  }
});

test("the range of an index interval equals minimum and maximum of its values", () => {
  const random = numbers(11);
  const column = new PlotColumn();
  const plain = [];
  for (let i = 0; i < 5000; i++) {
    const value = Math.fround(random() * 100 - 50);
    column.push(value);
    plain.push(value);
  }
  for (let k = 0; k < 500; k++) {
    const from = Math.floor(random() * 5000);
    const to = from + 1 + Math.floor(random() * (5000 - from));
    assert.deepEqual(column.range(from, to), [Math.min(...plain.slice(from, to)), Math.max(...plain.slice(from, to))]);
  }
  assert.equal(column.range(3, 3), null);
});

test("unknown values leave a gap", () => {
  const column = new PlotColumn();
  for (const value of [1, NaN, 3]) column.push(value);
  assert.deepEqual(column.range(0, 3), [1, 3]);
  assert.equal(column.range(1, 2), null);
});

test("the search finds the last entry of at most a value", () => {
  const column = Array.from({ length: 100 }, (_, i) => i / 10);
  assert.deepEqual([4.25, -1, 1e9].map((value) => lastAtMost(column, value)), [42, -1, 99]);
});

/** A round of 2 s with a sample every 0.1 s: force and height by time, and its result if there is one. */
function roundOf(force, height, result = null) {
  const t = Array.from({ length: 21 }, (_, i) => i / 10);
  const recording = new Recording();
  const plan = pieces.find(({ piece }) => piece === "round");
  recording.apply(pieces[0]);
  recording.apply({ ...plan, duration: 2 });
  recording.apply({
    piece: "samples", round: 1, t, q: {}, tool: t.flatMap(() => [0, 0, 0, 0, 0, 0, 1]), force: t.flatMap((time) => [0, 0, force(time)]),
    normal: t.map(force), height: t.map(height),
  });
  if (result) recording.apply({ ...pieces.find(({ piece }) => piece === "interpreted"), duration: 2, events: [], ...result });
  assert.equal(recording.broken, 0);
  return recording;
}

test("a force high above the surface is a push and no contact", () => {
  const force = (t) => (t > 0.35 && t < 1.55 ? 10 : 0);
  const height = (t) => (t > 0.95 ? 0.09 : 0);
  for (const result of [null, { contacts: [[0.4, 0.9]] }]) {
    const recording = roundOf(force, height, result);
    assert.deepEqual([0.1, 0.5, 1.2, 1.8].map((t) => recording.at(t).contact), ["none", "contact", "pushed", "none"]);
    assert.deepEqual(recording.rounds[0].contacts, recording.rounds[0].contacts, "is computed once");
  }
  const pushed = roundOf(force, () => 0, { contacts: [[0.4, 1.5]], events: [{ kind: "collision", start: 0.8, end: 1, words: "", by_hand: false }] });
  assert.deepEqual([0.5, 0.9, 1.2].map((t) => pushed.at(t).contact), ["contact", "pushed", "contact"]);
});

test("noise before the first landing is neither contact nor a push, and one strong sample is no push", () => {
  const noise = (t) => 0.42 * Math.cos(70 * t);
  for (const height of [0, 0.07]) {
    const { contact, pushed } = roundOf(noise, () => height).rounds[0].contacts;
    assert.deepEqual([contact, pushed], [[], []]);
  }
  const spike = roundOf((t) => (Math.abs(t - 1) < 0.01 ? 9 : noise(t)), () => 0.07);
  assert.deepEqual(spike.rounds[0].contacts.pushed, []);
});

test("what contacts follow from changes with the largest force and the result, not with each sample", () => {
  const weak = roundOf((t) => t / 2, () => 0);
  const [{ basis }] = weak.rounds;
  const more = { piece: "samples", round: 1, q: {}, tool: [0, 0, 0, 0, 0, 0, 1], force: [0, 0, 1], height: [0] };
  weak.apply({ ...more, t: [2.1], normal: [1.1] });
  assert.equal(weak.rounds[0].basis, basis);
  weak.apply({ ...more, t: [2.2], normal: [30] });
  assert.notEqual(weak.rounds[0].basis, basis);
  assert.equal(weak.broken, 0);
});

test("contact is right where the intervals of a result overlap or are unsorted", () => {
  const recording = roundOf(() => 10, () => 0, { contacts: [[1.2, 1.6], [0.2, 0.9], [0.4, 0.5]], incidents: [] });
  assert.deepEqual(recording.rounds[0].contacts.contact, [[0.2, 0.9], [1.2, 1.6]]);
  assert.deepEqual([0.1, 0.7, 1, 1.3].map((t) => recording.at(t).contact), ["none", "contact", "none", "contact"]);
});

test("an interval of contact without force is none in a recording of version 0.2.0", () => {
  const recording = roundOf((t) => (t > 0.95 && t < 1.55 ? 10 : 0.1), (t) => Math.abs(t - 0.3) / 10, { incidents: undefined, contacts: [[0.28, 0.33], [1, 1.5]] });
  assert.deepEqual(recording.rounds[0].contacts.contact, [[1, 1.5]]);
  assert.equal(recording.at(0.3).contact, "none");
});

test("a plan without measured force has its planned contact", () => {
  const planned = Recording.parse(lines(pieces.filter(({ piece }) => piece === "head" || piece === "round").slice(0, 2)));
  const phase = planned.rounds[0].plan.phases.find(({ contact }) => contact);
  assert.equal(planned.at((phase.start + phase.end) / 2).contact, "contact");
  assert.equal(planned.at(phase.start - 0.1).contact, "none");
});

test("results and found surfaces are known from the round's end on, and estimates until the robot wipes again", () => {
  const recording = Recording.parse(text);
  const [first, second] = recording.rounds;
  assert.equal(recording.resultAt(first.end - 0.01), null);
  assert.equal(recording.resultAt(first.end), first);
  assert.equal(recording.resultAt(second.start + second.firstContact + 0.01), null);
  assert.equal(recording.resultAt(recording.duration), second);
  assert.equal(recording.foundAt(first.end - 0.01), null);
  assert.deepEqual(recording.foundAt(first.end), first.interpreted.found);
});

test("a number of an old recording is read, as is one that states its round", () => {
  const facts = [["Strokes", "5", 1], ["Execution time", "26 s", null], ["Seed", "1"]];
  const recording = Recording.parse(lines(pieces.map((piece) => (piece.piece === "ended" ? { ...piece, facts } : piece))));
  assert.equal(recording.broken, 0);
  assert.deepEqual(recording.ended.facts, facts);
});

test("contact that is known so far equals that of all samples, and a new piece costs its own size", () => {
  const [head, round] = [pieces[0], { ...pieces.find(({ piece }) => piece === "round"), phases: [] }];
  const random = numbers(5);
  let t = 0;
  const piece = (count) => {
    const times = Array.from({ length: count }, () => (t += 0.01));
    const force = times.map((time) => (Math.floor(time) % 3 ? 8 + random() : 0.2 * random()));
    return { piece: "samples", round: 1, t: times, q: {}, tool: times.flatMap(() => [0, 0, 0, 0, 0, 0, 1]), force: force.flatMap((f) => [0, 0, f]), normal: force, height: times.map((time) => (Math.floor(time) % 2 ? 0 : 0.1)) };
  };
  const [live, late] = [new Recording(), new Recording()];
  for (const one of [head, round]) for (const recording of [live, late]) recording.apply(one);
  for (let k = 0; k < 40; k++) {
    const samples = piece(7);
    for (const recording of [live, late]) recording.apply(samples);
    assert.equal(typeof live.rounds[0].contactAt(t), "string");
  }
  const states = ({ rounds: [{ contacts }] }) => [contacts.contact, contacts.pushed];
  assert.deepEqual(states(live), states(late));
  assert.ok(states(live).every((list) => list.length > 0));
  live.apply(piece(360000));
  const since = performance.now();
  for (let k = 0; k < 100; k++) {
    live.apply(piece(25));
    live.rounds[0].contactAt(t);
  }
  const each = (performance.now() - since) / 100;
  assert.ok(each < 3, `${each.toFixed(1)} ms for a piece`);
});
