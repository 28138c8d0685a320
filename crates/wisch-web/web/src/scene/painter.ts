// What draws: with all it can on a graphics card, sparingly where the processor has to do it.
import { Color, PCFShadowMap, WebGLRenderer } from "three";
import type { Camera, Scene } from "three";
import { drawnBySoftware } from "../software.ts";
import { colour } from "../theme.ts";

/** More pixels than this cost more than they show. */
const MOST_PIXELS = 2.6e6;
/** Without a graphics card: resolutions while things move, finest first, and once they rest, and when that is. */
const MOVING_RATIOS = [0.75, 0.6, 0.5];
const RESTING_RATIO = 1.5;
const REST_MS = 700;
/** Pictures that come more slowly are drawn more coarsely [ms]; that is decided once so many have come. */
const SLOW_MS = 70;
const PICTURES_TO_TELL = 12;

export class Painter {
  readonly software = drawnBySoftware();
  readonly renderer: WebGLRenderer;
  private width = 0;
  private height = 0;
  private ratio = 0;
  private rested = false;
  private coarse = 0;
  /** When the last moving picture was drawn, and the time between pictures since the last decision. */
  private moved = { last: 0, took: 0, pictures: 0 };
  private rest: ReturnType<typeof setTimeout> | undefined;

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.software, alpha: !this.software, powerPreference: "high-performance" });
    // To ask for errors is to wait until all shaders are made.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = !this.software;
  }

  /** Without a graphics card the first picture comes without shadows: to make ready for them takes as long as the picture. */
  get shadows(): boolean {
    return !this.software || this.rested;
  }

  get shadowSize(): number {
    return this.software ? 512 : 1024;
  }

  size(width: number, height: number): void {
    [this.width, this.height, this.ratio] = [width, height, 0];
  }

  /** Takes over the colour of the ground, where it does not shine through. */
  paint(): void {
    if (this.software) this.renderer.setClearColor(new Color(colour("scene")));
  }

  /** Draws; what moves is drawn coarsely, and asked for again once it rests. */
  draw(scene: Scene, camera: Camera, resting: boolean, again: () => void): void {
    clearTimeout(this.rest);
    if (this.software && !resting) this.keepUp(performance.now());
    this.sharpen(resting);
    this.renderer.shadowMap.needsUpdate = resting || this.renderer.info.render.frame % 3 === 0;
    this.renderer.render(scene, camera);
    if (!resting) this.rest = setTimeout(() => {
      this.rested = true;
      again();
    }, REST_MS);
  }

  destroy(): void {
    clearTimeout(this.rest);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Draws more coarsely where pictures come too slowly. */
  private keepUp(now: number): void {
    const { moved } = this;
    const took = now - moved.last;
    moved.last = now;
    // After a rest, or while programs are made, it tells nothing.
    if (took > 500) return;
    moved.took += took;
    if (++moved.pictures < PICTURES_TO_TELL) return;
    if (moved.took / moved.pictures > SLOW_MS && this.coarse + 1 < MOVING_RATIOS.length) this.coarse++;
    moved.took = moved.pictures = 0;
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
