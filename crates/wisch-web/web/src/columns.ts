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
    if (this.length === this.data.length) this.reserve(2 * this.length);
    this.data[this.length++] = value;
  }

  /** Appends `value` until the column has `length` values. */
  fill(value: number, length: number): void {
    if (length > this.data.length) this.reserve(Math.max(length, 2 * this.data.length));
    if (length > this.length) this.data.fill(value, this.length, length);
    this.length = Math.max(length, this.length);
  }

  get last(): number {
    return this.length ? this.data[this.length - 1]! : NaN;
  }

  private reserve(capacity: number): void {
    const grown = this.exact ? new Float64Array(capacity) : new Float32Array(capacity);
    grown.set(this.data.subarray(0, this.length));
    this.data = grown;
  }
}

const FANOUT = 16;

/** A column that returns minimum and maximum of any index range in O(log n), to draw an hour in one pixel. */
export class PlotColumn extends Column {
  /** Level k holds minimum and maximum of each FANOUT^(k+1) consecutive values, alternating. */
  private readonly levels: Column[] = [];
  least = Infinity;
  largest = -Infinity;

  override push(value: number): void {
    super.push(value);
    if (value < this.least) this.least = value;
    if (value > this.largest) this.largest = value;
    let [low, high] = [value, value];
    for (let k = 0, size = FANOUT; this.length % size === 0; k++, size *= FANOUT) {
      const below = k === 0 ? null : this.levels[k - 1]!;
      [low, high] = [Infinity, -Infinity];
      for (let i = 0; i < FANOUT; i++) {
        const a = below ? below.data[below.length - 2 * FANOUT + 2 * i]! : this.data[this.length - FANOUT + i]!;
        const b = below ? below.data[below.length - 2 * FANOUT + 2 * i + 1]! : a;
        if (a < low) low = a;
        if (b > high) high = b;
      }
      const level = (this.levels[k] ??= new Column(this.exact, 64));
      level.push(low);
      level.push(high);
    }
  }

  /** Returns minimum and maximum of the indices from `from` up to, but not including, `to`; null if there are no finite values. */
  range(from: number, to: number): [number, number] | null {
    let [low, high] = [Infinity, -Infinity];
    let i = Math.max(0, from);
    const end = Math.min(to, this.length);
    while (i < end) {
      let [level, size] = [-1, 1];
      while (i % (size * FANOUT) === 0 && i + size * FANOUT <= end && level + 1 < this.levels.length) {
        level++;
        size *= FANOUT;
      }
      const at = i / size;
      const a = level < 0 ? this.data[i]! : this.levels[level]!.data[2 * at]!;
      const b = level < 0 ? a : this.levels[level]!.data[2 * at + 1]!;
      if (a < low) low = a;
      if (b > high) high = b;
      i += size;
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
