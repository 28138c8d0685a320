// The camera: orbit by mouse, touch and keys, fitted views, and following the tool.
import { PerspectiveCamera, Vector3 } from "three";
import type { Object3D } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

export type Look = "all" | "surface" | "above";
const TURN = Math.PI / 24;
/** Ratio of the visible extent to that of the shown points [1]. */
const MARGIN = 1.16;

export class Camera {
  readonly lens = new PerspectiveCamera(36, 1, 0.02, 200);
  readonly controls: OrbitControls;
  following = false;
  /** Share of the width that no panel covers [1]. */
  private open = 1;
  private followed: Vector3 | null = null;

  constructor(canvas: HTMLCanvasElement, changed: () => void) {
    this.lens.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.lens, canvas);
    this.controls.maxPolarAngle = 0.62 * Math.PI;
    this.controls.minDistance = 0.1;
    this.controls.maxDistance = 40;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", changed);
    // On a page that scrolls, the wheel scrolls it until a user clicks the scene.
    canvas.addEventListener("wheel", (event) => {
      const { scrollHeight, clientHeight } = document.documentElement;
      this.controls.enableZoom = event.ctrlKey || document.activeElement === canvas || scrollHeight <= clientHeight + 1;
    }, { capture: true, passive: true });
    canvas.addEventListener("pointerdown", () => {
      this.controls.enableZoom = true;
      canvas.focus({ preventScroll: true });
    }, true);
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const turn: Record<string, [number, number]> = { a: [-TURN, 0], d: [TURN, 0], w: [0, -TURN], s: [0, TURN] };
      const zoom: Record<string, number> = { z: 1 / 1.15, x: 1.15 };
      const [turned, zoomed] = [turn[event.key], zoom[event.key]];
      if (turned) this.turn(...turned);
      else if (zoomed) this.zoom(zoomed);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  /** Views points from a direction, as near as all of them fit. */
  look(places: Vector3[], from: Vector3): void {
    if (!places.length) return;
    const back = from.clone().normalize();
    const right = new Vector3().crossVectors(this.lens.up, back).normalize();
    const up = new Vector3().crossVectors(back, right);
    const middle = (axis: Vector3) => {
      const along = places.map((place) => place.dot(axis));
      return (Math.min(...along) + Math.max(...along)) / 2;
    };
    const target = new Vector3().addScaledVector(right, middle(right)).addScaledVector(up, middle(up)).addScaledVector(back, middle(back));
    const high = Math.tan((this.lens.fov * Math.PI) / 360);
    const wide = high * this.lens.aspect * this.open;
    const distance = Math.max(0.1, ...places.map((place) => {
      const away = place.clone().sub(target);
      return away.dot(back) + MARGIN * Math.max(Math.abs(away.dot(right)) / wide, Math.abs(away.dot(up)) / high);
    }));
    this.controls.target.copy(target);
    this.lens.position.copy(target).addScaledVector(back, distance);
    this.controls.update();
  }

  follow(tool: Vector3 | null): void {
    if (!this.following || !tool) {
      this.followed = null;
      return;
    }
    const by = tool.clone().sub(this.followed ?? this.controls.target);
    this.followed = tool.clone();
    if (by.lengthSq() < 1e-10) return;
    this.controls.target.add(by);
    this.lens.position.add(by);
    this.controls.update();
  }

  /** Returns the size of a metre at the distance of an object [pixels]. */
  pixelsPerMetre(thing: Object3D | null, height: number): number {
    const place = thing ? new Vector3().setFromMatrixPosition(thing.matrix) : this.controls.target;
    return height / (2 * Math.tan((this.lens.fov * Math.PI) / 360) * Math.max(0.05, place.distanceTo(this.lens.position)));
  }

  /** Sets the size of the canvas and the width that a panel covers on its left [pixels]; the view is centred in the rest. */
  shape(width: number, height: number, covered: number): void {
    this.lens.aspect = width / height;
    this.open = (width - covered) / width;
    this.lens.setViewOffset(width, height, -covered / 2, 0, width, height);
  }

  private turn(around: number, up: number): void {
    const away = this.lens.position.clone().sub(this.controls.target);
    away.applyAxisAngle(new Vector3(0, 0, 1), around);
    const side = new Vector3().crossVectors(this.lens.up, away).normalize();
    const tilted = away.clone().applyAxisAngle(side, up);
    const polar = tilted.angleTo(this.lens.up);
    if (polar > 0.02 && polar < this.controls.maxPolarAngle) away.copy(tilted);
    this.lens.position.copy(this.controls.target).add(away);
    this.controls.update();
  }

  private zoom(by: number): void {
    const away = this.lens.position.clone().sub(this.controls.target).multiplyScalar(by);
    this.lens.position.copy(this.controls.target).add(away);
    this.controls.update();
  }
}
