// Lifts what lies in the chart of a surface onto a curved surface.
import { Box2, BufferGeometry, Float32BufferAttribute, Vector2, Vector3 } from "three";
import { once } from "../columns.ts";
import { metres } from "../particles.ts";
import { matrix } from "./solids.ts";
import type { ConeShape, CylinderShape, MeshShape, RoundPiece } from "../recording.ts";
import type { Bend } from "../store.ts";

/** x and y in the chart, and the height over it; or x, y, z in the frame of the surface [m]. */
export type Corner = [number, number, number];

/** Largest turn of the normal along a line that is drawn straight [rad]. */
const TURN_RAD = 0.05;
/** Length of the lines and triangle sides that are drawn straight over a mesh [m]. */
const STEP_ON_MESH_M = 0.02;

/** Largest number of straight parts of a line and of strips of a triangle, and of parts of a triangle's side over a mesh. On a tiny
 * radius, or over a large mesh, they are longer. */
const MOST_PARTS = 500;
const MOST_PARTS_OF_SIDE = 64;

/** Returns the directions along the axis of a cylinder and across it, in the chart. */
function directions({ axis_rad }: CylinderShape): [[number, number], [number, number]] {
  const [c, s] = [Math.cos(axis_rad), Math.sin(axis_rad)];
  return [[c, s], [-s, c]];
}

/** Returns the angle about the axis of a cylinder or a cone from the chart's origin to a place [rad]. */
function rollOf(shape: CylinderShape | ConeShape, x: number, y: number): number {
  if (shape.kind === "cone") return rollOnCone(shape, x, y);
  const [, across] = directions(shape);
  return (across[0] * x + across[1] * y) / shape.radius_m;
}

/** Returns the number of straight parts that replace a line of the chart. */
function partsBetween(shape: NonNullable<Bend>, from: Corner, to: Corner): number {
  const wanted = shape.kind === "mesh" ? Math.hypot(to[0] - from[0], to[1] - from[1]) / STEP_ON_MESH_M
    : Math.abs(rollOf(shape, to[0], to[1]) - rollOf(shape, from[0], from[1])) / TURN_RAD;
  return Math.min(MOST_PARTS, Math.max(1, Math.ceil(wanted)));
}

/** Returns the point at a height over a place of the chart, in the frame of the surface [m]. */
export function lift(shape: Bend, x: number, y: number, height: number): Corner {
  if (!shape) return [x, y, height];
  if (shape.kind === "mesh") return sheetOf(shape).lift(x, y, height);
  if (shape.kind === "cone") return liftOntoCone(shape, x, y, height);
  const [along, across] = directions(shape);
  const v = along[0] * x + along[1] * y;
  const angle = (across[0] * x + across[1] * y) / shape.radius_m;
  const u = (shape.radius_m + height) * Math.sin(angle);
  return [along[0] * v + across[0] * u, along[1] * v + across[1] * u, height * Math.cos(angle) - 2 * shape.radius_m * Math.sin(angle / 2) ** 2];
}

/** Returns the normal of the surface under a point of the world, in the world. */
export function normalUnder({ pose, shape }: RoundPiece["surface"], point: Vector3): Vector3 {
  const worldFromSurface = matrix(pose);
  const normal = new Vector3(0, 0, 1);
  const at = point.clone().applyMatrix4(worldFromSurface.clone().invert());
  if (shape?.kind === "mesh") normal.copy(sheetOf(shape).normalNear(at));
  else if (shape?.kind === "cone") normal.copy(normalOfCone(shape, at));
  else if (shape) {
    const [, across] = directions(shape);
    // From the axis of the cylinder to the point, or back in a hollow.
    const [u, w] = [across[0] * at.x + across[1] * at.y, at.z + shape.radius_m];
    normal.set(across[0] * u, across[1] * u, w).multiplyScalar(Math.sign(shape.radius_m)).normalize();
  }
  return normal.transformDirection(worldFromSurface);
}

