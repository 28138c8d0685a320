// A drawing of the surface from above: outline, goal and dirt.
import { Box2, Vector2 } from "three";
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
  const pointsOf = (places: Float32Array) => Array.from({ length: places.length / 2 }, (_, i) => new Vector2(places[2 * i], places[2 * i + 1]));
  const view = new Box2().setFromPoints(rings.flatMap(pointsOf));
  if (goal?.kind === "collected") for (const side of [-1, 1]) view.expandByPoint(new Vector2(...goal.place).addScalar(side * goal.radius));
  const sizeOf = (box: Box2) => Math.max(...box.getSize(new Vector2()));
  // The view includes dirt that fell off the surface, if it lies near.
  const near = view.clone().expandByScalar(rings.length ? 0.15 * sizeOf(view) : Infinity);
  for (const { places } of layers) for (const point of pointsOf(places)) if (!rings.length || near.containsPoint(point)) view.expandByPoint(point);
  if (!(view.max.x > view.min.x)) view.set(new Vector2(), new Vector2(1, 1));
  const size = sizeOf(view);
  const { min, max } = view.expandByScalar(0.03 * size);
  const box = [min.x, -max.y, max.x - min.x, max.y - min.y].map((v) => (1000 * v).toFixed(1));
  // Many dots are drawn smaller.
  const most = Math.max(1, ...layers.map(({ places }) => places.length / 2));
  const unit = 7 * size * Math.min(1, Math.max(0.6, Math.sqrt(160 / most)));
  const d = rings.map((ring) => `${pathOf(ring)}Z`).join("");
  return svg("svg", { viewBox: box.join(" "), class: "w-picture", role: "img", "aria-label": label },
    svg("path", { d, class: "w-ground", "fill-rule": "evenodd", "stroke-width": 5 * size }),
    map && svg("clipPath", { id: map.id }, svg("path", { d, "clip-rule": "evenodd" })), map?.map,
    goal?.kind === "collected" && svg("circle", {
      cx: 1000 * goal.place[0], cy: -1000 * goal.place[1], r: 1000 * goal.radius, class: "w-goal", "stroke-width": 4 * size,
    }),
    ...layers.map((layer) => drawDots(layer, unit)));
}
