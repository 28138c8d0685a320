// Maps of a treated surface with their scale: passes or coat thickness, and the allowed band.
import { capitalise, el, makeSwatches, percent, svg, uniqueId } from "./dom.ts";
import { metres } from "./particles.ts";
import { makeFigure, surfacePicture } from "./picture.ts";
import { bandText, binOf, binsOf, CELL_REACH, DEGREES, degreesOf, quantityOf, resultValues, shareOf, type Degree } from "./treated.ts";
import type { Round } from "./round.ts";
import type { Recording } from "./store.ts";
import type { TreatmentRecord } from "./recording.ts";

/** Makes the scale of a map: a colour and an interval for each bin, grouped by too little, allowed and too much. */
export function makeScale(record: TreatmentRecord): HTMLElement {
  const bins = binsOf(record);
  const group = (degree: Degree) => {
    const shown = bins.filter((bin) => bin.degree === degree);
    return shown.length > 0 && el("li", { "data-degree": degree, style: `flex-grow:${shown.length}` }, el("span", {}, DEGREES[degree]),
      makeSwatches(shown));
  };
  return el("div", { class: "w-scale" }, el("ul", { "aria-label": `Scale in ${record.unit}` }, ...(Object.keys(DEGREES) as Degree[]).map(group)),
    el("p", {}, `${record.unit}; allowed: ${bandText(record)}${record.unit === "passes" ? ", counted in whole passes" : `, target ${record.target} ${record.unit}`}`));
}

/** Returns the shares of the places in each degree, in words. */
function describeShares(record: TreatmentRecord, values: readonly number[]): string {
  const degrees = degreesOf(record, values);
  return (Object.keys(DEGREES) as Degree[]).map((degree) => `${percent(shareOf(degrees, degree), 1)} ${DEGREES[degree]}`).join(", ");
}

/** Draws the values as one path per bin, in millimetres; neighbours in a row are one rectangle. */
export function drawCells(record: TreatmentRecord, values: readonly number[]): SVGElement[] {
  const bins = binsOf(record);
  const paths = bins.map(() => "");
  const places = metres(record.places);
  const [width, height] = record.cell.map((side) => 1000 * side) as [number, number];
  const [left, up] = [CELL_REACH * width, CELL_REACH * height];
  const count = values.length;
  for (let i = 0; i < count;) {
    const bin = binOf(bins, record, values[i]!);
    const [x, y] = [1000 * places[2 * i]!, -1000 * places[2 * i + 1]!];
    let run = 1;
    const follows = (k: number) => i + k < count && Math.abs(-1000 * places[2 * (i + k) + 1]! - y) < 0.1 * height && Math.abs(1000 * places[2 * (i + k)]! - x - k * width) < 0.1 * width;
    while (follows(run) && binOf(bins, record, values[i + run]!) === bin) run++;
    paths[bin] += `M${(x - left).toFixed(1)} ${(y - up).toFixed(1)}H${(x + (run - 1) * width + left).toFixed(1)}V${(y + up).toFixed(1)}H${(x - left).toFixed(1)}z`;
    i += run;
  }
  return bins.map(({ colour }, i) => svg("path", { d: paths[i]!, style: `fill:var(--${colour})` }));
}

/** Returns a map of a round's surface; null if its values are unknown. */
export function makeMapFigure(title: string, round: Round, values: number[] | null): HTMLElement | null {
  const record = round.plan.treatment;
  if (!record || !values) return null;
  const id = uniqueId();
  const label = `${title}: ${quantityOf(round)} per place; ${describeShares(record, values)} of ${values.length} places`;
  const map = svg("g", { "clip-path": `url(#${id})`, class: "w-map" }, ...drawCells(record, values));
  return makeFigure(surfacePicture(round, [], label, { id, map }), title);
}

/** Returns the figures of the first screen for a treated surface: before, predicted, and estimated or, with the truth, `seam`; with their scale. */
export function makeMapFigures({ rounds }: Recording, seam: HTMLElement | null): Element[] {
  const first = rounds[0]!;
  const last = rounds.at(-1)!;
  const done = rounds.findLast((round) => round.interpreted) ?? null;
  const unrolled = first.plan.surface.shape ? ", surface unrolled" : "";
  const record = last.plan.treatment;
  if (!record) {
    const missing = `This recording has no ${quantityOf(last)} per place.`;
    return [makeFigure(surfacePicture(last, [], missing), missing, { class: "w-wide" })];
  }
  const figures = [
    makeMapFigure("Before", first, first.treated?.first ?? null),
    makeMapFigure(last.number === 1 ? "Predicted" : `Predicted for round ${last.number}`, last, last.treated?.last ?? null),
    seam ?? (done && makeMapFigure(`Estimated after ${done.number} ${done.number === 1 ? "round" : "rounds"}: mean of the belief`, done, resultValues(done.plan.treatment, done.interpreted?.treated))),
  ].filter((one) => one !== null);
  const quantity = quantityOf(last);
  const title = `${capitalise(quantity)} per place${unrolled}`;
  return [el("p", { class: "w-wide w-quiet" }, title), ...figures, makeScale(record)];
}
