// Layout of the timeline: positions of times and lanes, ticks and text.
import { colour } from "../theme.ts";

/** Labels and heights of the lanes [pixels]. Plots have a value axis. */
const LANES = {
  axis: { label: "", height: 20, plot: false },
  rounds: { label: "Round", height: 20, plot: false },
  phases: { label: "Phase, stroke", height: 18, plot: false },
  contact: { label: "Contact", height: 12, plot: false },
  events: { label: "Events", height: 18, plot: false },
  force: { label: "Force [N]", height: 74, plot: true },
  height: { label: "Tool height\n[mm]", height: 50, plot: true },
  performance: { label: "Performance\n[%]", height: 88, plot: true },
};
export type LaneName = keyof typeof LANES;
export type Lane = (typeof LANES)[LaneName] & { name: LaneName; top: number };

/** Dashes of the simulator's truth and of predictions, on the timeline [pixels]. */
export const TRUTH_DASH: [number, number] = [3, 2];
export const PREDICTED_DASH = [1, 4];
const GAP = 4;

/** Positions of times and lanes on the canvas [CSS pixels]. */
export class Frame {
  lanes: Lane[] = [];
  left = 112;
  right = 22;
  width = 600;
  height = 0;
  /** Visible interval [s]. */
  from = 0;
  to = 1;

  constructor(readonly names: LaneName[]) {}

  /** Lays out the lanes over a width; with `tight`, plots are lower. */
  layOut(width: number, tight: boolean): void {
    this.width = width;
    const narrow = width < 560;
    this.left = narrow ? 34 : 112;
    let top = 0;
    this.lanes = this.names.map((name) => {
      const { plot, height } = LANES[name];
      // On a narrow page, the label of a plot is above it.
      if (narrow && plot) top += 13;
      const lane = { ...LANES[name], name, top, height: Math.round(height * (plot && tight ? 0.66 : 1)) };
      top += lane.height + GAP + (plot ? 4 : 0);
      return lane;
    });
    this.height = top;
  }

  get narrow(): boolean {
    return this.left < 100;
  }

  get span(): number {
    return this.width - this.left - this.right;
  }

  x(t: number): number {
    return this.left + ((t - this.from) / (this.to - this.from)) * this.span;
  }

  t(x: number): number {
    return this.from + ((x - this.left) / this.span) * (this.to - this.from);
  }

  lane(name: LaneName): Lane | undefined {
    return this.lanes.find((lane) => lane.name === name);
  }
}

const STEPS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200];

/** Returns the step between time labels and their times, at most `most` of them [s]. */
export function ticks(from: number, to: number, most: number): { step: number; times: number[] } {
  const step = STEPS.find((step) => (to - from) / step <= most) ?? (to - from) / most;
  return { step, times: multiplesOf(step, from, to) };
}

/** Returns the multiples of a step within an interval. */
function multiplesOf(step: number, from: number, to: number): number[] {
  const first = Math.ceil(from / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(to / step + 1e-9) - first + 1) }, (_, k) => (first + k) * step);
}

/** Returns round values of an axis from `low` to `high`, about `most` of them. */
export function levels(low: number, high: number, most: number): number[] {
  const raw = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((step) => step >= raw * 0.999) ?? raw;
  return multiplesOf(step, low, high);
}

export type Pen = CanvasRenderingContext2D;

/** How a text is drawn: also its colour, and the width to which it is shortened [pixels]. */
interface Look {
  size?: number;
  weight?: number;
  align?: CanvasTextAlign;
  base?: CanvasTextBaseline;
  name?: string;
  room?: number;
  /** Whether it is set off from what lies behind it. */
  halo?: boolean;
}

/** Sets how texts are drawn. */
export function setText(pen: Pen, { size = 11, weight = 400, align = "left", base = "middle", name = "quiet" }: Look = {}): void {
  pen.font = `${weight} ${size}px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif`;
  pen.textAlign = align;
  pen.textBaseline = base;
  pen.fillStyle = colour(name);
}

export function fillBox(pen: Pen, name: string, x: number, y: number, width: number, height: number): void {
  pen.fillStyle = colour(name);
  pen.fillRect(x, y, width, height);
}

/** Draws on a part of the canvas only. */
export function drawClipped(pen: Pen, [x, y, width, height]: [number, number, number, number], draw: () => void): void {
  pen.save();
  pen.beginPath();
  pen.rect(x, y, width, height);
  pen.clip();
  draw();
  pen.restore();
}

/** Draws a text; nothing if its room is too narrow for three letters. */
export function drawText(pen: Pen, text: string, x: number, y: number, look: Look = {}): void {
  const { room = Infinity, halo = false } = look;
  if (room < 14) return;
  setText(pen, look);
  let shown = text.length > 200 ? text.slice(0, 200) : text;
  if (pen.measureText(shown).width > room) {
    while (shown.length > 1 && pen.measureText(`${shown}\u2026`).width > room) shown = shown.slice(0, -1);
    if (shown.length < 3) return;
    shown += "\u2026";
  }
  [pen.strokeStyle, pen.lineWidth, pen.lineJoin] = [colour("paper"), 3, "round"];
  if (halo) pen.strokeText(shown, x, y);
  pen.fillText(shown, x, y);
}

export function drawLine(pen: Pen, x1: number, y1: number, x2: number, y2: number, name: string, width = 1): void {
  pen.strokeStyle = colour(name);
  pen.lineWidth = width;
  pen.beginPath();
  pen.moveTo(x1, y1);
  pen.lineTo(x2, y2);
  pen.stroke();
}
