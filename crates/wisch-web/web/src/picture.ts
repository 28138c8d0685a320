// A drawing of the surface from above: outline, goal and dirt.
import { el, svg } from "./dom.ts";
import { metres } from "./particles.ts";
import type { Round } from "./round.ts";

export interface Dots {
  mark: "believed" | "estimated" | "actual" | "seen";
  places: Float32Array;
}

/** Draws all dots as one path: a line of zero length with round ends, or a small shape, per dot. */
function drawDots({ mark, places }: Dots, unit: number): SVGPathElement {
  const [r, side] = [unit.toFixed(1), (2 * unit).toFixed(1)];
  const shape = {
    believed: "h0", estimated: `m-${r} 0a${r} ${r} 0 1 0 ${side} 0a${r} ${r} 0 1 0 -${side} 0`,
    actual: `m-${r} -${r}l${side} ${side}m0 -${side}l-${side} ${side}`, seen: `m-${r} -${r}h${side}v${side}h-${side}z`,
  }[mark];
  let d = "";
  for (let i = 0; i + 1 < places.length; i += 2) {
    const [x, y] = [1000 * places[i]!, -1000 * places[i + 1]!];
    if (Number.isFinite(x + y)) d += `M${x.toFixed(1)} ${y.toFixed(1)}${shape}`;
  }
  return svg("path", { d, class: `w-dots w-dots-${mark}`, "stroke-width": mark === "believed" ? 2.2 * unit : 0.7 * unit });
}

/** Returns the path of a line of the chart, in millimetres. */
export const pathOf = (line: Float32Array): string => Array.from({ length: line.length / 2 }, (_, i) => `${i ? "L" : "M"}${(1000 * line[2 * i]!).toFixed(1)} ${(-1000 * line[2 * i + 1]!).toFixed(1)}`).join("");

/** Says how a picture shows the surface of a round. */
export const viewOf = ({ plan: { surface } }: Round): string => (surface.shape ? "the unrolled surface" : "the surface from above");

/** Makes a figure of a picture with its title. */
export const makeFigure = (picture: SVGElement, title: string, look: Record<string, string> = {}): HTMLElement => el("figure", look, picture, el("figcaption", {}, title));

/** Draws the surface of a round with its dirt, in millimetres. `map`: its map, and the id by which the map is clipped to the surface. */
export function surfacePicture(round: Round, layers: Dots[], label: string, map: { id: string; map: SVGElement } | null = null): SVGSVGElement {
  const rings = round.plan.surface.rings.map((ring) => metres(ring)).filter((ring) => ring.length >= 6);
  const { goal } = round.plan;
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  const reach = (x: number, y: number) => {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [bottom, top] = [Math.min(bottom, y), Math.max(top, y)];
  };
  for (const ring of rings) for (let i = 0; i < ring.length; i += 2) reach(ring[i]!, ring[i + 1]!);
  if (goal?.kind === "collected") {
    const [[x, y], r] = [goal.place, goal.radius];
    reach(x - r, y - r);
    reach(x + r, y + r);
  }
  // The view includes dirt that fell off the surface, if it lies near.
  const margin = rings.length ? 0.15 * Math.max(right - left, top - bottom) : Infinity;
  const [l, b, r, t] = [left - margin, bottom - margin, right + margin, top + margin];
  for (const { places } of layers) {
    for (let i = 0; i + 1 < places.length; i += 2) {
      const [x, y] = [places[i]!, places[i + 1]!];
      if (!rings.length || (x > l && x < r && y > b && y < t)) reach(x, y);
    }
  }
  if (!(right > left)) [left, bottom, right, top] = [0, 0, 1, 1];
  const pad = 0.03 * Math.max(right - left, top - bottom);
  const box = [left - pad, -top - pad, right - left + 2 * pad, top - bottom + 2 * pad].map((v) => (1000 * v).toFixed(1));
  // Many dots are drawn smaller.
  const most = Math.max(1, ...layers.map(({ places }) => places.length / 2));
  const unit = 7 * Math.max(right - left, top - bottom) * Math.min(1, Math.max(0.6, Math.sqrt(160 / most)));
  const d = rings.map((ring) => `${pathOf(ring)}Z`).join("");
  return svg("svg", { viewBox: box.join(" "), class: "w-picture", role: "img", "aria-label": label },
    svg("path", { d, class: "w-ground", "fill-rule": "evenodd", "stroke-width": 0.005 * 1000 * Math.max(right - left, top - bottom) }),
    map && svg("clipPath", { id: map.id }, svg("path", { d, "clip-rule": "evenodd" })), map?.map,
    goal?.kind === "collected" && svg("circle", {
      cx: 1000 * goal.place[0], cy: -1000 * goal.place[1], r: 1000 * goal.radius, class: "w-goal", "stroke-width": 0.004 * 1000 * Math.max(right - left, top - bottom),
    }),
    ...layers.map((layer) => drawDots(layer, unit)));
}
