// A seam over the picture of the surface at the end of a round: estimated on its left, true on its right.
import { compareWithTruth, isComparable } from "./belief.ts";
import { capitalise, el, makeRow, makeTable, percent, svg, uniqueId } from "./dom.ts";
import { drawCells } from "./maps.ts";
import { metres } from "./particles.ts";
import { surfacePicture, viewOf } from "./picture.ts";
import { isTreated, resultValues } from "./treated.ts";
import type { DensityRecord } from "./recording.ts";
import type { Round } from "./round.ts";

/** Numbers of particles of a cell from which on it is shaded more; below the first one its area is the number. */
const SHADES = [1, 3, 10];
/** Where the seam may be at first: shares of the width. */
const FIRST = [0.15, 0.85] as const;
const LITTLE = 0.03;

const shadeOf = (number: number): number => Math.max(0, SHADES.findLastIndex((from) => number >= from));

/** Draws each cell as a square, in millimetres: of an area that is the expected number below 1, shaded more from there on. */
function drawDensity({ cell, places, expected }: DensityRecord): SVGElement[] {
  const at = metres(places);
  const paths = SHADES.map(() => "");
  expected.forEach((number, i) => {
    if (!(number > 0)) return;
    const half = 500 * cell * Math.sqrt(Math.min(1, number));
    const [x, y] = [1000 * at[2 * i]!, -1000 * at[2 * i + 1]!];
    paths[shadeOf(number)] += `M${(x - half).toFixed(1)} ${(y - half).toFixed(1)}h${(2 * half).toFixed(1)}v${(2 * half).toFixed(1)}h${(-2 * half).toFixed(1)}z`;
  });
  return paths.map((d, i) => svg("path", { d, class: `w-density-${i + 1}` }));
}

/** Returns the legend of a density: squares as they are drawn. */
export function makeDensityLegend({ cell }: DensityRecord): HTMLElement {
  const square = (number: number) => {
    const side = 14 * Math.sqrt(Math.min(1, number));
    return svg("svg", { viewBox: "0 0 14 14", width: 14, height: 14, "aria-hidden": "true" }, svg("rect", { x: 7 - side / 2, y: 7 - side / 2, width: side, height: side, class: `w-density-${shadeOf(number) + 1}` }));
  };
  return el("li", {}, `estimate: expected particles per ${Math.round(1000 * cell)} mm cell:`, ...[0.1, 0.5, ...SHADES].map((number, i, all) => el("span", {}, square(number), `${i === all.length - 1 ? "\u2265\u202f" : ""}${number}`)));
}

export class Seam {
  readonly element = el("figure", { class: "w-seam" });
  /** The table that compares them. */
  readonly table = el("div", { class: "w-compared" });
  /** Share of the width that shows the estimate; null until a user or the first picture sets it. */
  private share: number | null = null;
  /** Number of the round that a user chose. */
  private chosen: number | null = null;
  private rounds: Round[] = [];

  /** Shows the chosen comparable round, or the last one. At least one round must be comparable. */
  show(rounds: readonly Round[]): HTMLElement {
    this.rounds = rounds.filter(isComparable);
    const round = this.rounds.find(({ number }) => number === this.chosen) ?? this.rounds.at(-1)!;
    this.table.replaceChildren(this.makeTable(round));
    this.element.replaceChildren(...this.draw(round));
    return this.element;
  }

