// What draws: with all it can on a graphics card, sparingly where the processor has to do it.
import { Color, PCFShadowMap, WebGLRenderer } from "three";
import type { Camera, Scene } from "three";
import { colour } from "../theme.ts";

/** More pixels than this cost more than they show. */
const MOST_PIXELS = 2.6e6;
/** Without a graphics card: resolution while things move and once they rest, and when that is. */
const MOVING_RATIO = 0.75;
const RESTING_RATIO = 1.5;
const REST_MS = 700;

/** Whether the processor draws. */
function drawnBySoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) throw new Error("no WebGL");
  const name = gl.getExtension("WEBGL_debug_renderer_info");
  const software = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ? String(gl.getParameter(name.UNMASKED_RENDERER_WEBGL)) : "");
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}

export class Painter {
  readonly software = drawnBySoftware();
  readonly renderer: WebGLRenderer;
  private width = 0;
  private height = 0;
  private ratio = 0;
  private rested = false;
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

  private sharpen(resting: boolean): void {
    const most = Math.sqrt(MOST_PIXELS / (this.width * this.height));
    const screen = Math.min(devicePixelRatio || 1, 2, Math.max(1, most));
    const ratio = !this.software ? screen : resting ? Math.min(Math.max(RESTING_RATIO, screen), most) : MOVING_RATIO;
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
  }
}
