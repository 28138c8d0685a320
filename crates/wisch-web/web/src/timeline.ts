// One timeline for all rounds, below the scene. Its cursor is the clock.
import { clockText, el, estimateText, fixed, percent, phaseText, say, uniqueId } from "./dom.ts";
import { frames, isSoftwareRendered, throttle } from "./frames.ts";
import { endText, heightText } from "./words.ts";
import { isPrinting, onTheme } from "./theme.ts";
import { drawText, Frame, type Lane, type LaneName, type Pen } from "./timeline/frame.ts";
import { drawAxis, drawContact, drawEvents, drawPhases, drawRounds } from "./timeline/lanes.ts";
import { drawHighlights, drawSelection, type Interval } from "./timeline/highlights.ts";
import { drawMeasured, drawPerformance } from "./timeline/plots.ts";
import { listenPointer } from "./timeline/input.ts";
import type { Clock } from "./clock.ts";
import { HIGH_M, type Round } from "./round.ts";
import type { Recording } from "./store.ts";

/** Range of drawn heights [mm]. */
const HEIGHTS_MM: [number, number] = [-20, 80];
/** What draws each lane, from top to bottom. */
const DRAWN: Record<LaneName, (pen: Pen, frame: Frame, lane: Lane, recording: Recording) => void> = {
  axis: drawAxis, rounds: drawRounds, phases: drawPhases, contact: drawContact, events: drawEvents,
  force: (...on) => drawMeasured(...on, (round) => round.normal, { name: "force", unit: 1, least: 5, target: (round) => round.target }),
  height: (...on) => drawMeasured(...on, (round) => round.height, { name: "height", unit: 1000, least: 10, bounds: HEIGHTS_MM }),
  performance: drawPerformance,
};
const LANES = Object.keys(DRAWN) as LaneName[];
const COMPACT = LANES.slice(0, -2);
/** Width of the printed timeline [pixels]. */
const PAPER_PX = 700;
/** Below this height of the view, plots are lower [pixels]. */
const TIGHT_PX = 700;
/** Interval between redraws during a live run, with and without a graphics card [ms]. */
const EVERY_MS = { card: 60, software: 250 };
/** Shortest visible interval [s]. */
const NEAREST_S = 0.2;

export class Timeline {
  readonly element: HTMLElement;
  private readonly base = el("canvas", { "aria-hidden": "true" });
  private readonly cursor = el("i", { class: "w-cursor", "aria-hidden": "true" });
  private readonly hair = el("i", { class: "w-hair", "aria-hidden": "true", hidden: true });
  private readonly veil = el("i", { class: "w-veil", "aria-hidden": "true", hidden: true });
  private readonly whole = el("button", { class: "w-button w-whole", type: "button", hidden: true, title: "Show the whole run  (double-click)", click: () => this.reset() }, "Whole run");
  private readonly tip = el("div", { class: "w-tip", hidden: true });
  private readonly description = el("p", { class: "w-hidden", id: uniqueId() });
  private readonly frame: Frame;
  private readonly stop: (() => void)[] = [];
  private highlights: Interval[] = [];
  private selection: [number, number] | null = null;
  private zoomed = false;
  private readonly moved = () => this.draw();
  /** Whether the drawing is outdated, and the duration that it shows. */
  private stale = true;
  private drawnDuration = -1;
  private hovered: number | null = null;

