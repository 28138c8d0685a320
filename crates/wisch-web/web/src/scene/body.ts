// The body of a robot that has collision shapes only: casings in its capsules, housings round its joints' axes, and what
// holds the tool. It stays inside the collision shapes, up to what `test/body.test.mjs` allows, so that no gap looks free
// that is not.
import { Box3, BoxGeometry, CapsuleGeometry, Matrix4, SphereGeometry, Vector3, type BufferGeometry } from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import { mergeGeometries, mergeVertices } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { alongAxis, distanceTo, makePatch, turn, Z, type Add, type Finish, type Profile, type Rod, type Shell } from "./shell.ts";
import { geometryOf, matrix } from "./solids.ts";
import { Tree } from "./tree.ts";
import type { Head, JointRecord, MeshRecord, RobotRecord, Solid } from "../recording.ts";

/** The parts of a link by material, in its frame. */
export type Body = Partial<Record<Finish, BufferGeometry>>;

/** A casing's radius at its ends and where it is widest, as shares of the capsule's [1]. */
const END_SHARE = 0.56;
const WIDE_SHARE = 0.82;
/** How far a housing may come out of the collision shapes [m]. */
const OUT_M = 0.005;
/** A housing with less room than this is left out [m]. */
const LEAST_ROOM_M = 0.03;
/** A joint whose axis is this parallel to a capsule turns it about itself [1]. */
const PARALLEL = 0.9;

interface Link {
  index: number;
  /** Its capsules, in its frame; each begins at the end that is nearer to the root. */
  rods: Rod[];
  /** The nearest link with capsules towards the root, and those away from it. */
  before: Link | null;
  after: Link[];
  /** At position 0 of all joints. */
  worldFromLink: Matrix4;
  trunk: boolean;
  /** Joint whose origin is also that of another joint nearer to the root. */
  crossed: boolean;
}

/** Returns the parts of all links. */
export function makeBody({ robot, tool }: Head, meshes: MeshRecord[]): Body[] {
  if (!robot) return [];
  const links = findLinks(robot);
  const holder = links.find((link) => link.rods.length > 0 && findHeld(tool, meshes, robot, links, link));
  return robot.links.map(({ name, arm, shapes }, i) => {
    const parts: Record<Finish, BufferGeometry[]> = { casing: [], joint: [], ring: [], handle: [] };
    const add: Add = (finish, geometry, at) => {
      // A mesh that the recording lacks.
      if (!geometry.hasAttribute("position")) return;
      geometry.deleteAttribute("uv");
      const indexed = geometry.index ? geometry : mergeVertices(geometry);
      parts[finish].push(at ? indexed.applyMatrix4(at) : indexed);
    };
    const link = links[i]!;
    const [rod] = link.rods;
    const near = seenFrom(link, link.before ? [link.before, ...link.after] : link.after);
    const held = findHeld(tool, meshes, robot, links, link);
    const isHand = shapes.length === 1 && !link.after.length && (held !== null || isTwin(link, holder));
    if (rod && !arm && /head/i.test(name)) addHead(add, rod, link.worldFromLink);
    else if (rod && isHand) addGrip(add, rod, held, /left/i.test(name));
    else if (!link.trunk || !addTrunk(add, link)) for (const one of link.rods) addCasing(add, one, near);
    for (const shape of shapes) if (shape.kind !== "capsule") addShape(add, shape, arm ? null : link.worldFromLink, meshes);
    if (link.before) addHousing(add, robot.joints[i - 1]!, link);
    return Object.fromEntries(Object.entries(parts).filter(([, list]) => list.length).map(([finish, list]) => [finish, mergeGeometries(list)]));
  });
}

/** Whether a link is the other arm's end: as far from the root as the one that holds the tool, and of the same size. */
function isTwin(link: Link, holder: Link | undefined): boolean {
  const measure = (one: Link | null | undefined): string => (one ? `${one.rods.map(({ from, to, radius }) => [from.distanceTo(to), radius].map((size) => size.toFixed(3)))} ${measure(one.before)}` : "");
  return holder !== undefined && measure(link) === measure(holder);
}

