// What each stroke of a plan is predicted to gain and to cost, and the board with and without it.
import { el, fixed, percent, svg } from "./dom.ts";
import { makeMapFigure, makeScale } from "./maps.ts";
import { countWithin, metres } from "./particles.ts";
import { makeFigure, pathOf, surfacePicture, viewOf } from "./picture.ts";
import { binOf, binsOf, DEGREES, resultValues, type Degree } from "./treated.ts";
import type { LeftOut } from "./recording.ts";
import type { Round } from "./round.ts";

export interface StrokeGain {
  /** Counted from 0. */
  stroke: number;
  /** Predicted rise of the performance while it is wiped, in [0, 1]; negative where dirt leaves the goal. */
  gain: number;
  /** Performance of the whole plan minus that of the plan without the stroke, as predicted; null if unknown. */
  marginal: number | null;
  /** Way in contact [m]. */
  way: number;
  /** Start of its contact, and time from the end of the stroke before to its own end [s]. */
  start: number;
  time: number;
}

/** Smallest difference of shares that is stated [1]. */
export const LEAST_SHARE = 5e-4;
/** Number of shown particles from which on they may be a part of all, so that they are not counted. */
export const MOST_COUNTED = 700;

/** Returns the prediction for the plan without a stroke; null if there is none. */
const leftOut = ({ plan }: Round, stroke: number): LeftOut | null => plan.without?.find((one) => one.stroke === stroke) ?? null;

/** Returns the performance that the whole plan is predicted to reach, in [0, 1]. */
export const predictWhole = (round: Round): number => round.plan.predicted ?? round.growthAt(Infinity) ?? NaN;

/** Returns gain and cost of each stroke, in order of time; nothing without a prediction. */
export function findGains(round: Round): StrokeGain[] {
  const { phases, growth, strokes } = round.plan;
  if (!growth.length) return [];
  let since = 0;
  let before = round.growthAt(0)!;
  return phases.filter(({ stroke }) => typeof stroke === "number" && strokes[stroke]).map(({ start, end, stroke }) => {
    const after = round.growthAt(end)!;
    const without = leftOut(round, stroke!);
    const found = { stroke: stroke!, gain: after - before, marginal: without && predictWhole(round) - without.performance, way: measure(metres(strokes[stroke!] ?? [])), start, time: end - since };
    [since, before] = [end, after];
    return found;
  });
}

const measure = (line: Float32Array): number => {
  let way = 0;
  for (let i = 2; i + 1 < line.length; i += 2) way += Math.hypot(line[i]! - line[i - 2]!, line[i + 1]! - line[i - 1]!);
  return way;
};

/** States how many of `count` stay or are in a state, compared with the whole plan. */
const compare = (more: number, count: number, noun: string, rest: string): string =>
  more === 0 ? `as many ${noun} ${rest}` : `${Math.abs(more)} ${more > 0 ? "more" : "fewer"} of ${count} ${noun} ${rest}`;

/** Compares the particles that are left where they do not belong, and what is lost. */
function compareDirt({ plan, particles }: Round, without: LeftOut): string {
  const { goal, considered } = plan;
  const left = (places: Float32Array): number => places.length / 2 - (goal?.kind === "collected" ? countWithin(places, goal) : 0);
  const count = particles.first.length / 2;
  const more = left(metres(without.particles)) - left(particles.last);
  const stay = goal?.kind === "collected" ? "stay outside the goal area" : "stay on the surface";
  const whole = plan.lost ?? considered?.find(({ chosen }) => chosen)?.lost ?? null;
  const change = without.lost - (whole ?? NaN);
  const lost = whole === null ? `${percent(without.lost, 1)} in all is lost` : Math.abs(change) < LEAST_SHARE ? "nothing more is lost" : `${percent(Math.abs(change), 1)} ${change > 0 ? "more" : "less"} is lost`;
  return count < MOST_COUNTED ? `${compare(more, count, "particles", stay)}, and ${lost}` : lost;
}

