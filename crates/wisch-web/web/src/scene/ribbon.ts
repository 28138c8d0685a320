// The measured normal force along the path in contact: a band on the surface. Its width is the force, its colour compares the
// force with the target. It ends where contact is lost.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { lastAtMost } from "../columns.ts";
import { colour } from "../theme.ts";

/** Shares of the target force between which the force counts as on target [1]. */
const ON_TARGET = { low: 0.8, high: 1.25 };
/** Half the width of the band at the target force [m], and the limits of its shares [1]. */
const HALF_M = 0.006;
const NARROWEST = 0.12;
const WIDEST = 2.2;
/** Opacity of what is outside a selected interval [1]. */
const FADED = 0.15;
/** Cosine of the largest turn over which the band has no joint. */
const SMOOTH = 0.5;

/** Degrees of the force, with their colours and labels. */
export const FORCES = [
  { colour: "force-little", label: "below 80\u202f%" }, { colour: "force-target", label: "on target" }, { colour: "force-much", label: "above 125\u202f%" },
];
/** The colour without a known target. */
const UNKNOWN = FORCES.length;

/** Returns the degree of a force: an index of FORCES, or the one after the last without a target. */
function degreeOf(force: number, target: number | null): number {
  if (target === null) return UNKNOWN;
  return force < ON_TARGET.low * target ? 0 : force <= ON_TARGET.high * target ? 1 : 2;
}

/** The end of the band: its middle, half its width [m], its direction and its two corners. */
interface End {
  place: Vector3;
  half: number;
  way: Vector3 | null;
  corners: [Vector3, Vector3] | null;
}

export class Ribbon {
  readonly mesh = new Mesh(new BufferGeometry(), new MeshBasicMaterial({
    vertexColors: true, side: DoubleSide, transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -8, polygonOffsetUnits: -8,
  }));
  /** Times at which the segments end, within the round [s]. */
  readonly times: number[] = [];
  /** Degrees of the segments. */
  readonly degrees: number[] = [];
  private readonly corners: BufferAttribute;
  private readonly colours: BufferAttribute;
  private end: End | null = null;
  /** Largest force since the last segment [N]. */
  private peak = 0;
  private selected: [number, number] | null = null;
  private palette: Color[] = [];

  /** `most`: maximum number of segments; `target`: wanted force [N]. */
  constructor(private readonly most: number, private readonly target: number | null) {
    const { geometry } = this.mesh;
    this.corners = new BufferAttribute(new Float32Array(12 * most), 3);
    this.colours = new BufferAttribute(new Float32Array(16 * most), 4);
    geometry.setAttribute("position", this.corners);
    geometry.setAttribute("color", this.colours);
    geometry.setIndex(Array.from({ length: 6 * most }, (_, i) => 4 * Math.floor(i / 6) + [0, 1, 2, 2, 1, 3][i % 6]!));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
    this.paint();
  }

  clear(): void {
    this.breakOff();
    this.times.length = this.degrees.length = 0;
  }

  /** Ends the band here. */
  breakOff(): void {
    this.end = null;
    this.peak = 0;
  }

  /** Continues the band to a place on the surface, once that is `step` away [m]. `reference`: force of the usual width [N]. */
  push(time: number, place: Vector3, normal: Vector3, force: number, { step, reference }: { step: number; reference: number }): void {
    this.peak = Math.max(this.peak, force);
    const half = HALF_M * Math.min(WIDEST, Math.max(NARROWEST, this.peak / reference));
    const before = (this.end ??= { place, half, way: null, corners: null });
    if (place.distanceTo(before.place) < step || this.times.length === this.most) return;
    const way = place.clone().sub(before.place).normalize();
    const side = normal.clone().cross(way).normalize();
    const across = (middle: Vector3, reach: number): [Vector3, Vector3] => [middle.clone().addScaledVector(side, reach), middle.clone().addScaledVector(side, -reach)];
    const begin = before.corners && before.way!.dot(way) > SMOOTH ? before.corners : across(before.place, before.half);
    const corners = across(place, half);
    const i = this.times.length;
    [...begin, ...corners].forEach(({ x, y, z }, k) => this.corners.setXYZ(4 * i + k, x, y, z));
    this.corners.needsUpdate = true;
    this.times.push(time);
    this.degrees.push(degreeOf(this.peak, this.target));
    this.colour(i);
    this.end = { place, half, way, corners };
    this.peak = 0;
  }

  /** Shows the segments up to a time, and those of the selected interval. */
  show(time: number, visible: boolean): void {
    const until = Math.max(time, this.selected?.[1] ?? -Infinity);
    const count = lastAtMost(this.times, until) + 1;
    this.mesh.visible = visible && count > 0;
    this.mesh.geometry.setDrawRange(0, 6 * count);
  }

  /** Lights up the segments of an interval of the round, and fades the others; null ends this. */
  select(interval: [number, number] | null): void {
    this.selected = interval;
    for (let i = 0; i < this.times.length; i++) this.colour(i);
  }

  paint(): void {
    this.palette = [...FORCES.map((degree) => degree.colour), "contact"].map((name) => new Color(colour(name)));
    for (let i = 0; i < this.times.length; i++) this.colour(i);
  }

  private colour(i: number): void {
    const { r, g, b } = this.palette[this.degrees[i]!]!;
    const [from, to] = this.selected ?? [-Infinity, Infinity];
    const opacity = this.times[i]! >= from && this.times[i]! <= to ? 1 : FADED;
    for (let k = 0; k < 4; k++) this.colours.setXYZW(4 * i + k, r, g, b, opacity);
    this.colours.needsUpdate = true;
  }
}
