// Two recordings on one clock: their curves in the same plots, and a table of what differs.
import { DASH, clockText, countNames, el, estimateText, fixed, formatKnown, makeTable, percent, svg, svgText } from "../dom.ts";
import { throttle } from "../frames.ts";
import { ticks } from "../timeline/frame.ts";
import { stateOf } from "../words.ts";
import type { Clock } from "../clock.ts";
import type { PlotColumn } from "../columns.ts";
import type { Round } from "../round.ts";
import type { Recording } from "../store.ts";

/** Letters of the compared recordings. */
const LETTERS = ["A", "B"] as const;
/** Interval between redraws while a recording grows [ms]. */
const EVERY_MS = 500;
const [LEFT, RIGHT, AXIS] = [52, 14, 18];
const HEIGHT = { force: 96, performance: 110 };
const GAP = 30;

/** A property of a recording; numbers have a text for their difference. */
type Fact = [label: string, text: string, value?: number | null, by?: (difference: number) => string];

/** A property of two recordings. `by`: second minus first, "differs", empty for equal texts, or a dash where both are unknown. */
type Difference = { label: string; texts: [string, string]; by: string };

const signed = (unit: string, digits: number, factor = 1) => (difference: number): string => {
  const text = fixed(factor * difference, digits);
  return `${difference > 0 ? "+" : ""}${text}${unit && `\u202f${unit}`}`;
};
const points = signed("points", 0, 100);

/** Returns the way of the tool in contact [m]; null without samples. */
export function contactWay({ rounds }: Recording): number | null {
  if (!rounds.some(({ count }) => count)) return null;
  let way = 0;
  for (const round of rounds) {
    const { tool } = round;
    for (let i = 1; i < round.count; i++) {
      const step = Math.hypot(...[0, 1, 2].map((k) => tool[7 * i + k]! - tool[7 * i - 7 + k]!));
      if (Number.isFinite(step) && round.contactAt(round.t[i]!) === "contact") way += step;
    }
  }
  return way;
}

function factsOf(recording: Recording): Fact[] {
  const { head, rounds, ended } = recording;
  const { state, text } = stateOf(recording);
  const task = head?.task;
  const chosen = rounds.flatMap(({ plan }) => plan.considered?.find((one) => one.chosen)?.strategy ?? []);
  const last = rounds.findLast(({ interpreted }) => interpreted) ?? rounds.at(-1);
  const interpreted = last?.interpreted;
  const unknown = state === "unknown";
  const predicted = last?.plan.predicted ?? null;
  const actual = last?.truth?.performance ?? null;
  const peak = Math.max(...rounds.map(({ normal }) => normal.largest));
  const way = contactWay(recording);
  const estimate = interpreted ? estimateText(interpreted.estimate, 0, unknown ? ended!.verdict! : undefined) : DASH;
  return [
    ["Task", task ? `${task.action} on ${task.surface}` : DASH],
    ["Medium", task?.medium ?? DASH],
    ["Tool", task?.tool ?? DASH],
    ["Strategy", task ? [task.strategy, ...(chosen.length ? [`chosen: ${chosen.join(", ")}`] : [])].join("; ") : DASH],
    ["Target", formatKnown(task?.target, percent), task?.target ?? null, points],
    ["Rounds", String(rounds.length), rounds.length, signed("", 0)],
    ["Predicted, last round", formatKnown(predicted, percent), predicted, points],
    ["Estimated, last round", estimate, unknown ? null : interpreted?.estimate.mean ?? null, points],
    ["True, last round", formatKnown(actual, percent), actual, points],
    ["Way in contact", formatKnown(way, (metres) => `${fixed(metres, 2)} m`), way, signed("m", 2)],
    ["Duration", clockText(recording.duration), recording.duration, signed("s", 1)],
    ["Largest force", peak > 0 ? `${fixed(peak, 1)} N` : DASH, peak > 0 ? peak : null, signed("N", 1)],
    ["Events", countNames(recording.happenings.flatMap(({ source, kind }) => (source === "event" ? [kind] : []))) || "none"],
    ["Result", text],
  ];
}

/** Returns the properties of two recordings side by side. */
export function differencesOf(first: Recording, second: Recording): Difference[] {
  const others = factsOf(second);
  return factsOf(first).map(([label, text, value, by], i) => {
    const [, otherText, other] = others[i]!;
    const difference = typeof value === "number" && typeof other === "number" ? other - value : null;
    const same = (by ? difference !== null : text !== DASH) ? "" : DASH;
    return { label, texts: [text, otherText], by: text === otherText ? same : by && difference !== null ? by(difference) : "differs" };
  });
}

