// The static parts of a round: scene objects, surface (believed, found, true), goal and strokes; and the map of a treated surface.
import {
  BufferAttribute, BufferGeometry, CircleGeometry, Color, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
  MeshLambertMaterial, RingGeometry, Shape, ShapeGeometry, Vector2, Vector3, type Material,
} from "three";
import { metres } from "../particles.ts";
import { colour } from "../theme.ts";
import { binOf, binsOf, CELL_REACH, type SurfaceValues } from "../treated.ts";
import { lift, liftGeometry, liftLine, normalUnder, sheetOf, type Corner } from "./bend.ts";
import { LineMaterial, chain, cutDashes, segments } from "./lines.ts";
import { geometryOf, placeAt, shiftDepth, tint } from "./solids.ts";
import { TRUTH_DASH } from "../timeline/frame.ts";
import { blocksOf, cornersOf, isBetween, middleOf } from "./viewpoint.ts";
import { woodTexture } from "./dots.ts";
import { trueShape, type Bend, type Recording } from "../store.ts";
import type { Round } from "../round.ts";
import type { Pose } from "../recording.ts";

/** Height above the surface at which flat items are drawn [m]. */
export const ABOVE = 0.0015;
/** Dashes that mark the truth [m]. */
export const TRUE_DASH_M: [number, number] = [0.005 * TRUTH_DASH[0], 0.005 * TRUTH_DASH[1]];

/** Opacity of furniture between camera and surface [1]. */
const FADED = 0.2;
/** Height over the surface to which the camera sees [m]. */
const SIGHT_M = 0.03;
/** How far points that are to be seen lie from the corners of the surface, as a share of the way to its middle [1]. */
const INSET = 0.12;
/** Names of surfaces that are drawn as wood. */
const WOODEN = /board|table|wood|desk|counter/i;

/** Converts positions (x, y alternating) to corners above the surface. */
export function corners(places: number[], above = ABOVE): Corner[] {
  const flat = metres(places);
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i]!, flat[2 * i + 1]!, above]);
}

export class Still {
  readonly group = new Group();
  /** Furniture and surface. */
  readonly bodies = new Group();
  private readonly obstacles: Mesh<BufferGeometry, Material>[] = [];
  private sights: Vector3[] | null = null;
  surface: Mesh | null = null;
  /** Outlines of found and true surfaces by their poses. */
  private readonly outlines = new Map<Pose, Group>();
  private readonly strokes: ReturnType<typeof segments>[] = [];
  private readonly strokeGroup = new Group();

  constructor(readonly round: Round, { head, meshes }: Recording) {
    const { plan } = round;
    this.group.add(this.bodies);
    for (const { part, ...solid } of plan.scene) {
      const geometry = geometryOf(solid, meshes);
      const obstacle = part === "obstacle";
      // Furniture is drawn farther, so that a surface that was found below its top stays visible.
      const body = new Mesh(geometry, tint(shiftDepth(new MeshLambertMaterial(), 1.015), obstacle ? "obstacle" : "carrier"));
      body.receiveShadow = body.castShadow = true;
      if (obstacle) this.obstacles.push(body);
      const edge = new LineSegments(new EdgesGeometry(geometry, 30), tint(shiftDepth(new LineBasicMaterial({ transparent: true, opacity: 0.4 }), 1.01), "obstacle-line"));
      this.bodies.add(placeAt(body, solid.pose));
      this.group.add(placeAt(edge, solid.pose));
    }
    this.addSurface(WOODEN.test(head?.task?.surface ?? ""));
    this.addGoal();
    plan.strokes.forEach((stroke) => {
      const material = tint(new LineMaterial({ linewidth: 6, transparent: true, opacity: 0.35 }), "stroke");
      const line = segments(chain(liftLine(plan.surface.shape, corners(stroke, 2 * ABOVE), false), false), material);
      this.strokes.push(line);
      this.strokeGroup.add(line);
    });
    this.group.add(placeAt(this.strokeGroup, plan.surface.pose));
  }

  /** Shows the outlines of the true surface and of the one that is known as found, and emphasises the current stroke. A chosen
   * stroke is shown in any case. */
  show(layers: { strokes: boolean; found: boolean; actual: boolean }, stroke: number | null, found: Pose | null, chosen: number | null): void {
    const { truth } = this.round;
    const actual = truth?.surface ?? null;
    const { shape } = this.round.plan.surface;
    for (const outline of this.outlines.values()) outline.visible = false;
    if (found && layers.found) this.showOutline(found, () => this.outlineAt(found, shape, "found", 0.28));
    if (actual && layers.actual) this.showOutline(actual, () => this.outlineAt(actual, trueShape(truth, shape), "actual", 0));
    this.strokeGroup.visible = layers.strokes || chosen !== null;
    this.strokes.forEach((line, i) => {
      line.visible = layers.strokes || i === chosen;
      tint(line.material, i === chosen ? "chosen" : "stroke");
      line.material.linewidth = i === chosen ? 7 : i === stroke ? 9 : 6;
      line.material.opacity = i === chosen ? 1 : i === stroke ? 0.6 : 0.35;
    });
  }

  /** Shows the outline at a pose, and makes it first if there is none. */
  private showOutline(pose: Pose, make: () => Group): void {
    let outline = this.outlines.get(pose);
    if (!outline) {
      outline = make();
      this.outlines.set(pose, outline);
      this.group.add(outline);
    }
    outline.visible = true;
  }