const inverse = (pose: Matrix4) => pose.clone().invert();
const moved = (rods: readonly Rod[], by: Matrix4): Rod[] => rods.map(({ from, to, radius }) => ({ from: from.clone().applyMatrix4(by), to: to.clone().applyMatrix4(by), radius }));

/** Returns the capsules of other links in the frame of a link, at position 0 of all joints. */
const seenFrom = ({ worldFromLink }: Pick<Link, "worldFromLink">, others: readonly Link[]): Rod[] => others.flatMap(({ rods, worldFromLink: worldFromOther }) => moved(rods, inverse(worldFromLink).multiply(worldFromOther)));

function findLinks(robot: RobotRecord): Link[] {
  const tree = new Tree(robot.joints);
  tree.update([0, 0, 0, 0, 0, 0, 1], []);
  const links: Link[] = [];
  robot.links.forEach(({ arm, shapes }, index) => {
    const joint = robot.joints[index - 1];
    const parent = joint ? links[joint.parent]! : null;
    const before = parent && (parent.rods.length ? parent : parent.before);
    const worldFromLink = tree.worldFromLink[index]!;
    const rods = shapes.flatMap((shape) => (shape.kind === "capsule" ? [rodOf(shape)] : []));
    // A capsule begins at the end that is nearer to those before it.
    const ends = before ? seenFrom({ worldFromLink }, [before]).flatMap(({ from, to }) => [from, to]) : [new Vector3()];
    const away = (point: Vector3) => Math.min(...ends.map((end) => end.distanceTo(point)));
    for (const rod of rods) if (away(rod.to) < away(rod.from) - 1e-6) [rod.from, rod.to] = [rod.to, rod.from];
    const place = new Vector3().setFromMatrixPosition(worldFromLink);
    const crossed = parent !== null && before !== parent && place.distanceTo(new Vector3().setFromMatrixPosition(parent.worldFromLink)) < 1e-3 && !isRoll(robot.joints[parent.index - 1]!, parent);
    const link = { index, rods, before, after: [], worldFromLink, trunk: !arm && rods.length > 0 && (rods.length > 1 || !before), crossed };
    if (rods.length) before?.after.push(link);
    links.push(link);
  });
  return links;
}

function rodOf({ pose, length, radius }: Extract<Solid, { length: number }>): Rod {
  const linkFromShape = matrix(pose);
  const [from, to] = [-length / 2, length / 2].map((z) => new Vector3(0, 0, z).applyMatrix4(linkFromShape));
  return { from: from!, to: to!, radius };
}

/** Returns how the tool looks from the frame of a link, if that link or one fixed to it carries the tool. */
function findHeld(tool: Head["tool"], meshes: MeshRecord[], { joints }: RobotRecord, links: Link[], link: Link): Held | null {
  let index = tool.link ?? 0;
  while (index > link.index && joints[index - 1]!.kind === "fixed") index = joints[index - 1]!.parent;
  if (tool.link === null || index !== link.index) return null;
  const carrier = links[tool.link]!;
  const linkFromTool = inverse(link.worldFromLink).multiply(carrier.worldFromLink).multiply(matrix(tool.solid.pose));
  const geometry = geometryOf(tool.solid, meshes);
  geometry.computeBoundingBox();
  const box = geometry.boundingBox!;
  const size = box.getSize(new Vector3());
  const narrow = size.x <= size.y ? "x" : "y";
  const axis = (name: "x" | "y" | "z") => new Vector3().setComponent("xyz".indexOf(name), 1).transformDirection(linkFromTool);
  return {
    back: box.getCenter(new Vector3()).setZ(box.max.z).applyMatrix4(linkFromTool),
    normal: axis("z"), side: axis(narrow), sizes: narrow === "x" ? [size.x, size.y] : [size.y, size.x],
  };
}

