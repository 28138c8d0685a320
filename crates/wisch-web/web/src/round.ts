// One round: plan, measurements and results.
import { Quaternion } from "three";
import { PlotColumn, lastAtMost, lastIndex, number } from "./columns.ts";
import { capitalise } from "./dom.ts";
import { trackParticles, trackValues, type ParticleTrack, type ValueTrack } from "./particles.ts";
import type { EventRecord, InterpretedPiece, ObservedPiece, Pose, RoundPiece, SamplesPiece, TruthPiece } from "./recording.ts";

/** Without a result, a force counts if it exceeds both this share of the round's largest normal force [1], in steps of STEP_N [N],
 * and TOUCH_N or, far from the surface, PUSH_N [N]: more than the noise of free motion, which is up to 0.7 N. */
const TOUCH_SHARE = 0.1;
const STEP_N = 2;
const TOUCH_N = 1;
const PUSH_N = 2;
/** Least force that confirms an interval of a result [N]. */
const CONFIRM_N = 0.3;
/** Least number of samples in a row that show contact or a push, if only their force does. */
export const LEAST_SAMPLES = 3;
/** Height over the believed surface above which a force cannot come from wiping [m]. */
export const HIGH_M = 0.03;

/** What is measured at a time. */
export interface Measured {
  /** Positions of the robot's variables; empty without samples. */
  q: Float64Array;
  tool: Pose | null;
  force: [number, number, number] | null;
  normal: number | null;
  height: number | null;
}

/** Who acts on the tool: the surface that it presses on, somebody or something else, or nothing. */
export type Contact = "contact" | "pushed" | "none";
type Intervals = readonly (readonly [start: number, end: number])[];

/** Intervals between at least LEAST_SAMPLES samples in a row that have a property. They grow with the samples. */
class Stretches {
  readonly list: [number, number][] = [];
  private taken = 0;
  private first = 0;

  /** Takes the samples that are new. */
  extend(times: readonly number[], has: (i: number) => boolean): Intervals {
    for (; this.taken < times.length; this.taken++) {
      const i = this.taken;
      if (!has(i)) this.first = i + 1;
      else if (i - this.first + 1 === LEAST_SAMPLES) this.list.push([times[this.first]!, times[i]!]);
      else if (i - this.first >= LEAST_SAMPLES) this.list.at(-1)![1] = times[i]!;
    }
    return this.list;
  }
}

/** What a round's states follow from, and the stretches of its samples that are known so far. */
interface States {
  basis: string;
  count: number;
  pressed: Stretches;
  high: Stretches;
  contact: Intervals;
  pushed: Intervals;
}

/** An event with its interval on the common clock [s]. */
export interface Happening extends Omit<EventRecord, "by_hand"> {
  /** "event": detected by the robot. "push": ground truth of the simulated world. */
  source: "event" | "push";
  round: number;
}

/** A force that does not come from wiping. It shows neither who pushed nor whether the robot struck something, though files call
 * it a collision. */
export const PUSH = "push or collision";

/** Returns a title in which a collision is called what the page calls it everywhere. */
export const namePushes = (title: string): string =>
  title.replace(/(?<!or )\b(?:human )?collision(s?)\b/i, (_, many, at) => (many ? "pushes or collisions" : at ? PUSH : capitalise(PUSH)));

/** Returns the kind of an event in which somebody or something acts on the robot; null for other events. */
export const pushOf = ({ kind, by_hand }: EventRecord): typeof PUSH | "hand guiding" | null =>
  /guiding/i.test(kind) ? "hand guiding" : by_hand || /collision/i.test(kind) ? PUSH : null;

export class Round {
  readonly number: number;
  /** Start on the common clock [s]. */
  start = 0;
  readonly t: number[] = [];
  readonly q: number[][];
  /** Poses, seven numbers per sample. */
  readonly tool: number[] = [];
  readonly force: number[] = [];
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
  private states: States | null = null;