  /** `selected` is called with the interval of the common clock that a user selects [s]; null ends the selection. */
  constructor(private readonly recording: Recording, private readonly clock: Clock, compact: boolean, private readonly selected: (interval: [number, number] | null) => void) {
    this.frame = new Frame(compact ? COMPACT : LANES);
    this.element = el("div", {
      class: "w-timeline", role: "slider", tabindex: 0, "aria-label": "Time in the run",
      "aria-valuemin": 0, "aria-describedby": this.description.id, "aria-keyshortcuts": "Space ArrowLeft ArrowRight [ ] Home End I O Escape",
    }, this.base, this.veil, this.hair, this.cursor, this.whole, this.tip, this.description);
    listenPointer(this.element, {
      seek: (x) => {
        if (clock.playing) clock.pause();
        clock.seek(this.timeAt(x));
      },
      selectsAt: (y) => {
        const lane = this.frame.lane("force");
        return lane !== undefined && y >= lane.top && y <= lane.top + lane.height;
      },
      select: (ends) => this.select(ends && [this.timeAt(Math.min(...ends)), this.timeAt(Math.max(...ends))]),
      hover: (x) => this.hover(x),
      zoom: (x, factor, moved) => this.zoom(x, factor, moved),
      reset: () => this.reset(),
    });
    const sizes = new ResizeObserver(() => this.resize());
    sizes.observe(this.element);
    requestAnimationFrame(() => {
      const view = this.element.closest(".w-view");
      if (view) sizes.observe(view);
    });
    const grown = throttle(isSoftwareRendered() ? EVERY_MS.software : EVERY_MS.card, () => this.redraw());
    this.stop.push(
      () => sizes.disconnect(), grown.stop,
      clock.subscribe(() => this.ask()),
      recording.onChange(() => (recording.live ? grown.ask() : this.redraw())),
      onTheme(() => this.resize()),
    );
  }

  highlight(intervals: Interval[]): void {
    this.highlights = intervals;
    this.redraw();
  }

  private timeAt(x: number): number {
    return this.frame.t(Math.min(Math.max(x, this.frame.left), this.frame.width - this.frame.right));
  }

  /** Selects an interval of the common clock; null ends the selection. Returns whether that changes anything. */
  select(interval: [number, number] | null): boolean {
    if (!interval && !this.selection) return false;
    this.selection = interval;
    this.selected(interval);
    this.redraw();
    return true;
  }

  /** Moves the start or the end of the selection to the shown time; its other end is at first that of the run. */
  selectTo(isEnd: boolean): void {
    const { time, duration } = this.clock;
    const [from, to] = this.selection ?? [0, duration];
    const ends: [number, number] = isEnd ? [from < time ? from : 0, time] : [time, to > time ? to : duration];
    if (ends[0] < ends[1]) this.select(ends);
  }

  redraw(): void {
    this.stale = true;
    this.ask();
  }

  destroy(): void {
    frames.drop(this.moved);
    for (const stop of this.stop) stop();
  }

  private ask(): void {
    frames.draw(this.moved);
  }

  private resize(): void {
    const width = isPrinting() ? PAPER_PX : this.element.clientWidth;
    if (!width) return;
    this.frame.layOut(width, isPrinting() || (this.element.closest(".w-view")?.clientHeight ?? TIGHT_PX) < TIGHT_PX);
    const magnified = (this.element as HTMLElement & { currentCSSZoom?: number }).currentCSSZoom ?? 1;
    const ratio = isPrinting() ? 3 : Math.min((devicePixelRatio || 1) * magnified, 2);
    Object.assign(this.base, { width: Math.round(width * ratio), height: Math.round(this.frame.height * ratio) });
    Object.assign(this.base.style, { width: `${width}px`, height: `${this.frame.height}px` });
    this.element.style.height = this.base.style.height;
    this.stale = true;
    frames.drop(this.moved);
    this.draw();
  }

  private reset(): void {
    this.zoomed = false;
    this.redraw();
  }

  private zoom(x: number, factor: number, moved: number): void {
    const { frame } = this;
    const whole = Math.max(this.clock.duration, NEAREST_S);
    const about = frame.t(x);
    const width = Math.min(whole, Math.max(NEAREST_S, (frame.to - frame.from) * factor));
    const share = (about - frame.from) / (frame.to - frame.from);
    let from = about - share * width - (moved / frame.span) * width;
    from = Math.min(Math.max(0, from), whole - width);
    [frame.from, frame.to] = [from, from + width];
    this.zoomed = width < whole * 0.999;
    this.redraw();
  }

