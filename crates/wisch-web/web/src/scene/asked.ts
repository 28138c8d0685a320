// Queried particles: diamonds with a dark rim, filled for the dirt before a round, hollow for the estimate after it. The marks
// of the recording have other shapes, so that readers distinguish both without colours.
import type { CanvasTexture } from "three";
import { colour } from "../theme.ts";
import { hexOr } from "./path.ts";
import { lift } from "./bend.ts";
import { drawTexture, makeDots, type Dots } from "./dots.ts";
import { placeAt } from "./solids.ts";
import { ABOVE } from "./surface.ts";
import type { Pose } from "../recording.ts";
import type { Bend } from "../store.ts";

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
