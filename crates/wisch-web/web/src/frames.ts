// What is to be done for the next picture, all in one go: first what moves on, then what is drawn of it. A draw that is
// asked for by a step, or by another draw, still belongs to the same picture; each is made once a picture.

type Step = (now: number) => void;
type Draw = () => void;

interface Host {
  request(callback: (now: number) => void): unknown;
}

export class Frames {
  private steps = new Map<number, Step>();
  private draws = new Set<Draw>();
  private made: Set<Draw> | null = null;
  private asked = false;
  private last = 0;

  constructor(private readonly host: Host) {}

  /** Calls back once, when the next picture is made. */
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

  /** Draws once: in the picture that is being made, or in the next. */
  draw(draw: Draw): void {
    this.draws.add(draw);
    this.ask();
  }

  /** Does without a draw that was asked for. */
  drop(draw: Draw): void {
    this.draws.delete(draw);
  }

  private ask(): void {
    if (this.asked || this.made) return;
    this.asked = true;
    this.host.request((now) => this.make(now));
  }

  private make(now: number): void {
    this.asked = false;
    const made = (this.made = new Set<Draw>());
    const steps = this.steps;
    this.steps = new Map();
    for (const step of steps.values()) safely(() => step(now));
    for (let next = this.next(made); next; next = this.next(made)) {
      this.draws.delete(next);
      made.add(next);
      safely(next);
    }
    this.made = null;
    if (this.steps.size || this.draws.size) this.ask();
  }

  /** Asked for and not made yet. */
  private next(made: Set<Draw>): Draw | null {
    for (const draw of this.draws) if (!made.has(draw)) return draw;
    return null;
  }
}

/** Acts at once, or as soon as so much time has passed since it did [ms]. */
export function calmly(everyMs: number, act: () => void): { ask: () => void; stop: () => void } {
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

/** What fails takes nothing else with it. */
function safely(act: () => void): void {
  try {
    act();
  } catch (error) {
    reportError(error);
  }
}

export const frames = new Frames({ request: (callback) => requestAnimationFrame(callback) });