  private pen(): Pen {
    // Without a graphics card, `willReadFrequently` keeps the canvas in main memory, which is faster.
    const pen = this.base.getContext("2d", { willReadFrequently: isSoftwareRendered() })!;
    const ratio = this.base.width / (parseFloat(this.base.style.width) || 1);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, this.frame.width, this.frame.height);
    return pen;
  }

  private draw(): void {
    const { recording, clock, frame } = this;
    const { duration } = clock;
    if (!this.zoomed) [frame.from, frame.to] = [0, Math.max(duration, 1e-3)];
    else if (clock.playing || clock.following) this.scrollToCursor();
    if (this.stale || this.drawnDuration !== duration) {
      this.drawBase();
      say(this.description, recording.rounds.map((round) => describeRound(recording, round)).join(" "));
      this.drawnDuration = duration;
      this.stale = false;
    }
    this.whole.hidden = !this.zoomed;
    this.moveOverlays();
    const { element } = this;
    element.setAttribute("aria-valuemax", duration.toFixed(1));
    element.setAttribute("aria-valuenow", clock.time.toFixed(2));
    const instant = recording.at(clock.time);
    const phase = instant?.round.plan.phases[instant.phase]?.name;
    element.setAttribute("aria-valuetext", `${clockText(clock.time)}${instant ? `, round ${instant.round.number}` : ""}${phase ? `, ${phaseText(phase)}` : ""}${this.selection ? `, ${describeSelection(recording, this.selection)}` : ""}`);
  }

  /** Scrolls when the cursor leaves the visible interval. */
  private scrollToCursor(): void {
    const { frame, clock } = this;
    const width = frame.to - frame.from;
    if (clock.time >= frame.from && clock.time <= frame.to - 0.03 * width) return;
    const from = Math.min(Math.max(0, clock.time - 0.1 * width), Math.max(0, clock.duration - width));
    if (Math.abs(from - frame.from) < 1e-9) return;
    [frame.from, frame.to] = [from, from + width];
    this.stale = true;
  }

  private drawBase(): void {
    const { frame, recording } = this;
    const pen = this.pen();
    for (const lane of frame.lanes) {
      const { name, label, plot, top, height } = lane;
      DRAWN[name](pen, frame, lane, recording);
      if (!frame.narrow) label.split("\n").forEach((line, i) => drawText(pen, line, 2, top + (plot ? 8 + 13 * i : height / 2), { room: frame.left - (plot ? 26 : 6) }));
      else if (plot) drawText(pen, label, 2, top - 8);
    }
    drawHighlights(pen, frame, this.highlights);
    const force = frame.lane("force");
    if (force && this.selection) drawSelection(pen, frame, force, this.selection, describeSelection(this.recording, this.selection));
    this.drawVeil();
  }

  /** Moves the overlays without redrawing the canvas. */
  private moveOverlays(): void {
    const { frame, clock } = this;
    const right = frame.width - frame.right;
    const x = frame.x(clock.time);
    this.cursor.hidden = x < frame.left - 1 || x > right + 1;
    this.cursor.style.transform = `translateX(${x.toFixed(1)}px)`;
    this.hair.hidden = this.hovered === null;
    if (this.hovered !== null) this.hair.style.transform = `translateX(${this.hovered}px)`;
  }

  /** Covers the part of a live run that is not measured yet. */
  private drawVeil(): void {
    const { frame, recording } = this;
    const right = frame.width - frame.right;
    const measured = Math.min(right, Math.max(frame.left, frame.x(recording.now)));
    this.veil.hidden = !recording.live || measured >= right;
    Object.assign(this.veil.style, { left: `${measured}px`, width: `${right - measured}px` });
  }

  private hover(x: number | null): void {
    const { frame } = this;
    const inside = x !== null && x >= frame.left && x <= frame.width - frame.right;
    this.hovered = inside ? x : null;
    this.tip.hidden = !inside;
    if (inside) {
      say(this.tip, this.describe(frame.t(x)).join("\n"));
      // The tooltip stands above the lanes, so that it covers none of what it explains.
      this.tip.style.left = `${Math.max(2, Math.min(x - this.tip.offsetWidth / 2, frame.width - this.tip.offsetWidth - 2))}px`;
    }
    this.ask();
  }

  /** Returns the lines of the tooltip at a time. */
  private describe(t: number): string[] {
    const instant = this.recording.at(t);
    if (!instant) return [clockText(t, 2)];
    const { round, normal, height, performance, phase, contact } = instant;
    const near = 4 * ((this.frame.to - this.frame.from) / this.frame.span);
    const events = this.recording.happenings.filter(({ start, end }) => t >= start - near && t <= end + near);
    const shown = this.highlights.filter(({ start, end, label }) => label && t >= start - near && t <= end + near).map(({ label }) => label);
    // The mark of a round's end is explained on both sides of it.
    const ended = this.recording.rounds.findLast((other) => other.interpreted && Math.abs(t - other.end) < 4 * near) ?? this.recording.resultAt(t);
    return [
      `${clockText(t, 2)} \u00b7 round ${round.number}`,
      phaseText(round.plan.phases[phase]?.name ?? ""),
      normal === null ? "" : `force ${fixed(normal, 1)} N${contact === "none" || round.target === null ? "" : `, target ${fixed(round.target, 1)} N`}`,
      height === null ? "" : `tool height ${heightText(instant)}`,
      contact === "none" ? "" : contact === "pushed" ? `pushed by somebody or something${height !== null && height > HIGH_M ? ", not on the surface" : ""}` : "contact with the surface",
      performance === null ? "" : `performance ${percent(performance)} predicted`,
      ...(ended ? describeResult(ended) : []),
      this.selection && t >= this.selection[0] && t <= this.selection[1] ? describeSelection(this.recording, this.selection) : "",
      ...new Set(shown),
      ...events.map(({ kind, words }) => `${kind}: ${words}`),
    ].filter((text) => text !== "");
  }
}

