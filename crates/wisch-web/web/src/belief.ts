// The belief at the end of a round against the ground truth of the simulated world.
import { fixed, percent } from "./dom.ts";
import { PER_METRE, countWithin, metres } from "./particles.ts";
import { MOST_COUNTED } from "./strokes.ts";
import { degreesOf, isTreated, quantityOf, resultValues, shareOf } from "./treated.ts";
import type { DensityRecord, Places } from "./recording.ts";
import type { Round } from "./round.ts";

/** Share of the dirt that the stated area holds [1]. */
const SPREAD_SHARE = 0.9;

/** Whether a round has a result and the ground truth of the same places, so that they can be compared. */
export function isComparable(round: Round): boolean {
  const { plan: { treatment }, interpreted, truth } = round;
  if (!isTreated(round)) return Boolean(interpreted && truth?.particles);
  return Boolean(resultValues(treatment, interpreted?.treated) && resultValues(treatment, truth?.treated));
}

/** Returns the area of the fewest cells that hold 90 % of all, in cells; 0 without any. */
export function spreadOf(numbers: readonly number[]): number {
  const falling = numbers.filter((number) => number > 0).sort((a, b) => b - a);
  const wanted = SPREAD_SHARE * falling.reduce((sum, number) => sum + number, 0);
  let held = 0;
  const last = falling.findIndex((number) => (held += number) >= wanted - 1e-9);
  return last + 1;
}

/** Counts particles in the cells of a density, also in cells that it leaves out. */
export function countInCells(particles: Places, { cell, places }: DensityRecord): number[] {
  const counts = new Map<string, number>();
  const column = (v: number, axis: number) => Math.round((v - (places[axis] ?? 0)) / (PER_METRE * cell));
  for (let i = 0; i + 1 < particles.length; i += 2) {
    const key = `${column(particles[i]!, 0)} ${column(particles[i + 1]!, 1)}`;
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  return [...counts.values()];
}

/** A quantity as estimated and as true, and how far they are apart; empty if that says nothing. */
export type Comparison = [quantity: string, estimated: string, actual: string, off: string];

/** Compares two numbers of particles, the second of which is a whole one. */
function compareCounts(where: string, estimated: number, actual: number): Comparison {
  const off = Math.abs(Math.round(estimated) - actual);
  // One random sample of the belief is no error of it.
  return [where, String(Math.round(estimated)), String(actual), where.endsWith("(sample)") ? "" : `${off} ${off === 1 ? "particle" : "particles"}`];
}

function compareDirt({ plan: { goal }, interpreted, truth }: Round): Comparison[] {
  const { particles, density } = interpreted!;
  const actual = truth!.particles!;
  const of = density ? "" : " (sample)";
  const all = density ? density.remaining ?? density.expected.reduce((sum, number) => sum + number, 0) : particles.length / 2;
  const truly = truth!.remaining ?? actual.length / 2;
  // Of very many particles a recording has a part.
  const isThinned = actual.length / 2 !== truly || (truth!.remaining === undefined && actual.length / 2 >= MOST_COUNTED);
  const rows: Comparison[] = [];
  if (goal?.kind === "collected" && !isThinned && (!density || density.goal !== undefined)) {
    const held = density?.goal ?? countWithin(metres(particles), goal);
    const heldTruly = countWithin(metres(actual), goal);
    rows.push(compareCounts(`In the goal area${of}`, held, heldTruly), compareCounts(`Elsewhere on the surface${of}`, Math.max(0, all - held), truly - heldTruly));
  } else if (truth!.remaining !== undefined || !isThinned) rows.push(compareCounts(`Left on the surface${of}`, all, truly));
  const area = (numbers: number[]) => `${Math.round(spreadOf(numbers) * density!.cell ** 2 * 1e4)} cm\u00b2`;
  if (density && !isThinned && all > 0 && truly > 0) rows.push(["Area that holds 90\u202f% of the dirt", area(density.expected), area(countInCells(actual, density)), ""]);
  return rows;
}

function compareTreated(round: Round): Comparison[] {
  const { plan: { treatment }, interpreted, truth } = round;
  const record = treatment!;
  const values = [resultValues(record, interpreted!.treated)!, resultValues(record, truth!.treated)!] as const;
  const { length } = values[0];
  const [estimated, actual] = [degreesOf(record, values[0]), degreesOf(record, values[1])];
  const means = values.map((list) => list.reduce((sum, value) => sum + value, 0) / Math.max(1, length)) as [number, number];
  const mean = (value: number) => (record.unit === "passes" ? fixed(value, 2) : `${fixed(value, 1)} ${record.unit}`);
  const wrong = estimated.filter((degree, i) => degree !== actual[i]).length;
  return [
    [`Mean ${quantityOf(round)}`, mean(means[0]), mean(means[1]), mean(Math.abs(means[0] - means[1]))],
    ["Places whose mean is in the band", percent(shareOf(estimated, "allowed"), 1), percent(shareOf(actual, "allowed"), 1), `${wrong} of ${length} places`],
  ];
}

/** Whether the true performance of a round is known, and outside the interval of its estimate. */
export function isTruthOutside({ interpreted, truth }: Round): boolean {
  const performance = truth?.performance ?? null;
  return Boolean(interpreted && performance !== null && (performance < interpreted.estimate.low || performance > interpreted.estimate.high));
}

/** Compares estimate and ground truth of a comparable round. */
export function compareWithTruth(round: Round): Comparison[] {
  const { mean } = round.interpreted!.estimate;
  const performance = round.truth!.performance ?? null;
  const rows = isTreated(round) ? compareTreated(round) : compareDirt(round);
  if (performance === null) return rows;
  const shown = (share: number) => Number(fixed(100 * share, 1));
  const off = `${fixed(Math.abs(shown(mean) - shown(performance)), 1)} points, ${isTruthOutside(round) ? "outside" : "inside"} the interval`;
  return [...rows, ["Performance", percent(mean, 1), percent(performance, 1), off]];
}
