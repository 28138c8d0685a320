// The static parts of a round: scene objects, surface (believed, found, true), goal and strokes.
import {
  Color, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Material, Mesh, MeshLambertMaterial, Object3D, RingGeometry,
  CircleGeometry, Shape, ShapeGeometry, Vector2,
} from "three";
import type { BufferGeometry } from "three";
import { colour } from "../theme.ts";
import { metres } from "../particles.ts";
import { type Corner, liftGeometry, liftLine } from "./bend.ts";
import { sheetOf } from "./sheet.ts";
import { LineMaterial, chain, cutDashes, segments } from "./lines.ts";
import { geometryOf, matrix, shiftDepth } from "./solids.ts";
import { TRUTH_DASH } from "../timeline/frame.ts";
import { type Bend, trueShape } from "../store.ts";
import type { Round } from "../round.ts";
import type { MeshRecord, Pose } from "../recording.ts";

/** Height above the surface at which flat items are drawn [m]. */
export const ABOVE = 0.0015;
/** Length of a unit of the dashes that mark the truth [m]. */
const DASH_M = 0.005;

/** Converts positions (x, y alternating) to corners above the surface. */
export function corners(places: number[], above = ABOVE): Corner[] {
  const flat = metres(places);
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i]!, flat[2 * i + 1]!, above]);
}

export class Still {
  readonly group = new Group();
  surface: Mesh | null = null;
  private found: Group | null = null;
  private actual: Object3D | null = null;
  private foundAt: Pose | null = null;
  private actualAt: Pose | null = null;
  private readonly strokes: Object3D[] = [];
  private readonly strokeGroup = new Group();
  private readonly materials: Material[] = [];
  private readonly geometries: BufferGeometry[] = [];

  constructor(readonly round: Round, meshes: MeshRecord[]) {
    const { plan } = round;
    for (const { part, ...solid } of plan.scene) {
      const geometry = geometryOf(solid, meshes);
      const obstacle = part === "obstacle";
      // The carrier is drawn farther, so that a surface that was found below its top stays visible.
      const material = obstacle ? new MeshLambertMaterial({ transparent: true, opacity: 0.5, depthWrite: false }) : shiftDepth(new MeshLambertMaterial(), 1.015);
      const body = new Mesh(geometry, this.keep(material, obstacle ? "obstacle" : "carrier"));
      body.receiveShadow = !obstacle;
      body.renderOrder = obstacle ? 1 : 0;
      const edges = this.own(new EdgesGeometry(geometry, 30));
      const edge = new LineSegments(edges, this.keep(new LineBasicMaterial({ transparent: true, opacity: 0.5 }), "obstacle-line"));
      if (solid.kind !== "mesh") this.geometries.push(geometry);
      for (const object of [body, edge]) this.group.add(placeAt(object, solid.pose));
    }
    this.addSurface();
    this.addGoal();
    plan.strokes.forEach((stroke) => {
      const material = this.keep(new LineMaterial({ linewidth: 6, transparent: true, opacity: 0.35 }), "stroke");
      const line = segments(chain(liftLine(plan.surface.shape, corners(stroke, 2 * ABOVE), false), false), material);
      this.strokes.push(line);
      this.strokeGroup.add(line);
    });
    this.group.add(placeAt(this.strokeGroup, plan.surface.pose));
  }

  /** Shows the outlines of the true surface and of the one that is known as found, and emphasises the current stroke. */
  show(layers: { strokes: boolean; found: boolean; actual: boolean }, stroke: number | null, found: Pose | null): void {
    const { truth } = this.round;
    if (found !== this.foundAt) {
      this.foundAt = found;
      if (this.found) this.group.remove(this.found);
      this.found = found ? this.outlineAt(found, this.round.plan.surface.shape, "found", 0.28) : null;
      if (this.found) this.group.add(this.found);
    }
    const actual = truth?.surface ?? null;
    if (actual !== this.actualAt) {
      this.actualAt = actual;
      if (this.actual) this.group.remove(this.actual);
      this.actual = actual ? this.outlineAt(actual, trueShape(truth, this.round.plan.surface.shape), "actual", 0) : null;
      if (this.actual) this.group.add(this.actual);
    }
    if (this.found) this.found.visible = layers.found;
    if (this.actual) this.actual.visible = layers.actual;
    this.strokeGroup.visible = layers.strokes;
    this.strokes.forEach((line, i) => {
      const material = (line as unknown as { material: LineMaterial }).material;
      material.linewidth = i === stroke ? 9 : 6;
      material.opacity = i === stroke ? 0.6 : 0.35;
    });
  }

