// Lifts what lies in the chart of a surface onto a curved surface.
import { BufferAttribute, BufferGeometry, Vector3 } from "three";
import { matrix } from "./solids.ts";
import type { RoundPiece, SurfaceShape } from "../recording.ts";
import type { Corner } from "./surface.ts";

/** Shape of a surface; none for a plane. */
export type Bend = SurfaceShape | null | undefined;

/** Longest line that is drawn straight on a curved surface [m]. */
const STEP_M = 0.02;
/** Largest number of halvings of a triangle's edges. */
const MOST_HALVINGS = 6;

/** Returns the directions along the axis of a cylinder and across it, in the chart. */
function directions({ axis }: SurfaceShape): [[number, number], [number, number]] {
  const [c, s] = [Math.cos(axis), Math.sin(axis)];
  return [[c, s], [-s, c]];
}

/** Returns the point at a height over a place of the chart, in the frame of the surface [m]. */
export function lift(shape: Bend, x: number, y: number, height: number): Corner {
  if (!shape) return [x, y, height];
  const [along, across] = directions(shape);
  const v = along[0] * x + along[1] * y;
  const angle = (across[0] * x + across[1] * y) / shape.radius;
  const u = (shape.radius + height) * Math.sin(angle);
  return [along[0] * v + across[0] * u, along[1] * v + across[1] * u, height * Math.cos(angle) - 2 * shape.radius * Math.sin(angle / 2) ** 2];
}

/** Returns the normal of the surface under a point of the world, in the world. */
export function normalUnder({ pose, shape }: RoundPiece["surface"], point: Vector3): Vector3 {
  const worldFromSurface = matrix(pose);
  const normal = new Vector3(0, 0, 1);
  if (shape) {
    const [, across] = directions(shape);
    const at = point.clone().applyMatrix4(worldFromSurface.clone().invert());
    // From the axis of the cylinder to the point, or back in a hollow.
    const [u, w] = [across[0] * at.x + across[1] * at.y, at.z + shape.radius];
    normal.set(across[0] * u, across[1] * u, w).multiplyScalar(Math.sign(shape.radius)).normalize();
  }
  return normal.transformDirection(worldFromSurface);
}

/** Lifts a line of the chart, in short steps. */
export function liftLine(shape: Bend, corners: readonly Corner[], closed: boolean): Corner[] {
  if (!shape) return [...corners];
  const lifted: Corner[] = [];
  for (let i = 0; i < corners.length; i++) {
    const [x, y, height] = corners[i]!;
    const next = i + 1 < corners.length ? corners[i + 1]! : closed ? corners[0]! : null;
    const parts = next ? Math.max(1, Math.ceil(Math.hypot(next[0] - x, next[1] - y) / STEP_M)) : 1;
    for (let k = 0; k < parts; k++) {
      const share = k / parts;
      const to = next ?? corners[i]!;
      lifted.push(lift(shape, x + share * (to[0] - x), y + share * (to[1] - y), height + share * (to[2] - height)));
    }
  }
  return lifted;
}

/** Lifts a flat geometry, whose triangles are divided until they are small; a plane keeps it. */
export function liftGeometry(shape: Bend, flat: BufferGeometry): BufferGeometry {
  if (!shape) return flat;
  const corners = flat.index ? flat.toNonIndexed() : flat;
  const { array, count } = corners.getAttribute("position");
  const positions: number[] = [];
  const divide = (triangle: Corner[], depth: number): void => {
    const [a, b, c] = triangle as [Corner, Corner, Corner];
    const longest = Math.max(...[[a, b], [b, c], [c, a]].map(([p, q]) => Math.hypot(q![0] - p![0], q![1] - p![1])));
    if (longest <= STEP_M || depth >= MOST_HALVINGS) {
      for (const [x, y, z] of triangle) positions.push(...lift(shape, x, y, z));
      return;
    }
    const between = (p: Corner, q: Corner): Corner => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2];
    const [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)];
    for (const part of [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]) divide(part, depth + 1);
  };
  for (let i = 0; i + 2 < count; i += 3) {
    divide([0, 1, 2].map((k): Corner => [array[3 * (i + k)]!, array[3 * (i + k) + 1]!, array[3 * (i + k) + 2]!]), 0);
  }
  const bent = new BufferGeometry();
  bent.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  bent.computeVertexNormals();
  flat.dispose();
  return bent;
}
