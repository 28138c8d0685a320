// A surface of a mesh: its points by their places in the chart.
import { Box2, BufferGeometry, Float32BufferAttribute, Vector2, Vector3 } from "three";
import { once } from "../columns.ts";
import type { MeshShape } from "../recording.ts";

/** Triangle and barycentric coordinates of a place; outside the chart, those of the triangle at the nearest vertex. */
interface Located {
  corners: [number, number, number];
  weights: [number, number, number];
}

/** The chart of a mesh in square cells. */
export class Sheet {
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
    const { points } = this.shape;
    let [nearest, least] = [0, Infinity];
    for (let i = 0; i < points.length; i += 3) {
      const distance = (points[i]! - point.x) ** 2 + (points[i + 1]! - point.y) ** 2 + (points[i + 2]! - point.z) ** 2;
      if (distance < least) [nearest, least] = [i, distance];
    }
    return new Vector3().fromArray(this.normals, nearest);
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
    const { places } = this.shape;
    let [nearest, least] = [0, Infinity];
    for (let i = 0; i < this.triangleOf.length; i++) {
      const distance = (places[2 * i]! - x) ** 2 + (places[2 * i + 1]! - y) ** 2;
      if (distance < least) [nearest, least] = [i, distance];
    }
    return this.locate(this.triangleOf[nearest] ?? 0, x, y);
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

/** Returns the chart of a mesh, which is made once. */
export const sheetOf = once((shape: MeshShape) => new Sheet(shape));
