// The camera: orbit by mouse, touch and keys, fitted views, and smooth ways between them.
import { PerspectiveCamera, Vector3, type Object3D } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Angles, View } from "./viewpoint.ts";

/** Angle [rad] and factor of a step by keys. */
const TURN = Math.PI / 24;
const ZOOM = 1.15;
/** Time in which a smooth way gets by a factor of e nearer to its end [ms]. */
const GLIDE_MS = 380;

export class Camera {
  readonly lens = new PerspectiveCamera(36, 1, 0.02, 200);
  readonly controls: OrbitControls;
  /** Share of the width that no panel covers [1]. */
  private open = 1;
  /** End of the current smooth way, and the time of its last step [ms]. */
  private goal: View | null = null;
  private stepped = 0;
  /** Whether a user asked for the view, which is else the first one. */
  asked = false;
  /** Whether a user's hand is on the controls. */
  private held = false;

  /** `changed` is called when the view changes, `taken` when a user changes it. */
  constructor(canvas: HTMLCanvasElement, changed: () => void, private readonly taken: () => void) {
    this.lens.up.set(0, 0, 1);
    this.controls = Object.assign(new OrbitControls(this.lens, canvas), { maxPolarAngle: 0.62 * Math.PI, minDistance: 0.1, maxDistance: 40, zoomToCursor: true });
    this.controls.addEventListener("start", () => { this.held = true; });
    this.controls.addEventListener("end", () => { this.held = false; });
    this.controls.addEventListener("change", () => {
      if (this.held) this.take();
      changed();
    });
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
      const { controls } = this;
      const moves: Record<string, () => void> = {
        a: () => controls.rotateLeft(TURN), d: () => controls.rotateLeft(-TURN), w: () => controls.rotateUp(TURN), s: () => controls.rotateUp(-TURN),
        z: () => controls.dollyIn(1 / ZOOM), x: () => controls.dollyIn(ZOOM),
      };
      const move = moves[event.key];
      if (!move) return;
      this.take();
      move();
      event.preventDefault();
      event.stopPropagation();
    });
  }

  get angles(): Angles {
    const high = Math.tan((this.lens.fov * Math.PI) / 360);
    return { high, wide: high * this.lens.aspect * this.open };
  }

  /** Shows a view at once, or at the end of a smooth way; users who prefer reduced motion get it at once. */
  look(view: View | null, smooth = false): void {
    if (!view) return;
    this.goal = smooth && !matchMedia("(prefers-reduced-motion: reduce)").matches ? view : null;
    this.stepped = performance.now();
    this.asked = smooth;
    if (!this.goal) return this.move(view);
    // Linked cameras stop their own smooth ways now, so that the last request wins.
    this.controls.dispatchEvent({ type: "change" });
  }

  /** Goes on along the smooth way; returns whether it continues. */
  step(): boolean {
    if (!this.goal) return false;
    const now = performance.now();
    const share = 1 - Math.exp((this.stepped - now) / GLIDE_MS);
    this.stepped = now;
    const { goal } = this;
    const target = this.controls.target.clone().lerp(goal.target, share);
    const eye = this.lens.position.clone().lerp(goal.eye, share);
    if (eye.distanceTo(goal.eye) + target.distanceTo(goal.target) < 2e-3 * eye.distanceTo(target)) this.goal = null;
    this.move(this.goal ? { target, eye } : goal);
    return this.goal !== null;
  }

  /** Takes over the view of a camera with which this one is linked; an own smooth way ends. */
  followLinked(view: View, asked: boolean): void {
    if (asked) this.take();
    this.goal = null;
    this.move(view);
  }

  /** The current view. */
  get view(): View {
    return { target: this.controls.target.clone(), eye: this.lens.position.clone() };
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

  private move({ target, eye }: View): void {
    const { held } = this;
    this.held = false;
    this.controls.target.copy(target);
    this.lens.position.copy(eye);
    this.controls.update();
    this.held = held;
  }

  /** Ends a smooth way, because a user moves this or a linked camera. */
  private take(): void {
    this.goal = null;
    this.asked = true;
    this.taken();
  }
}