/** Adds a casing with a ring. `near`: capsules of the links beside it. */
function addCasing(add: Add, { from, to, radius }: Rod, near: readonly Rod[]): void {
  const way = to.clone().sub(from);
  const half = way.length() / 2;
  const at = alongAxis(half > 0 ? way : new Vector3(0, 0, 1), from.clone().lerp(to, 0.5));
  // Widest at a third, and slim at both ends, where the joints' housings are; a short one is not slim.
  const slim = Math.min(1, (2 * half) / radius);
  const radiusAt = (share: number) => radius * (WIDE_SHARE - (WIDE_SHARE - END_SHARE) * slim * (1 - Math.sin(Math.PI * Math.min(1, Math.max(0, share)) ** 0.7) ** 0.8) - 0.06 * share);
  // It reaches as far as its capsule where the next capsule begins beyond its end.
  const reaches = (end: -1 | 1) => {
    const [tip, out] = end > 0 ? [to, way] : [from, way.clone().negate()];
    const [next] = near.flatMap((rod) => [rod.from, rod.to]).sort((a, b) => a.distanceTo(tip) - b.distanceTo(tip));
    return next !== undefined && next.clone().sub(tip).dot(out) > 0.3 * radius * out.length();
  };
  const cap = (end: -1 | 1, r: number) => Array.from({ length: 4 }, (_, i): Profile[number] => {
    const angle = (Math.PI / 2) * (end < 0 ? i / 4 : 1 - (i + 1) / 4);
    return [r * Math.sin(angle), end * (half + (reaches(end) ? 0.95 * radius : 0.6 * r) * Math.cos(angle))];
  });
  const profile = [...cap(-1, radiusAt(0)), ...Array.from({ length: 15 }, (_, i): Profile[number] => [radiusAt(i / 14), half * (i / 7 - 1)]), ...cap(1, radiusAt(1))];
  add("casing", turn(profile), at);
  if (half < 0.25 * radius) return;
  const [a, b] = [0.16, 0.16 + (0.06 * radius) / (2 * half)];
  const ring = [a, b].map((share): Profile[number] => [radiusAt(share) + 0.02 * radius, half * (2 * share - 1)]);
  add("ring", turn([[radiusAt(a), ring[0]![1]], ring[0]!, ring[0]!, ring[1]!, ring[1]!, [radiusAt(b), ring[1]![1]]]), at);
}

const isRoll = ({ axis }: JointRecord, link: Link) => seatOf(new Vector3(...axis), link) !== null;

/** Returns where a collar sits on the axis of a joint that turns a capsule about itself; null for other joints. */
function seatOf(axis: Vector3, link: Link): { z: number; radius: number } | null {
  const { rods, before } = link;
  const own = rods.find(({ from, to, radius }) => Math.abs(to.clone().sub(from).normalize().dot(axis)) > PARALLEL && from.clone().cross(axis).length() < 0.3 * radius);
  if (own) return { z: own.from.dot(axis) + Math.sign(own.to.clone().sub(own.from).dot(axis)) * -0.1 * own.radius, radius: 0.7 * own.radius };
  if (!before || before.trunk) return null;
  for (const { from, to, radius } of seenFrom(link, [before])) {
    const way = to.clone().sub(from).normalize().dot(axis);
    // Where the link's origin is far from the capsule, the next one meets it at its end.
    const [inwards, share] = to.length() > 1.5 * radius ? [-0.45, 0.56] : [0.55, 0.64];
    if (Math.abs(way) > PARALLEL) return { z: to.dot(axis) - Math.sign(way) * inwards * radius, radius: share * radius };
  }
  return null;
}

/** Adds what shows a joint: a collar where it turns its link about itself, else a drum about its axis. */
function addHousing(add: Add, joint: JointRecord, link: Link): void {
  if (joint.kind !== "revolute") return;
  const axis = new Vector3(...joint.axis).normalize();
  const seat = seatOf(axis, link);
  if (seat) {
    const [r, w] = [seat.radius * 1.06, 0.13 * seat.radius];
    add("joint", turn([[0, -w], [r * 0.94, -w], [r, -0.6 * w], [r, 0.6 * w], [r * 0.94, w], [0, w]]), alongAxis(axis, axis.clone().multiplyScalar(seat.z)));
    return;
  }
  const near = seenFrom(link, [link.before!, ...(link.rods.length ? [] : link.after)]);
  const { room, along } = findRoom(axis, [...near, ...link.rods]);
  if (room < LEAST_ROOM_M) return;
  addAxle(add, axis, findRoom(axis, near), findRoom(axis, link.rods));
  const reach = room + OUT_M;
  // Where two axes cross, the second drum is thinner and longer.
  const [r, h] = link.crossed ? [0.6 * reach, 0.79 * reach] : [0.76 * reach, 0.64 * reach];
  addDrum(add, alongAxis(axis, axis.clone().multiplyScalar(along)), r, h);
}

