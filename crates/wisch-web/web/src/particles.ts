// Particles over time: each step takes some away and adds others. Any step is at hand without going through all before.
import { lastAtMost, number } from "./columns.ts";
import type { ParticleStep } from "./recording.ts";

/** Places come in tenths of a millimetre. */
export const PER_METRE = 1e4;
/** So many steps after one that is kept whole. */
const KEPT = 32;

export const metres = (places: readonly unknown[]): Float32Array => Float32Array.from(places, (v) => number(v) / PER_METRE);

export class ParticleTrack {
  readonly times: number[];
  private readonly kept: Float32Array[] = [];
  private index = -1;
  private now: Float32Array = new Float32Array();
  /** The most numbers that any step has. */
  readonly most: number;

  constructor(private readonly steps: ParticleStep[]) {
    this.times = steps.map(([time]) => number(time));
    let places: Float32Array = new Float32Array();
    let most = 0;
    steps.forEach((step, i) => {
      places = next(places, step);
      most = Math.max(most, places.length);
      if (i % KEPT === 0) this.kept.push(places);
    });
    this.most = most;
  }

  /** Step at a time, -1 before the first. */
  stepAt(time: number): number {
    return lastAtMost(this.times, time);
  }

  /** x, y in turn [m] at a step. */
  places(index: number): Float32Array {
    if (index < 0 || !this.steps.length) return new Float32Array();
    if (index === this.index) return this.now;
    const kept = Math.floor(index / KEPT);
    const forward = this.index >= 0 && this.index < index && this.index >= kept * KEPT;
    let places = forward ? this.now : this.kept[kept]!;
    for (let i = forward ? this.index + 1 : kept * KEPT + 1; i <= index; i++) places = next(places, this.steps[i]!);
    this.index = index;
    this.now = places;
    return places;
  }

  at(time: number): Float32Array {
    return this.places(Math.max(0, this.stepAt(time)));
  }
}

function next(places: Float32Array, [, gone, added]: ParticleStep): Float32Array {
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
