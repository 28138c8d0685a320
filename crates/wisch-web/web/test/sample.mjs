// A synthetic recording for tests and for inspection: `node test/sample.mjs > sample.jsonl`.
import { FLANGE, REST_POSE, ROBOT, SPONGE, TOOL, reach } from "./arm.mjs";

const PERIOD_S = 0.04;
const SPEED = 0.12;
const LIFT_M = 0.06;
const BOARD = { width: 0.32, depth: 0.24, z: 0.77 };
const ROOT = [0, -0.45, 0.75, 0, 0, Math.SQRT1_2, Math.SQRT1_2];
const GOAL = [0.09, -0.06];
const GOAL_RADIUS = 0.045;
const TOOL_HALF = 0.045;

/** Reproducible pseudo-random numbers. */
export function numbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const whole = (v) => Math.round(v * 1e4);
const rounded = (v, digits = 5) => Number(v.toFixed(digits));
const inGoal = ([x, y]) => Math.hypot(x - GOAL[0], y - GOAL[1]) < GOAL_RADIUS;
/** Converts a pose of the tool from the surface frame to the robot's root frame. */
const inRoot = ([x, y], z) => [y + 0.45, -x, z + BOARD.z - 0.75];

/** Strokes from the edges to the goal. */
function strokesOf(round, random) {
  const angles = round === 1 ? [2.6, 3.3, 2.0, 1.4, 4.2] : [2.9, 2.2];
  return angles.map((angle) => {
    const far = 0.2 + 0.03 * random();
    const from = [Math.max(-0.15, Math.min(0.15, GOAL[0] + far * Math.cos(angle))), Math.max(-0.11, Math.min(0.11, GOAL[1] + far * Math.sin(angle)))];
    return [from, [GOAL[0] * 0.5 + from[0] * 0.5 + 0.02, GOAL[1] * 0.5 + from[1] * 0.5], GOAL];
  });
}

/** Phases and tool positions over time: approach, wipe and lift for each stroke. */
function plan(strokes) {
  const phases = [];
  const track = [];
  let [t, at, height] = [0, [0, -0.2], LIFT_M];
  const move = (name, to, toHeight, contact, stroke, speed) => {
    const [from, fromHeight, start] = [at, height, t];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1], toHeight - fromHeight);
    const steps = Math.max(2, Math.round(length / speed / PERIOD_S));
    for (let k = 0; k < steps; k++) {
      const s = (1 - Math.cos((Math.PI * (k + 1)) / steps)) / 2;
      t += PERIOD_S;
      track.push({ t, place: [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])], height: fromHeight + s * (toHeight - fromHeight), contact });
    }
    const last = phases.at(-1);
    if (last && last.name === name && last.stroke === stroke) last.end = rounded(t, 3);
    else phases.push({ name, start: rounded(start, 3), end: rounded(t, 3), contact, stroke });
    [at, height] = [to, toHeight];
  };
  strokes.forEach((stroke, i) => {
    move("transfer", stroke[0], LIFT_M, false, null, 2 * SPEED);
    move("lower", stroke[0], 0, false, null, SPEED);
    for (const corner of stroke.slice(1)) move("wipe", corner, 0, true, i, SPEED);
    move("lift", stroke.at(-1), LIFT_M, false, null, SPEED);
  });
  move("home", [0, -0.2], LIFT_M, false, null, 2 * SPEED);
  return { phases, track, duration: rounded(t, 3) };
}

/** Particles that the tool pushes, as steps at regular times. */
function pushed(particles, track, share, random) {
  let list = particles.map((p) => p.slice());
  const steps = [[0, [], list.flat().map(whole)]];
  const growth = [[0, rounded(list.filter(inGoal).length / list.length)]];
  track.forEach(({ t, place, contact }, k) => {
    if (!contact || k === 0) return;
    const before = track[k - 1].place;
    const way = [place[0] - before[0], place[1] - before[1]];
    const gone = [];
    const added = [];
    const kept = [];
    list.forEach((p, i) => {
      const near = Math.hypot(p[0] - place[0], p[1] - place[1]) < TOOL_HALF;
      if (near && !inGoal(p) && random() < share) {
        const moved = [p[0] + 1.25 * way[0] + 0.001 * (random() - 0.5), p[1] + 1.25 * way[1] + 0.001 * (random() - 0.5)];
        gone.push(i);
        added.push(moved);
      } else kept.push(p);
    });
    if (!gone.length) return;
    list = [...kept, ...added];
    steps.push([rounded(t, 3), gone, added.flat().map(whole)]);
    growth.push([rounded(t, 3), rounded(list.filter(inGoal).length / list.length)]);
  });
  return { steps, list, growth };
}

