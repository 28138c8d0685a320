// The 3-D scene at the time of the clock, drawn only when something changes.
import {
  AmbientLight, Box3, Color, DirectionalLight, GridHelper, Group, HemisphereLight, Material, Mesh, MeshLambertMaterial,
  MeshStandardMaterial, Object3D, PlaneGeometry, SRGBColorSpace, Scene, ShadowMaterial, Sphere, Vector3,
} from "three";
import { frames } from "../frames.ts";
import { colour, theme } from "../theme.ts";
import type { BufferGeometry } from "three";
import { Asked } from "./asked.ts";
import type { ShownParticles } from "./asked.ts";
import { Camera } from "./camera.ts";
import type { Look } from "./camera.ts";
import { Dirt } from "./dirt.ts";
import type { Mark } from "./dirt.ts";
import { Force } from "./force.ts";
import { LineMaterial, segments } from "./lines.ts";
import { Marks } from "./marks.ts";
import { Painter } from "./painter.ts";
import { Axes, Path, Trajectories, hexOr } from "./path.ts";
import type { ShownFrame, Trajectory } from "./path.ts";
import { Robot, ghostMaterial } from "./robot.ts";
import type { RobotMaterials } from "./robot.ts";
import { Still } from "./surface.ts";
import type { Round } from "../round.ts";
import type { Rgba } from "../recording.ts";
import type { Instant, Recording } from "../store.ts";

export type Layers = Record<Mark | "path" | "strokes" | "force" | "events" | "found" | "actualSurface", boolean>;
export const LAYERS: Layers = {
  believed: true, estimated: true, actual: true, seen: false, path: true, strokes: false, force: true, events: true, found: true, actualSurface: true,
};

/** The robot at a time of the common clock [s], drawn translucent. */
export interface Ghost {
  time: number;
  color?: string;
}

/** Maximum distance of a click from the path [pixels]. */
const NEAR_PX = 9;
/** Number of rounds whose geometry is cached. */
const KEPT_ROUNDS = 6;

/** Direction to the light, in units of the scene's radius. */
const SUN = new Vector3(0.9, 0.5, 1.9);

