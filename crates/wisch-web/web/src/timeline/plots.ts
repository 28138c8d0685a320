// Plots over time: force, height and performance.
import { fixed, percent } from "../dom.ts";
import { colour } from "../theme.ts";
import { drawClipped, drawLine, drawText, fillBox, levels, PREDICTED_DASH, type Frame, type Lane, type Pen } from "./frame.ts";
import type { PlotColumn } from "../columns.ts";
import type { Estimate } from "../recording.ts";
import type { Round } from "../round.ts";
import type { Recording } from "../store.ts";

type Scale = (value: number) => number;

/** Draws the axis and grid of a plot; returns its scale. */
function drawScale(pen: Pen, frame: Frame, lane: Lane, low: number, high: number, most: number, shown: (value: number) => string): Scale {
  const y = (value: number) => lane.top + lane.height - ((value - low) / (high - low)) * lane.height;
  for (const value of levels(low, high, most)) {
    drawLine(pen, frame.left, y(value), frame.width - frame.right, y(value), Math.abs(value) < 1e-12 ? "rule" : "grid");
    drawText(pen, shown(value), frame.left - 5, Math.min(Math.max(y(value), lane.top + 4), lane.top + lane.height - 3), { size: 10, align: "right" });
  }
  return y;
}

/** Returns where the curves of a plot are. */
const plotArea = (frame: Frame, { top, height }: Lane): [number, number, number, number] => [frame.left - 1, top - 2, frame.span + 2, height + 4];

/** Draws a measured column of all rounds; `unit` converts its values to shown values. */
export function drawMeasured(pen: Pen, frame: Frame, lane: Lane, recording: Recording, of: (round: Round) => PlotColumn, look: { name: string; unit: number; least: number; bounds?: [number, number]; target?: (round: Round) => number | null }): void {
  let [low, high] = [0, look.least];
  for (const round of recording.rounds) {
    const { least, largest } = of(round);
    if (least <= largest) [low, high] = [Math.min(low, least * look.unit), Math.max(high, largest * look.unit, look.target?.(round) ?? 0)];
  }
  // Heights far from the surface would flatten the heights in contact.
  if (look.bounds) [low, high] = [Math.max(low, look.bounds[0]), Math.min(high, look.bounds[1])];
  const room = 0.06 * (high - low);
  const y = drawScale(pen, frame, lane, low < 0 ? low - room : 0, high + room, 3, (value) => String(Number(value.toPrecision(3))).replace("-", "\u2212"));
  let labelled: number | null = null;
  drawClipped(pen, plotArea(frame, lane), () => {
    for (const round of recording.rounds) {
      if (round.end < frame.from || round.start > frame.to || !round.count) continue;
      pen.strokeStyle = colour(look.name);
      pen.lineWidth = 1.5;
      pen.lineJoin = "round";
      const dense = round.count * ((frame.to - frame.from) / Math.max(round.length, 1e-9)) > 4 * frame.span;
      drawCurve(pen, (dense ? findEnvelope : findSamples)(frame, round, of(round), (value) => y(value * look.unit)));
      const target = look.target?.(round) ?? null;
      if (target !== null) drawTarget(pen, [Math.max(frame.left, frame.x(round.start)), frame.x(round.end)], y(target), frame.narrow || target === labelled ? "" : `target ${fixed(target, 1)}\u202fN`, true);
      labelled = target;
    }
  });
}

/** A place on the canvas; null where the curve breaks off. */
type Point = [x: number, y: number] | null;

function drawCurve(pen: Pen, points: readonly Point[]): void {
  pen.beginPath();
  points.forEach((point, i) => { if (point) points[i - 1] ? pen.lineTo(...point) : pen.moveTo(...point); });
  pen.stroke();
}

/** Returns every visible sample. */
function findSamples(frame: Frame, round: Round, { data }: PlotColumn, y: Scale): Point[] {
  const from = round.place(frame.from - round.start)[0];
  const to = Math.min(round.count, round.place(frame.to - round.start)[0] + 2);
  return data.slice(from, to).map((value, i) => (Number.isFinite(value) ? [frame.x(round.start + round.t[from + i]!), y(value)] : null));
}

/** Returns minimum and maximum of each column of pixels. */
function findEnvelope(frame: Frame, round: Round, column: PlotColumn, y: Scale): Point[] {
  const points: Point[] = [];
  const last = Math.min(frame.width - frame.right, frame.x(round.start + round.t.at(-1)!));
  for (let x = Math.max(Math.floor(frame.left), Math.floor(frame.x(round.start))); x <= last; x++) {
    const [from, to] = [x, x + 1].map((edge) => round.place(frame.t(edge) - round.start)[0]) as [number, number];
    const range = column.range(from, Math.max(to, from + 1) + 1);
    const [top, bottom] = range ? [y(range[1]), y(range[0])] : [];
    points.push(...(range ? [[x, bottom!], [x, Math.min(top!, bottom! - 0.7)]] as Point[] : [null]));
  }
  return points;
}

/** Width of the band of the last estimate, and least width of the others [pixels]. */
const BAND_PX = 14;

