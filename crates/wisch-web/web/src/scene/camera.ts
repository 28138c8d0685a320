// The camera: orbit by mouse, finger and keys, views that fit, and following the tool.
import { PerspectiveCamera, Sphere, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

export type Look = "all" | "surface" | "above";
const TURN = Math.PI / 24;

export class Camera {
  readonly lens = new PerspectiveCamera(36, 1, 0.02, 200);
  readonly controls: OrbitControls;
  following = false;
  private followed: Vector3 | null = null;

  constructor(canvas: HTMLCanvasElement, changed: () => void) {
    this.lens.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.lens, canvas);
    this.controls.maxPolarAngle = 0.62 * Math.PI;
    this.controls.minDistance = 0.1;
    this.controls.maxDistance = 40;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", changed);
    // The wheel scrolls the page until the picture is touched, where there is anything to scroll.
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

  /** Shows a ball from a direction. */
  look({ center, radius }: Sphere, from: Vector3): void {
    const half = (this.lens.fov * Math.PI) / 360;
    const narrowest = Math.min(half, Math.atan(Math.tan(half) * this.lens.aspect));
    this.controls.target.copy(center);
    this.lens.position.copy(center).addScaledVector(from.clone().normalize(), (0.98 * Math.max(radius, 0.05)) / Math.sin(narrowest));
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

  shape(width: number, height: number): void {
    this.lens.aspect = width / height;
    this.lens.updateProjectionMatrix();
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
