// Surfaces of which a robot's body is made: turned profiles, and shells round blended shapes.
import { BufferAttribute, BufferGeometry, Matrix4, Quaternion, Vector3 } from "three";

export const Z = new Vector3(0, 0, 1);

/** A capsule's axis between the middles of its caps, and its radius [m]. */
export interface Rod {
  from: Vector3;
  to: Vector3;
  radius: number;
}

/** Returns the pose that has its z axis along `axis`. */
export const alongAxis = (axis: Vector3, at = new Vector3()): Matrix4 =>
  new Matrix4().makeRotationFromQuaternion(new Quaternion().setFromUnitVectors(Z, axis.clone().normalize())).setPosition(at);

const makeGeometry = (points: number[], normals: number[], index: number[]): BufferGeometry => new BufferGeometry()
  .setAttribute("position", new BufferAttribute(Float32Array.from(points), 3))
  .setAttribute("normal", new BufferAttribute(Float32Array.from(normals), 3)).setIndex(index);

export type Profile = [radius: number, z: number][];

/** Turns a profile, from its bottom to its top [m], about z. A point that stands twice makes an edge. */
export function turn(profile: Profile, segments = 24): BufferGeometry {
  const [points, normals, index] = [[] as number[], [] as number[], [] as number[]];
  const slopes = profile.slice(1).map(([radius, z], j) => [z - profile[j]![1], profile[j]![0] - radius] as const);
  for (let i = 0; i <= segments; i++) {
    const [cos, sin] = [Math.cos((2 * Math.PI * i) / segments), Math.sin((2 * Math.PI * i) / segments)];
    profile.forEach(([radius, z], j) => {
      const [before, after] = [slopes[j - 1] ?? [0, 0], slopes[j] ?? [0, 0]];
      const [out, up] = [before[0] + after[0], before[1] + after[1]];
      const size = Math.hypot(out, up) || 1;
      points.push(radius * cos, radius * sin, z);
      normals.push((out * cos) / size, (out * sin) / size, up / size);
      const [a, b] = [(i - 1) * profile.length + j, i * profile.length + j];
      if (i === 0 || j === profile.length - 1 || (slopes[j]![0] === 0 && slopes[j]![1] === 0)) return;
      if (radius > 0) index.push(a, b, b + 1);
      if (profile[j + 1]![0] > 0) index.push(a, b + 1, a + 1);
    });
  }
  return makeGeometry(points, normals, index);
}

/** Returns the distance of a point from the surface of a capsule [m], negative inside. */
export function distanceTo({ from, to, radius }: Rod, { x, y, z }: { x: number; y: number; z: number }): number {
  const [wx, wy, wz] = [to.x - from.x, to.y - from.y, to.z - from.z];
  const length = wx * wx + wy * wy + wz * wz;
  const share = length > 0 ? Math.min(1, Math.max(0, ((x - from.x) * wx + (y - from.y) * wy + (z - from.z) * wz) / length)) : 0;
  return Math.hypot(x - from.x - share * wx, y - from.y - share * wy, z - from.z - share * wz) - radius;
}

/** Capsules blended into each other, and cut by a box with round edges. */
export interface Shell {
  /** In the link: z up, x to the robot's front. */
  linkFromShell: Matrix4;
  /** In the shell's frame. */
  rods: readonly Rod[];
  /** Half the sizes of the box, and the radius of its edges [m]. */
  box: Vector3;
  edge: number;
}

/** Width over which capsules are blended, and over which the box cuts them [m]. */
const BLEND_M = 0.012;
const SOFT_M = 0.01;
/** Number of halvings of an interval that holds a point of the surface. */
const HALVINGS = 13;
/** Step of differences, and room at the ends of a shell [m]. */
const STEP_M = 1e-4;

function distanceToShell({ rods, box, edge }: Shell, x: number, y: number, z: number): number {
  let sum = 0;
  for (const rod of rods) sum += Math.exp(-distanceTo(rod, { x, y, z }) / BLEND_M);
  const [ox, oy, oz] = [Math.abs(x) - box.x + edge, Math.abs(y) - box.y + edge, Math.abs(z) - box.z + edge];
  const cut = Math.hypot(Math.max(0, ox), Math.max(0, oy), Math.max(0, oz)) + Math.min(0, Math.max(ox, oy, oz)) - edge;
  return SOFT_M * Math.log(sum ** (-BLEND_M / SOFT_M) + Math.exp(cut / SOFT_M));
}

/** Returns a patch of a shell, `inset` under it [m], between azimuths from the front [rad] and heights in [-1, 1]. `column`: width of
 * its columns [rad], which is also that of its rows. */
export function makePatch(shell: Shell, inset: number, [left, right]: [number, number], [low, high]: [number, number], column: number): BufferGeometry {
  const columns = Math.ceil((right - left) / column);
  const [bottom, top] = [Math.asin(low), Math.asin(high)];
  const rows = Math.max(2, Math.ceil((top - bottom) / column));
  const [points, normals, index] = [[] as number[], [] as number[], [] as number[]];
  const distance = (x: number, y: number, z: number) => distanceToShell(shell, x, y, z) + inset;
  const add = (azimuth: number, height: number, most: number) => {
    const [cos, sin, z] = [Math.cos(azimuth), Math.sin(azimuth), height * (shell.box.z - inset - STEP_M)];
    let [radius, outer] = [0, most];
    for (let k = 0; k < HALVINGS && most > 0; k++) {
      const middle = (radius + outer) / 2;
      if (distance(middle * cos, middle * sin, z) < 0) radius = middle;
      else outer = middle;
    }
    const [x, y] = [radius * cos, radius * sin];
    const slope = new Vector3(distance(x + STEP_M, y, z) - distance(x - STEP_M, y, z), distance(x, y + STEP_M, z) - distance(x, y - STEP_M, z), distance(x, y, z + STEP_M) - distance(x, y, z - STEP_M));
    points.push(...new Vector3(x, y, z).applyMatrix4(shell.linkFromShell));
    normals.push(...slope.transformDirection(shell.linkFromShell));
  };
  const heights = Array.from({ length: rows + 1 }, (_, j) => Math.sin(bottom + (j / rows) * (top - bottom)));
  // An end of the shell is closed by a row on its axis.
  const closed = [...(low <= -1 ? [-1] : []), ...heights, ...(high >= 1 ? [1] : [])];
  closed.forEach((height, j) => {
    const isClosing = (j === 0 && low <= -1) || (j === closed.length - 1 && high >= 1);
    for (let i = 0; i <= columns; i++) add(left + ((right - left) * i) / columns, height, isClosing ? 0 : 2 * shell.box.length());
    if (j > 0) for (let i = 0; i < columns; i++) {
      const [a, b] = [(j - 1) * (columns + 1) + i, j * (columns + 1) + i];
      index.push(a, a + 1, b, b, a + 1, b + 1);
    }
  });
  return makeGeometry(points, normals, index);
}