/** Whether a point of the world is over a surface: always for a curved one, to which points have no place here. */
export function isOver({ pose, rings, shape }: RoundPiece["surface"], [x, y, z]: readonly number[]): boolean {
  if (shape || !rings.length) return true;
  const at = new Vector3(x, y, z).applyMatrix4(matrix(pose).invert());
  // In holes, an even number of rings surrounds the point.
  return rings.map((ring) => metres(ring)).filter((ring) => {
    let isInside = false;
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [ring[i]!, ring[i + 1]!, ring[j]!, ring[j + 1]!];
      if (ay > at.y !== by > at.y && at.x < ax + ((bx - ax) * (at.y - ay)) / (by - ay)) isInside = !isInside;
    }
    return isInside;
  }).length % 2 === 1;
}

/** Lifts a line of the chart, in short steps. */
export function liftLine(shape: Bend, corners: readonly Corner[], closed: boolean): Corner[] {
  if (!shape) return [...corners];
  const lifted: Corner[] = [];
  for (let i = 0; i < corners.length; i++) {
    const [x, y, height] = corners[i]!;
    const next = i + 1 < corners.length ? corners[i + 1]! : closed ? corners[0]! : null;
    const parts = next ? partsBetween(shape, corners[i]!, next) : 1;
    for (let k = 0; k < parts; k++) {
      const share = k / parts;
      const to = next ?? corners[i]!;
      lifted.push(lift(shape, x + share * (to[0] - x), y + share * (to[1] - y), height + share * (to[2] - height)));
    }
  }
  return lifted;
}

/** Returns the part of a convex polygon where a linear function is at least 0. */
function keepInside(polygon: readonly Corner[], inside: (at: Corner) => number): Corner[] {
  const kept: Corner[] = [];
  polygon.forEach((corner, i) => {
    const next = polygon[(i + 1) % polygon.length]!;
    const [here, there] = [inside(corner), inside(next)];
    if (here >= 0) kept.push(corner);
    if (here >= 0 !== there >= 0) {
      const share = here / (here - there);
      kept.push([corner[0] + share * (next[0] - corner[0]), corner[1] + share * (next[1] - corner[1]), corner[2] + share * (next[2] - corner[2])]);
    }
  });
  return kept;
}

type Triangle = [Corner, Corner, Corner];

/** Cuts triangles into strips along the axis of a cylinder, or from the apex of a cone, which are straight enough. */
function cutIntoStrips(shape: CylinderShape | ConeShape): (triangle: Triangle, add: (part: Triangle) => void) => void {
  const past = (angle: number): ((at: Corner) => number) => {
    if (shape.kind === "cylinder") return ([x, y]) => rollOf(shape, x, y) - angle;
    const beyond = pastRollOnCone(shape, angle);
    return ([x, y]) => beyond(x, y);
  };
  return (triangle, add) => {
    const rolls = triangle.map(([x, y]) => rollOf(shape, x, y));
    const [least, most] = [Math.min(...rolls), Math.max(...rolls)];
    const turn = Math.max(TURN_RAD, (most - least) / MOST_PARTS);
    const low = Math.floor(least / turn);
    for (let strip = low; strip < Math.max(most / turn, low + 0.5); strip++) {
      const [begin, end] = [past(strip * turn), past((strip + 1) * turn)];
      const part = keepInside(keepInside(triangle, begin), (at) => -end(at));
      for (let k = 1; k + 1 < part.length; k++) add([part[0]!, part[k]!, part[k + 1]!]);
    }
  };
}

/** Halves a triangle at its longest side until its sides are at most `step` [m], by default a share of the longest one. */
function halve([a, b, c]: Triangle, add: (part: Triangle) => void, step = 0): void {
  const lengths = [[a, b], [b, c], [c, a]].map(([from, to]) => Math.hypot(from![0] - to![0], from![1] - to![1]));
  const longest = lengths.indexOf(Math.max(...lengths));
  const most = step || Math.max(STEP_ON_MESH_M, lengths[longest]! / MOST_PARTS_OF_SIDE);
  if (lengths[longest]! <= most) return add([a, b, c]);
  const [p, q, r] = ([[a, b, c], [b, c, a], [c, a, b]] as const)[longest]!;
  const middle: Corner = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2];
  halve([p, middle, r], add, most);
  halve([middle, q, r], add, most);
}

