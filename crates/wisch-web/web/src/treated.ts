// Passes or coat thickness of each place of a treated surface: over time as predicted, and after a round as estimated and true.
import { number } from "./columns.ts";
import { trueShape, type Bend, type Recording } from "./store.ts";
import type { Round } from "./round.ts";
import type { Pose, TreatmentRecord } from "./recording.ts";

/** Whether the goal of a round is a treated surface, whose places are no dirt. */
export const isTreated = ({ plan: { goal } }: Round): boolean => goal?.kind === "polished" || goal?.kind === "dispensed";

/** Returns what is measured at each place, in words. */
export const quantityOf = ({ plan: { goal } }: Round): string => (goal?.kind === "dispensed" ? "coat thickness" : "passes");

/** Distance from the middle of a drawn cell to its edge, in its sides; cells overlap a little, as their middles are rounded. */
export const CELL_REACH = 0.51;

export type Degree = "little" | "allowed" | "much";
export const DEGREES: Record<Degree, string> = { little: "too little", allowed: "allowed", much: "too much" };

/** An interval of values with its colour. */
export interface Bin {
  degree: Degree;
  /** Least value; passes are rounded before. */
  from: number;
  label: string;
  /** Name of its colour on the page. */
  colour: string;
}

/** Most bins below, in and above the allowed band. */
const MOST_BINS: Record<Degree, number> = { little: 4, allowed: 3, much: 2 };

/** Divides an interval into at most `most` parts and returns where they begin. */
function divide(from: number, to: number, most: number, whole: boolean): number[] {
  const parts = whole ? Math.min(most, to - from) : most;
  const starts = Array.from({ length: parts }, (_, i) => from + ((to - from) * i) / parts);
  return whole ? starts.map(Math.floor) : starts;
}

/** Returns the scale of a map, from nothing upwards. */
export function binsOf({ unit, low, high, target }: TreatmentRecord): Bin[] {
  const whole = unit === "passes";
  const above = whole ? high + 1 : high;
  const starts: Record<Degree, number[]> = {
    little: divide(0, low, MOST_BINS.little, whole),
    allowed: divide(low, above, MOST_BINS.allowed, whole),
    much: [above, whole ? above + Math.max(1, high - low) : high + 2 * (high - target)],
  };
  // Few bins use the whole range of shades; the faintest one, which looks like no surface, is left to fine scales.
  const shade = (degree: Degree, i: number, count: number): number => {
    const [first, most] = [degree === "little" && count < MOST_BINS.little ? 2 : 1, MOST_BINS[degree]];
    return first + Math.round((i * (most - first)) / Math.max(1, count - 1));
  };
  const all = (Object.keys(starts) as Degree[]).flatMap((degree) => starts[degree].map((from, i, { length }) => ({ degree, from, colour: `${degree}-${shade(degree, i, length)}` })));
  const text = (value: number): string => (whole ? String(value) : String(Number(value.toPrecision(value < 100 ? 2 : 3))));
  return all.map((bin, i) => {
    const next = all[i + 1]?.from;
    const last = next === undefined ? null : whole ? next - 1 : next;
    return { ...bin, label: last === null ? `\u2265 ${text(bin.from)}` : last === bin.from ? text(last) : `${text(bin.from)}\u2013${text(last)}` };
  });
}

/** Returns the index of the bin of a value. The allowed band includes both its ends. */
export function binOf(bins: readonly Bin[], { unit, target }: TreatmentRecord, value: number): number {
  const counted = unit === "passes" ? Math.round(value) : value;
  const margin = 1e-6 * target;
  let found = 0;
  bins.forEach(({ degree, from }, i) => { if (degree === "much" && unit !== "passes" ? counted > from + margin : counted >= from - margin) found = i; });
  return found;
}

/** Returns for each value whether it is too little, allowed or too much. */
export function degreesOf(record: TreatmentRecord, values: readonly number[]): Degree[] {
  const bins = binsOf(record);
  return values.map((value) => bins[binOf(bins, record, value)]!.degree);
}

export const shareOf = (degrees: readonly Degree[], wanted: Degree): number => degrees.filter((degree) => degree === wanted).length / Math.max(1, degrees.length);

/** Returns the allowed band in words, such as "2 to 4 passes". */
export const bandText = ({ unit, low, high }: TreatmentRecord): string => (low === high ? `${low} ${unit}` : `${low} to ${high} ${unit}`);

/** A map of a surface at a time. */
export interface SurfaceValues {
  kind: "predicted" | "estimated" | "true";
  title: string;
  record: TreatmentRecord;
  values: number[];
  pose: Pose;
  shape: Bend;
}

const cache = new WeakMap<number[], number[]>();

/** Converts written values of a result to the unit of the record; null where they are missing, or of other places. */
export function resultValues(record: TreatmentRecord | null | undefined, written: number[] | null | undefined): number[] | null {
  if (!record || !written || written.length !== record.places.length / 2) return null;
  const known = cache.get(written);
  if (known) return known;
  const values = written.map((steps) => number(steps) * record.step);
  cache.set(written, values);
  return values;
}

/** Returns the map that the scene shows: after a round the true or the estimated one, until the robot wipes again; else the predicted one. */
export function mapAt(recording: Recording, t: number, round: Round, layers: { believed: boolean; estimated: boolean; actual: boolean }): SurfaceValues | null {
  const done = recording.endedAt(t);
  if (done?.plan.treatment) {
    const { interpreted, truth, plan: { treatment: record, surface } } = done;
    const pose = interpreted?.found ?? surface.pose;
    const name = `${quantityOf(done)} after round ${done.number}`;
    const actual = layers.actual ? resultValues(record, truth?.treated) : null;
    if (actual) return { kind: "true", title: `True ${name}`, record, values: actual, pose: truth?.surface ?? pose, shape: trueShape(truth, surface.shape) };
    const estimated = layers.estimated ? resultValues(record, interpreted?.treated) : null;
    if (estimated) return { kind: "estimated", title: `Estimated ${name}: mean of the belief`, record, values: estimated, pose, shape: surface.shape };
  }
  const { treatment: record, surface } = round.plan;
  if (!layers.believed || !record || !round.treated) return null;
  return { kind: "predicted", title: `Predicted ${quantityOf(round)}`, record, values: round.treated.at(t - round.start), pose: surface.pose, shape: surface.shape };
}