  constructor(readonly plan: RoundPiece, variables: number) {
    this.number = plan.round;
    this.q = Array.from({ length: variables }, () => []);
    this.particles = trackParticles(plan.particles);
    this.treated = plan.treatment ? trackValues(plan.treatment) : null;
  }

  /** Normal force with which the tool is to press [N]; null if it is unknown. */
  get target(): number | null {
    const { press_force = null } = this.plan;
    return press_force !== null && press_force > 0 ? press_force : null;
  }

  /** Detected events. */
  get events(): readonly EventRecord[] {
    return this.interpreted?.events ?? this.plan.events ?? [];
  }

  get count(): number {
    return this.t.length;
  }

  /** Duration: measured, or else planned [s]. */
  get length(): number {
    const sampled = this.t.at(-1) ?? 0;
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
    for (const time of t) this.t.push(Math.max(number(time), this.t.at(-1) ?? -Infinity));
    this.q.forEach((column, variable) => {
      const positions = q[variable];
      const last = column.at(-1) ?? 0;
      for (let i = 0; i < n; i++) column.push(positions ? number(positions[i]) : last);
    });
    for (const [column, values] of [[this.tool, tool], [this.force, force], [this.normal, normal], [this.height, height]] as const) for (const v of values) column.push(number(v));
  }

  /** Returns the index of the sample at or before a time, and the interpolation share towards the next in [0, 1]. */
  place(time: number): [index: number, share: number] {
    const i = Math.max(0, lastAtMost(this.t, time));
    const [from, to] = [this.t[i]!, this.t[i + 1]!];
    if (i + 1 >= this.count || !(to > from)) return [i, 0];
    return [i, Math.min(1, Math.max(0, (time - from) / (to - from)))];
  }

  toolAt(time: number): Pose | null {
    return this.count ? interpolatePose(this.tool, ...this.place(time)) : null;
  }

  /** Returns what is measured at a time, interpolated between samples. */
  measuredAt(time: number): Measured {
    const [i, share] = this.place(time);
    const known = this.count > 0;
    const at = (column: readonly number[], k = 0, width = 1) => interpolate(column[width * i + k]!, column[width * (i + 1) + k]!, share);
    const finite = ({ data }: PlotColumn) => (Number.isFinite(at(data)) ? at(data) : null);
    return {
      q: Float64Array.from(known ? this.q : [], (column) => at(column)), tool: this.toolAt(time),
      force: known ? [at(this.force, 0, 3), at(this.force, 1, 3), at(this.force, 2, 3)] : null, normal: finite(this.normal), height: finite(this.height),
    };
  }

  /** Planned start of the first stroke, from which on the robot changes the dirt [s]. */
  get firstContact(): number {
    return this.plan.phases.find(({ contact }) => contact)?.start ?? 0;
  }

  /** Returns the predicted performance at a time. */
  growthAt(time: number): number | null {
    const { growth } = this.plan;
    if (!growth.length) return null;
    const i = Math.max(0, growth.findLastIndex(([start]) => start <= time));
    const [from, to] = [growth[i]!, growth[i + 1]];
    if (!to || time <= from[0] || to[0] <= from[0]) return from[1];
    return interpolate(from[1], to[1], Math.min(1, (time - from[0]) / (to[0] - from[0])));
  }

  /** Returns the index of the phase at a time; -1 before the first. */
  phaseAt(time: number): number {
    return this.plan.phases.findLastIndex(({ start }) => start <= time + 1e-9);
  }

  /** Intervals in which the tool presses on the surface, and in which something else acts on it; the second ones win. New samples
   * cost what they are, not what the round has. */
  get contacts(): { contact: Intervals; pushed: Intervals } {
    const { basis, count } = this;
    if (this.states?.basis !== basis) this.states = { basis, count: -1, pressed: new Stretches(), high: new Stretches(), contact: [], pushed: [] };
    if (this.states.count !== count) Object.assign(this.states, this.classify(this.states), { count });
    return this.states;
  }