/** Lifts a flat geometry, whose triangles are divided until they are small; a plane keeps it. */
export function liftGeometry(shape: Bend, flat: BufferGeometry): BufferGeometry {
  if (!shape) return flat;
  const corners = flat.index ? flat.toNonIndexed() : flat;
  const { array, count } = corners.getAttribute("position");
  const positions: number[] = [];
  const divide = shape.kind === "mesh" ? halve : cutIntoStrips(shape);
  const add = (triangle: Triangle): void => {
    for (const [x, y, z] of triangle) positions.push(...lift(shape, x, y, z));
  };
  for (let i = 0; i + 2 < count; i += 3) {
    const corner = (k: number): Corner => [array[3 * (i + k)]!, array[3 * (i + k) + 1]!, array[3 * (i + k) + 2]!];
    divide([corner(0), corner(1), corner(2)], add);
  }
  const bent = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(positions, 3));
  bent.computeVertexNormals();
  flat.dispose();
  return bent;
}

// A circular cone onto which the chart is rolled: in the chart, a sector about the apex.

/** Directions of a cone in the chart and in space. */
interface Axes {
  along: readonly [number, number];
  /** Cosine of the half angle, and its sine with the sign of the radius. */
  cosine: number;
  sine: number;
  /** Distance of the chart's origin from the apex [m]. */
  slant: number;
  /** The direction in which the axis widens, the direction from it at the origin, and the direction across both. */
  axis: Vector3;
  radial: Vector3;
  across: Vector3;
}

const axesOf = once((cone: ConeShape): Axes => {
  const [x, y] = [Math.cos(cone.axis_rad), Math.sin(cone.axis_rad)];
  const [cosine, sine] = [Math.cos(cone.half_angle_rad), Math.sin(cone.half_angle_rad) * Math.sign(cone.radius_m)];
  return {
    along: [x, y], cosine, sine, slant: cone.radius_m / sine,
    axis: new Vector3(cosine * x, cosine * y, -sine), radial: new Vector3(sine * x, sine * y, cosine), across: new Vector3(-y, x, 0),
  };
});

/** Returns the angle about the axis from the chart's origin to a place [rad]. */
function rollOnCone(cone: ConeShape, x: number, y: number): number {
  const { along, slant, sine } = axesOf(cone);
  return Math.atan2(along[0] * y - along[1] * x, slant + along[0] * x + along[1] * y) / sine;
}

/** Returns the point at a height over a place, in the frame of the surface [m]. */
function liftOntoCone(cone: ConeShape, x: number, y: number, height: number): [number, number, number] {
  const { along, slant, sine, cosine, axis, radial, across } = axesOf(cone);
  const [v, u] = [along[0] * x + along[1] * y, along[0] * y - along[1] * x];
  // How much farther from the apex than the origin.
  const beyond = (v * (2 * slant + v) + u * u) / (Math.hypot(slant + v, u) + slant);
  const angle = Math.atan2(u, slant + v) / sine;
  const round = across.clone().multiplyScalar(Math.sin(angle)).addScaledVector(radial, -2 * Math.sin(angle / 2) ** 2);
  const out = round.clone().add(radial);
  return round.multiplyScalar(cone.radius_m)
    .addScaledVector(axis, cosine * beyond).addScaledVector(out, sine * beyond)
    .addScaledVector(out, cosine * height).addScaledVector(axis, -sine * height)
    .toArray();
}

/** Returns the normal under a point in the frame of the surface. */
function normalOfCone(cone: ConeShape, point: Vector3): Vector3 {
  const { sine, cosine, axis, radial, across } = axesOf(cone);
  const [up, side] = [radial.dot(point) + cone.radius_m, across.dot(point)];
  const out = radial.clone().multiplyScalar(up).addScaledVector(across, side).multiplyScalar(Math.sign(cone.radius_m)).normalize();
  return out.multiplyScalar(cosine).addScaledVector(axis, -sine);
}

/** Returns a linear function of the place that is positive where the angle about the axis is larger than `roll` [rad]. */
function pastRollOnCone(cone: ConeShape, roll: number): (x: number, y: number) => number {
  const { along, slant, sine } = axesOf(cone);
  const [s, c] = [Math.sin(roll * sine), Math.cos(roll * sine)];
  return (x, y) => Math.sign(sine) * (c * (along[0] * y - along[1] * x) - s * (slant + along[0] * x + along[1] * y));
}

// A mesh: its points by their places in the chart.

/** Triangle and barycentric coordinates of a place; outside the chart, those of the triangle at the nearest vertex. */
interface Located {
  corners: [number, number, number];
  weights: [number, number, number];
}

