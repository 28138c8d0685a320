// The end of an arm: a hand with fingers round the handle of the tool, or, where there is no room for one, a gripper's jaws.
import { BoxGeometry, CapsuleGeometry, Matrix4, SphereGeometry, Vector3 } from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import { alongAxis, turn, Z, type Add, type Rod } from "./shell.ts";

/** The tool as a hand sees it: the middle of its back, its normal away from the surface, its narrower side, and the sides' lengths [m]. */
export interface Held {
  back: Vector3;
  normal: Vector3;
  side: Vector3;
  sizes: [narrow: number, wide: number];
}

/** A hand fits between the last shape and a tool at least this many radii away [1]. */
const ROOM_FOR_HAND = 0.8;
/** Angles of a finger's joints round a handle, and of one that holds nothing [degrees]; 0 is the palm, 90 ahead. */
const CLOSED = [15, 85, 155, 225];
const OPEN = [8, 40, 72, 104];
const THUMB = [-30, -95, -160];

const block = (...[x, y, z, edge]: [number, number, number, number]) => new RoundedBoxGeometry(x, y, z, 2, edge);

/** Adds what holds a tool, or an empty hand, at the end of an arm; all lengths are shares of the capsule's radius. */
export function addGrip(add: Add, rod: Rod, held: Held | null, left: boolean): void {
  const way = rod.to.clone().sub(rod.from);
  const ahead = way.lengthSq() > 0 ? way.normalize() : Z.clone();
  const far = held ? held.back.clone().sub(rod.to).dot(ahead) : Infinity;
  const handy = far > ROOM_FOR_HAND * rod.radius;
  // The palm lies on the side to which the tool's back faces; the jaws, at its narrower sides.
  const wanted = held ? (handy ? held.normal : held.side).clone() : new Vector3(1, 0, 0);
  const side = wanted.addScaledVector(ahead, -wanted.dot(ahead));
  if (side.lengthSq() < 1e-4) side.set(ahead.y, ahead.z, ahead.x).cross(ahead);
  side.normalize();
  const frame = new Matrix4().makeBasis(side, ahead.clone().cross(side), ahead).setPosition(rod.to);
  const put: Add = (finish, geometry, at = new Matrix4()) => add(finish, geometry, frame.clone().multiply(at));
  const length = rod.to.distanceTo(rod.from);
  if (handy) addHand(put, rod.radius, length, held !== null, left);
  else addGripper(put, rod.radius, length, far, held!.sizes[0] / 2);
  if (held) addHandle(put, handy, rod.radius, held, frame);
}

const at = (x: number, y: number, z: number) => new Matrix4().makeTranslation(x, y, z);
const link = (from: Vector3, to: Vector3) => alongAxis(to.clone().sub(from), from.clone().lerp(to, 0.5));

function addHand(put: Add, r: number, length: number, holds: boolean, left: boolean): void {
  const [start, end] = [-length - 1.05 * r, -0.62 * r];
  put("casing", turn([[0, start], [0.36 * r, start], [0.42 * r, start + 0.1 * r], [0.42 * r, start + 0.3 * r], [0.33 * r, end - 0.25 * r], [0.3 * r, end], [0, end]], 24));
  put("joint", turn([[0.3 * r, end - 0.32 * r], [0.37 * r, end - 0.3 * r], [0.37 * r, end - 0.14 * r], [0.3 * r, end - 0.12 * r]], 24));
  put("ring", turn([[0.4 * r, start + 0.34 * r], [0.435 * r, start + 0.34 * r], [0.43 * r, start + 0.4 * r], [0.39 * r, start + 0.4 * r]], 24));
  put("casing", block(0.27 * r, 1.02 * r, 1.25 * r, 0.11 * r), at(0.29 * r, 0, -0.06 * r));
  put("joint", block(0.1 * r, 0.8 * r, 0.8 * r, 0.04 * r), at(0.41 * r, 0, -0.1 * r));
  const [angles, reach] = holds ? [CLOSED, 0.25 * r] : [OPEN, 0.42 * r];
  const middle = new Vector3(holds ? 0 : -0.12 * r, 0, (holds ? 0.45 : 0.3) * r);
  for (const y of [-0.385, -0.14, 0.14, 0.385]) addFinger(put, angles, reach, middle.clone().setY(y * r), 0.088 * r);
  addFinger(put, THUMB, reach, middle.clone().setY((left ? -0.3 : 0.3) * r), 0.1 * r);
}

