// The 3-D scene at the time of the clock, drawn only when something changes.
import {
  AmbientLight, Box3, DirectionalLight, GridHelper, Group, HemisphereLight, LineBasicMaterial, Material, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  MeshStandardMaterial, PlaneGeometry, SRGBColorSpace, Scene, ShadowMaterial, Sphere, Vector3,
} from "three";
import { frames } from "../frames.ts";
import { colour, theme } from "../theme.ts";
import { Camera } from "./camera.ts";
import { Dirt, type Mark } from "./dirt.ts";
import { Force } from "./force.ts";
import { LineMaterial, segments, setSegments } from "./lines.ts";
import { Marks } from "./marks.ts";
import { Painter } from "./painter.ts";
import { Path } from "./path.ts";
import { hexOr, makeAsked, makeAxes, makeTrajectories, type ShownFrame, type ShownParticles, type Trajectory } from "./queried.ts";
import { BaseMap, RejectedStrokes } from "./reasons.ts";
import { makeGhost, Robot, type RobotMaterials } from "./robot.ts";
import { Shots } from "./shots.ts";
import { disposeAll, paint, release, tint } from "./solids.ts";
import { Still, SurfaceMap } from "./surface.ts";
import { fit } from "./viewpoint.ts";
import type { Round } from "../round.ts";
import type { Rgba } from "../recording.ts";
import type { Interval } from "../timeline/highlights.ts";
import type { Choice } from "../why.ts";
import type { Instant, Recording } from "../store.ts";
import { mapAt } from "../treated.ts";

export type Layers = Record<Mark | "path" | "ribbon" | "strokes" | "rejected" | "bases" | "force" | "events" | "found" | "actualSurface" | "collision", boolean>;
export const LAYERS: Layers = {
  believed: true, estimated: true, actual: true, seen: false, path: true, ribbon: true, strokes: false, rejected: true, bases: false, force: true, events: true, found: true, actualSurface: true, collision: false,
};

/** The robot at a time of the common clock [s], drawn translucent. */
export interface Ghost {
  time: number;
  color?: string;
}

/** Data of a query, shown in addition to the recording. */
export interface Shown {
  trajectories: Trajectory[];
  /** The robot, or the tool where no robot is known, at times. */
  ghosts: Ghost[];
  frames: ShownFrame[];
  particles: ShownParticles[];
  /** Intervals of the common clock, highlighted in the timeline and along the tool's path. */
  intervals: Interval[];
}

export const NOTHING_SHOWN: Shown = { trajectories: [], ghosts: [], frames: [], particles: [], intervals: [] };

export type Look = "all" | "surface" | "above";

/** Maximum distance of a click from the path [pixels]. */
const NEAR_PX = 9;
/** Number of rounds whose geometry is cached. */
const KEPT_ROUNDS = 6;

/** Direction to the light, in units of the scene's radius. */
const SUN = new Vector3(0.9, 0.5, 1.9);
/** Intensities. What lies flat gets just as much light (π) as makes its colour that of the style sheet. */
const SUN_LIGHT = 1.7;
const SKY_LIGHT = 1.4;
const AMBIENT_LIGHT = Math.PI - SKY_LIGHT - (SUN_LIGHT * SUN.z) / SUN.length();

/** Colours of the robot's materials by their names on the page. */
const ROBOT_COLOURS = { body: "body-1", arm: "arm-1", joint: "joint", ring: "ring", handle: "joint", collision: "quiet", tool: "tool" };