  /** Makes furniture between the camera and the surface translucent. */
  fade(eye: Vector3): void {
    if (!this.surface || !this.obstacles.length) return;
    this.sights ??= this.pointsOver(SIGHT_M);
    for (const obstacle of this.obstacles) {
      const [block] = blocksOf([obstacle]);
      const hides = block !== undefined && this.sights.some((place) => isBetween(block, place, eye));
      obstacle.material.transparent = hides;
      obstacle.material.opacity = hides ? FADED : 1;
      obstacle.material.depthWrite = obstacle.castShadow = !hides;
    }
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
    return liftGeometry(bend, new ShapeGeometry(shape));
  }

  /** Corners of the surface in the world [m]. */
  get corners(): Vector3[] {
    return this.surface ? cornersOf([this.surface]) : [];
  }

  /** Returns points at a height over the middle of the surface and near its corners, which are to be seen [m]. */
  pointsOver(height: number): Vector3[] {
    this.group.updateMatrixWorld(true);
    const middle = middleOf(this.corners);
    return [middle, ...this.corners.map((corner) => corner.lerp(middle, INSET))].map((place) => place.clone().addScaledVector(normalUnder(this.round.plan.surface, place), height));
  }

  private addSurface(wooden: boolean): void {
    const { pose, shape } = this.round.plan.surface;
    const face = this.face();
    if (!face) return;
    const material = new MeshLambertMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 });
    // A curved surface has no texture coordinates.
    if (wooden && !shape) material.map = woodTexture();
    this.surface = placeAt(new Mesh(face, tint(material, wooden ? "surface-3d" : "sheet-3d")), pose);
    this.surface.receiveShadow = true;
    this.bodies.add(this.surface);
    const ends = this.rings.flatMap((ring) => chain(liftLine(shape, ring, true), true));
    this.group.add(placeAt(segments(ends, tint(new LineMaterial({ linewidth: 2 }), "outline")), pose));
  }

  /** Draws the surface at another pose: as a dashed outline, or with `filled` > 0 as a filled outline of that opacity. */
  private outlineAt(pose: Pose, shape: Bend, name: string, filled: number): Group {
    const group = placeAt(new Group(), pose);
    const line = tint(new LineMaterial({ linewidth: filled ? 3 : 2 }), name);
    const ends = this.rings.flatMap((ring) => chain(liftLine(shape, ring.map(([x, y, z]) => [x, y, z + (filled ? 1 : 2) * ABOVE]), true), true));
    group.add(segments(filled ? ends : cutDashes(ends, TRUE_DASH_M), line));
    const face = filled ? this.face() : null;
    if (face) {
      const material = new MeshLambertMaterial({ transparent: true, opacity: filled, depthWrite: false });
      group.add(new Mesh(face, tint(material, name)));
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
      group.add(new Mesh(liftGeometry(surface.shape, geometry), tint(material, name)));
    };
    flat(new CircleGeometry(goal.radius, 48), 0.22, "goal");
    flat(new RingGeometry(Math.max(0, goal.radius - 0.003), goal.radius, 48), 1, "goal-line");
    flat(new CircleGeometry(Math.min(0.006, 0.3 * goal.radius), 24), 1, "goal-line");
    this.group.add(group);
  }
}

/** Directions from the middle of a cell to its corners. */
const CORNERS = [[-1, -1], [1, -1], [1, 1], [-1, 1]] as const;

/** Makes the cells of a map over their surface. */
function makeCells({ record, shape }: SurfaceValues): BufferGeometry {
  const places = metres(record.places);
  const [across, up] = record.cell.map((side) => CELL_REACH * side) as [number, number];
  const count = places.length / 2;
  const positions = new Float32Array(12 * count);
  const index: number[] = [];
  for (let i = 0; i < count; i++) {
    CORNERS.forEach(([x, y], k) => positions.set(lift(shape, places[2 * i]! + x * across, places[2 * i + 1]! + y * up, ABOVE / 2), 12 * i + 3 * k));
    index.push(4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3);
  }
  const colours = new BufferAttribute(new Float32Array(12 * count), 3);
  return new BufferGeometry().setAttribute("position", new BufferAttribute(positions, 3)).setAttribute("color", colours).setIndex(index);
}

export class SurfaceMap {
  /** Its depth is shifted as that of the surface, and a little more, but less than that of the tool's path. */
  readonly mesh = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ vertexColors: true, side: DoubleSide, toneMapped: false, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 }));
  /** The shown map, and the theme of its colours. */
  private shown: SurfaceValues | null = null;
  private theme = "";

  constructor() {
    this.mesh.frustumCulled = false;
  }

  /** Shows a map; null hides it. */
  show(map: SurfaceValues | null, theme: string): void {
    this.mesh.visible = map !== null;
    if (!map) return;
    placeAt(this.mesh, map.pose);
    const sameCells = this.shown?.record === map.record && this.shown.shape === map.shape;
    if (!sameCells) {
      this.mesh.geometry.dispose();
      this.mesh.geometry = makeCells(map);
    }
    if (!sameCells || this.shown?.values !== map.values || this.theme !== theme) this.paint(map);
    this.shown = map;
    this.theme = theme;
  }

  private paint({ record, values }: SurfaceValues): void {
    const bins = binsOf(record);
    const colours = bins.map((bin) => new Color(colour(bin.colour)));
    const attribute = this.mesh.geometry.getAttribute("color") as BufferAttribute;
    values.forEach((value, i) => {
      const { r, g, b } = colours[binOf(bins, record, value)]!;
      for (let k = 0; k < 4; k++) attribute.setXYZ(4 * i + k, r, g, b);
    });
    attribute.needsUpdate = true;
  }
}