/** Returns the range of a measured column in each of `count` equal steps up to `duration` [s]; null without samples. */
export function envelopeOf(recording: Recording, of: (round: Round) => PlotColumn, duration: number, count: number): ([number, number] | null)[] {
  return Array.from({ length: count }, (_, k) => {
    const [from, to] = [(k * duration) / count, ((k + 1) * duration) / count];
    const round = recording.roundAt(from);
    if (!round?.count || from > round.start + round.t.at(-1)!) return null;
    const first = round.place(from - round.start)[0];
    return of(round).range(first, Math.max(first, round.place(to - round.start)[0]) + 1);
  });
}

type Scale = (value: number) => number;
const text = (x: number, y: number, words: string, anchor: "start" | "middle" | "end") => svgText(x, y, words, anchor, { "font-size": 11, fill: "var(--quiet)" });
/** The first line is wider, so that it is seen below the second. */
const lookOf = (i: number) => (i ? { "stroke-width": 1.2 } : { "stroke-width": 3, "stroke-opacity": 0.7 });
const colourOf = (i: number): string => `var(--${i ? "second" : "first"})`;

export class Comparison {
  readonly element: HTMLElement;
  private readonly plots = el("div", { class: "s-curves" });
  private readonly table = el("div", { class: "s-table", tabindex: 0, role: "group", "aria-label": "Differences" });
  private readonly stops: (() => void)[] = [];
  private cursor: SVGElement | null = null;
  private x: Scale = () => 0;

  /** `names`: the names of the recordings, which may have the same title. */
  constructor(private readonly pair: readonly [Recording, Recording], names: readonly string[], private readonly clock: Clock) {
    const legend = pair.map(({ head }, i) => el("li", {}, makeLetter(i), [head?.title, names[i]].filter((words) => words).join(" \u00b7 ")));
    const signs = "Line: predicted performance. Bar and dot: estimate with its 90\u202f% interval after a round. Cross: true.";
    this.element = el("section", { class: "s-compare", "aria-label": "Comparison" },
      el("div", {}, el("ul", { class: "w-legend" }, ...legend), this.plots, el("p", { class: "w-quiet s-remark" }, signs)), this.table);
    const redraw = throttle(EVERY_MS, () => this.draw());
    const sizes = new ResizeObserver(() => redraw.ask());
    sizes.observe(this.plots);
    this.stops.push(() => sizes.disconnect(), redraw.stop, clock.subscribe(() => this.move()), ...pair.map((one) => one.onChange(() => redraw.ask())));
  }

  destroy(): void {
    for (const stop of this.stops) stop();
  }

  private draw(): void {
    const { clock, pair } = this;
    const width = this.plots.clientWidth;
    if (!width) return;
    const span = Math.max(1, width - LEFT - RIGHT);
    this.x = (time) => LEFT + (time / Math.max(clock.duration, 1e-3)) * span;
    const tops = { force: 20, performance: 20 + HEIGHT.force + GAP };
    const height = tops.performance + HEIGHT.performance + AXIS;
    this.cursor = svg("line", { y1: 0, y2: height - AXIS, stroke: "var(--ink)", "stroke-width": 1.5 });
    const { times } = ticks(0, clock.duration, Math.max(2, span / 90));
    const picture = svg("svg", {
      width, height, role: "img", "aria-label": "Force and performance of both recordings over time",
      click: ({ offsetX }: MouseEvent) => clock.seek(((offsetX - LEFT) / span) * clock.duration),
    },
      ...this.drawForce(tops.force, width, Math.round(span)), ...this.drawPerformance(tops.performance, width),
      ...times.map((time) => text(this.x(time), height - 3, clockText(time, 0), "middle")), this.cursor);
    this.plots.replaceChildren(picture);
    this.move();
    this.table.replaceChildren(makeDifferenceTable(differencesOf(...pair)));
  }

  private move(): void {
    const x = this.x(this.clock.time).toFixed(1);
    this.cursor?.setAttribute("x1", x);
    this.cursor?.setAttribute("x2", x);
  }

