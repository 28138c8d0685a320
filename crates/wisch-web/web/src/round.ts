// One round: plan, measurements and results.
import { Column, PlotColumn, lastAtMost, number } from "./columns.ts";
import { ParticleTrack } from "./particles.ts";
import { ValueTrack } from "./treated.ts";
import type { EventRecord, InterpretedPiece, ObservedPiece, Pose, RoundPiece, SamplesPiece, TruthPiece } from "./recording.ts";

/** The tool is in contact if its normal force exceeds both TOUCH_N [N] and this share of the round's peak force [1]. */
export const TOUCH_N = 0.3;
const TOUCH_SHARE = 0.1;

export class Round {
  readonly number: number;
  /** Start on the common clock [s]. */
  start = 0;
  readonly t = new Column(true);
  readonly q: Column[];
  /** Poses, seven numbers per sample. */
  readonly tool = new Column();
  readonly force = new Column();
  readonly normal = new PlotColumn();
  readonly height = new PlotColumn();
  readonly particles: ParticleTrack;
  /** Predicted values of a treated surface. */
  readonly treated: ValueTrack | null;
  interpreted: InterpretedPiece | null = null;
  truth: TruthPiece | null = null;
  observed: ObservedPiece | null = null;
  /** Whether the round has all its samples. */
  over = false;

  constructor(readonly plan: RoundPiece, variables: number) {
    this.number = plan.round;
    this.q = Array.from({ length: variables }, () => new Column(false, 64));
    this.particles = new ParticleTrack(plan.particles);
    this.treated = plan.treatment ? new ValueTrack(plan.treatment) : null;
  }

  /** Detected events. */
  get events(): readonly EventRecord[] {
    return this.interpreted?.events ?? this.plan.events ?? [];
  }

  /** Measured intervals of contact, as they are known after the round. */
  get contacts(): readonly [number, number][] | null {
    return this.interpreted?.contacts ?? this.plan.contacts ?? null;
  }

  get count(): number {
    return this.t.length;
  }

  /** Duration: measured, or else planned [s]. */
  get length(): number {
    const sampled = this.count ? this.t.last : 0;
    if (this.interpreted) return Math.max(this.interpreted.duration, sampled);
    return this.over && this.count ? sampled : Math.max(this.plan.duration, sampled);
  }

  get end(): number {
    return this.start + this.length;
  }

  push({ t, q, tool, force, normal, height }: SamplesPiece): void {
    const n = t.length;
    const wrong = tool.length !== 7 * n || force.length !== 3 * n || normal.length !== n || height.length !== n;
    if (wrong || Object.values(q).some((column) => column.length !== n)) throw new Error("columns of samples differ in length");
    if (!t.every(Number.isFinite)) throw new Error("a time is not finite");
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

  /** Returns the index of the sample at or before a time, and the interpolation share towards the next in [0, 1]. */
  place(time: number): [index: number, share: number] {
    const i = Math.max(0, lastAtMost(this.t.data, time, this.count));
    const [from, to] = [this.t.data[i]!, this.t.data[i + 1]!];
    if (i + 1 >= this.count || !(to > from)) return [i, 0];
    return [i, Math.min(1, Math.max(0, (time - from) / (to - from)))];
  }

  /** Writes the positions of all variables at a time into `out`. */
  positions(time: number, out: Float64Array): Float64Array {
    if (!this.count) return out;
    const [i, share] = this.place(time);
    this.q.forEach(({ data }, v) => { out[v] = interpolate(data[i]!, data[i + 1]!, share); });
    return out;
  }

  toolAt(time: number): Pose | null {
    if (!this.count) return null;
    const [i, share] = this.place(time);
    return interpolatePose(this.tool.data, i, share);
  }

  forceAt(time: number): [number, number, number] | null {
    if (!this.count) return null;
    const [i, share] = this.place(time);
    const at = (k: number) => interpolate(this.force.data[3 * i + k]!, this.force.data[3 * i + 3 + k]!, share);
    return [at(0), at(1), at(2)];
  }

  valueAt(column: Column, time: number): number | null {
    if (!this.count) return null;
    const [i, share] = this.place(time);
    const value = interpolate(column.data[i]!, column.data[i + 1]!, share);
    return Number.isFinite(value) ? value : null;
  }

  /** Returns the predicted performance at a time. */
  growthAt(time: number): number | null {
    const { growth } = this.plan;
    if (!growth.length) return null;
    let i = growth.length - 1;
    while (i > 0 && growth[i]![0] > time) i--;
    const [from, to] = [growth[i]!, growth[i + 1]];
    if (!to || time <= from[0] || to[0] <= from[0]) return from[1];
    return interpolate(from[1], to[1], Math.min(1, (time - from[0]) / (to[0] - from[0])));
  }

  /** Returns the index of the phase at a time; -1 before the first. */
  phaseAt(time: number): number {
    const { phases } = this.plan;
    let found = -1;
    phases.forEach((phase, i) => { if (phase.start <= time + 1e-9) found = i; });
    return found;
  }

  /** Force above which the tool counts as in contact [N]. */
  get touchForce(): number {
    return Math.max(TOUCH_N, TOUCH_SHARE * this.normal.largest);
  }

  /** Whether the tool is in contact: as measured, or else as planned. */
  touches(time: number, normal: number | null): boolean {
    if (normal !== null && this.normal.largest > TOUCH_N) return normal > this.touchForce;
    return this.plan.phases[this.phaseAt(time)]?.contact ?? false;
  }
}

const interpolate = (a: number, b: number, share: number): number => (share > 0 ? a + share * (b - a) : a);

/** Interpolates between the poses i and i + 1 of `data`; the rotation takes the shorter way. */
function interpolatePose(data: ArrayLike<number>, i: number, share: number): Pose {
  const [a, b] = [7 * i, 7 * i + 7];
  const pose = Array.from({ length: 7 }, (_, k) => data[a + k]!) as Pose;
  if (share <= 0) return pose;
  let same = 0;
  for (let k = 3; k < 7; k++) same += data[a + k]! * data[b + k]!;
  const sign = same < 0 ? -1 : 1;
  for (let k = 0; k < 3; k++) pose[k] = interpolate(pose[k]!, data[b + k]!, share);
  for (let k = 3; k < 7; k++) pose[k] = interpolate(pose[k]!, sign * data[b + k]!, share);
  const norm = Math.hypot(pose[3], pose[4], pose[5], pose[6]) || 1;
  for (let k = 3; k < 7; k++) pose[k]! /= norm;
  return pose;
}