/** Adds a drum about z with a ring and a light cap at both ends. */
function addDrum(add: Add, at: Matrix4, r: number, h: number): void {
  const below = (profile: Profile): Profile => profile.map(([radius, z]) => [radius, -z]);
  const side: Profile = [[0.66 * r, h], [0.66 * r, h], [0.88 * r, h], [0.88 * r, h], [r, h - 0.12 * r], [r, h - 0.12 * r]];
  const disc: Profile = [[0, h - 0.1 * r], [0.5 * r, h - 0.1 * r], [0.58 * r, h - 0.05 * r], [0.58 * r, h - 0.05 * r], [0.6 * r, h - 0.2 * r]];
  const rim: Profile = [[0.6 * r, h - 0.2 * r], [0.6 * r, h], [0.6 * r, h], [0.7 * r, h + 0.012 * r], [0.7 * r, h + 0.012 * r], [0.72 * r, h - 0.05 * r]];
  add("joint", turn([...below(side), ...side.toReversed()], 28), at);
  for (const [finish, profile] of [["casing", disc], ["ring", rim]] as const) {
    add(finish, turn(below(profile)), at);
    add(finish, turn(profile.toReversed()), at);
  }
}

interface Room {
  room: number;
  along: number;
}

/** Returns the place on an axis with the most room inside capsules [m], if the joint's origin lacks it. */
function findRoom(axis: Vector3, rods: readonly Rod[]): Room {
  const roomAt = (along: number) => Math.max(-1, ...rods.map((rod) => -distanceTo(rod, along * axis.x, along * axis.y, along * axis.z)));
  const best = { room: roomAt(0), along: 0 };
  for (let along = -0.3; along <= 0.3; along += 0.01) if (roomAt(along) > best.room / 0.75 + 1e-3) Object.assign(best, { room: roomAt(along), along });
  return best;
}

/** Adds an axle between two links that lie beside each other on their joint's axis and almost touch. */
function addAxle(add: Add, axis: Vector3, one: Room, other: Room): void {
  const length = Math.abs(one.along - other.along);
  const least = Math.min(one.room, other.room);
  if (least < LEAST_ROOM_M || length < least || length > one.room + other.room + OUT_M) return;
  const r = 0.5 * least;
  add("joint", turn([[r, -length / 2], [r, length / 2]]), alongAxis(axis, axis.clone().multiplyScalar((one.along + other.along) / 2)));
}

/** Returns a shell round capsules, cut to shares of the box around them. `edge`: radius of its edges, as a share of its least size. */
function shellOf(rods: readonly Rod[], worldFromLink: Matrix4, shares: [number, number, number], edge: number): Shell {
  const linkFromShell = new Matrix4().extractRotation(inverse(worldFromLink));
  const turned = moved(rods, inverse(linkFromShell));
  const box = new Box3();
  for (const { from, to, radius } of turned) for (const end of [from, to]) box.expandByPoint(end.clone().addScalar(radius)).expandByPoint(end.clone().addScalar(-radius));
  const middle = box.getCenter(new Vector3());
  const half = box.getSize(new Vector3()).multiplyScalar(0.5).multiply(new Vector3(...shares));
  return {
    linkFromShell: linkFromShell.clone().setPosition(middle.clone().applyMatrix4(linkFromShell)), box: half, edge: edge * Math.min(half.x, half.y, half.z),
    rods: moved(turned, new Matrix4().makeTranslation(middle.negate())),
  };
}

