// Where to look from: a direction from which no part of the robot hides tool and surface, and the distance at which all fits.
import { Box3, Matrix4, Mesh, Ray, Vector3, type BufferGeometry, type Object3D } from "three";

/** Ratio of the visible extent to that of the shown points [1]. */
const MARGIN = 1.12;
/** Length of the lines of sight that are tested [m]. */
const SIGHT_M = 1.8;
/** Candidates: number of azimuths, and angles over the horizon [rad]. */
const AZIMUTHS = 16;
const ELEVATIONS = [0.45, 0.7, 0.95];

/** A mesh's bounding box, which stands for it in tests of sight. */
export interface Block {
  blockFromWorld: Matrix4;
  box: Box3;
}

/** What lines of sight are tested with at one time. */
export interface Moment {
  blocks: Block[];
  /** Points of the tool in the world [m]. */
  tool: Vector3[];
}

/** The lens: tangents of half its angles of view, upwards and to the side. */
export interface Angles {
  high: number;
  wide: number;
}

/** Where a camera is and looks at [m]. */
export interface View {
  target: Vector3;
  eye: Vector3;
}

/** Returns the boxes around all visible meshes that are not empty, each in its own frame. */
function boxesIn(objects: readonly Object3D[]): { worldFromBox: Matrix4; box: Box3 }[] {
  return objects.filter(({ visible }) => visible).flatMap((object) => {
    const geometry = object instanceof Mesh ? object.geometry as BufferGeometry : null;
    if (geometry && !geometry.boundingBox) geometry.computeBoundingBox();
    const box = geometry?.boundingBox;
    return [...(box && !box.isEmpty() ? [{ worldFromBox: object.matrixWorld, box }] : []), ...boxesIn(object.children)];
  });
}

/** Returns the corners of a box. */
export const cornersOfBox = ({ min, max }: Box3): Vector3[] =>
  Array.from({ length: 8 }, (_, k) => new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z));

/** Returns the corners of the bounding boxes of all meshes in `objects`, in the world [m]. */
export const cornersOf = (objects: readonly Object3D[]): Vector3[] =>
  boxesIn(objects).flatMap(({ worldFromBox, box }) => cornersOfBox(box).map((corner) => corner.applyMatrix4(worldFromBox)));

export const blocksOf = (objects: readonly Object3D[]): Block[] =>
  boxesIn(objects).map(({ worldFromBox, box }) => ({ blockFromWorld: worldFromBox.clone().invert(), box }));

/** Whether a block lies between two points. */
export function isBetween({ blockFromWorld, box }: Block, from: Vector3, to: Vector3): boolean {
  const start = from.clone().applyMatrix4(blockFromWorld);
  const way = to.clone().applyMatrix4(blockFromWorld).sub(start);
  const hit = new Ray(start, way.clone().normalize()).intersectBox(box, new Vector3());
  return box.containsPoint(start) || (hit !== null && hit.distanceTo(start) < way.length());
}

/** Returns the share of points that are seen from a direction [1]. */
function shareSeen(points: readonly Vector3[], direction: Vector3, blocks: readonly Block[]): number {
  if (!points.length) return 1;
  return points.filter((point) => {
    const eye = point.clone().addScaledVector(direction, SIGHT_M);
    return !blocks.some((block) => isBetween(block, point, eye));
  }).length / points.length;
}

/** Returns the direction to look from: tool and surface are seen at most moments, the surface from its front, and, where that
 * leaves a choice, from near `preferred`. */
export function chooseDirection(moments: readonly Moment[], surface: readonly Vector3[], normal: Vector3, preferred: Vector3): Vector3 {
  let [best, most] = [preferred, -Infinity];
  for (const elevation of ELEVATIONS) for (let k = 0; k < AZIMUTHS; k++) {
    const azimuth = (2 * Math.PI * k) / AZIMUTHS;
    const direction = new Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
    const facing = direction.dot(normal);
    if (facing < 0.2) continue;
    let seen = 0;
    for (const { blocks, tool } of moments) seen += (3 * shareSeen(tool, direction, blocks) + 2 * shareSeen(surface, direction, blocks)) / moments.length;
    const score = seen + 2 * Math.min(facing, 0.8) + 0.6 * direction.dot(preferred);
    if (score > most) [best, most] = [direction, score];
  }
  return best;
}

/** Returns the mean of points. */
export const middleOf = (points: readonly Vector3[]): Vector3 => points.reduce((sum, point) => sum.addScaledVector(point, 1 / points.length), new Vector3());

/** Returns where to look at and where to look from, so that all points are seen as near as possible; null without points. */
export function fit(points: readonly Vector3[], from: Vector3, { high, wide }: Angles): View | null {
  if (!points.length) return null;
  const back = from.clone().normalize();
  const right = new Vector3().crossVectors(new Vector3(0, 0, 1), back).normalize();
  const up = new Vector3().crossVectors(back, right);
  const middle = (axis: Vector3) => {
    const along = points.map((point) => point.dot(axis));
    return (Math.min(...along) + Math.max(...along)) / 2;
  };
  const target = new Vector3().addScaledVector(right, middle(right)).addScaledVector(up, middle(up)).addScaledVector(back, middle(back));
  const reach = () => Math.max(0.1, ...points.map((point) => {
    const away = point.clone().sub(target);
    return away.dot(back) + MARGIN * Math.max(Math.abs(away.dot(right)) / wide, Math.abs(away.dot(up)) / high);
  }));
  // Near points spread more, so the eye moves sideways until both sides are equally far from the edges.
  for (let round = 0; round < 3; round++) {
    const distance = reach();
    const shift = (axis: Vector3) => {
      const seen = points.map((point) => {
        const away = point.clone().sub(target);
        return away.dot(axis) / Math.max(0.05, distance - away.dot(back));
      });
      return ((Math.min(...seen) + Math.max(...seen)) / 2) * distance;
    };
    const [aside, higher] = [shift(right), shift(up)];
    target.addScaledVector(right, aside).addScaledVector(up, higher);
  }
  return { target, eye: target.clone().addScaledVector(back, reach()) };
}
