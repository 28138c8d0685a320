// Diagrams of a query.
import { el, fixed, svg, svgText } from "../dom.ts";
import { trackName } from "../scene/queried.ts";
import type { Plot } from "./server.ts";

const WIDTH = 400;
const HEIGHT = 220;
const [LEFT, RIGHT, TOP, BOTTOM] = [52, 12, 10, 38];
const ROW = 27;
/** Width of the labels beside bars. */
const LABEL = 130;
/** Letters of a label, and of its second line, which is smaller. */
const LETTERS = 20;
const SMALL_LETTERS = 21;

/** Draws a diagram; `titled` returns the title of a name, with its episode in a second line. */
export function drawPlot(given: Plot, titled: (name: string) => string): HTMLElement {
  const entitle = <T>(list: [string, T][] | undefined) => list?.map(([name, value]): [string, T] => [titled(name), value]);
  const one = { ...given, amounts: entitle(given.amounts), spans: entitle(given.spans) };
  const title = one.title || one.id || one.diagram;
  const drawn = one.amounts ? (one.diagram === "piechart" ? drawPie(one.amounts) : drawBars(one.amounts)) : one.spans ? drawSpans(one.spans) : drawPoints(one);
  drawn.setAttribute("role", "img");
  drawn.setAttribute("aria-label", `${one.diagram}: ${title}`);
  const labels = [one.x_label, one.y_label].filter((label) => label);
  return el("figure", { class: "s-plot" }, el("figcaption", {}, title), drawn, labels.length ? el("p", { class: "w-quiet" }, labels.join(" / ")) : null);
}

const short = (value: number): string => (Number.isInteger(value) ? fixed(value, 0) : fixed(value, Math.abs(value) < 10 ? 3 : 1));
const picture = (height: number, ...children: (Node | null)[]): SVGSVGElement => svg("svg", { viewBox: `0 0 ${WIDTH} ${height}` }, ...children);
/** Makes a label of one or two lines. */
const label = (x: number, y: number, words: string, anchor: "start" | "end" = "end"): SVGElement[] => {
  const [first = "", second] = words.split("\n");
  if (!second) return [svgText(x, y, cut(first, LETTERS), anchor)];
  const small = svgText(x, y + 6, cut(second, SMALL_LETTERS), anchor, { fill: "var(--quiet)", "font-size": 9.5 });
  return [svgText(x, y - 5, cut(first, LETTERS), anchor), small];
};
const oneLine = (words: string): string => words.replace("\n", ", ");
const cut = (words: string, most: number): string => (words.length > most ? `${words.slice(0, most - 1)}\u2026` : words);

/** Draws an interval of numbers per row, with its name beside it. */
function drawRows(rows: readonly { name: string; from: number; to: number; value: string; label?: string }[], [low, high]: [number, number], room: number, fill: string): SVGElement[] {
  const x = (value: number) => LABEL + ((WIDTH - LABEL - room) * (value - low)) / (high - low || 1);
  return rows.flatMap(({ name, from, to, value, label: text }, i) => [
    ...label(LABEL - 6, i * ROW + 17, name),
    svg("rect", { x: x(from), y: i * ROW + 4, width: Math.max(1, x(to) - x(from)), height: ROW - 6, rx: 3, fill: `var(--${fill})` }, svg("title", {}, `${oneLine(name)}: ${value}`)),
    ...(text === undefined ? [] : [svgText(x(to) + 5, i * ROW + 17, text)]),
  ]);
}

function drawBars(amounts: [string, number][]): SVGSVGElement {
  const numbers = amounts.map(([, n]) => n);
  const rows = amounts.map(([name, n]) => ({ name, from: Math.min(0, n), to: Math.max(0, n), value: String(n), label: short(n) }));
  return picture(rows.length * ROW + 6, ...drawRows(rows, [Math.min(0, ...numbers), Math.max(0, ...numbers)], 52, "believed"));
}