/** Side of the cells of a density [m]. */
const CELL_M = 0.01;

/** The density of a belief: `members` samples of it, whose particles lie up to `spread` metres from the estimated ones. */
function densityOf(particles, spread, members = 20) {
  const random = numbers(11);
  const counts = new Map();
  let goal = 0;
  for (let k = 0; k < members; k++) {
    for (const place of particles) {
      const member = place.map((v) => v + 2 * spread * (random() - 0.5));
      const column = member.map((v) => Math.floor(v / CELL_M)).join();
      counts.set(column, (counts.get(column) ?? 0) + 1);
      if (inGoal(member)) goal++;
    }
  }
  const cells = [...counts].map(([column, count]) => [column.split(",").map((i) => whole((Number(i) + 0.5) * CELL_M)), rounded(count / members, 2)]);
  return { cell: CELL_M, places: cells.flatMap(([place]) => place), expected: cells.map(([, count]) => count), goal: rounded(goal / members, 2) };
}

const estimate = (mean, half) => ({ mean: rounded(mean, 4), low: rounded(Math.max(0, mean - half), 4), high: rounded(Math.min(1, mean + half * 0.8), 4) });

/** Candidate plans of the first round. */
const CONSIDERED = [
  { strategy: "kde", chosen: false, score: -1.6402, predicted: 0.66, lost: 0.48, strokes: 3, in_contact: 11.31, duration: 124.2, lines: [[-1400, 900, 1400, 900], [1400, 300, -1400, 300], [-1400, -300, 900, -600]], error: null },
  { strategy: "rrt", chosen: false, score: null, predicted: null, lost: null, strokes: null, in_contact: null, duration: null, error: "no way leads to the goal" },
  { strategy: "adaptive", chosen: true, score: 0.7613, predicted: 1, lost: 0, strokes: 5, in_contact: 0.94, duration: 17.3, error: null },
];

/** Base poses before the table: the nearer, the more is in reach. */
const BASES = Array.from({ length: 45 }, (_, i) => [rounded(0.1 * (i % 9) - 0.4, 3), rounded(0.5 + 0.1 * Math.floor(i / 9), 3), -1.571, rounded(Math.max(0, 1 - 0.4 * Math.abs((i % 9) - 4) ** 1.5 / 4 - 0.15 * Math.floor(i / 9)), 3)]);

/** Why the plan of the first round is as it is. */
function reasonsOf(strokes, believed) {
  const without = strokes.map((_, stroke) => {
    const { list } = pushed(believed, plan(strokes.filter((_, i) => i !== stroke)).track, 0.97, numbers(11));
    return { stroke, performance: rounded(list.filter(inGoal).length / list.length), lost: stroke === 1 ? 0.01 : 0, particles: list.flat().map(whole) };
  });
  return {
    considered: CONSIDERED, lost: 0, without, another: { gain: 0.0123, line: strokes[2].flat().map(whole), way: 0.21 }, bases: { poses: BASES, chosen: [4, 13] },
    headings: strokes.map((_, i) => (i === 3 ? "The tool begins by sweeping 60 mm of at most 90 mm." : "The tool sweeps 90 mm, as wide as it can.")),
  };
}

