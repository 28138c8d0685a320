// Columns of numbers that grow at their end.

type Numbers = Float32Array<ArrayBuffer> | Float64Array<ArrayBuffer>;

/** A growing array of numbers; `push` takes O(1) amortised time. */
export class Column {
  data: Numbers;
  /** Number of values. */
  length = 0;

  constructor(readonly exact = false, capacity = 256) {
    this.data = exact ? new Float64Array(capacity) : new Float32Array(capacity);
  }

  push(value: number): void {
    if (this.length === this.data.length) {
      const grown = this.exact ? new Float64Array(2 * this.length) : new Float32Array(2 * this.length);
      grown.set(this.data);
      this.data = grown;
    }
    this.data[this.length++] = value;
  }

  /** Appends `value` until the column has `length` values. */
  fill(value: number, length: number): void {
    while (this.length < length) this.push(value);
  }

  get last(): number {
    return this.length ? this.data[this.length - 1]! : NaN;
  }
}

/** A column with its range, for plots. */
export class PlotColumn extends Column {
  least = Infinity;
  largest = -Infinity;

  override push(value: number): void {
    super.push(value);
    if (value < this.least) this.least = value;
    if (value > this.largest) this.largest = value;
  }

  /** Returns minimum and maximum of the indices from `from` up to, but not including, `to`; null if there are no finite values. */
  range(from: number, to: number): [number, number] | null {
    let [low, high] = [Infinity, -Infinity];
    for (let i = Math.max(0, from), end = Math.min(to, this.length); i < end; i++) {
      const value = this.data[i]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    return low <= high ? [low, high] : null;
  }
}

/** Returns the last of the indices below `length` that has a property, which none has after the first without it; -1 if none has it. */
export function lastIndex(length: number, has: (i: number) => boolean): number {
  let [low, high] = [0, length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (has(middle)) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Returns the index of the last entry that is at most `value` among the first `length` entries, which must be sorted; -1 if all are greater. */
export const lastAtMost = (rising: ArrayLike<number>, value: number, length = rising.length): number => lastIndex(length, (i) => rising[i]! <= value);

/** Returns a number of a piece; NaN for null, which stands for an unknown value. */
export const number = (value: unknown): number => (typeof value === "number" ? value : NaN);