  /** Returns the one classification of contact at a time, which lane, path and texts show. */
  contactAt(time: number): Contact {
    const { contact, pushed } = this.contacts;
    return isWithin(pushed, time) ? "pushed" : isWithin(contact, time) ? "contact" : "none";
  }

  /** Whether the tool presses on the surface at a time, also while something else acts on it. */
  isPressed(time: number): boolean {
    return isWithin(this.contacts.contact, time);
  }

  /** What contacts follow from besides the samples: the classification of earlier samples changes only with it. */
  get basis(): string {
    return `${Boolean(this.interpreted)} ${this.touchForce}`;
  }

  /** Force from which on the tool touches something, as known so far [N]. */
  private get touchForce(): number {
    return TOUCH_SHARE * STEP_N * Math.floor(Math.max(0, this.normal.largest) / STEP_N);
  }

  /** Classifies the whole round. The intervals of a result count where the force confirms them: old recordings also have
   * those of a tool that crosses the height of the surface beside it. Before the result, force and height decide. */
  private classify({ pressed, high }: States): { contact: Intervals; pushed: Intervals } {
    const { normal, height, plan, interpreted } = this;
    const isMeasured = normal.least <= normal.largest;
    const least = this.touchForce;
    // Detected contacts may be weaker than what is visible without knowledge of the press force.
    const weakest = Math.max(CONFIRM_N, 0.5 * least);
    const known = interpreted?.contacts ?? plan.contacts;
    const detected = this.events.filter(pushOf).map(({ start, end }) => [start, end] as const);
    if (!this.count || !isMeasured) {
      const planned = plan.phases.filter(({ contact }) => contact).map(({ start, end }) => [start, end] as const);
      return { contact: mergeIntervals(known ?? planned), pushed: mergeIntervals(detected) };
    }
    const isHigh = (i: number) => height.data[i]! > HIGH_M;
    const strength = (i: number) => Math.hypot(this.force[3 * i]!, this.force[3 * i + 1]!, this.force[3 * i + 2]!);
    const pushes = high.extend(this.t, (i) => isHigh(i) && strength(i) > Math.max(PUSH_N, least));
    const pushed = detected.length ? mergeIntervals([...detected, ...pushes]) : pushes;
    if (!known) return { contact: pressed.extend(this.t, (i) => !isHigh(i) && normal.data[i]! > Math.max(TOUCH_N, least)), pushed };
    const isConfirmed = ([start, end]: readonly [number, number]) => (normal.range(this.place(start)[0], this.place(end)[0] + 2)?.[1] ?? 0) > weakest;
    return { contact: mergeIntervals(interpreted?.incidents ? known : known.filter(isConfirmed)), pushed };
  }
}

/** Returns whether a time is within one of the intervals, which are sorted and disjoint. */
function isWithin(intervals: Intervals, time: number): boolean {
  const last = lastIndex(intervals.length, (i) => intervals[i]![0] <= time);
  return last >= 0 && time <= intervals[last]![1];
}

/** Sorts intervals, and merges those that overlap. */
function mergeIntervals(intervals: Intervals): Intervals {
  const merged: [number, number][] = [];
  for (const [start, end] of [...intervals].sort((a, b) => a[0] - b[0])) {
    const last = merged.at(-1);
    if (last && start <= last[1]) last[1] = Math.max(last[1], end);
    else merged.push([start, end]);
  }
  return merged;
}

const interpolate = (a: number, b: number, share: number): number => (share > 0 ? a + share * (b - a) : a);

/** Interpolates between the poses i and i + 1 of `data`; the rotation takes the shorter way. */
function interpolatePose(data: number[], i: number, share: number): Pose {
  const [a, b] = [7 * i, 7 * i + 7];
  const pose = data.slice(a, b) as Pose;
  if (share <= 0) return pose;
  for (let k = 0; k < 3; k++) pose[k] = interpolate(pose[k]!, data[b + k]!, share);
  Quaternion.slerpFlat(pose, 3, data, a + 3, data, b + 3, share);
  return pose;
}