/** All pieces of a run of two rounds, in order. */
export function sample({ title = "Breadcrumbs on a chopping board", count = 300 } = {}) {
  const random = numbers(7);
  const pieces = [{
    piece: "head", schema: 1, title, program: "wisch 0.1.0", begun: null,
    task: {
      action: "collect", medium: "breadcrumbs", tool: "sponge", surface: "chopping board", strategy: "kde", seed: 1, target: 0.85,
      asked: "Collect the breadcrumbs on the chopping board near its corner; 85 of 100 are to lie there.",
    },
    robot: ROBOT, tool: TOOL, meshes: [FLANGE, SPONGE],
  }];
  const stage = (round, stage, words) => pieces.push({ piece: "stage", round, stage, words });
  const flat = (list) => list.flat().map(whole);
  let believed = Array.from({ length: count }, () => [(random() - 0.5) * 0.3, (random() - 0.5) * 0.22]);
  let actual = believed.map(([x, y]) => [x + 0.004 * (random() - 0.5), y + 0.004 * (random() - 0.5)]);
  pieces.push({ piece: "observed", round: 0, detections: flat(actual.filter(() => random() < 0.4)), hidden_m2: 0.004 });
  const outcomes = [[0.71, 0.12, 0.05], [0.9, 0.07, 0.03]];
  let surface = [0, 0, BOARD.z, 0, 0, 0, 1];
  for (let round = 1; round <= 2; round++) {
    stage(round, "planning", "Planning strokes for the dirt that is believed to be left.");
    const strokes = strokesOf(round, random);
    const { phases, track, duration } = plan(strokes);
    stage(round, "planned", `${strokes.length} strokes, ${duration.toFixed(1)} s.`);
    stage(round, "audited", "The plan keeps the joint limits and clears all obstacles.");
    const predicted = pushed(believed, track, 0.97, random);
    pieces.push({
      piece: "round", round, kind: "executed", duration, root: ROOT,
      surface: { pose: surface, rings: [flat([[-0.16, -0.12], [0.16, -0.12], [0.16, 0.12], [-0.16, 0.12]])] },
      scene: [
        { part: "carrier", kind: "box", size: [0.32, 0.24, 0.02], pose: [0, 0, 0.76, 0, 0, 0, 1] },
        { part: "carrier", kind: "box", size: [1.2, 0.9, 0.04], pose: [0, -0.2, 0.73, 0, 0, 0, 1] },
        { part: "obstacle", kind: "cylinder", radius: 0.04, length: 0.14, pose: [-0.26, 0.06, 0.82, 0, 0, 0, 1] },
      ],
      meshes: [], press_force: 8, goal: { kind: "collected", place: GOAL, radius: GOAL_RADIUS },
      strokes: strokes.map(flat), phases, predicted: predicted.growth.at(-1)[1], growth: predicted.growth, particles: predicted.steps,
      ...(round === 1 ? reasonsOf(strokes, believed) : {}),
      why: round === 1
        ? ["Five strokes reach 96 % of the dirt that is believed to lie outside the goal.", "The longest stroke begins at the far edge, where most of the dirt is."]
        : ["The second and third strokes met less dirt than predicted.", "Two strokes sweep the dirt that is believed to remain there."],
    });
    stage(round, "executing", "Wiping as planned.");
    samples(pieces, round, track, random);
    const real = pushed(actual, track, round === 1 ? 0.8 : 0.93, random);
    actual = real.list;
    believed = actual.map(([x, y]) => [x + 0.012 * (random() - 0.5), y + 0.012 * (random() - 0.5)]);
    pieces.push({ piece: "observed", round, detections: flat(actual.filter(() => random() < 0.5)), hidden_m2: 0.002 });
    stage(round, "interpreting", "Comparing the measured contact with the predicted contact.");
    const truth = actual.filter(inGoal).length / count;
    const [, half, touch] = outcomes[round - 1];
    const events = round === 1 ? [
      { kind: "collision", start: 9.2, end: 9.9, words: "Something hit the tool from the side: 14 N along the surface, not from wiping.", by_hand: false },
      { kind: "hand guiding", start: 12.6, end: 14.1, words: "Somebody led the tool away and back.", by_hand: true },
    ] : [{ kind: "effectless stroke", start: 4.0, end: 5.2, words: "Stroke 1 met almost no dirt.", by_hand: false }];
    const contacts = phases.filter((phase) => phase.contact).map(({ start, end }) => [rounded(start + 0.06, 3), rounded(end - 0.04, 3)]);
    pieces.push({
      piece: "interpreted", round, duration, estimate: estimate(truth + 0.015, half), by_touch: estimate(truth - 0.03, half + touch),
      verdict: round === 1 ? "wipe again" : "goal met", ending: "as planned",
      words: round === 1
        ? ["All five strokes touched the surface.", "The board is 3 mm lower than believed and tilted by 0.8 degrees; the next round uses the new pose.", "The estimate's lower end is below the target: wipe again."]
        : ["Both strokes touched all along.", "The estimate's lower end is above the target."],
      found: round === 1 ? [0.004, 0.006, BOARD.z - 0.003, 0.007, 0, 0.02, 0.9998] : null,
      events, contacts, particles: flat(believed), density: densityOf(actual, round === 1 ? 0.02 : 0.002),
      incidents: round === 1 ? [
        { time: 9.25, title: "Collision in stroke 3", evidence: "At 9.3 s: 17.6 N at most, tool up to 22 mm from the surface, for 0.6 s in total.", effect: "The tool was in contact for 40.0 % of that time; elsewhere nothing counts as wiped.", advice: "Keep clear of the robot; the next round wipes what is left." },
        { time: null, title: "The surface is not at its believed pose", evidence: "The contacts lie 3.0 mm below the believed surface and are tilted by 0.80\u00b0.", effect: "Later rounds use the measured pose.", advice: "" },
      ] : [],
    });
    pieces.push({ piece: "truth", round, performance: rounded(truth, 4), particles: flat(actual), pushes: round === 1 ? [[9.25, 9.8], [12.5, 14]] : [], surface: round === 1 ? [0.004, 0.007, BOARD.z - 0.0032, 0.007, 0, 0.021, 0.9998] : null });
    if (round === 1) surface = pieces.at(-2).found;
  }
  pieces.push({
    piece: "ended", met: true, verdict: "goal met", badge: "goal met",
    story: {
      next: { words: "Wipe again tomorrow.", command: "wisch run sample --seed 1" },
      asked: "Collect the breadcrumbs on the chopping board near its corner; 85 of 100 are to lie there.",
      happened: "The robot wiped two rounds of five and two strokes. It was hit once and led by hand once; the board lay 3 mm lower than believed.",
      sure: "With 90 % probability between 84 % and 96 % of the breadcrumbs lie at the goal.",
      surer: "A look at the board from the other side would show the 20 cm\u00b2 that were hidden.",
    },
    facts: [["Strokes", "5", 1], ["Strokes", "2", 2], ["Rounds", "2", null], ["Wiped for", "25.6 s", null], ["Path in contact", "1.94 m", null], ["Mean force", "8.1 N", null], ["Largest force", "17.6 N", null]],
    episode: null,
  });
  return pieces;
}

