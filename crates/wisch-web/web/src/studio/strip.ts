// What happened in an episode as a strip over its time, and beside it how sure its estimate is.
import { clockText, countNames, el, estimateText, percent, svg } from "../dom.ts";
import { PUSH } from "../round.ts";
import { MARKS } from "../timeline/lanes.ts";
import type { Listed } from "./server.ts";

/** The mark of what ends a round early. */
const BAR = "M-2 -8h4v16h-4z";

/** How the events of a class are named and marked. */
const LOOKS: Record<string, { name: string; shape: string; colour: string; hollow?: boolean }> = {
  HumanCollision: { name: PUSH, shape: MARKS.collision, colour: "collision" },
  HandGuiding: { name: "hand guiding", shape: MARKS.hand, colour: "hand" },
  ContactLoss: { name: "contact loss", shape: MARKS.event, colour: "event", hollow: true },
  Overload: { name: "overload", shape: MARKS.event, colour: "event" },
  ProtectiveStop: { name: "protective stop", shape: BAR, colour: "bad" },
  Stopped: { name: "stop on request or by an error", shape: BAR, colour: "bad" },
  EndedEarly: { name: "early end", shape: BAR, colour: "bad" },
};

/** Counts the events by their names: "2 × push or collision, 1 × contact loss". */
export const describeEvents = ({ events }: Pick<Listed, "events">): string =>
  countNames(events.flatMap(({ class: name, count }) => Array.from({ length: LOOKS[name] ? count : 0 }, () => LOOKS[name]!.name)));

/** Draws the rounds of an episode as blocks, and its events as marks on them. */
function drawTime(episode: Listed): SVGElement {
  const { seconds, round_starts: starts } = episode;
  const x = (time: number) => `${(100 * Math.min(1, Math.max(0, time / seconds))).toFixed(2)}%`;
  const width = (from: number, to: number) => `${((100 * Math.max(0, to - from)) / seconds).toFixed(2)}%`;
  const rounds = starts.map((start, i) => svg("rect", { x: x(start), y: 3, width: width(start, starts[i + 1] ?? seconds), height: 12, rx: 2, class: "s-round" }));
  const known = episode.events.flatMap((event) => (LOOKS[event.class] ? [{ ...event, ...LOOKS[event.class]! }] : []));
  const spans = known.map(({ start, end, colour }) => svg("rect", { x: x(start), y: 7.5, width: width(start, end), height: 3, fill: `var(--${colour})` }));
  const marks = known.map(({ start, end, count, name, shape, colour, hollow }) => {
    const ink = hollow ? { fill: "var(--paper)", stroke: `var(--${colour})`, "stroke-width": 2 } : { fill: `var(--${colour})`, stroke: "var(--paper)" };
    const title = `${count > 1 ? `${count} \u00d7 ` : ""}${name}, ${clockText(start)} to ${clockText(end)}`;
    return svg("svg", { x: x(start), y: 9, overflow: "visible" }, svg("path", { d: shape, ...ink }, svg("title", {}, title)));
  });
  return svg("svg", { class: "s-time", "aria-hidden": "true" }, ...rounds, ...spans, ...marks);
}

/** Draws the estimate with its interval on a scale from 0 to 100 %, and the target; null without an estimate. */
function drawEstimate({ performance: mean, low, high, target }: Listed): SVGElement | null {
  if (mean === null) return null;
  const x = (share: number) => `${(100 * Math.min(1, Math.max(0, share))).toFixed(2)}%`;
  const [from, to] = [low ?? mean, high ?? mean];
  const words = `estimated ${estimateText({ mean, low: from, high: to })}${target === null ? "" : `, target ${percent(target)}`}`;
  const upright = (share: number, y1: number, y2: number, look: Record<string, string | number>) => svg("line", { x1: x(share), x2: x(share), y1, y2, ...look });
  return svg("svg", { class: "s-estimate", role: "img", "aria-label": words }, svg("title", {}, words),
    svg("rect", { y: 6, width: "100%", height: 6, rx: 3, class: "s-round" }),
    svg("rect", { x: x(from), y: 4, width: x(to - from), height: 10, rx: 2, fill: "var(--estimated)", "fill-opacity": 0.4 }),
    upright(mean, 2, 16, { stroke: "var(--estimated)", "stroke-width": 2.5 }),
    target !== null && upright(target, 0, 18, { stroke: "var(--target)", "stroke-width": 1.5, "stroke-dasharray": "3 2" }));
}

/** Returns the strip of an episode; null for one that lasts no time. */
export const makeStrip = (episode: Listed): HTMLElement | null =>
  (episode.seconds > 0 ? el("span", { class: "s-strip" }, drawTime(episode), drawEstimate(episode)) : null);