/** Compares the places that get too little and too much; null if their values are unknown. */
function comparePlaces({ plan: { treatment: record }, treated }: Round, without: LeftOut): string | null {
  const values = resultValues(record, without.treated);
  if (!record || !treated || !values) return null;
  const bins = binsOf(record);
  const count = (list: readonly number[], degree: Degree) => list.filter((value) => bins[binOf(bins, record, value)]!.degree === degree).length;
  return (["little", "much"] as const).map((degree) => compare(count(values, degree) - count(treated.last, degree), values.length, "places", `get ${DEGREES[degree]}`)).join(", ");
}

/** Says what the plan would do without a stroke, and what the stroke takes. */
export function describeStroke(round: Round, { stroke, way, time }: StrokeGain): string[] {
  const without = leftOut(round, stroke);
  const takes = `The stroke takes ${fixed(time, 1)} s with the way to it, and ${fixed(way, 2)} m in contact.`;
  const heading = round.plan.headings?.[stroke];
  if (!without) return [takes, ...(heading ? [heading] : [])];
  const whole = predictWhole(round);
  const performance = Math.abs(whole - without.performance) < LEAST_SHARE ? `${percent(whole, 1)} as with it` : `${percent(without.performance, 1)} instead of ${percent(whole, 1)}`;
  const rest = round.plan.treatment ? comparePlaces(round, without) : compareDirt(round, without);
  return [`Predicted without stroke ${stroke + 1}: ${performance}${rest ? `; ${rest}` : ""}.`, takes, ...(heading ? [heading] : [])];
}

/** Draws the strokes on a picture of the surface, under its dots: one of them thick with an arrow, or left out. */
function drawStrokes(picture: SVGSVGElement, round: Round, stroke: number, isWiped: boolean): void {
  const { width, height } = picture.viewBox.baseVal;
  const unit = Math.max(width, height) / 100;
  const lines = round.plan.strokes.map((line) => metres(line));
  const others = lines.filter((_, i) => i !== stroke).map(pathOf).join("");
  const chosen = isWiped ? lines[stroke] : null;
  const parts: SVGElement[] = [svg("path", { d: others, class: "w-line", "stroke-width": 0.6 * unit })];
  if (chosen && chosen.length >= 4) {
    const [x0, y0, x, y] = chosen.slice(-4);
    const turn = (Math.atan2(y0! - y!, x! - x0!) * 180) / Math.PI;
    const arrow = svg("path", { d: `M${3 * unit} 0L${-2 * unit} ${2.6 * unit}V${-2.6 * unit}z`, class: "w-line-tip", transform: `translate(${1000 * x!} ${-1000 * y!}) rotate(${turn})` });
    parts.push(...["w-line w-casing", "w-line w-line-chosen"].map((kind, i) => svg("path", { d: pathOf(chosen), class: kind, "stroke-width": (i ? 1.6 : 3) * unit })), arrow);
  }
  picture.insertBefore(svg("g", {}, ...parts), picture.querySelector(".w-dots"));
}

/** Returns the predicted board at the end of the plan, with and without a stroke; nothing if the latter is unknown. */
export function makeStrokeFigures(round: Round, stroke: number): Element[] {
  const without = leftOut(round, stroke);
  if (!without) return [];
  const { treatment: record } = round.plan;
  const figure = (title: string, isWiped: boolean): HTMLElement | null => {
    const values = isWiped ? round.treated?.last ?? null : resultValues(record, without.treated);
    const places = isWiped ? round.particles.last : metres(without.particles);
    const label = `${title}, at the end: ${viewOf(round)} with ${places.length / 2} particles`;
    const made = record ? makeMapFigure(title, round, values) : makeFigure(surfacePicture(round, [{ mark: "believed", places }], label), title);
    const picture = made?.querySelector<SVGSVGElement>("svg.w-picture");
    if (picture) drawStrokes(picture, round, stroke, isWiped);
    return made;
  };
  const figures = [figure(`Predicted with stroke ${stroke + 1}`, true), figure("Predicted without it", false)].filter((one) => one !== null);
  return [el("div", { class: "w-pair" }, ...figures), ...(record ? [makeScale(record)] : [])];
}