/** The chart of a mesh in square cells. */
class Sheet {
  readonly geometry: BufferGeometry;
  private readonly normals: ArrayLike<number>;
  private readonly low: [number, number];
  private readonly cell: number;
  private readonly columns: number;
  private readonly cells: number[][] = [];
  /** A triangle of each vertex. */
  private readonly triangleOf: number[] = [];

  constructor(private readonly shape: MeshShape) {
    const { points, places, triangles } = shape;
    this.geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute([...points], 3)).setIndex([...triangles]);
    this.geometry.computeVertexNormals();
    this.normals = this.geometry.getAttribute("normal").array;
    const chart = new Box2();
    for (let i = 0; i < places.length; i += 2) chart.expandByPoint(new Vector2(places[i], places[i + 1]));
    this.low = chart.min.toArray();
    const size = chart.getSize(new Vector2());
    this.cell = Math.max(Math.sqrt((3 * size.x * size.y) / Math.max(triangles.length, 1)), 1e-4);
    this.columns = Math.floor(size.x / this.cell) + 1;
    for (let t = 0; t < triangles.length; t += 3) {
      const corners = [0, 1, 2].map((k) => triangles[t + k]!);
      corners.forEach((i) => (this.triangleOf[i] ??= t));
      const [columns, rows] = [0, 1].map((axis) => {
        const at = corners.map((i) => Math.floor((places[2 * i + axis]! - this.low[axis]!) / this.cell));
        return [Math.min(...at), Math.max(...at)] as const;
      });
      for (let row = rows![0]; row <= rows![1]; row++) {
        for (let column = columns![0]; column <= columns![1]; column++) (this.cells[row * this.columns + column] ??= []).push(t);
      }
    }
  }

  /** Returns the point at a height over a place, in the frame of the surface [m]. */
  lift(x: number, y: number, height: number): [number, number, number] {
    const located = this.find(x, y);
    const at = this.mean(this.shape.points, located);
    const normal = this.mean(this.normals, located).normalize();
    return at.addScaledVector(normal, height).toArray();
  }

  /** Returns the normal at the vertex that is nearest to a point in the frame of the surface. */
  normalNear(point: Vector3): Vector3 {
    return new Vector3().fromArray(this.normals, 3 * nearestTo(point.toArray(), this.shape.points));
  }

  private mean(values: ArrayLike<number>, { corners, weights }: Located): Vector3 {
    const sum = new Vector3();
    corners.forEach((i, k) => {
      sum.x += weights[k]! * values[3 * i]!;
      sum.y += weights[k]! * values[3 * i + 1]!;
      sum.z += weights[k]! * values[3 * i + 2]!;
    });
    return sum;
  }

  private find(x: number, y: number): Located {
    const [column, row] = [Math.floor((x - this.low[0]) / this.cell), Math.floor((y - this.low[1]) / this.cell)];
    const near = column >= 0 && column < this.columns && row >= 0 ? this.cells[row * this.columns + column] ?? [] : [];
    for (const t of near) {
      const located = this.locate(t, x, y);
      if (located.weights.every((weight) => weight >= -1e-6)) return located;
    }
    return this.locate(this.triangleOf[nearestTo([x, y], this.shape.places)] ?? 0, x, y);
  }

  private locate(t: number, x: number, y: number): Located {
    const { places, triangles } = this.shape;
    const corners: [number, number, number] = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
    const [a, b, c] = [2 * corners[0], 2 * corners[1], 2 * corners[2]];
    const [ax, ay, bx, by, cx, cy] = [places[a]!, places[a + 1]!, places[b]!, places[b + 1]!, places[c]!, places[c + 1]!];
    const doubled = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const second = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / doubled;
    const third = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / doubled;
    return { corners, weights: [1 - second - third, second, third] };
  }
}

/** Returns the index of the row of numbers that is nearest to a place. */
function nearestTo(place: readonly number[], rows: readonly number[]): number {
  let [nearest, least] = [0, Infinity];
  for (let i = 0; i * place.length < rows.length; i++) {
    let distance = 0;
    for (let k = 0; k < place.length; k++) distance += (place[k]! - rows[i * place.length + k]!) ** 2;
    if (distance < least) [nearest, least] = [i, distance];
  }
  return nearest;
}

/** Returns the chart of a mesh, which is made once. */
export const sheetOf = once((shape: MeshShape) => new Sheet(shape));
