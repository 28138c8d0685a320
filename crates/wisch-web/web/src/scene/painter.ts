// The renderer: full quality on a graphics card, reduced quality in software.
import { Color, PCFShadowMap, WebGLRenderer, type Camera, type Scene } from "three";
import { isSoftwareRendered } from "../frames.ts";
import { colour } from "../theme.ts";

/** Maximum number of drawn pixels. */
const MOST_PIXELS = 2.6e6;
/** Without a graphics card: pixel ratios while the scene moves, finest first; the ratio at rest; and the time until rest [ms]. */
const MOVING_RATIOS = [0.75, 0.6, 0.5];
const RESTING_RATIO = 1.5;
const REST_MS = 700;
/** A longer mean frame time lowers the resolution [ms]; it is averaged over DECISION_FRAMES frames. */
const SLOW_MS = 70;
const DECISION_FRAMES = 6;

export class Painter {
  readonly software = isSoftwareRendered();
  readonly renderer: WebGLRenderer;
  private width = 0;
  private height = 0;
  private ratio = 0;
  private coarse = 0;
  /** Time of the last frame in motion [ms]; total frame time [ms] and number of frames since the last decision. */
  private moved = { last: 0, took: 0, frames: 0 };
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, stencil: true, antialias: !this.software, alpha: !this.software, powerPreference: "high-performance" });
    // The check for shader errors would wait until all shaders are compiled.
    this.renderer.debug.checkShaderErrors = false;
    Object.assign(this.renderer.shadowMap, { enabled: true, type: PCFShadowMap, autoUpdate: !this.software });
  }

  size(width: number, height: number): void {
    [this.width, this.height, this.ratio] = [width, height, 0];
  }

  /** Sets the background colour; in software the canvas is opaque. */
  paint(): void {
    if (this.software) this.renderer.setClearColor(new Color(colour("scene")));
  }

  /** Draws a frame. In motion it is coarse, and `again` is called once the scene rests. */
  draw(scene: Scene, camera: Camera, resting: boolean, again: () => void): void {
    clearTimeout(this.rest);
    if (this.software && !resting) this.keepUp(performance.now());
    this.sharpen(resting);
    this.renderer.shadowMap.needsUpdate = resting;
    this.renderer.render(scene, camera);
    if (!resting) this.rest = setTimeout(again, REST_MS);
  }

  destroy(): void {
    clearTimeout(this.rest);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Lowers the resolution if frames take too long. */
  private keepUp(now: number): void {
    const { moved } = this;
    const took = now - moved.last;
    moved.last = now;
    // Frame times after a rest or during shader compilation are not representative.
    if (took > 500) return;
    moved.took += took;
    if (++moved.frames < DECISION_FRAMES) return;
    if (moved.took / moved.frames > SLOW_MS && this.coarse + 1 < MOVING_RATIOS.length) this.coarse++;
    moved.took = moved.frames = 0;
  }

  private sharpen(resting: boolean): void {
    const most = Math.sqrt(MOST_PIXELS / (this.width * this.height));
    const screen = Math.min(devicePixelRatio || 1, 2, Math.max(1, most));
    const ratio = !this.software ? screen : resting ? Math.min(Math.max(RESTING_RATIO, screen), most) : MOVING_RATIOS[this.coarse]!;
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
  }
}
