// What queries show: paths, frames, and particles as diamonds with a dark rim, filled for the dirt before a round, hollow for the
// estimate after it. The marks of the recording have other shapes, so that readers distinguish both without colours.
import { Vector3, type CanvasTexture, type Object3D } from "three";
import { colour } from "../theme.ts";
import { lift } from "./bend.ts";
import { dotTexture, drawTexture, makeDots, type Dots } from "./dots.ts";
import { LineMaterial, chain, segments } from "./lines.ts";
import { matrix, placeAt, tint } from "./solids.ts";
import { ABOVE } from "./surface.ts";
import type { Pose } from "../recording.ts";
import type { Bend } from "../store.ts";

/** Length of the axes of a frame [m]. */
const AXIS_M = 0.1;
/** Size of the dots at samples and origins [pixels]. */
const DOT_PX = 11;
export interface ShownParticles {
  name: string;
  color?: string;
  /** Pose of the surface on which the particles lie. */
  pose: Pose;
  /** Its shape; a plane has none. */
  shape?: Bend;
  /** Positions in the surface frame [m]. */
  places: [number, number][];
  /** Believed before a round, or estimated after it. */
  state: "before" | "estimated";
}

/** Size of the diamonds [pixels]. */
const SIZE_PX = 13;

const diamond = (half: number): Path2D => new Path2D(`M32 ${32 - half}l${half} ${half}l${-half} ${half}l${-half} ${-half}z`);

/** Draws a diamond with a dark rim. */
const drawDiamond = (hollow: boolean): CanvasTexture => drawTexture((pen) => {
  pen.fillStyle = "#000";
  pen.fill(diamond(31));
  pen.fillStyle = "#fff";
  pen.fill(diamond(24));
  if (!hollow) return;
  pen.globalCompositeOperation = "destination-out";
  pen.fill(diamond(13));
});

/** Returns the colour that the query gives, or else the highlight colour. */
export const askedColour = (color: string | undefined): string => hexOr(color, colour("highlight"));

/** Makes the marks of queried particles. */
export function makeAsked(list: readonly ShownParticles[]): Dots[] {
  return list.map(({ color, pose, shape, places, state }, i) => {
    const points = places.flatMap(([x, y]) => lift(shape, x, y, 2 * ABOVE));
    const dots = placeAt(makeDots(points, drawDiamond(state === "estimated"), SIZE_PX, { renderOrder: 7 + i / (list.length + 1) }), pose);
    dots.material.color.set(askedColour(color));
    return dots;
  });
}

export interface Trajectory {
  name: string;
  color?: string;
  points: [number, number, number][];
  /** Points at the times that a query asked for. */
  samples?: [number, number, number][];
}

/** A frame whose axes are shown. */
export interface ShownFrame {
  name: string;
  color?: string;
  /** On the common clock [s]. */
  time: number;
  pose: Pose;
}

/** Number of colours of trajectories without a colour. */
const TRACK_COLOURS = 6;

/** Returns the name of the i-th default colour. */
export const trackName = (i: number): string => `track-${(i % TRACK_COLOURS) + 1}`;

/** Makes the lines of queried trajectories, with dots at their samples. */
export const makeTrajectories = (list: readonly Trajectory[]): Object3D[] => list.flatMap(({ points, samples, color }, i) => {
  // Drawn after the translucent highlight of the same path, and nearer than that path.
  const material = new LineMaterial({ linewidth: 4.5, transparent: true, polygonOffset: true, polygonOffsetFactor: -12, polygonOffsetUnits: -12 });
  material.color.set(safeColour(color, i));
  const line = segments(chain(points, false), material);
  line.renderOrder = 6;
  return samples?.length ? [line, dots(samples, safeColour(color, i))] : [line];
});

/** Makes the axes of queried frames, each with a dot at its origin in the colour of the query. */
export const makeAxes = (list: readonly ShownFrame[]): Object3D[] => list.flatMap(({ pose, color }) => {
  const worldFromFrame = matrix(pose);
  const origin = new Vector3().setFromMatrixPosition(worldFromFrame).toArray();
  const axes = ["axis-x", "axis-y", "axis-z"].map((name, k) => {
    const end = new Vector3().setComponent(k, AXIS_M).applyMatrix4(worldFromFrame).toArray();
    return segments([...origin, ...end], tint(new LineMaterial({ linewidth: 3.5 }), name));
  });
  return [...axes, dots([origin], hexOr(color, colour("axis-z")))];
});

/** Makes dots of a colour. */
function dots(places: readonly [number, number, number][], color: string): Dots {
  const made = makeDots(places.flat(), dotTexture(), DOT_PX);
  made.material.color.set(color);
  return made;
}

/** Returns `color` if it is a hexadecimal colour, else `other`. */
export const hexOr = (color: string | undefined, other: string): string => (color && /^#[0-9a-f]{3,8}$/i.test(color) ? color : other);

/** Returns `color` if it is a hexadecimal colour, else the i-th default colour. */
export const safeColour = (color: string | undefined, i: number): string => hexOr(color, colour(trackName(i)));
