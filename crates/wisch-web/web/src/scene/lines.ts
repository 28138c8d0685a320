// Lines with a width in pixels, which can grow.
import { Vector3, type Color } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

/** Depth offset that draws lines on a surface slightly nearer. */
const NEARER = { polygonOffset: true, polygonOffsetFactor: -4, polygonOffsetUnits: -4 };

export function segments(ends: ArrayLike<number>, material: LineMaterial): LineSegments2 {
  const line = new LineSegments2(new LineSegmentsGeometry(), material);
  line.frustumCulled = false;
  setSegments(line, ends);
  return line;
}

/** Replaces the segments of a line. */
export function setSegments(line: LineSegments2, ends: ArrayLike<number>): void {
  line.geometry.dispose();
  line.geometry = new LineSegmentsGeometry().setPositions(ends.length ? Float32Array.from(ends) : new Float32Array(6));
  line.visible = ends.length > 0;
}

/** Converts consecutive corners into segments of a closed or open line. */
export function chain(corners: readonly (readonly [number, number, number])[], closed: boolean): number[] {
  const ends: number[] = [];
  for (let i = 0; i + (closed ? 0 : 1) < corners.length; i++) ends.push(...corners[i]!, ...corners[(i + 1) % corners.length]!);
  return ends;
}

/** Maximum number of dashes of an outline; the dashes of a longer one are longer. */
const MOST_DASHES = 2000;

/** Cuts segments into dashes of a pattern that goes on across corners; unlike a dashed material it takes no shader of its own. */
export function cutDashes(ends: readonly number[], pattern: readonly [number, number]): number[] {
  const cut: number[] = [];
  let way = 0;
  const lengthOf = (i: number) => Math.hypot(ends[i + 3]! - ends[i]!, ends[i + 4]! - ends[i + 1]!, ends[i + 5]! - ends[i + 2]!);
  let whole = 0;
  for (let i = 0; i + 5 < ends.length; i += 6) whole += lengthOf(i);
  const scale = Math.max(1, whole / (MOST_DASHES * (pattern[0] + pattern[1])));
  const [dash, gap] = [scale * pattern[0], scale * pattern[1]];
  for (let i = 0; i + 5 < ends.length; i += 6) {
    const at = (share: number) => [0, 1, 2].map((k) => ends[i + k]! + share * (ends[i + 3 + k]! - ends[i + k]!));
    const length = lengthOf(i);
    for (let from = -(way % (dash + gap)); from < length; from += dash + gap) {
      const [start, end] = [Math.max(0, from), Math.min(length, from + dash)];
      if (end > start) cut.push(...at(start / length), ...at(end / length));
    }
    way += length;
  }
  return cut;
}

/** Segments that are added one by one, each with a colour of the palette; `show` draws the first ones. */
export class GrowingSegments {
  readonly line: LineSegments2;
  private readonly positions: number[] = [];
  private readonly kinds: number[] = [];
  private changed = true;

  constructor(width: number, private palette: Color[]) {
    this.line = segments([], new LineMaterial({ linewidth: width, vertexColors: true, ...NEARER }));
  }

  get count(): number {
    return this.kinds.length;
  }

  clear(): void {
    this.positions.length = this.kinds.length = 0;
    this.changed = true;
  }

  push(ends: readonly number[], kind: number): void {
    for (const end of ends) this.positions.push(end);
    this.kinds.push(kind);
    this.changed = true;
  }

  /** Returns the end of a segment. */
  end(i: number): Vector3 {
    return new Vector3().fromArray(this.positions, 6 * i + 3);
  }

  paint(palette: Color[]): void {
    this.palette = palette;
    this.changed = true;
  }

  show(shown: number): void {
    if (this.changed) this.upload();
    this.line.geometry.instanceCount = Math.min(shown, this.count);
    this.line.visible = shown > 0;
  }

  private upload(): void {
    this.changed = false;
    const { geometry } = this.line;
    geometry.dispose();
    const size = 6 * Math.max(1, this.count);
    const colours = new Float32Array(size);
    for (let i = 0; i < this.count; i++) for (const at of [6 * i, 6 * i + 3]) this.palette[this.kinds[i]!]!.toArray(colours, at);
    geometry.setPositions(this.count ? this.positions : new Float32Array(size)).setColors(colours);
  }
}

export { LineMaterial };