/** Samples along a track, in pieces of several instants. */
function samples(pieces, round, track, random) {
  let q = REST_POSE;
  let piece = null;
  track.forEach(({ t, place, height, contact }, k) => {
    q = reach(inRoot(place, height), q);
    if (!piece || piece.t.length === 25) {
      piece = { piece: "samples", round, t: [], q: Object.fromEntries(q.map((_, i) => [i, []])), tool: [], force: [], normal: [], height: [] };
      pieces.push(piece);
    }
    const hit = round === 1 && t > 9.2 && t < 9.9 ? Math.sin(((t - 9.2) / 0.7) * Math.PI) : 0;
    const led = round === 1 && t > 12.6 && t < 14.1 ? Math.sin(((t - 12.6) / 1.5) * Math.PI) : 0;
    const normal = (contact ? 8 + 0.8 * Math.sin(5 * t) + 0.6 * (random() - 0.5) : 0.1 * (random() - 0.5)) + 4 * hit;
    const way = k ? [place[0] - track[k - 1].place[0], place[1] - track[k - 1].place[1]] : [0, 0];
    const long = Math.hypot(...way) || 1;
    const drag = contact ? 0.35 * normal : 0;
    piece.t.push(rounded(t, 3));
    q.forEach((v, i) => piece.q[i].push(rounded(v)));
    piece.tool.push(...[place[0], place[1], BOARD.z + height - 0.001 * hit].map((v) => rounded(v)), 0, 0, 0, 1);
    piece.force.push(...[(-drag * way[0]) / long + 14 * hit - 6 * led, (-drag * way[1]) / long + 8 * led, normal].map((v) => rounded(v, 2)));
    piece.normal.push(rounded(normal, 2));
    piece.height.push(rounded(height - (contact ? 0.0028 : 0) + 0.0003 * (random() - 0.5), 5));
  });
}