/** Says what the timeline shows of a round. */
export function describeRound(recording: Recording, round: Round): string {
  const { number, start, end, plan, contacts: { contact, pushed }, normal, interpreted, events } = round;
  const sum = (list: readonly (readonly [number, number])[]) => clockText(list.reduce((all, [from, to]) => all + to - from, 0));
  const isLogged = plan.kind === "logged";
  const isMeasured = round.count > 0 && normal.least <= normal.largest;
  const count = (number: number, noun: string) => `${number} ${noun}${number === 1 ? "" : "s"}`;
  return `${[
    `Round ${number}, ${clockText(start)} to ${clockText(end)}`, isLogged ? "" : count(plan.strokes.length, "stroke"),
    isMeasured ? `in contact for ${sum(contact)}` : isLogged ? "" : `planned contact for ${sum(contact)}`,
    pushed.length ? `pushed for ${sum(pushed)}` : "", events.length ? count(events.length, "detected event") : "",
    normal.largest > 0 ? `force at most ${fixed(normal.largest, 1)} N` : "", plan.predicted === null ? "" : `predicted ${percent(plan.predicted)}`,
    interpreted ? `estimated ${estimateText(interpreted.estimate)}` : "", endText(recording, round),
  ].filter((part) => part).join(", ")}.`;
}

/** Explains what is drawn at a round's end. */
function describeResult(round: Round): string[] {
  const { estimate } = round.interpreted!;
  const predicted = round.growthAt(round.length);
  return [
    `performance after round ${round.number}: ${estimateText(estimate)} estimated`,
    predicted === null ? "" : `the estimate after round ${round.number} replaces the prediction of ${percent(predicted)}`,
    typeof round.truth?.performance === "number" ? `true performance after round ${round.number}: ${percent(round.truth.performance)}` : "",
  ];
}

/** Describes the force in a selected interval. */
function describeSelection({ rounds }: Recording, [from, to]: [number, number]): string {
  const ranges = rounds.filter((round) => round.count && round.start <= to && round.end >= from)
    .map((round) => round.normal.range(round.place(from - round.start)[0], round.place(to - round.start)[0] + 1)).filter((range) => range !== null);
  const [low, high] = [Math.min(...ranges.map((range) => range[0])), Math.max(...ranges.map((range) => range[1]))];
  return `selected: ${clockText(from, 2)} to ${clockText(to, 2)}${ranges.length ? `, force ${fixed(low, 1)} to ${fixed(high, 1)} N` : ""}`;
}
