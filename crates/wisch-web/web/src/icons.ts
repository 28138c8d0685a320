// Icons on buttons and in legends, as SVG paths.
import { svg } from "./dom.ts";
import { FORCES } from "./scene/ribbon.ts";

const PATHS = {
  play: "M4 2.5v11l9.5-5.5z",
  pause: "M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z",
  before: "M3 3h2v10H3zM13 3v10L6 8z",
  after: "M11 3h2v10h-2zM3 3v10l7-5z",
} as const;

export const icon = (name: keyof typeof PATHS): SVGSVGElement =>
  svg("svg", { viewBox: "0 0 16 16", width: 14, height: 14, "aria-hidden": "true", fill: "currentColor" }, svg("path", { d: PATHS[name] }));

const MARKS: Record<string, () => SVGElement> = {
  believed: () => svg("circle", { cx: 8, cy: 8, r: 3.2, fill: "var(--believed)" }),
  estimated: () => svg("circle", { cx: 8, cy: 8, r: 4.6, fill: "none", stroke: "var(--estimated)", "stroke-width": 2.4 }),
  actual: () => svg("path", { d: "M4 4l8 8M12 4l-8 8", fill: "none", stroke: "var(--actual)", "stroke-width": 2.6 }),
  seen: () => svg("rect", { x: 3, y: 3, width: 10, height: 10, fill: "none", stroke: "var(--seen)", "stroke-width": 1.8 }),
  map: () => svg("g", {}, ...["little-3", "allowed-2", "much-1"].map((name, i) => svg("rect", { x: 1 + 5 * i, y: 3, width: 5, height: 10, fill: `var(--${name})` }))),
  path: () => svg("path", { d: "M1 11h6l8-6", fill: "none", stroke: "var(--contact)", "stroke-width": 2.4 }),
  ribbon: () => svg("g", { class: "w-forces" }, ...FORCES.map(({ colour }, i) => svg("rect", { x: 1 + 5 * i, y: 7 - 2 * i, width: 5, height: 2 + 4 * i, fill: `var(--${colour})` }))),
  strokes: () => svg("path", { d: "M1 11h6l8-6", fill: "none", stroke: "var(--stroke)", "stroke-width": 2 }),
  rejected: () => svg("path", { d: "M1 11h6l8-6", fill: "none", stroke: "var(--rejected)", "stroke-width": 1.2 }),
  bases: () => svg("path", { d: "M14.5 8L9 11.5A4.5 4.5 0 1 1 9 4.5z", fill: "var(--band-6)", stroke: "var(--quiet)", "stroke-width": 1.2 }),
  force: () => svg("path", { d: "M8 15V6M8 1l4 6H4z", fill: "var(--force)", stroke: "var(--force)", "stroke-width": 2 }),
  events: () => svg("circle", { cx: 8, cy: 8, r: 4.5, fill: "var(--collision)", stroke: "var(--ink)", "stroke-width": 1.2 }),
  found: () => svg("path", { d: "M2 12l3-8h9l-3 8z", fill: "var(--found)", "fill-opacity": 0.3, stroke: "var(--found)", "stroke-width": 2 }),
  actualSurface: () => svg("path", { d: "M2 12l3-8h9l-3 8z", fill: "none", stroke: "var(--actual)", "stroke-width": 1.6, "stroke-dasharray": "3 2" }),
  collision: () => svg("path", { d: "M5 2h6l3 6-3 6H5L2 8zM5 2l6 12M11 2L5 14", fill: "none", stroke: "var(--quiet)", "stroke-width": 1 }),
  "by-touch": () => svg("path", { d: "M8 1v14M5 1h6M5 15h6", fill: "none", stroke: "var(--by-touch)", "stroke-width": 1.6 }),
  interval: () => svg("path", { d: "M8 1v14M4 1h8M4 15h8", fill: "none", stroke: "var(--estimated)", "stroke-width": 2.2 }),
  target: () => svg("path", { d: "M0 8h16", fill: "none", stroke: "var(--target)", "stroke-width": 2, "stroke-dasharray": "4 3" }),
  goal: () => svg("circle", { cx: 8, cy: 8, r: 5.5, fill: "var(--goal)", "fill-opacity": 0.35, stroke: "var(--goal-line)", "stroke-width": 1.6 }),
};

/** Returns the mark of a layer as it looks in the scene. */
export const mark = (name: string): SVGSVGElement =>
  svg("svg", { viewBox: "0 0 16 16", width: 15, height: 15, "aria-hidden": "true" }, MARKS[name]?.());

/** Returns the mark of queried particles. */
export const diamond = (colour: string, hollow: boolean): SVGSVGElement =>
  svg("svg", { viewBox: "0 0 16 16", width: 15, height: 15, "aria-hidden": "true" },
    svg("path", { d: `M8 1l7 7-7 7-7-7z${hollow ? "M8 5l3 3-3 3-3-3z" : ""}`, "fill-rule": "evenodd", fill: colour, stroke: "#000", "stroke-width": 1.4 }));