/** The pieces of a run as if its surface were polished: 2 to 3 passes wanted, 32 columns and 24 rows of places. */
export function polished(pieces = sample()) {
  const [columns, rows] = [32, 24];
  const places = Array.from({ length: columns * rows }, (_, i) => [whole(0.01 * (i % columns) - 0.155), whole(0.01 * Math.floor(i / columns) - 0.115)]).flat();
  /** Hundredths of a pass, more of them to the right. */
  const passes = (most) => Array.from({ length: columns * rows }, (_, i) => Math.round((100 * most * (i % columns)) / (columns - 1)));
  return pieces.map((piece) => {
    if (piece.piece === "head") return { ...piece, task: { ...piece.task, action: "polish" } };
    if (piece.piece === "interpreted") return { ...piece, particles: [], density: undefined, treated: passes(piece.round === 1 ? 2 : 4) };
    if (piece.piece === "truth") return { ...piece, particles: null, treated: passes(piece.round === 1 ? 3 : 5) };
    if (piece.piece !== "round") return piece;
    const begin = piece.round === 1 ? passes(0) : passes(2);
    const right = begin.map((_, i) => i).filter((i) => i % columns >= columns / 2);
    const steps = [[0, begin.map((_, i) => i), begin], [6, right, right.map((i) => begin[i] + 150)], [9, [0], [400]]];
    const without = piece.without?.map((one) => ({ ...one, particles: [], treated: passes(one.stroke / 2) }));
    return { ...piece, without, another: undefined, goal: { kind: "polished" }, particles: [], treatment: { unit: "passes", target: 2, low: 2, high: 3, step: 0.01, cell: [0.01, 0.01], places, steps } };
  });
}

/** An hour of samples of a robot with many joints, without dirt. */
export function hour({ seconds = 3600, rate = 25, variables = 40 } = {}) {
  const pieces = sample({ count: 100 }).slice(0, 1);
  const head = { ...pieces[0], title: "An hour", robot: { ...ROBOT, variables: Array.from({ length: variables }, (_, i) => `joint_${i + 1}`) } };
  const round = sample({ count: 100 }).find(({ piece }) => piece === "round");
  const phases = Array.from({ length: seconds / 10 }, (_, i) => ({ name: i % 2 ? "wipe" : "transfer", start: 10 * i, end: 10 * i + 10, contact: i % 2 === 1, stroke: i % 2 ? (i >> 1) % 5 : null }));
  const out = [head, { ...round, duration: seconds, phases }];
  for (let second = 0; second < seconds; second++) {
    const t = Array.from({ length: rate }, (_, k) => rounded(second + k / rate, 3));
    const q = Object.fromEntries(Array.from({ length: variables }, (_, v) => [v, t.map((time) => rounded((REST_POSE[v] ?? 0) + 0.3 * Math.sin(time * (0.2 + 0.01 * v))))]));
    out.push({
      piece: "samples", round: 1, t, q,
      tool: t.flatMap((time) => [rounded(0.12 * Math.sin(time / 3)), rounded(0.09 * Math.cos(time / 7)), 0.77, 0, 0, 0, 1]),
      force: t.flatMap((time) => [rounded(Math.sin(time), 2), 0, rounded(8 + Math.sin(9 * time), 2)]),
      normal: t.map((time) => rounded(time % 20 > 10 ? 8 + Math.sin(9 * time) : 0, 2)),
      height: t.map((time) => rounded(time % 20 > 10 ? 0 : 0.06)),
    });
  }
  return out;
}

export const lines = (pieces) => `${pieces.map((piece) => JSON.stringify(piece)).join("\n")}\n`;

if (process.argv[1] === (await import("node:url")).fileURLToPath(import.meta.url)) process.stdout.write(lines(sample()));
