// The work for the next animation frame: first all steps, then all draws. A draw that a step or another draw requests runs
// in the same frame. Each draw runs at most once per frame.

import type { Recording } from "./store.ts";

type Step = (now: number) => void;
type Draw = () => void;

export class Frames {
  private steps = new Map<number, Step>();
  private draws = new Set<Draw>();
  private drawn: Set<Draw> | null = null;
  private asked = false;
  private last = 0;

  /** `request` calls its argument in the next frame. */
  constructor(private readonly host: (step: Step) => unknown) {}

  /** Calls `step` once, in the next frame. */
  request(step: Step): number {
    this.steps.set(++this.last, step);
    this.ask();
    return this.last;
  }

  now(): number {
    return performance.now();
  }

  cancel(id: number): void {
    this.steps.delete(id);
  }

  /** Requests a draw in the current frame, or else in the next. */
  draw(draw: Draw): void {
    this.draws.add(draw);
    this.ask();
  }

  /** Cancels a requested draw. */
  drop(draw: Draw): void {
    this.draws.delete(draw);
  }

  private ask(): void {
    if (this.asked || this.drawn) return;
    this.asked = true;
    this.host((now) => this.run(now));
  }

  private run(now: number): void {
    this.asked = false;
    const drawn = (this.drawn = new Set<Draw>());
    const steps = this.steps;
    this.steps = new Map();
    for (const step of steps.values()) runGuarded(() => step(now));
    for (let next = this.next(drawn); next; next = this.next(drawn)) {
      this.draws.delete(next);
      drawn.add(next);
      runGuarded(next);
    }
    this.drawn = null;
    if (this.steps.size || this.draws.size) this.ask();
  }

  /** Returns a requested draw that has not run in this frame. */
  private next(drawn: Set<Draw>): Draw | null {
    for (const draw of this.draws) if (!drawn.has(draw)) return draw;
    return null;
  }
}

/** Returns a throttled `act`: it runs at once, or when `everyMs` [ms] have passed since the last run. */
export function throttle(everyMs: number, act: () => void): { ask: () => void; stop: () => void } {
  let last = -Infinity;
  let later: ReturnType<typeof setTimeout> | undefined;
  const now = () => {
    later = undefined;
    last = performance.now();
    act();
  };
  return {
    ask: () => {
      if (later !== undefined) return;
      const left = last + everyMs - performance.now();
      if (left <= 0) now();
      else later = setTimeout(now, left);
    },
    stop: () => clearTimeout(later),
  };
}

/** Calls `act` in the next frame after a recording has changed by more than samples; returns a function that stops this. */
export function onNews(recording: Recording, act: () => void): () => void {
  const stop = recording.onChange((piece) => { if (piece?.piece !== "samples") frames.draw(act); });
  return () => {
    stop();
    frames.drop(act);
  };
}

/** Runs `act`; reports an exception without stopping the other work of the frame. */
function runGuarded(act: () => void): void {
  try {
    act();
  } catch (error) {
    reportError(error);
  }
}

export const frames = new Frames((step) => requestAnimationFrame(step));

let known: boolean | null = null;

/** Whether the browser renders without a graphics card. */
export function isSoftwareRendered(): boolean {
  return (known ??= detectSoftware());
}

function detectSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const name = gl.getExtension("WEBGL_debug_renderer_info");
  const software = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ? String(gl.getParameter(name.UNMASKED_RENDERER_WEBGL)) : "");
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}
