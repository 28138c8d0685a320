// The force of the environment on the tool, and its component along the surface normal, as arrows.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { normalUnder } from "./bend.ts";
import { tint } from "./solids.ts";
import type { Instant } from "../store.ts";

/** Length of the arrow for the largest force of a round [m]. */
const LONGEST_M = 0.11;
/** Thickness of an arrow as a share of its distance from the camera [1]. */
const THICK = 0.0042;
const LEAST_N = 0.5;
const UP = new Vector3(0, 1, 0);

class Arrow {
  readonly group = new Group();
  private readonly shaft: Mesh;
  private readonly tip: Mesh;

  constructor(radius: number, name: string) {
    const material = tint(new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.95 }), name);
    this.shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 12).translate(0, 0.5, 0), material);
    this.tip = new Mesh(new ConeGeometry(3 * radius, 6 * radius, 16).translate(0, 3 * radius, 0), material);
    this.group.add(this.shaft, this.tip);
    this.group.renderOrder = this.shaft.renderOrder = this.tip.renderOrder = 8;
  }

  /** Draws the arrow from a point along a vector; the vector's length is the arrow's. */
  show(place: Vector3, along: Vector3, thick: number): void {
    const length = along.length();
    this.group.visible = length > 1e-3;
    if (!this.group.visible) return;
    this.group.position.copy(place);
    this.group.quaternion.setFromUnitVectors(UP, along.clone().divideScalar(length));
    this.shaft.scale.set(thick, length, thick);
    this.tip.position.y = length;
    this.tip.scale.setScalar(Math.min(thick, length / 9));
  }
}

export class Force {
  readonly group = new Group();
  private readonly whole = new Arrow(1, "force");
  private readonly pressed = new Arrow(0.5, "ink");

  constructor() {
    this.group.add(this.whole.group, this.pressed.group);
  }

  show(instant: Instant, place: Vector3, eye: Vector3, visible: boolean): void {
    const { force, normal, round } = instant;
    const size = force ? Math.hypot(...force) : 0;
    this.group.visible = visible && size > LEAST_N;
    if (!this.group.visible || !force) return;
    const scale = LONGEST_M / Math.max(10, round.normal.largest, size);
    const thick = THICK * eye.distanceTo(place);
    this.whole.show(place, new Vector3(...force).multiplyScalar(scale), thick);
    const up = normalUnder(round.plan.surface, place);
    this.pressed.show(place, up.multiplyScalar(Math.abs(normal ?? 0) > LEAST_N ? (normal ?? 0) * scale : 0), thick);
  }
}