export class Stage {
  readonly layers: Layers = { ...LAYERS };
  readonly camera: Camera;
  private readonly painter: Painter;
  private readonly scene = new Scene();
  private readonly materials: RobotMaterials & Record<string, unknown>;
  /** The floor, which receives shadows. */
  private readonly ground = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.14 }));
  private sun: DirectionalLight | null = null;
  private grid: GridHelper | null = null;
  private robot: Robot | null = null;
  private readonly ghosts = new Group();
  private ghostList: Ghost[] = [];
  private still: Still | null = null;
  private path: Path | null = null;
  private readonly entered = new Map<Round, { still: Still; path: Path }>();
  private highlighted: { from: number; to: number }[] = [];
  private readonly highlights = new Group();
  private readonly highlightLook = new LineMaterial({ linewidth: 8, transparent: true, opacity: 0.75, depthWrite: false });
  private readonly trajectories = new Trajectories();
  private readonly axes = new Axes();
  private readonly dirt = new Dirt();
  private readonly asked = new Asked();
  private readonly force = new Force();
  private readonly marks = new Marks();
  private home: { all: Vector3[]; surface: Vector3[]; from: Vector3 } | null = null;
  private sized = false;
  private readonly moved = () => this.draw();
  private time = 0;
  /** Number of drawn frames, for measurements. */
  drawn = 0;

  /** Number of drawn ghosts, for measurements. */
  get ghostCount(): number {
    return this.ghosts.children.length;
  }

  constructor(private readonly canvas: HTMLCanvasElement, private readonly recording: Recording) {
    this.painter = new Painter(canvas);
    const matte = (roughness: number) => (this.painter.software ? new MeshLambertMaterial() : new MeshStandardMaterial({ roughness, metalness: 0.05 }));
    // The round ends of adjacent links coincide; a depth offset of one shade prevents flicker.
    const under = (roughness: number) => Object.assign(matte(roughness), { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 });
    const hand = Object.assign(matte(0.5), { transparent: true, opacity: 0.45, depthWrite: false });
    const own = new Map<string, Material>();
    const coloured = (rgba: Rgba): Material => {
      const [red, green, blue, opacity] = rgba;
      const known = own.get(rgba.join());
      if (known) return known;
      const material = Object.assign(matte(0.5), opacity < 1 ? { transparent: true, opacity, depthWrite: false } : {});
      material.color.setRGB(red, green, blue, SRGBColorSpace);
      own.set(rgba.join(), material);
      return material;
    };
    this.materials = { body: [matte(0.6), under(0.6)], arm: [matte(0.5), under(0.5)], hand, tool: new MeshLambertMaterial(), coloured };
    this.scene.add(this.dirt.group, this.asked.group, this.force.group, this.marks.points, this.trajectories.group, this.axes.group, this.highlights, this.ghosts);
    this.camera = new Camera(canvas, () => this.ask());
    canvas.addEventListener("webglcontextrestored", () => this.ask());
    this.paint();
  }

  /** Requests a frame at a time of the clock. */
  show(time: number): void {
    this.time = time;
    this.ask();
  }

  ask(): void {
    frames.draw(this.moved);
  }

  /** Sets the size of the canvas, and the width that a panel covers on its left [pixels]. */
  resize(width: number, height: number, covered: number): void {
    if (!width || !height) return;
    this.painter.size(width, height);
    this.camera.shape(width, height, covered);
    if (!this.sized) this.home = null;
    this.sized = true;
    this.draw();
  }

  look(at: Look): void {
    const instant = this.recording.at(this.time);
    if (!this.home || !instant) return;
    this.camera.following = false;
    if (at === "above") this.camera.look(this.home.surface, new Vector3(0, -1e-3, 1));
    else this.camera.look(this.home[at], this.home.from);
    this.ask();
  }

  /** Returns the time of the common clock at which the tool was at a point of the canvas; null if its path is not near. */
  timeAt(x: number, y: number): number | null {
    if (!this.path || !this.layers.path) return null;
    const { clientWidth, clientHeight } = this.canvas;
    const time = this.path.nearest((place) => {
      place.project(this.camera.lens);
      return { x: ((place.x + 1) / 2) * clientWidth, y: ((1 - place.y) / 2) * clientHeight };
    }, x, y, this.time - this.path.round.start, NEAR_PX);
    return time === null ? null : this.path.round.start + time;
  }

  set follow(wanted: boolean) {
    this.camera.following = wanted;
    if (wanted && this.home && this.robot) {
      const away = this.camera.lens.position.clone().sub(this.camera.controls.target).setLength(0.7);
      this.camera.controls.target.copy(this.robot.toolPlace);
      this.camera.lens.position.copy(this.robot.toolPlace).add(away);
      this.camera.controls.update();
    }
    this.ask();
  }

  highlight(intervals: { start: number; end: number }[]): void {
    this.highlighted = intervals.map(({ start, end }) => ({ from: start, to: end }));
    this.drawHighlights();
    this.ask();
  }

  showTrajectories(list: Trajectory[]): void {
    this.trajectories.show(list);
    this.ask();
  }

  showParticles(list: ShownParticles[]): void {
    this.asked.show(list);
    this.ask();
  }

  showFrames(list: ShownFrame[]): void {
    this.axes.show(list);
    this.ask();
  }

  showGhosts(list: Ghost[]): void {
    this.ghostList = list;
    this.ghosts.clear();
    const { head, meshes } = this.recording;
    if (head && this.robot) {
      for (const { time, color } of list) {
        const instant = this.recording.at(time);
        if (!instant) continue;
        const look = ghostMaterial();
        look.color.set(hexOr(color, colour("ghost")));
        const ghost = new Robot(head, meshes, { body: [look, look], arm: [look, look], hand: look, tool: look, coloured: () => look }, this.robot);
        ghost.show(instant.round.plan.root, instant.q, instant.tool);
        this.ghosts.add(ghost.group);
      }
    }
    this.ask();
  }

  paint(): void {
    const set = (material: Material, name: string) => (material as MeshStandardMaterial).color.set(colour(name));
    const { body, arm, hand, tool } = this.materials;
    set(body[0], "body-1"); set(body[1], "body-2"); set(arm[0], "arm-1"); set(arm[1], "arm-2");
    set(hand, "arm-1"); set(tool, "tool");
    this.painter.paint();
    this.showGhosts(this.ghostList);
    this.highlightLook.color.set(colour("highlight"));
    if (this.grid) (this.grid.material as Material & { color: Color }).color.set(colour("rule"));
    this.dirt.paint();
    this.asked.paint();
    this.force.paint();
    for (const { still, path } of this.entered.values()) {
      still.paint();
      path.paint();
    }
    this.ask();
  }

  /** Returns the current frame as a PNG data URL, for printing. */
  picture(): string {
    this.draw(true);
    return this.canvas.toDataURL("image/png");
  }

  destroy(): void {
    frames.drop(this.moved);
    this.camera.controls.dispose();
    for (const { still, path } of this.entered.values()) {
      still.dispose();
      path.dispose();
    }
    this.painter.destroy();
  }

  private draw(resting = !this.painter.software): void {
    const instant = this.recording.at(this.time);
    if (!this.sized) return;
    if (instant) this.place(instant);
    if (this.sun) this.sun.castShadow = this.ground.visible = this.painter.shadows;
    this.painter.draw(this.scene, this.camera.lens, resting, () => this.draw(true));
    this.drawn++;
  }

  private place(instant: Instant): void {
    const { head, meshes } = this.recording;
    const { round, time } = instant;
    if (!this.robot && head) {
      this.robot = new Robot(head, meshes, this.materials);
      this.scene.add(this.robot.group);
      this.showGhosts(this.ghostList);
    }
    if (this.still?.round !== round) this.enter(instant);
    this.robot?.show(round.plan.root, instant.q, instant.tool);
    if (!this.home) this.initView(instant);
    const stroke = instant.phase >= 0 ? round.plan.phases[instant.phase]!.stroke : null;
    this.still!.show({ strokes: this.layers.strokes, found: this.layers.found, actual: this.layers.actualSurface }, stroke);
    this.camera.follow(this.robot?.toolPlace ?? null);
    this.path!.show(time, this.layers.path);
    this.dirt.scale(this.camera.pixelsPerMetre(this.still!.surface, this.canvas.clientHeight));
    this.dirt.show(this.recording, this.time, instant, this.layers);
    this.marks.show(this.recording, round, time, this.layers.events, theme());
    if (this.robot) this.force.show(instant, this.robot.toolPlace, this.camera.lens.position, this.layers.force);
  }

  /** Switches to another round; the geometry of recent rounds stays cached. */
  private enter({ round }: Instant): void {
    for (const object of [this.still?.group, this.path?.object]) if (object) this.scene.remove(object);
    const kept = this.entered.get(round) ?? { still: new Still(round, this.recording.meshes), path: new Path(round) };
    this.entered.delete(round);
    this.entered.set(round, kept);
    for (const [oldest, { still, path }] of this.entered) {
      if (this.entered.size <= KEPT_ROUNDS) break;
      this.entered.delete(oldest);
      still.dispose();
      path.dispose();
    }
    this.still = kept.still;
    this.path = kept.path;
    this.scene.add(this.still.group, this.path.object);
    this.drawHighlights();
  }

  private drawHighlights(): void {
    for (const line of [...this.highlights.children]) {
      (line as ReturnType<typeof segments>).geometry.dispose();
      this.highlights.remove(line);
    }
    if (!this.path) return;
    const { start } = this.path.round;
    const ends = this.highlighted.flatMap(({ from, to }) => this.path!.between(from - start, to - start));
    if (ends.length) this.highlights.add(segments(ends, this.highlightLook));
  }

  /** Chooses the first view, and builds floor and lights around the scene. */
  private initView({ round }: Instant): void {
    const contact = round.plan.phases.find((phase) => phase.contact);
    const then = this.recording.at(round.start + (contact?.start ?? 0));
    if (then && this.robot) this.robot.show(round.plan.root, then.q, then.tool);
    const shown = [this.robot?.group, this.still?.surface].filter((object): object is Group | Mesh => Boolean(object));
    const near = [this.still?.surface].filter((object): object is Mesh => Boolean(object));
    const all = this.cornersOf(shown);
    const work = this.cornersOf([...(this.robot?.working ?? []), ...near]);
    const surface = this.cornersOf(near.length ? near : shown);
    this.home = { all, surface, from: this.frontOf(round.plan.root ? then : null) };
    if (!this.grid) this.build(new Box3().setFromPoints(all).getBoundingSphere(new Sphere()));
    if (this.robot) {
      const now = this.recording.at(this.time);
      if (now) this.robot.show(round.plan.root, now.q, now.tool);
    }
    this.camera.look(work, this.home.from);
  }

  /** Returns a direction of view from the far side of the surface, on the side of the wiping arm. */
  private frontOf(instant: Instant | null): Vector3 {
    const robot = this.recording.head?.robot;
    if (!instant || !robot || !instant.q.length || !this.robot) return new Vector3(0.75, -1, 0.85);
    const base = this.robot.linkPlace(Math.max(0, robot.links.findIndex(({ shapes }) => shapes.length)));
    const way = this.robot.toolPlace.sub(base).setZ(0);
    if (way.length() < 1e-3) way.set(1, 0, 0);
    const arm = robot.links.findIndex((link) => link.arm);
    const aside = arm < 0 ? new Vector3() : this.robot.linkPlace(arm).sub(base);
    const left = way.x * aside.y - way.y * aside.x > 1e-6;
    return way.normalize().applyAxisAngle(new Vector3(0, 0, 1), left ? 0.95 : -0.95).setZ(0.62).normalize();
  }

  /** Returns the corners of the bounding boxes of all meshes in `objects`, in the world [m]. */
  private cornersOf(objects: Object3D[]): Vector3[] {
    this.scene.updateMatrixWorld(true);
    const places: Vector3[] = [];
    const add = (object: Object3D) => {
      if (!object.visible) return;
      if (object instanceof Mesh) {
        const geometry = object.geometry as BufferGeometry;
        geometry.computeBoundingBox();
        const { min, max } = geometry.boundingBox!;
        if (min.x <= max.x) {
          for (let k = 0; k < 8; k++) places.push(new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z).applyMatrix4(object.matrixWorld));
        }
      }
      object.children.forEach(add);
    };
    objects.forEach(add);
    return places.length ? places : [new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 0.5)];
  }

  private build({ center, radius }: Sphere): void {
    const cells = 2 * Math.min(60, Math.max(6, Math.ceil(3 * radius)));
    this.grid = new GridHelper(cells / 2, cells);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.set(Math.round(center.x), Math.round(center.y), 0);
    Object.assign(this.grid.material, { vertexColors: false, transparent: true, opacity: 0.7 });
    (this.grid.material as Material & { color: Color }).color.set(colour("rule"));
    this.ground.scale.setScalar(cells / 2);
    this.ground.position.set(this.grid.position.x, this.grid.position.y, -0.001);
    this.ground.receiveShadow = true;
    const sun = new DirectionalLight(0xffffff, 2.0);
    sun.position.copy(center).addScaledVector(SUN, 2 * radius);
    sun.target.position.copy(center);
    this.sun = sun;
    sun.shadow.mapSize.set(this.painter.shadowSize, this.painter.shadowSize);
    sun.shadow.bias = -0.0005;
    sun.shadow.normalBias = 0.01;
    sun.shadow.intensity = 0.6;
    Object.assign(sun.shadow.camera, {
      left: -1.4 * radius, right: 1.4 * radius, top: 1.4 * radius, bottom: -1.4 * radius, near: 0.1, far: 9 * radius,
    });
    this.scene.add(this.grid, this.ground, sun, sun.target, new HemisphereLight(0xffffff, 0x8a8f98, 1.7), new AmbientLight(0xffffff, 0.35));
    for (const [axis, name] of [[[1, 0, 0], "axis-x"], [[0, 1, 0], "axis-y"], [[0, 0, 1], "axis-z"]] as const) {
      const material = new LineMaterial({ linewidth: 2.5 });
      material.color.set(colour(name));
      this.scene.add(segments([0, 0, 0.002, ...axis.map((v) => 0.25 * v)], material));
    }
  }
}
