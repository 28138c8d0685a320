// One round: what was planned, what was measured, what came out.
import { Column, PlotColumn, lastAtMost, number } from "./columns.ts";
import { ParticleTrack } from "./particles.ts";
import type { JudgedPiece, ObservedPiece, Pose, RoundPiece, SamplesPiece, TruthPiece } from "./recording.ts";

/** Pressed harder than this, and than this share of what it was pressed with at most, the tool touches. */
export const TOUCH_N = 0.3;
const TOUCH_SHARE = 0.1;

export class Round {
  readonly number: number;
  /** When it begins on the common clock. */
  start = 0;
  readonly t = new Column(true);
  readonly q: Column[];
  /** Seven columns in turn. */
  readonly tool = new Column();
  readonly force = new Column();
  readonly normal = new PlotColumn();
  readonly height = new PlotColumn();
  readonly particles: ParticleTrack;
  judged: JudgedPiece | null = null;
  truth: TruthPiece | null = null;
  observed: ObservedPiece | null = null;
  /** Whether no more samples of it will come. */
  over = false;

  constructor(readonly plan: RoundPiece, variables: number) {
    this.number = plan.round;
    this.q = Array.from({ length: variables }, () => new Column(false, 64));
    this.particles = new ParticleTrack(plan.particles);
  }

  get count(): number {
    return this.t.length;
  }

  /** How long it takes, as far as is known. */
  get length(): number {
    const sampled = this.count ? this.t.last : 0;
    if (this.judged) return Math.max(this.judged.duration, sampled);
    return this.over && this.count ? sampled : Math.max(this.plan.duration, sampled);
  }

  get end(): number {
    return this.start + this.length;
  }

  push({ t, q, tool, force, normal, height }: SamplesPiece): void {
    const n = t.length;
    const wrong = tool.length !== 7 * n || force.length !== 3 * n || normal.length !== n || height.length !== n;
    if (wrong || Object.values(q).some((column) => column.length !== n)) throw new Error("samples of different length");
    if (!t.every(Number.isFinite)) throw new Error("a time that is none");
    const before = this.count;
    for (const time of t) this.t.push(Math.max(number(time), this.count ? this.t.last : -Infinity));
    this.q.forEach((column, variable) => {
      const positions = q[variable];
      if (positions) for (const position of positions) column.push(number(position));
      else column.fill(before ? column.last : 0, before + n);
    });
    for (const v of tool) this.tool.push(number(v));
    for (const v of force) this.force.push(number(v));
    for (const v of normal) this.normal.push(number(v));
    for (const v of height) this.height.push(number(v));
  }

  /** Index of the sample at or before a time and the share of the way to the next. */
  place(time: number): [index: number, share: number] {
    const i = Math.max(0, lastAtMost(this.t.data, time, this.count));
    const [from, to] = [this.t.data[i]!, this.t.data[i + 1]!];
    if (i + 1 >= this.count || !(to > from)) return [i, 0];
    return [i, Math.min(1, Math.max(0, (time - from) / (to - from)))];
  }

  /** Positions of all variables at a time, into `out`. */
  positions(time: number, out: Float64Array): Float64Array {
    if (!this.count) return out;
    const [i, share] = this.place(time);
    this.q.forEach(({ data }, v) => { out[v] = between(data[i]!, data[i + 1]!, share); });
    return out;
  }

  toolAt(time: number): Pose | null {
    if (!this.count) return null;
    const [i, share] = this.place(time);
    return between7(this.tool.data, i, share);
  }

  forceAt(time: number): [number, number, number] | null {
    if (!this.count) return null;
    const [i, share] = this.place(time);
    const at = (k: number) => between(this.force.data[3 * i + k]!, this.force.data[3 * i + 3 + k]!, share);
    return [at(0), at(1), at(2)];
  }

  valueAt(column: Column, time: number): number | null {
    if (!this.count) return null;
    const [i, share] = this.place(time);
    const value = between(column.data[i]!, column.data[i + 1]!, share);
    return Number.isFinite(value) ? value : null;
  }

  /** Performance as predicted at a time. */
  growthAt(time: number): number | null {
    const { growth } = this.plan;
    if (!growth.length) return null;
    let i = growth.length - 1;
    while (i > 0 && growth[i]![0] > time) i--;
    const [from, to] = [growth[i]!, growth[i + 1]];
    if (!to || time <= from[0] || to[0] <= from[0]) return from[1];
    return between(from[1], to[1], Math.min(1, (time - from[0]) / (to[0] - from[0])));
  }

  /** Index of the phase at a time, -1 if there is none. */
  phaseAt(time: number): number {
    const { phases } = this.plan;
    let found = -1;
    phases.forEach((phase, i) => { if (phase.start <= time + 1e-9) found = i; });
    return found;
  }

  /** What tells touch from noise [N]. */
  get touchForce(): number {
    return Math.max(TOUCH_N, TOUCH_SHARE * this.normal.largest);
  }

  /** Whether the tool touches: as measured, else as planned. */
  touches(time: number, normal: number | null): boolean {
    if (normal !== null && this.normal.largest > TOUCH_N) return normal > this.touchForce;
    return this.plan.phases[this.phaseAt(time)]?.contact ?? false;
  }
}

const between = (a: number, b: number, share: number): number => (share > 0 ? a + share * (b - a) : a);

/** A pose between two, the rotation along the shorter way. */
function between7(data: ArrayLike<number>, i: number, share: number): Pose {
  const [a, b] = [7 * i, 7 * i + 7];
  const pose = Array.from({ length: 7 }, (_, k) => data[a + k]!) as Pose;
  if (share <= 0) return pose;
  let same = 0;
  for (let k = 3; k < 7; k++) same += data[a + k]! * data[b + k]!;
  const sign = same < 0 ? -1 : 1;
  for (let k = 0; k < 3; k++) pose[k] = between(pose[k]!, data[b + k]!, share);
  for (let k = 3; k < 7; k++) pose[k] = between(pose[k]!, sign * data[b + k]!, share);
  const norm = Math.hypot(pose[3], pose[4], pose[5], pose[6]) || 1;
  for (let k = 3; k < 7; k++) pose[k]! /= norm;
  return pose;
}