function drawPie(amounts: [string, number][]): SVGSVGElement {
  const all = amounts.reduce((sum, [, n]) => sum + n, 0) || 1;
  const [cx, cy, r] = [90, 92, 82];
  let angle = -Math.PI / 2;
  const rim = (a: number) => `${cx + r * Math.cos(a)} ${cy + r * Math.sin(a)}`;
  const height = Math.max(2 * cy, amounts.length * ROW + 10);
  return picture(height, ...amounts.flatMap(([name, value], i) => {
    const from = angle;
    angle += (2 * Math.PI * value) / all;
    const fill = `var(--${trackName(i)})`;
    const isAll = value >= all;
    const shape = isAll
      ? svg("circle", { cx, cy, r, fill })
      : svg("path", { d: `M${cx} ${cy}L${rim(from)}A${r} ${r} 0 ${angle - from > Math.PI ? 1 : 0} 1 ${rim(angle)}Z`, fill, stroke: "var(--paper)" });
    return [shape, svg("rect", { x: 190, y: i * ROW + 4, width: 12, height: 12, fill }), ...label(208, i * ROW + 14, name, "start"), svgText(WIDTH - 4, i * ROW + 14, `${short(value)} (${fixed((100 * value) / all, 0)} %)`, "end")];
  }));
}

function drawSpans(list: [string, [number, number]][]): SVGSVGElement {
  const range: [number, number] = [Math.min(...list.map(([, [start]]) => start)), Math.max(...list.map(([, [, end]]) => end))];
  const rows = list.map(([name, [from, to]]) => ({ name, from, to, value: `${short(to - from)} s` }));
  const height = rows.length * ROW + 22;
  return picture(height, ...drawRows(rows, range, 10, "event"), svgText(LABEL, height - 4, "0 s"), svgText(WIDTH - 10, height - 4, `${short(range[1] - range[0])} s`, "end"));
}

function drawPoints({ points = [], diagram, x_label, y_label }: Pick<Plot, "points" | "diagram" | "x_label" | "y_label">): SVGSVGElement {
  const range = (k: 0 | 1): [number, number] => {
    const values = points.map((point) => point[k]);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    return low < high ? [low, high] : [low - 0.5, high + 0.5];
  };
  if (!points.length) return picture(30, svgText(8, 18, "no points"));
  const [[x0, x1], [y0, y1]] = [range(0), range(1)];
  const x = (value: number) => LEFT + ((WIDTH - LEFT - RIGHT) * (value - x0)) / (x1 - x0);
  const y = (value: number) => HEIGHT - BOTTOM - ((HEIGHT - TOP - BOTTOM) * (value - y0)) / (y1 - y0);
  const marks: Node[] = diagram === "linechart"
    ? [svg("path", { d: points.map(([px, py], i) => `${i ? "L" : "M"}${x(px).toFixed(1)} ${y(py).toFixed(1)}`).join(""), fill: "none", stroke: "var(--believed)", "stroke-width": 1.8 })]
    : points.map(([px, py]) => svg("circle", { cx: x(px), cy: y(py), r: 2.6, fill: "var(--believed)", "fill-opacity": 0.7 }));
  return picture(HEIGHT,
    svg("path", { d: `M${LEFT} ${TOP}V${HEIGHT - BOTTOM}H${WIDTH - RIGHT}`, fill: "none", stroke: "var(--rule)" }), ...marks,
    svgText(LEFT - 5, y(y0), short(y0), "end"), svgText(LEFT - 5, y(y1) + 9, short(y1), "end"),
    svgText(LEFT, HEIGHT - BOTTOM + 15, short(x0)), svgText(WIDTH - RIGHT, HEIGHT - BOTTOM + 15, short(x1), "end"),
    svgText(WIDTH / 2, HEIGHT - 5, cut(x_label, 40), "middle"), svgText(4, TOP + 22, cut(y_label, 30)));
}