type Panel = [azimuths: [number, number], heights: [number, number]];
const ROUND: [number, number] = [-Math.PI, Math.PI];
/** Azimuths of a panel in front, and of the one behind with a gap on both sides [rad]. */
const inFront = (width: number): [number, number] => [-width, width];
const behind = (width: number): [number, number] => [width + 0.04, 2 * Math.PI - width - 0.04];

/** Adds a dark shell, and light panels on it with gaps between them. */
function addPanels(add: Add, shell: Shell, panels: readonly Panel[], depth: number): void {
  add("joint", makePatch(shell, depth, ROUND, [-1, 1], Math.PI / 12));
  for (const [azimuths, heights] of panels) add("casing", makePatch(shell, 0, azimuths, heights, Math.PI / 15));
}

/** Adds a base or a chest, whose foot stays dark; returns whether the shapes surround their middle, as a shell must. */
function addTrunk(add: Add, { rods, worldFromLink }: Link): boolean {
  const shell = shellOf(rods, worldFromLink, [0.94, 0.9, 0.95], 0.5);
  if (!shell.rods.some((rod) => distanceTo(rod, 0, 0, 0) < -0.5 * rod.radius)) return false;
  addPanels(add, shell, [[inFront(0.75), [-0.62, 0.5]], [behind(0.75), [-0.62, 0.5]], [ROUND, [0.53, 1]]], 0.008);
  return true;
}

/** Adds a head with a dark visor and two cameras. */
function addHead(add: Add, rod: Rod, worldFromLink: Matrix4): void {
  const r = rod.radius;
  const shell = shellOf([rod], worldFromLink, [0.84, 0.72, 0.8], 0.62);
  addPanels(add, shell, [[ROUND, [0.5, 1]], [behind(0.95), [-0.3, 0.48]], [ROUND, [-1, -0.32]]], 0.01);
  for (const side of [-0.26, 0.26]) {
    const eye = new Vector3(shell.box.x - 0.012, side * r, 0.12 * r).applyMatrix4(shell.linkFromShell);
    add("ring", turn([[0.13 * r, -0.01], [0.13 * r, 0], [0.1 * r, 0.008], [0, 0.009]], 18), alongAxis(new Vector3(1, 0, 0).transformDirection(shell.linkFromShell), eye));
  }
}

/** Adds a shape other than a capsule. A sphere that rests on the floor is drawn as a wheel, which lies inside; `worldFromLink` is null for arms. */
function addShape(add: Add, shape: Solid, worldFromLink: Matrix4 | null, meshes: MeshRecord[]): void {
  const isOnFloor = (radius: number) => Math.abs(new Vector3().setFromMatrixPosition(matrix(shape.pose)).applyMatrix4(worldFromLink!).z - radius) < 0.1 * radius;
  if (shape.kind !== "sphere" || !worldFromLink || !isOnFloor(shape.radius)) return add("casing", geometryOf(shape, meshes).clone(), matrix(shape.pose));
  const axis = new Vector3(0, 1, 0).transformDirection(inverse(worldFromLink));
  addDrum(add, alongAxis(axis, new Vector3().setFromMatrixPosition(matrix(shape.pose))), 0.9 * shape.radius, 0.42 * shape.radius);
}

// The end of an arm: a hand with fingers round the handle of the tool, or, where there is no room for one, a gripper's jaws.

/** The tool as a hand sees it: the middle of its back, its normal away from the surface, its narrower side, and the sides' lengths [m]. */
interface Held {
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
function addGrip(add: Add, rod: Rod, held: Held | null, left: boolean): void {
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
const between = (from: Vector3, to: Vector3) => alongAxis(to.clone().sub(from), from.clone().lerp(to, 0.5));

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
    put("casing", turn([[0, -half], [0.85 * r, 0.35 * r - half], [r, 0.6 * r - half], [r, tip - 0.5 * r], [0.8 * r, tip - 0.1 * r], [0, tip]], 12), between(before, joint));
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
  put("handle", turn([[0.075 * r, -bar.distanceTo(on) / 2], [0.075 * r, bar.distanceTo(on) / 2]], 12), between(bar, on));
}
