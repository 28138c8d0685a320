// Surfaces of which a robot's body is made: turned profiles, and shells round blended shapes.
import { BufferGeometry, Float32BufferAttribute, LatheGeometry, Matrix4, Quaternion, Vector2, Vector3 } from "three";

/** Materials of a body. */
export type Finish = "casing" | "joint" | "ring" | "handle";
export type Add = (finish: Finish, geometry: BufferGeometry, at?: Matrix4) => void;

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

export type Profile = [radius: number, z: number][];

/** Turns a profile, from its bottom to its top [m], about z. A point that stands twice makes an edge. */
export function turn(profile: Profile, segments = 24): BufferGeometry {
  const turned = new LatheGeometry(profile.map(([radius, z]) => new Vector2(radius, z)), segments).rotateX(Math.PI / 2);
  // Triangles at the axis and at edges have no area: there are two for each segment and each part of the profile.
  return turned.setIndex([...turned.index!.array].filter((_, k) => {
    const j = Math.floor(k / 6) % (profile.length - 1);
    const [from, to] = [profile[j]!, profile[j + 1]!];
    return (from[0] !== to[0] || from[1] !== to[1]) && (k % 6 < 3 ? from : to)[0] > 0;
  }));
}

/** Returns the distance of a point from the surface of a capsule [m], negative inside. */
export function distanceTo({ from, to, radius }: Rod, x: number, y: number, z: number): number {
  const wx = to.x - from.x;
  const wy = to.y - from.y;
  const wz = to.z - from.z;
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
/** How near a point is to the surface, and step of differences [m]. */
const NEAR_M = 1e-4;

function distanceToShell({ rods, box, edge }: Shell, x: number, y: number, z: number): number {
  let sum = 0;
  for (const rod of rods) sum += Math.exp(-distanceTo(rod, x, y, z) / BLEND_M);
  const ox = Math.abs(x) - box.x + edge;
  const oy = Math.abs(y) - box.y + edge;
  const oz = Math.abs(z) - box.z + edge;
  const cut = Math.hypot(Math.max(0, ox), Math.max(0, oy), Math.max(0, oz)) + Math.min(0, Math.max(ox, oy, oz)) - edge;
  return SOFT_M * Math.log(sum ** (-BLEND_M / SOFT_M) + Math.exp(cut / SOFT_M));
}

/** Returns a zero of a rising function between 0 and `outer` by halving; 0 if it is positive at 0. */
function findZero(of: (x: number) => number, outer: number): number {
  if (of(0) >= 0) return 0;
  let [from, to] = [0, outer];
  while (to - from > 0.5 * NEAR_M) {
    const middle = (from + to) / 2;
    if (of(middle) < 0) from = middle;
    else to = middle;
  }
  return (from + to) / 2;
}

/** Returns a patch of a shell, `inset` under it [m], between azimuths from the front [rad] and heights in [-1, 1]. `column`: width of
 * its columns [rad], which is also that of its rows. */
export function makePatch(shell: Shell, inset: number, [left, right]: [number, number], [low, high]: [number, number], column: number): BufferGeometry {
  const columns = Math.ceil((right - left) / column);
  const [bottom, top] = [Math.asin(low), Math.asin(high)];
  const rows = Math.max(2, Math.ceil((top - bottom) / column));
  const heights = Array.from({ length: rows + 1 }, (_, j) => Math.sin(bottom + (j / rows) * (top - bottom)));
  // An end of the shell is closed by a row on its axis.
  const closed = [...(low <= -1 ? [-1] : []), ...heights, ...(high >= 1 ? [1] : [])];
  const [points, normals, index] = [[] as number[], [] as number[], [] as number[]];
  const [at, slope] = [new Vector3(), new Vector3()];
  const distance = (x: number, y: number, z: number) => distanceToShell(shell, x, y, z) + inset;
  closed.forEach((height, j) => {
    const isClosing = (j === 0 && low <= -1) || (j === closed.length - 1 && high >= 1);
    const z = height * (shell.box.z - inset - NEAR_M);
    for (let i = 0; i <= columns; i++) {
      const azimuth = left + ((right - left) * i) / columns;
      const cos = Math.cos(azimuth);
      const sin = Math.sin(azimuth);
      const radius = isClosing ? 0 : findZero((r) => distance(r * cos, r * sin, z), 2 * shell.box.length());
      const x = radius * cos;
      const y = radius * sin;
      const here = distance(x, y, z);
      at.set(x, y, z).applyMatrix4(shell.linkFromShell);
      slope.set(distance(x + NEAR_M, y, z) - here, distance(x, y + NEAR_M, z) - here, distance(x, y, z + NEAR_M) - here).transformDirection(shell.linkFromShell);
      const b = j * (columns + 1) + i;
      points.push(at.x, at.y, at.z);
      normals.push(slope.x, slope.y, slope.z);
      const a = b - columns - 1;
      if (j > 0 && i < columns) index.push(a, a + 1, b, b, a + 1, b + 1);
    }
  });
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3)).setAttribute("normal", new Float32BufferAttribute(normals, 3)).setIndex(index);
}