function addFinger(put: Add, angles: readonly number[], reach: number, middle: Vector3, radius: number): void {
  const joints = angles.map((degrees) => {
    const angle = (degrees * Math.PI) / 180;
    return new Vector3(Math.cos(angle), 0, Math.sin(angle)).multiplyScalar(reach).add(middle);
  });
  joints.slice(1).forEach((joint, i) => {
    const before = joints[i]!;
    const [half, r] = [before.distanceTo(joint) / 2, radius * (1 - 0.06 * i)];
    const tip = i === joints.length - 2 ? half + 0.6 * r : half - 0.35 * r;
    put("casing", turn([[0, -half], [0.85 * r, 0.35 * r - half], [r, 0.6 * r - half], [r, tip - 0.5 * r], [0.8 * r, tip - 0.1 * r], [0, tip]], 12), link(before, joint));
    put("joint", new SphereGeometry(0.98 * r, 10, 6), at(before.x, before.y, before.z));
  });
}

function addGripper(put: Add, r: number, length: number, far: number, half: number): void {
  const start = -length - 0.9 * r;
  put("casing", turn([[0, start], [0.8 * r, start], [0.84 * r, start + 0.08 * r], [0.84 * r, -0.2 * r], [0.76 * r, -0.12 * r], [0, -0.12 * r]], 28));
  put("ring", turn([[0.84 * r, -0.5 * r], [0.88 * r, -0.48 * r], [0.88 * r, -0.36 * r], [0.84 * r, -0.34 * r]], 28));
  put("joint", block(1.5 * r, 0.86 * r, 0.42 * r, 0.08 * r), at(0, 0, 0.02 * r));
  // The jaws hold the tool by its edges, as far as they may reach out of the capsule.
  const thick = 0.16 * r;
  const wide = 0.3 * r;
  const x = Math.min(half, 0.75 * r) + thick / 2;
  const reach = Math.sqrt(Math.max(0, (r + 0.008) ** 2 - (x + thick / 2) ** 2 - wide ** 2));
  const tip = Math.min(far + 0.012, reach);
  for (const side of [-x, x]) put("casing", new BoxGeometry(thick, 2 * wide, tip - 0.05 * r), at(side, 0, (tip + 0.05 * r) / 2));
}

/** Adds a plate on the tool's back, and, in a hand, the bar that the fingers hold with its stem. */
function addHandle(put: Add, handy: boolean, r: number, { back, normal, side, sizes }: Held, frame: Matrix4): void {
  const inHand = frame.clone().invert();
  const on = back.clone().applyMatrix4(inHand);
  const turned = new Matrix4().extractRotation(inHand);
  const basis = new Matrix4().makeBasis(side.clone().transformDirection(turned), normal.clone().cross(side).transformDirection(turned), normal.clone().transformDirection(turned));
  const thick = 0.006;
  put("handle", new BoxGeometry(0.62 * sizes[0], 0.62 * sizes[1], thick), basis.setPosition(on));
  if (!handy) return;
  const bar = new Vector3(0, 0, 0.45 * r);
  put("handle", new CapsuleGeometry(0.12 * r, 0.98 * r, 4, 14), at(bar.x, bar.y, bar.z));
  put("handle", turn([[0.075 * r, -bar.distanceTo(on) / 2], [0.075 * r, bar.distanceTo(on) / 2]], 12), link(bar, on));
}