/** Draws performance: predicted dotted, estimated as bands, true as crosses, and the target. */
export function drawPerformance(pen: Pen, frame: Frame, lane: Lane, recording: Recording): void {
  const y = drawScale(pen, frame, lane, 0, 1, 2, (value) => fixed(100 * value, 0));
  const target = recording.head?.task?.target;
  const right = frame.width - frame.right;
  drawClipped(pen, plotArea(frame, lane), () => {
    if (target !== undefined) drawTarget(pen, [frame.left, right], y(target), `target ${percent(target)}`, target <= 0.8);
    for (const round of recording.rounds) {
      if (round.end < frame.from || round.start > frame.to) continue;
      drawPrediction(pen, frame, round, y);
    }
  });
  recording.rounds.forEach((round, i) => {
    if (!round.interpreted || round.end > frame.to + 1e-9) return;
    const band = bandOf(frame, round, recording.rounds[i + 1]);
    if (band) drawBand(pen, band, round.interpreted.estimate, y);
    if (round.end >= frame.from) drawResult(pen, frame, round, y);
  });
}

/** Draws a target as a dashed line, with its label above or below it, in front of curves. */
function drawTarget(pen: Pen, [from, to]: [number, number], y: number, label: string, isAbove: boolean): void {
  pen.setLineDash([6, 4]);
  drawLine(pen, from, y, to, y, "target", 1.5);
  pen.setLineDash([]);
  drawText(pen, label, from + 5, y + (isAbove ? -2 : 3), { size: 10, base: isAbove ? "bottom" : "top", name: "target", halo: true });
}

function drawPrediction(pen: Pen, frame: Frame, round: Round, y: Scale): void {
  const points = round.plan.growth;
  if (!points.length) return;
  pen.strokeStyle = colour("believed");
  pen.lineWidth = 2.2;
  pen.lineCap = "round";
  pen.setLineDash(PREDICTED_DASH);
  // The last value holds until the end of the round.
  drawCurve(pen, [...points, [Infinity, points.at(-1)![1]]].map(([time, share]) => [frame.x(round.start + Math.min(time!, round.length)), y(share!)]));
  pen.setLineDash([]);
  pen.lineCap = "butt";
}

/** Returns left and right end of the band in which an estimate holds, until the next stroke; null where it is not visible. */
export function bandOf(frame: Frame, round: Round, next: Round | undefined): [number, number] | null {
  const x = frame.x(round.end);
  const until = next ? frame.x(next.start + next.firstContact) : 0;
  const [from, to] = [Math.max(x, frame.left), Math.min(Math.max(x + BAND_PX, until), frame.width - 4)];
  return to > from ? [from, to] : null;
}

/** Draws an estimate with its interval. */
function drawBand(pen: Pen, [from, to]: [number, number], { mean, low, high }: Estimate, y: Scale): void {
  fillBox(pen, "interval", from, y(high), to - from, Math.max(1, y(low) - y(high)));
  for (const bound of [low, high]) drawLine(pen, from, y(bound), to, y(bound), "estimated", 1);
  drawLine(pen, from, y(mean), to, y(mean), "estimated", 2.4);
}

/** Draws what becomes known at a round's end: an arrow from the prediction to the estimate that replaces it, the estimate from
 * touch, and the true performance. */
function drawResult(pen: Pen, frame: Frame, round: Round, y: Scale): void {
  const { estimate, by_touch } = round.interpreted!;
  const x = frame.x(round.end);
  const predicted = round.growthAt(round.length);
  if (predicted !== null) drawJump(pen, x, y(predicted), y(estimate.mean));
  // Without a camera both estimates are one.
  if (by_touch.low !== estimate.low || by_touch.high !== estimate.high) drawWhisker(pen, x - 13, y, by_touch);
  const truth = round.truth?.performance ?? null;
  if (truth === null) return;
  const at = y(truth);
  for (const [width, name] of [[5, "paper"], [2.4, "actual"]] as const) {
    drawLine(pen, x + 3, at - 4.5, x + 12, at + 4.5, name, width);
    drawLine(pen, x + 12, at - 4.5, x + 3, at + 4.5, name, width);
  }
}

/** Draws an arrow from the predicted to the estimated value. */
function drawJump(pen: Pen, x: number, from: number, to: number): void {
  drawLine(pen, x, from, x, to, "ink", 1.4);
  if (Math.abs(to - from) < 8) return;
  const back = 6 * Math.sign(from - to);
  drawLine(pen, x - 3.5, to + back, x, to, "ink", 1.4);
  drawLine(pen, x + 3.5, to + back, x, to, "ink", 1.4);
}

/** Draws the estimate from touch. */
function drawWhisker(pen: Pen, x: number, y: Scale, { mean, low, high }: Estimate): void {
  drawLine(pen, x, y(low), x, y(high), "by-touch", 1.4);
  for (const bound of [low, high]) drawLine(pen, x - 3, y(bound), x + 3, y(bound), "by-touch", 1.4);
  fillBox(pen, "by-touch", x - 2.2, y(mean) - 2.2, 4.4, 4.4);
}
