// Columns of numbers that grow at their end.

/** Measured values with their range, for plots. */
export class PlotColumn {
  readonly data: number[] = [];
  least = Infinity;
  largest = -Infinity;

  push(value: number): void {
    this.data.push(value);
    if (value < this.least) this.least = value;
    if (value > this.largest) this.largest = value;
  }

  /** Returns minimum and maximum of the indices from `from` up to, but not including, `to`; null if there are no finite values. */
  range(from: number, to: number): [number, number] | null {
    let [low, high] = [Infinity, -Infinity];
    for (let i = Math.max(0, from), end = Math.min(to, this.data.length); i < end; i++) {
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

/** Returns the index of the last of the sorted entries that is at most `value`; -1 if all are greater. */
export const lastAtMost = (rising: readonly number[], value: number): number => lastIndex(rising.length, (i) => rising[i]! <= value);

/** Returns `make` such that it makes the value of an object once. */
export function once<Key extends object, Value>(make: (key: Key) => Value): (key: Key) => Value {
  const made = new WeakMap<Key, Value>();
  return (key) => {
    if (!made.has(key)) made.set(key, make(key));
    return made.get(key)!;
  };
}

/** Returns a number of a piece; NaN for null, which stands for an unknown value. */
export const number = (value: unknown): number => (typeof value === "number" ? value : NaN);
