// Particles over time. Each step removes and adds particles; snapshots give access to any step without replaying all before it.
import { lastAtMost, number } from "./columns.ts";
import type { ParticleStep } from "./recording.ts";

/** Positions are in tenths of a millimetre. */
export const PER_METRE = 1e4;
/** Number of steps between two snapshots. */
const SNAPSHOT_STEPS = 32;

export const metres = (places: readonly unknown[]): Float32Array => Float32Array.from(places, (v) => number(v) / PER_METRE);

/** Returns the number of particles within a circle [m]. */
export const countWithin = (places: Float32Array, { place: [x, y], radius }: { place: [number, number]; radius: number }): number =>
  places.filter((v, i) => i % 2 === 0 && Math.hypot(v - x, places[i + 1]! - y) <= radius).length;

export class ParticleTrack {
  readonly times: number[];
  private readonly snapshots: Float32Array[] = [];
  private index = -1;
  private now: Float32Array = new Float32Array();
  /** Maximum number of coordinates of a step. */
  readonly most: number;

  constructor(private readonly steps: ParticleStep[]) {
    this.times = steps.map(([time]) => number(time));
    let places: Float32Array = new Float32Array();
    let most = 0;
    steps.forEach((step, i) => {
      places = applyStep(places, step);
      most = Math.max(most, places.length);
      if (i % SNAPSHOT_STEPS === 0) this.snapshots.push(places);
    });
    this.most = most;
  }

  /** Returns the index of the step at a time; -1 before the first. */
  stepAt(time: number): number {
    return lastAtMost(this.times, time);
  }

  /** Returns the positions of a step: x, y alternating [m]. */
  places(index: number): Float32Array {
    if (index < 0 || !this.steps.length) return new Float32Array();
    if (index === this.index) return this.now;
    const snapshot = Math.floor(index / SNAPSHOT_STEPS);
    const forward = this.index >= 0 && this.index < index && this.index >= snapshot * SNAPSHOT_STEPS;
    let places = forward ? this.now : this.snapshots[snapshot]!;
    for (let i = forward ? this.index + 1 : snapshot * SNAPSHOT_STEPS + 1; i <= index; i++) places = applyStep(places, this.steps[i]!);
    this.index = index;
    this.now = places;
    return places;
  }

  at(time: number): Float32Array {
    return this.places(Math.max(0, this.stepAt(time)));
  }
}

function applyStep(places: Float32Array, [, gone, added]: ParticleStep): Float32Array {
  const drop = new Set(gone);
  const result = new Float32Array(Math.max(0, places.length - 2 * drop.size) + added.length);
  let n = 0;
  for (let i = 0; i < places.length / 2; i++) {
    if (drop.has(i)) continue;
    result[n++] = places[2 * i]!;
    result[n++] = places[2 * i + 1]!;
  }
  for (const v of added) result[n++] = number(v) / PER_METRE;
  return n === result.length ? result : result.slice(0, n);
}
