// Particles, and values of treated places, over time.
import { lastAtMost, number, once } from "./columns.ts";
import type { ParticleStep, TreatmentRecord, ValueStep } from "./recording.ts";

/** Positions are in tenths of a millimetre. */
export const PER_METRE = 1e4;
/** Number of steps between two snapshots. */
const SNAPSHOT_STEPS = 32;

export const metres = once((places: readonly unknown[]): Float32Array => Float32Array.from(places, (v) => number(v) / PER_METRE));

/** Returns the number of particles within a circle [m]. */
export const countWithin = (places: Float32Array, { place: [x, y], radius }: { place: [number, number]; radius: number }): number =>
  places.filter((v, i) => i % 2 === 0 && Math.hypot(v - x, places[i + 1]! - y) <= radius).length;

/** States that steps change; snapshots give access to any of them without replaying all before it. */
class Track<State, Step extends readonly [time: number, ...rest: unknown[]]> {
  private readonly times: number[];
  private readonly snapshots: State[] = [];
  private index = -1;

  /** `now`: the state before the first step. `apply` returns the state after a step. */
  constructor(private readonly steps: readonly Step[], private now: State, private readonly apply: (state: State, step: Step) => State) {
    this.times = steps.map(([time]) => number(time));
    steps.reduce((state, step, i) => {
      const next = apply(state, step);
      if (i % SNAPSHOT_STEPS === 0) this.snapshots.push(next);
      return next;
    }, now);
  }

  /** Returns the state at a time, at least that after the first step; the same object until it changes. */
  at(time: number): State {
    const index = Math.min(this.steps.length - 1, Math.max(0, lastAtMost(this.times, time)));
    if (index === this.index) return this.now;
    const snapshot = Math.floor(index / SNAPSHOT_STEPS);
    if (!(this.index < index && this.index >= snapshot * SNAPSHOT_STEPS)) {
      this.index = snapshot * SNAPSHOT_STEPS;
      this.now = this.snapshots[snapshot]!;
    }
    while (this.index < index) this.now = this.apply(this.now, this.steps[++this.index]!);
    return this.now;
  }

  get first(): State {
    return this.at(-Infinity);
  }

  get last(): State {
    return this.at(Infinity);
  }
}

/** Positions of particles: x, y alternating [m]. */
export type ParticleTrack = Track<Float32Array, ParticleStep>;
/** Values of all places of a treated surface, in the unit of its record. */
export type ValueTrack = Track<number[], ValueStep>;

export const trackParticles = (steps: readonly ParticleStep[]): ParticleTrack => new Track(steps, new Float32Array(), applyStep);

export const trackValues = ({ steps, step, places }: TreatmentRecord): ValueTrack =>
  new Track(steps, Array.from({ length: places.length / 2 }, () => 0), (values, [, changed, written]) => {
    const next = [...values];
    changed.forEach((place, k) => { if (place < next.length) next[place] = number(written[k]) * step; });
    return next;
  });

function applyStep(places: Float32Array, [, gone, added]: ParticleStep): Float32Array {
  const drop = new Set(gone);
  const kept = places.filter((_, i) => !drop.has(i >> 1));
  const result = new Float32Array(kept.length + added.length);
  result.set(kept);
  result.set(metres(added), kept.length);
  return result;
}