  private drawForce(top: number, width: number, count: number): Node[] {
    const { clock, pair } = this;
    const curves = pair.map((one) => envelopeOf(one, ({ normal }) => normal, clock.duration, count));
    const ranges = curves.flat().filter((range) => range !== null);
    const [low, high] = [Math.min(0, ...ranges.map(([least]) => least)), Math.max(5, ...ranges.map(([, most]) => most))];
    const y: Scale = (value) => top + HEIGHT.force * (1 - (value - low) / (high - low));
    const paths = curves.map((curve, i) => {
      let d = "";
      curve.forEach((range, k) => {
        if (range) d += `${d && curve[k - 1] ? "L" : "M"}${LEFT + k} ${y(range[0]).toFixed(1)}V${y(range[1]).toFixed(1)}`;
      });
      return svg("path", { d, fill: "none", stroke: colourOf(i), ...lookOf(i), "data-curve": `force-${LETTERS[i]}` });
    });
    return [...drawFrame("Force [N]", top, width, y, [0, high / 2, high].map(Math.round), String), ...paths];
  }

  private drawPerformance(top: number, width: number): Node[] {
    const y: Scale = (share) => top + HEIGHT.performance * (1 - share);
    const marks = this.pair.flatMap((recording, i) => recording.rounds.flatMap((round) => this.drawRound(round, i, y)));
    const targets = new Set(this.pair.map(({ head }) => head?.task?.target).filter((target) => target !== undefined));
    const lines = [...targets].map((target) => svg("line", { x1: LEFT, x2: width - RIGHT, y1: y(target), y2: y(target), stroke: "var(--target)", "stroke-dasharray": "6 4" }));
    return [...drawFrame("Performance [%]", top, width, y, [0, 0.5, 1], (share) => String(100 * share)), ...lines, ...marks];
  }

  /** Draws prediction, estimate and truth of a round; the marks of the two recordings lie side by side. */
  private drawRound({ plan, start, end, length, interpreted, truth }: Round, i: number, y: Scale): Node[] {
    const colour = colourOf(i);
    const nodes: Node[] = [];
    if (plan.growth.length) {
      const corners = plan.growth.map(([time, share]) => `${this.x(start + Math.min(time, length)).toFixed(1)} ${y(share).toFixed(1)}`);
      nodes.push(svg("path", { d: `M${corners.join("L")}H${this.x(end).toFixed(1)}`, fill: "none", stroke: colour, ...lookOf(i), "data-curve": `predicted-${LETTERS[i]}` }));
    }
    const x = this.x(end) - 4 - 9 * (1 - i);
    if (interpreted) {
      const { mean, low, high } = interpreted.estimate;
      nodes.push(
        svg("rect", { x: x - 3, y: y(high), width: 6, height: Math.max(1, y(low) - y(high)), fill: colour, "fill-opacity": 0.3, stroke: colour }, svg("title", {}, `${LETTERS[i]}: estimated ${estimateText(interpreted.estimate)}`)),
        svg("circle", { cx: x, cy: y(mean), r: 3, fill: colour }));
    }
    if (typeof truth?.performance === "number") {
      const at = y(truth.performance);
      nodes.push(svg("path", { d: `M${x - 4} ${at - 4}l8 8m0 -8l-8 8`, stroke: colour, "stroke-width": 2, fill: "none" }, svg("title", {}, `${LETTERS[i]}: true ${percent(truth.performance)}`)));
    }
    return nodes;
  }
}

function drawFrame(title: string, top: number, width: number, y: Scale, levels: number[], shown: (value: number) => string): Node[] {
  return [text(0, top - 8, title, "start"), ...levels.flatMap((value) => [
    svg("line", { x1: LEFT, x2: width - RIGHT, y1: y(value), y2: y(value), stroke: "var(--rule)", "stroke-width": 0.6 }),
    text(LEFT - 6, y(value) + 4, shown(value), "end"),
  ])];
}

/** Returns the letter of a recording in its colour. */
export function makeLetter(i: number): HTMLElement {
  return el("i", { class: `s-letter s-letter-${i ? "second" : "first"}` }, LETTERS[i] ?? "");
}

const makeDifferenceTable = (differences: Difference[]): HTMLElement =>
  makeTable(["", ...LETTERS, "B \u2212 A"], differences.map(({ label, texts, by }) => el("tr", { "data-differs": String(by !== "" && by !== DASH) },
    el("th", { scope: "row" }, label), ...texts.map((words) => el("td", { title: words }, words)), el("td", {}, by || "same"))));