export class Stage {
  readonly layers: Layers = { ...LAYERS };
  readonly camera: Camera;
  private readonly painter: Painter;
  private readonly scene = new Scene();
  private readonly materials: RobotMaterials & { own: Map<string, Material> };
  private seeThrough = 0;
  /** The floor, which receives shadows. */
  private readonly ground = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.14 }));
  private sun: DirectionalLight | null = null;
  private grid: GridHelper | null = null;
  private robot: Robot | null = null;
  private readonly ghosts = new Group();
  /** What is shown of the current round, and of the recent ones. */
  private current: { still: Still; path: Path; shots: Shots } | null = null;
  private readonly entered = new Map<Round, NonNullable<Stage["current"]>>();
  private shown = NOTHING_SHOWN;
  private selected: [number, number] | null = null;
  private readonly highlights = segments([], tint(new LineMaterial({ linewidth: 8, transparent: true, opacity: 0.75, depthWrite: false }), "highlight"));
  private readonly queried = new Group();
  private readonly dirt = new Dirt();
  private readonly map = new SurfaceMap();
  private readonly force = new Force();
  private readonly marks = new Marks();
  private readonly rejected = new RejectedStrokes();
  private readonly bases = new BaseMap();
  private choice: Choice | null = null;
  /** Whether the first view is shown, and whether the user chose another; key of the followed shot, null while none is followed. */
  private begun = false;
  private chosen = false;
  private shot: string | null = null;
  private sized = false;
  private apply = () => {};
  private first: number | null = null;
  private readonly moved = () => this.draw();
  private time = 0;
  /** Number of drawn frames, for measurements. */
  drawn = 0;
  /** Is called after each frame, while the canvas still has it. */
  onDrawn: (() => void) | null = null;

  /** `left` is called when the camera stops following because a user moves it. */
  constructor(readonly canvas: HTMLCanvasElement, private readonly recording: Recording, private readonly left: () => void) {
    this.painter = new Painter(canvas);
    const matte = (roughness: number) => (this.painter.software ? new MeshLambertMaterial() : new MeshStandardMaterial({ roughness, metalness: 0.05 }));
    const own = new Map<string, Material>();
    const coloured = (rgba: Rgba): Material => {
      const [red, green, blue, opacity] = rgba;
      const known = own.get(rgba.join());
      if (known) return known;
      const material = Object.assign(matte(0.5), opacity < 1 ? { depthWrite: false } : {});
      material.userData.opacity = opacity;
      material.color.setRGB(red, green, blue, SRGBColorSpace);
      this.clear(material);
      own.set(rgba.join(), material);
      return material;
    };
    this.materials = { body: matte(0.6), arm: matte(0.5), joint: matte(0.45), ring: matte(0.4), handle: matte(0.4), collision: new MeshBasicMaterial({ wireframe: true, transparent: true, opacity: 0.35 }), tool: new MeshLambertMaterial(), coloured, own };
    this.scene.add(this.dirt.group, this.map.mesh, this.force.group, this.marks.group, this.queried, this.highlights, this.ghosts, this.rejected.group, this.bases.group);
    this.camera = new Camera(canvas, () => this.ask(), () => this.leave());
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
    this.apply = () => this.applySize(width, height, covered);
    if (this.sized || !this.painter.software) return this.apply();
    // Without a graphics card the first frame takes long. The texts are shown before it.
    this.first ??= requestAnimationFrame(() => setTimeout(() => { if (this.canvas.isConnected) this.apply(); }));
  }

  private applySize(width: number, height: number, covered: number): void {
    this.painter.size(width, height);
    this.camera.shape(width, height, covered);
    if (!this.chosen) this.begun = false;
    this.sized = true;
    this.draw();
  }

  look(at: Look): void {
    const instant = this.recording.at(this.time);
    const shots = this.current?.shots;
    if (!shots || !instant) return;
    this.shot = null;
    this.chosen = true;
    const points = at === "all" ? [...shots.all(instant.time), ...this.bases.places] : shots.surface();
    this.camera.look(fit(points, at === "above" ? new Vector3(0, -1e-3, 1) : shots.from, this.camera.angles), true);
    this.ask();
  }

  /** Returns the time of the common clock at which the tool was at a point of the canvas; null if its path is not near. */
  timeAt(x: number, y: number): number | null {
    const path = this.current?.path;
    if (!path || !(this.layers.path || this.layers.ribbon)) return null;
    const { clientWidth, clientHeight } = this.canvas;
    const time = path.nearest((place) => {
      place.project(this.camera.lens);
      return { x: ((place.x + 1) / 2) * clientWidth, y: ((1 - place.y) / 2) * clientHeight };
    }, x, y, this.time - path.round.start, NEAR_PX, !this.layers.path);
    return time === null ? null : path.round.start + time;
  }

  /** Whether the camera follows the work: wide in free motion, close at strokes. */
  get follow(): boolean {
    return this.shot !== null;
  }

  set follow(wanted: boolean) {
    this.shot = wanted ? "" : null;
    this.chosen = true;
    this.ask();
  }

  /** Sets the share of light that passes through the robot, in [0, 1]. */
  set xray(share: number) {
    this.seeThrough = share;
    const { body, arm, joint, ring, handle, own } = this.materials;
    for (const material of [body, arm, joint, ring, handle, ...own.values()]) this.clear(material);
    if (this.robot) this.robot.order = share > 0 ? 9 : 0;
    this.ask();
  }

  /** Shows what a reader chose of the plan of a round, while the clock is in that round. */
  choose(choice: Choice | null): void {
    this.choice = choice;
    this.ask();
  }

  /** What a reader chose of the plan of the shown round. */
  private get chosenNow(): Choice | null {
    return this.choice && this.choice.round === this.current?.still.round ? this.choice : null;
  }

  /** Lights up the force along the path in an interval of the common clock; null ends this. */
  select(interval: [number, number] | null): void {
    this.selected = interval;
    this.lightRibbon();
    this.ask();
  }

  /** Shows data of a query instead of those before. */
  showData(shown: Shown): void {
    this.shown = shown;
    disposeAll(this.queried);
    for (const one of [...makeTrajectories(shown.trajectories), ...makeAsked(shown.particles), ...makeAxes(shown.frames)]) this.queried.add(one);
    this.makeGhosts();
    this.drawHighlights();
    this.ask();
  }

  private makeGhosts(): void {
    disposeAll(this.ghosts);
    const { head, meshes } = this.recording;
    if (!head || !this.robot) return;
    for (const [i, { time, color }] of this.shown.ghosts.entries()) {
      const instant = this.recording.at(time);
      if (!instant) continue;
      this.ghosts.add(makeGhost(head, meshes, this.robot, hexOr(color, colour("ghost")), i, instant.round.plan.root, instant.q, instant.tool));
    }
  }

  paint(): void {
    for (const [part, name] of Object.entries(ROBOT_COLOURS)) (this.materials[part as keyof typeof ROBOT_COLOURS] as MeshStandardMaterial).color.set(colour(name));
    this.painter.paint();
    this.showData(this.shown);
    paint(this.scene);
    this.dirt.paint();
    for (const { still, path } of this.entered.values()) {
      paint(still.group);
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
    for (const { still, path } of this.entered.values()) for (const one of [still.group, path.object]) release(one);
    this.painter.destroy();
  }

  private draw(resting = !this.painter.software): void {
    const instant = this.recording.at(this.time);
    if (!this.sized) return;
    if (instant) this.place(instant);
    // In software only frames at rest have shadows, because they take as long as all else.
    if (this.sun) this.sun.castShadow = this.ground.visible = resting || !this.painter.software;
    this.painter.draw(this.scene, this.camera.lens, resting, () => this.draw(true));
    this.drawn++;
    this.onDrawn?.();
  }

  private place(instant: Instant): void {
    const { head, meshes } = this.recording;
    const { round, time } = instant;
    if (!this.robot && head) {
      this.robot = new Robot(head, meshes, this.materials);
      this.scene.add(this.robot.group);
      this.makeGhosts();
    }
    if (this.current?.still.round !== round) this.enter(round);
    const { still, path } = this.current!;
    this.aim(time);
    this.robot?.show(round.plan.root, instant.q, instant.tool);
    const stroke = instant.phase >= 0 ? round.plan.phases[instant.phase]!.stroke : null;
    const choice = this.chosenNow;
    this.rejected.show(this.layers.rejected && choice?.rejected ? choice.rejected.lines : null, round.plan.surface);
    this.bases.show(this.layers.bases ? round.plan.bases : undefined, theme());
    still.show({ strokes: this.layers.strokes, found: this.layers.found, actual: this.layers.actualSurface }, stroke, this.recording.foundAt(this.time), choice?.stroke ?? null);
    if (this.robot) this.robot.collisionShown = this.layers.collision;
    still.fade(this.camera.lens.position);
    path.show(time, this.layers);
    this.dirt.show(this.recording, this.time, instant, this.layers, this.camera.pixelsPerMetre(still.surface, this.canvas.clientHeight));
    this.map.show(mapAt(this.recording, this.time, round, this.layers), theme());
    this.marks.show(this.recording, round, time, this.layers.events, theme());
    if (this.robot) this.force.show(instant, this.robot.toolPlace, this.camera.lens.position, this.layers.force);
  }

  /** Switches to another round; the geometry of recent rounds stays cached. */
  private enter(round: Round): void {
    if (this.current) this.scene.remove(this.current.still.group, this.current.path.object);
    let kept = this.entered.get(round);
    if (!kept) {
      const still = new Still(round, this.recording);
      kept = { still, path: new Path(round), shots: new Shots(this.recording, this.robot, still) };
    }
    this.entered.delete(round);
    this.entered.set(round, kept);
    for (const [oldest, { still, path }] of this.entered) {
      if (this.entered.size <= KEPT_ROUNDS) break;
      this.entered.delete(oldest);
      for (const one of [still.group, path.object]) release(one);
    }
    this.current = kept;
    this.scene.add(kept.still.group, kept.path.object);
    this.drawHighlights();
    this.lightRibbon();
  }

  /** Chooses the first view; while the camera follows, the view of a time of the round. */
  private aim(time: number): void {
    const shots = this.current!.shots;
    if (!this.begun) {
      this.begun = true;
      this.camera.look(fit(shots.surface(), shots.from, this.camera.angles));
      if (!this.grid) this.build(new Box3().setFromPoints(shots.all(time)).getBoundingSphere(new Sphere()));
    }
    if (this.shot !== null) {
      const { key, points } = shots.at(time);
      if (key !== this.shot) this.camera.look(fit(points, shots.from, this.camera.angles), true);
      this.shot = key;
    }
    if (this.camera.step()) this.ask();
  }

  /** Keeps the view that a user chose by moving the camera; following ends. */
  private leave(): void {
    this.chosen = true;
    if (this.shot === null) return;
    this.shot = null;
    this.left();
  }

  /** Sets how much a material of the robot hides. */
  private clear(material: Material): void {
    const opacity = ((material.userData.opacity as number | undefined) ?? 1) * (1 - this.seeThrough);
    material.opacity = opacity;
    material.transparent = opacity < 1;
  }

  private lightRibbon(): void {
    if (!this.current) return;
    const { ribbon, round: { start } } = this.current.path;
    ribbon.select(this.selected && [this.selected[0] - start, this.selected[1] - start]);
  }

  private drawHighlights(): void {
    const path = this.current?.path;
    setSegments(this.highlights, path ? this.shown.intervals.flatMap(({ start, end }) => path.between(start - path.round.start, end - path.round.start)) : []);
  }

  private build({ center, radius }: Sphere): void {
    const cells = 2 * Math.min(60, Math.max(6, Math.ceil(3 * radius)));
    this.grid = new GridHelper(cells / 2, cells);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.set(Math.round(center.x), Math.round(center.y), 0);
    tint(Object.assign(this.grid.material, { vertexColors: false, transparent: true, opacity: 0.7 }) as LineBasicMaterial, "rule");
    this.ground.scale.setScalar(cells / 2);
    this.ground.position.set(this.grid.position.x, this.grid.position.y, -0.001);
    this.ground.receiveShadow = true;
    const sun = new DirectionalLight(0xffffff, SUN_LIGHT);
    sun.position.copy(center).addScaledVector(SUN, 2 * radius);
    sun.target.position.copy(center);
    this.sun = sun;
    sun.shadow.mapSize.setScalar(this.painter.software ? 512 : 1024);
    Object.assign(sun.shadow, { bias: -0.0005, normalBias: 0.01, intensity: 0.4, radius: 4 });
    Object.assign(sun.shadow.camera, { left: -1.4 * radius, right: 1.4 * radius, top: 1.4 * radius, bottom: -1.4 * radius, near: 0.1, far: 9 * radius });
    const sky = new HemisphereLight(0xffffff, 0x8a8f98, SKY_LIGHT);
    sky.position.set(0, 0, 1);
    this.scene.add(this.grid, this.ground, sun, sun.target, sky, new AmbientLight(0xffffff, AMBIENT_LIGHT));
    for (const [axis, name] of [[[1, 0, 0], "axis-x"], [[0, 1, 0], "axis-y"], [[0, 0, 1], "axis-z"]] as const) {
      this.scene.add(segments([0, 0, 0.002, ...axis.map((v) => 0.25 * v)], tint(new LineMaterial({ linewidth: 2.5 }), name)));
    }
  }
}
