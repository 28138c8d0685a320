// What a plan is compared with: the strokes of a rejected plan as thin lines, and on the floor the rated base poses.
import {
  Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, RingGeometry, Shape, ShapeGeometry, Sprite, SpriteMaterial, Vector3,
  type BufferGeometry, type CanvasTexture,
} from "three";
import { REACH_BANDS, reachBand } from "../bases.ts";
import { colour } from "../theme.ts";
import type { Places, RatedBases, RoundPiece } from "../recording.ts";
import { liftLine } from "./bend.ts";
import { drawTexture } from "./dots.ts";
import { LineMaterial, chain, segments, setSegments } from "./lines.ts";
import { disposeAll, placeAt, shiftDepth, tint } from "./solids.ts";
import { ABOVE, corners } from "./surface.ts";

export class RejectedStrokes {
  readonly group = new Group();
  /** Lines, and a rim that sets them off from what lies below. */
  private readonly lines = ["paper", "rejected"].map((name, i) => segments([], tint(new LineMaterial({ linewidth: 4 - 2 * i, polygonOffset: true, polygonOffsetFactor: -7 - i, polygonOffsetUnits: -7 - i }), name)));
  private shown: readonly Places[] | null = null;

  constructor() {
    this.group.add(...this.lines);
  }

  /** Shows strokes over a surface; null hides them. */
  show(lines: readonly Places[] | null, { pose, shape }: RoundPiece["surface"]): void {
    this.group.visible = lines !== null;
    if (!lines || lines === this.shown) return;
    this.shown = lines;
    placeAt(this.group, pose);
    const ends = lines.flatMap((line) => chain(liftLine(shape, corners(line, 2.5 * ABOVE), false), false));
    for (const line of this.lines) setSegments(line, ends);
  }
}

/** Radius of the mark of a base pose, and width of its rim [m]. */
const RADIUS_M = 0.03;
const RIM_M = 0.006;
/** Heights over the floor at which rims, marks and rings are drawn [m]. */
const HEIGHTS_M = [0.003, 0.004, 0.005];
/** Size of the numbers of chosen base poses, as a share of the picture's height [1]. */
const NUMBER_SIZE = 0.045;

/** Makes a drop whose tip points along x. */
function makeDrop(radius: number): BufferGeometry {
  const shape = new Shape().absarc(0, 0, radius, Math.PI / 4, (7 * Math.PI) / 4, false);
  return new ShapeGeometry(shape.lineTo(1.9 * radius, 0), 10);
}

/** Draws a number in a disc. */
const drawNumber = (number: number): CanvasTexture => drawTexture((pen) => {
  pen.arc(32, 32, 30, 0, 2 * Math.PI);
  pen.fillStyle = colour("ink");
  pen.fill();
  pen.font = "bold 38px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillStyle = colour("paper");
  pen.fillText(String(number), 32, 35);
});

/** The map of base poses: drops that point where the base faces, in the colour of their share in reach; chosen ones are ringed and numbered. */
export class BaseMap {
  readonly group = new Group();
  private shown: RatedBases | null = null;
  private theme = "";

  /** Positions of the drawn base poses. */
  get places(): Vector3[] {
    return this.group.visible ? this.shown?.poses.map(([x, y]) => new Vector3(x, y, 0)) ?? [] : [];
  }

  /** Shows rated base poses; undefined hides them. */
  show(bases: RatedBases | undefined, theme: string): void {
    this.group.visible = bases !== undefined;
    if (!bases || (this.shown === bases && this.theme === theme)) return;
    [this.shown, this.theme] = [bases, theme];
    disposeAll(this.group);
    const { poses, chosen } = bases;
    const bands = Array.from({ length: REACH_BANDS }, (_, i) => new Color(colour(`band-${i + 1}`)));
    const unrated = new Color(colour("quiet"));
    const rims = this.addMarks(makeDrop(RADIUS_M + RIM_M), poses.length);
    const marks = this.addMarks(makeDrop(RADIUS_M), poses.length);
    const kept = chosen.map((i) => poses[i]).filter((pose) => pose !== undefined);
    const rings = this.addMarks(new RingGeometry(2 * RADIUS_M, 2 * RADIUS_M + 2 * RIM_M, 32), kept.length);
    // The robot stands on the base pose that it has chosen: ring and number show through it.
    rings.material.depthTest = false;
    rings.renderOrder = 8;
    poses.forEach((pose, i) => {
      rims.setMatrixAt(i, placeOf(pose, HEIGHTS_M[0]!));
      rims.setColorAt(i, unrated);
      marks.setMatrixAt(i, placeOf(pose, HEIGHTS_M[1]!));
      marks.setColorAt(i, pose[3] === null ? unrated : bands[reachBand(pose[3])]!);
    });
    kept.forEach((pose, i) => {
      rings.setMatrixAt(i, placeOf(pose, HEIGHTS_M[2]!));
      rings.setColorAt(i, new Color(colour("ink")));
      const number = new Sprite(new SpriteMaterial({ map: drawNumber(i + 1), sizeAttenuation: false, depthTest: false }));
      number.position.set(pose[0], pose[1], HEIGHTS_M[2]!);
      number.center.set(0.5, -0.6);
      number.scale.setScalar(NUMBER_SIZE);
      number.renderOrder = 9;
      this.group.add(number);
    });
  }

  private addMarks(geometry: BufferGeometry, count: number): InstancedMesh<BufferGeometry, MeshBasicMaterial> {
    const marks = new InstancedMesh(geometry, shiftDepth(new MeshBasicMaterial({ toneMapped: false, transparent: true }), 0.998), count);
    marks.frustumCulled = false;
    this.group.add(marks);
    return marks;
  }
}

const UP = new Vector3(0, 0, 1);
const placeOf = ([x, y, yaw]: RatedBases["poses"][number], height: number): Matrix4 =>
  new Matrix4().compose(new Vector3(x, y, height), new Quaternion().setFromAxisAngle(UP, yaw), new Vector3(1, 1, 1));
