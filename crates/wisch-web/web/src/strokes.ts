// What each stroke of a plan is predicted to gain, and what it costs.
import { el, fixed, percent } from "./dom.ts";
import { metres } from "./particles.ts";
import type { Round } from "./round.ts";

export interface StrokeGain {
  /** Counted from 0. */
  stroke: number;
  /** Predicted rise of the performance, in [0, 1]; negative where dirt leaves the goal. */
  gain: number;
  /** Way in contact [m]. */
  way: number;
  /** Time from the end of the stroke before to its own end [s]. */
  time: number;
}

/** Returns gain and cost of each stroke, in order of time; nothing without a prediction. */
export function findGains(round: Round): StrokeGain[] {
  const { phases, growth, strokes } = round.plan;
  if (!growth.length) return [];
  let since = 0;
  let before = round.growthAt(0)!;
  return phases.filter(({ stroke }) => stroke !== null).map(({ end, stroke }) => {
    const after = round.growthAt(end)!;
    const found = { stroke: stroke!, gain: after - before, way: measure(metres(strokes[stroke!] ?? [])), time: end - since };
    [since, before] = [end, after];
    return found;
  });
}

const measure = (line: Float32Array): number => {
  let way = 0;
  for (let i = 2; i + 1 < line.length; i += 2) way += Math.hypot(line[i]! - line[i - 2]!, line[i + 1]! - line[i - 1]!);
  return way;
};

/** Returns a table of the strokes; a click shows the end of a stroke. */
export function makeGainTable(round: Round, seek: (time: number) => void): HTMLElement | null {
  const gains = findGains(round);
  if (!gains.length) return null;
  let end = round.start;
  return el("div", { class: "w-choice", tabindex: 0, role: "group", "aria-label": "Strokes" },
    el("table", {},
      el("caption", {}, "Predicted gain of each stroke in performance, with its way in contact and its time, including the way to it. A stroke without a gain may prepare a later one."),
      el("thead", {}, el("tr", {}, ...["Stroke", "Gain", "Contact", "Time"].map((name) => el("th", { scope: "col" }, name)))),
      el("tbody", {}, ...gains.map(({ stroke, gain, way, time }) => {
        const until = end += time;
        return el("tr", {},
          el("th", { scope: "row" }, el("button", { type: "button", class: "w-link", click: () => seek(until) }, String(stroke + 1))),
          ...[`${gain > 0 ? "+" : ""}${percent(gain)}`, `${fixed(way, 2)} m`, `${fixed(time, 1)} s`].map((text) => el("td", {}, text)));
      }))));
}
