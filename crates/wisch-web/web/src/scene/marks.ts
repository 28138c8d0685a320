// Positions of the tool at events, and arrows where somebody or something pushed.
import { Color, Float32BufferAttribute, Group, Vector3 } from "three";
import { lastAtMost } from "../columns.ts";
import { colour } from "../theme.ts";
import { eventColour } from "../timeline/lanes.ts";
import { dotTexture, makeDots } from "./dots.ts";
import { GrowingSegments, cutDashes } from "./lines.ts";
import { TRUE_DASH_M } from "./surface.ts";
import type { Round } from "../round.ts";
import type { Recording } from "../store.ts";

const SIZE = 13;
/** Length of an arrow per newton [m/N], its limits, and the length of its head [m]. */
const METRES_PER_N = 0.006;
const ARROW_M = { least: 0.04, most: 0.16 };
const HEAD_M = 0.02;
/** Least force of a push that has an arrow [N]. */
const LEAST_N = 1;
/** Colours of pushes. */
const PUSHES = ["collision", "hand", "actual"];

/** Returns the sample of an interval of a round with the largest measured force; -1 without any. */
export function strongestSample({ t, force, count }: Round, start: number, end: number): number {
  let [best, most] = [-1, LEAST_N];
  for (let i = Math.max(0, lastAtMost(t, start)); i < count && t[i]! <= end; i++) {
    const size = Math.hypot(force[3 * i]!, force[3 * i + 1]!, force[3 * i + 2]!);
    if (size > most) [best, most] = [i, size];
  }
  return best;
}

/** Returns the segments of an arrow along the force at a sample, with a dashed shaft for a true push. */
export function makeArrow({ tool, force }: Round, i: number, isTrue: boolean): number[] {
  const along = new Vector3().fromArray(force, 3 * i);
  const length = Math.min(ARROW_M.most, Math.max(ARROW_M.least, METRES_PER_N * along.length()));
  const from = new Vector3().fromArray(tool, 7 * i);
  const way = along.normalize();
  const tip = from.clone().addScaledVector(way, length);
  const aside = new Vector3(Math.abs(way.x) < 0.7 ? 1 : 0, Math.abs(way.x) < 0.7 ? 0 : 1, 0).cross(way).normalize();
  const sides = [aside, aside.clone().negate(), way.clone().cross(aside), aside.clone().cross(way)];
  const head = sides.flatMap((side) => [...tip.toArray(), ...tip.clone().addScaledVector(way, -HEAD_M).addScaledVector(side, 0.5 * HEAD_M).toArray()]);
  const shaft = [...from.toArray(), ...tip.toArray()];
  return [...(isTrue ? cutDashes(shaft, TRUE_DASH_M) : shaft), ...head];
}

export class Marks {
  readonly group = new Group();
  private readonly points = makeDots([], dotTexture(), SIZE, { nearer: 0.985, vertexColors: true });
  private readonly arrows = new GrowingSegments(4, []);
  private key = "";
  /** Start of each mark, and of each segment of an arrow, within the round [s]. */
  private starts: number[] = [];
  private pushes: number[] = [];

  constructor() {
    this.group.add(this.points, this.arrows.line);
  }

  /** Shows the events of a round up to a time of that round. */
  show(recording: Recording, round: Round, time: number, visible: boolean, themed: string): void {
    const key = `${round.start} ${round.number} ${recording.happenings.length} ${round.count > 0} ${themed}`;
    if (key !== this.key) {
      this.key = key;
      this.arrows.paint(PUSHES.map((name) => new Color(colour(name))));
      this.build(recording, round);
    }
    const shown = this.starts.filter((start) => start <= time).length;
    this.points.visible = visible && shown > 0;
    this.points.geometry.setDrawRange(0, shown);
    this.arrows.show(visible ? this.pushes.filter((start) => start <= time).length : 0);
  }

  private build(recording: Recording, round: Round): void {
    const [places, colours]: [number[], number[]] = [[], []];
    [this.starts, this.pushes] = [[], []];
    this.arrows.clear();
    for (const happening of recording.happenings) {
      const [start, end] = [happening.start - round.start, happening.end - round.start];
      if (start < 0 || start > round.length) continue;
      // A detected event hides the true push that it overlaps.
      const isDetected = happening.source === "push" && recording.happenings.some((other) => other.source === "event" && other.start < happening.end && other.end > happening.start);
      if (isDetected) continue;
      const tool = round.toolAt((start + end) / 2);
      if (!tool) continue;
      const name = eventColour(happening);
      this.starts.push(start);
      places.push(tool[0], tool[1], tool[2]);
      colours.push(...new Color(colour(name)).toArray());
      const strongest = PUSHES.includes(name) ? strongestSample(round, start, end) : -1;
      if (strongest < 0) continue;
      const ends = makeArrow(round, strongest, happening.source === "push");
      for (let k = 0; k < ends.length; k += 6) {
        this.arrows.push(ends.slice(k, k + 6), PUSHES.indexOf(name));
        this.pushes.push(start);
      }
    }
    this.points.geometry.dispose();
    this.points.geometry.setAttribute("position", new Float32BufferAttribute(places, 3)).setAttribute("color", new Float32BufferAttribute(colours, 3));
  }
}
