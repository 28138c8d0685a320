// Values of the places of a treated surface over time. Each step changes some of them.
import { lastAtMost, number } from "./columns.ts";
import type { TreatmentRecord, ValueStep } from "./recording.ts";

/** The predicted values of all places over time, in the unit of the record. */
export class ValueTrack {
  private readonly times: number[];
  private index = -1;
  private now: number[] = [];

  constructor(private readonly record: TreatmentRecord) {
    this.times = record.steps.map(([time]) => number(time));
  }

  /** Returns the values at a time; the same array until they change. */
  at(time: number): number[] {
    const index = Math.max(0, lastAtMost(this.times, time));
    if (index === this.index) return this.now;
    const forward = this.index >= 0 && this.index < index;
    const values = forward ? [...this.now] : Array.from({ length: this.record.places.length / 2 }, () => 0);
    for (const step of this.record.steps.slice(forward ? this.index + 1 : 0, index + 1)) this.apply(values, step);
    this.index = index;
    this.now = values;
    return values;
  }

  get first(): number[] {
    return this.at(-Infinity);
  }

  get last(): number[] {
    return this.at(Infinity);
  }

  private apply(values: number[], [, changed, steps]: ValueStep): void {
    changed.forEach((place, k) => { if (place < values.length) values[place] = number(steps[k]) * this.record.step; });
  }
}