  paint(): void {
    for (const material of this.materials) {
      (material as Material & { color: Color }).color.set(colour(material.name));
    }
  }

  dispose(): void {
    for (const material of this.materials) material.dispose();
    for (const geometry of this.geometries) geometry.dispose();
  }

  private keep<M extends Material>(material: M, name: string): M {
    material.name = name;
    (material as unknown as { color: Color }).color.set(colour(name));
    this.materials.push(material);
    return material;
  }

  private own<G extends BufferGeometry>(geometry: G): G {
    this.geometries.push(geometry);
    return geometry;
  }

  private get rings(): Corner[][] {
    return this.round.plan.surface.rings.map((ring) => corners(ring)).filter((ring) => ring.length >= 3);
  }

  private face(): BufferGeometry | null {
    const bend = this.round.plan.surface.shape;
    if (bend?.kind === "mesh") return sheetOf(bend).geometry;
    const [outer, ...holes] = this.rings.map((ring) => ring.map(([x, y]) => new Vector2(x, y)));
    if (!outer) return null;
    const shape = new Shape(outer);
    shape.holes = holes.map((hole) => new Shape(hole));
    return this.own(liftGeometry(bend, new ShapeGeometry(shape)));
  }

  private addSurface(): void {
    const { pose, shape } = this.round.plan.surface;
    const face = this.face();
    if (!face) return;
    const material = new MeshLambertMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 });
    this.surface = placeAt(new Mesh(face, this.keep(material, "surface-3d")), pose);
    this.surface.receiveShadow = true;
    this.group.add(this.surface);
    const ends = this.rings.flatMap((ring) => chain(liftLine(shape, ring, true), true));
    this.group.add(placeAt(segments(ends, this.keep(new LineMaterial({ linewidth: 2 }), "outline")), pose));
  }

  /** Draws the surface at another pose: as a dashed outline, or with `tint` > 0 as a filled outline of that opacity. */
  private outlineAt(pose: Pose, shape: Bend, name: string, tint: number): Group {
    const group = placeAt(new Group(), pose);
    const line = this.keep(new LineMaterial({ linewidth: tint ? 3 : 2 }), name);
    const ends = this.rings.flatMap((ring) => chain(liftLine(shape, ring.map(([x, y, z]) => [x, y, z + (tint ? 1 : 2) * ABOVE]), true), true));
    group.add(segments(tint ? ends : cutDashes(ends, [DASH_M * TRUTH_DASH[0], DASH_M * TRUTH_DASH[1]]), line));
    const face = tint ? this.face() : null;
    if (face) {
      const material = new MeshLambertMaterial({ transparent: true, opacity: tint, depthWrite: false });
      group.add(new Mesh(face, this.keep(material, name)));
    }
    return group;
  }

  private addGoal(): void {
    const { goal, surface } = this.round.plan;
    if (goal?.kind !== "collected") return;
    const [x, y] = goal.place;
    const group = placeAt(new Group(), surface.pose);
    const flat = (geometry: BufferGeometry, opacity: number, name: string) => {
      const material = new MeshLambertMaterial({ transparent: true, opacity, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -3, polygonOffsetUnits: -3 });
      geometry.translate(x, y, ABOVE);
      const mesh = new Mesh(this.own(liftGeometry(surface.shape, geometry)), this.keep(material, name));
      group.add(mesh);
    };
    flat(new CircleGeometry(goal.radius, 48), 0.22, "goal");
    flat(new RingGeometry(Math.max(0, goal.radius - 0.003), goal.radius, 48), 1, "goal-line");
    flat(new CircleGeometry(Math.min(0.006, 0.3 * goal.radius), 24), 1, "goal-line");
    this.group.add(group);
  }
}

function placeAt<O extends Object3D>(object: O, pose: Pose): O {
  object.matrixAutoUpdate = false;
  matrix(pose, object.matrix);
  return object;
}
