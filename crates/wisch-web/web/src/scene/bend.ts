// Lifts what lies in the chart of a surface onto a curved surface.
import { BufferAttribute, BufferGeometry, Vector3 } from "three";
import { matrix } from "./solids.ts";
import type { RoundPiece, SurfaceShape } from "../recording.ts";
import type { Bend } from "../store.ts";

/** x and y in the chart, and the height over it; or x, y, z in the frame of the surface [m]. */
export type Corner = [number, number, number];

/** Largest turn of the normal along a line that is drawn straight [rad]. */
const TURN_RAD = 0.05;

/** Returns the directions along the axis of a cylinder and across it, in the chart. */
function directions({ axis_rad }: SurfaceShape): [[number, number], [number, number]] {
  const [c, s] = [Math.cos(axis_rad), Math.sin(axis_rad)];
  return [[c, s], [-s, c]];
}

/** Returns the angle by which the normal turns between two places of the chart [rad]. */
function turnBetween(shape: SurfaceShape, from: Corner, to: Corner): number {
  const [, across] = directions(shape);
  return Math.abs((across[0] * (to[0] - from[0]) + across[1] * (to[1] - from[1])) / shape.radius_m);
}

/** Returns the point at a height over a place of the chart, in the frame of the surface [m]. */
export function lift(shape: Bend, x: number, y: number, height: number): Corner {
  if (!shape) return [x, y, height];
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
  if (shape) {
    const [, across] = directions(shape);
    const at = point.clone().applyMatrix4(worldFromSurface.clone().invert());
    // From the axis of the cylinder to the point, or back in a hollow.
    const [u, w] = [across[0] * at.x + across[1] * at.y, at.z + shape.radius_m];
    normal.set(across[0] * u, across[1] * u, w).multiplyScalar(Math.sign(shape.radius_m)).normalize();
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
    const parts = next ? Math.max(1, Math.ceil(turnBetween(shape, corners[i]!, next) / TURN_RAD)) : 1;
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

/** Lifts a flat geometry, whose triangles are divided until they are small; a plane keeps it. */
export function liftGeometry(shape: Bend, flat: BufferGeometry): BufferGeometry {
  if (!shape) return flat;
  const corners = flat.index ? flat.toNonIndexed() : flat;
  const { array, count } = corners.getAttribute("position");
  const positions: number[] = [];
  // Strips along the axis are straight enough.
  const [, across] = directions(shape);
  const roll = ([x, y]: Corner): number => (across[0] * x + across[1] * y) / shape.radius_m / TURN_RAD;
  const divide = (triangle: Corner[]): void => {
    const rolls = triangle.map(roll);
    const low = Math.floor(Math.min(...rolls));
    for (let strip = low; strip < Math.max(...rolls, low + 0.5); strip++) {
      const part = keepInside(keepInside(triangle, (at) => roll(at) - strip), (at) => strip + 1 - roll(at));
      for (let k = 1; k + 1 < part.length; k++) {
        for (const [x, y, z] of [part[0]!, part[k]!, part[k + 1]!]) positions.push(...lift(shape, x, y, z));
      }
    }
  };
  for (let i = 0; i + 2 < count; i += 3) {
    divide([0, 1, 2].map((k): Corner => [array[3 * (i + k)]!, array[3 * (i + k) + 1]!, array[3 * (i + k) + 2]!]));
  }
  const bent = new BufferGeometry();
  bent.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  bent.computeVertexNormals();
  flat.dispose();
  return bent;
}