  private draw(round: Round): Element[] {
    const { interpreted, truth, number } = round;
    const treatment = isTreated(round) ? round.plan.treatment : null;
    const [surface, left, right] = [uniqueId(), uniqueId(), uniqueId()];
    const side = (clip: string, ...parts: SVGElement[]) => svg("g", { "clip-path": `url(#${clip})`, class: "w-map" }, ...parts);
    const density = treatment ? null : interpreted!.density ?? null;
    const onSurface = (...parts: SVGElement[]) => svg("g", { "clip-path": `url(#${surface})` }, ...parts);
    const map = treatment ? [side(left, ...drawCells(treatment, resultValues(treatment, interpreted!.treated)!)), side(right, ...drawCells(treatment, resultValues(treatment, truth!.treated)!))] : [];
    const dots = treatment ? [] : [
      ...(density ? [] : [{ mark: "estimated" as const, places: metres(interpreted!.particles) }]), { mark: "actual" as const, places: metres(truth!.particles!) },
    ];
    const rows = compareWithTruth(round).map(([quantity, estimated, actual]) => `${quantity}: ${estimated} estimated, ${actual} true.`);
    const label = `${capitalise(viewOf(round))} at the end of round ${number}: estimated left of the seam, true right of it. ${rows.join(" ")}`;
    const picture = surfacePicture(round, dots, label, { id: surface, map: onSurface(...map) });
    if (density) picture.querySelector(".w-dots")?.before(onSurface(side(left, ...drawDensity(density))));
    picture.querySelector(".w-dots-estimated")?.setAttribute("clip-path", `url(#${left})`);
    picture.querySelector(".w-dots-actual")?.setAttribute("clip-path", `url(#${right})`);
    const [x, y, width, height] = picture.getAttribute("viewBox")!.split(" ").map(Number) as [number, number, number, number];
    this.share ??= treatment ? 0.5 : chooseShare(metres(truth!.particles!), x / 1000, width / 1000);
    const [before, after] = [left, right].map((id) => svg("clipPath", { id }, svg("rect", { y, height })));
    const line = svg("path", { class: "w-seam-line", "vector-effect": "non-scaling-stroke" });
    picture.append(before!, after!, line);
    const slider = el("input", { type: "range", min: 0, max: 1, step: 0.01, "aria-label": "Seam between estimate and truth", input: () => place(Number(slider.value)) });
    const place = (share: number) => {
      this.share = share;
      const at = x + share * width;
      for (const [clip, from, to] of [[before!, x, at], [after!, at, x + width]] as const) {
        clip.firstElementChild!.setAttribute("x", String(from));
        clip.firstElementChild!.setAttribute("width", String(to - from));
      }
      line.setAttribute("d", `M${at} ${y}v${height}`);
      slider.setAttribute("aria-valuetext", `${percent(share)} of the width shows the estimate, the rest the truth`);
    };
    this.element.style.setProperty("--ratio", (width / height).toFixed(4));
    slider.value = String(this.share);
    place(Number(slider.value));
    return [
      el("div", { class: "w-seam-picture" }, picture, slider),
      el("figcaption", {}, el("span", {}, `\u25c2 Estimated${treatment ? " mean" : ""}`), el("span", {}, "True \u25b8"), this.makeChoice(round)),
    ];
  }

  /** States the shown round, with buttons for the others. */
  private makeChoice(shown: Round): HTMLElement {
    const text = "End of round";
    if (this.rounds.length === 1) return el("p", { class: "w-rounds" }, `${text} ${shown.number}`);
    return el("div", { class: "w-rounds", role: "group", "aria-label": text }, text, ...this.rounds.map(({ number }) =>
      el("button", { type: "button", class: "w-button", "aria-pressed": String(number === shown.number), click: () => {
        this.chosen = number;
        this.show(this.rounds);
        this.element.querySelector<HTMLElement>("[aria-pressed=true]")?.focus();
      } }, String(number))));
  }

  /** Makes the table of what is estimated and what is true. */
  private makeTable(round: Round): HTMLElement {
    return makeTable([`End of round ${round.number}`, "Estimated", "True", "Off by"], compareWithTruth(round).map(([quantity, ...values]) => makeRow(quantity, values)));
  }
}

/** Returns where the seam divides the true dirt, so that both its sides may show some: a little left of the middle particle. */
function chooseShare(places: Float32Array, left: number, width: number): number {
  const columns = Array.from({ length: places.length / 2 }, (_, i) => places[2 * i]!).sort((a, b) => a - b);
  const middle = columns[columns.length >> 1];
  return middle === undefined ? 0.5 : Math.min(FIRST[1], Math.max(FIRST[0], (middle - left) / width - LITTLE));
}
