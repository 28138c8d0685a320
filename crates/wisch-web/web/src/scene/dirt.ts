// Particles: believed and predicted over time, estimated, observed and true. Their marks differ in shape and colour.
import { Float32BufferAttribute, Group } from "three";
import { metres } from "../particles.ts";
import { ABOVE } from "./surface.ts";
import { lift } from "./bend.ts";
import { drawTexture, makeDots, type Dots } from "./dots.ts";
import { GRAIN_M, Grains, formOf } from "./grains.ts";
import { placeAt, tint } from "./solids.ts";
import type { Pose } from "../recording.ts";
import type { Bend, Instant, Recording } from "../store.ts";
import { isTreated } from "../treated.ts";

export type Mark = "believed" | "estimated" | "actual" | "seen";
export const MARKS: Mark[] = ["believed", "estimated", "actual", "seen"];
const SIZE: Record<Mark, number> = { believed: 6, estimated: 12, actual: 8, seen: 14 };

const DRAW: Record<Mark, (pen: CanvasRenderingContext2D) => void> = {
  believed: (pen) => { pen.arc(32, 32, 28, 0, 2 * Math.PI); pen.fill(); },
  estimated: (pen) => { pen.lineWidth = 9; pen.arc(32, 32, 25, 0, 2 * Math.PI); pen.stroke(); },
  actual: (pen) => { pen.lineWidth = 15; pen.moveTo(10, 10); pen.lineTo(54, 54); pen.moveTo(54, 10); pen.lineTo(10, 54); pen.stroke(); },
  seen: (pen) => { pen.lineWidth = 7; pen.rect(6, 6, 52, 52); pen.stroke(); },
};

export class Dirt {
  readonly group = new Group();
  private readonly points: Record<Mark, Dots>;
  private readonly shown = new Map<Mark, Float32Array | null>();
  /** Believed and predicted dirt as solids; null while its medium has none. */
  private grains: Grains | null = null;

  constructor() {
    this.points = Object.fromEntries(MARKS.map((mark) => {
      const points = makeDots([], drawTexture(DRAW[mark]), SIZE[mark], { nearer: 0.99, alphaTest: 0.15, renderOrder: 2 + MARKS.indexOf(mark) });
      tint(points.material, mark);
      this.group.add(points);
      return [mark, points];
    })) as Dirt["points"];
  }

  paint(): void {
    this.grains?.paint();
  }

  /** Shows the dirt at a time. Dots have the size of grains, within limits of visibility. */
  show(recording: Recording, t: number, { round, time }: Instant, layers: Record<Mark, boolean>, pixelsPerMetre: number): void {
    const size = Math.min(1.25, Math.max(0.7, (GRAIN_M * pixelsPerMetre) / SIZE.believed));
    for (const mark of MARKS) this.points[mark].material.size = size * SIZE[mark];
    const { pose, shape } = round.plan.surface;
    // The places of a treated surface are no dirt.
    const dirty = !isTreated(round);
    const believed = dirty && layers.believed ? round.particles.at(time) : null;
    const form = formOf(recording.head?.task?.medium);
    if (form && !this.grains) {
      this.grains = new Grains(form);
      this.group.add(this.grains.group);
    }
    this.grains?.show(believed, pose, shape, pixelsPerMetre);
    this.set("believed", this.grains ? null : believed, pose, shape, 1);
    // The previous outcome, or what was known before the first round, fades once the robot wipes and so changes it.
    const opacity = recording.endedAt(t) || t < round.start + round.firstContact ? 1 : 0.45;
    const outcome = recording.outcomeAt(t);
    for (const mark of ["estimated", "actual", "seen"] as const) {
      const { places, pose, shape } = outcome[mark];
      this.set(mark, places && layers[mark] && (dirty || mark === "seen") ? metres(places) : null, pose, shape, opacity);
    }
  }

  private set(mark: Mark, places: Float32Array | null, pose: Pose, shape: Bend, opacity: number): void {
    const points = this.points[mark];
    points.visible = places !== null && places.length > 0;
    if (!places || !points.visible) return;
    placeAt(points, pose);
    points.material.opacity = opacity;
    if (this.shown.get(mark) === places) return;
    this.shown.set(mark, places);
    const at = Array.from({ length: places.length / 2 }, (_, i) => lift(shape, places[2 * i]!, places[2 * i + 1]!, ABOVE));
    points.geometry.dispose();
    points.geometry.setAttribute("position", new Float32BufferAttribute(at.flat(), 3));
  }
}
