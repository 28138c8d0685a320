// The clock of a view: play, pause, speed, seek, and following a live run.
import { frames } from "./frames.ts";
import type { Recording } from "./store.ts";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];
/** A live run arrives in pieces. The clock stretches each piece to this multiple of the time between two pieces, so that it
 * is still moving when the next piece arrives. CATCH_UP_S bounds that time [s]. */
const MARGIN = 1.15;
const CATCH_UP_S = { least: 0.12, most: 0.8 };
/** Longest time between two frames that the clock keeps up with [s]. A single longer one is a tab that was suspended; more of
 * them in a row are a machine that is too slow for real time. */
const LONGEST_FRAME_S = 3;

/** A recording, as the clock sees it. */
type Span = Pick<Recording, "duration" | "now" | "live">;

/** Time without movement until a clock counts as resting [ms]. */
const REST_MS = 300;

/** Calls `act` with the time whenever a clock rests; returns a function that stops this. */
export function onRest(clock: Clock, act: (time: number) => void): () => void {
  let later: ReturnType<typeof setTimeout> | undefined;
  const stop = clock.subscribe(({ playing, following }) => {
    clearTimeout(later);
    if (!playing && !following) later = setTimeout(() => act(clock.time), REST_MS);
  });
  return () => {
    clearTimeout(later);
    stop();
  };
}

export class Clock {
  /** The shown time [s]. */
  time = 0;
  playing = false;
  /** Whether the clock follows the end of a live run. */
  following = false;
  speed = 1;
  private readonly spans = new Set<Span>();
  private readonly callbacks = new Set<(clock: Clock) => void>();
  private frame: number | null = null;
  private before = 0;
  /** Number of frames in a row that took too long. */
  private late = 0;
  /** While following: end of the measured part [s], when it last moved [ms], mean time between moves [s], and speed of the clock. */
  private known = { edge: 0, since: 0, every: CATCH_UP_S.least, pace: 0 };

  constructor(private readonly pictures: Pick<typeof frames, "request" | "cancel" | "now"> = frames) {}

  /** Adds a recording to the clock; returns a function that removes it. */
  join(span: Span): () => void {
    this.spans.add(span);
    return () => { this.spans.delete(span); };
  }

  get duration(): number {
    return Math.max(0, ...[...this.spans].map((span) => span.duration));
  }

  /** End of the measured part over all recordings [s]. */
  get end(): number {
    return Math.max(0, ...[...this.spans].map((span) => span.now));
  }

  /** End of the measured part of the live runs; without one, the end of all recordings [s]. */
  get edge(): number {
    const live = [...this.spans].filter((span) => span.live);
    return live.length ? Math.max(0, ...live.map((span) => span.now)) : this.end;
  }

  /** Whether the clock plays slower than it should, because frames take too long. */
  get isLate(): boolean {
    return this.playing && this.late > 1;
  }

  get live(): boolean {
    return [...this.spans].some((span) => span.live);
  }

  subscribe(callback: (clock: Clock) => void): () => void {
    this.callbacks.add(callback);
    return () => this.callbacks.delete(callback);
  }

  /** Updates the clock after a recording has grown. */
  onGrowth(): void {
    if (this.following && !this.live) {
      this.following = false;
      this.time = this.end;
    }
    if (this.following) {
      this.keepPace();
      this.run();
    }
    this.notify();
  }

  seek(time: number): void {
    this.following = false;
    this.time = Math.min(this.duration, Math.max(0, Number.isFinite(time) ? time : 0));
    this.notify();
  }

  play(): void {
    if (this.time >= this.end - 1e-6) {
      if (this.live) return this.follow();
      this.time = 0;
    }
    this.playing = true;
    this.following = false;
    this.run();
    this.notify();
  }

  pause(): void {
    this.playing = false;
    this.following = false;
    this.notify();
  }

  toggle(): void {
    if (this.playing || this.following) this.pause();
    else this.play();
  }

  /** Follows the end of a live run. */
  follow(): void {
    this.following = true;
    this.playing = false;
    this.known = { edge: -1, since: this.pictures.now(), every: CATCH_UP_S.least, pace: 0 };
    this.keepPace();
    this.run();
    this.notify();
  }

  setSpeed(speed: number): void {
    this.speed = Math.min(10, Math.max(0.1, speed));
    this.notify();
  }

  /** Selects the next higher (1) or lower (-1) speed. */
  faster(by: 1 | -1): void {
    const at = SPEEDS.reduce((best, speed, i) => (Math.abs(speed - this.speed) < Math.abs(SPEEDS[best]! - this.speed) ? i : best), 0);
    this.setSpeed(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, at + by))]!);
  }

  destroy(): void {
    if (this.frame !== null) this.pictures.cancel(this.frame);
    this.frame = null;
    this.callbacks.clear();
  }

  private run(): void {
    if (this.frame !== null) return;
    this.before = this.pictures.now();
    this.late = 0;
    this.frame = this.pictures.request((now) => this.step(now));
  }

  private step(now: number): void {
    this.frame = null;
    const took = Math.max(0, (now - this.before) / 1000);
    this.late = took > LONGEST_FRAME_S ? this.late + 1 : 0;
    const passed = this.late ? 0.25 : took;
    this.before = Math.max(this.before, now);
    if (this.following) {
      const { edge } = this;
      const gap = edge - this.time;
      const step = passed * this.known.pace;
      this.time = Math.abs(gap) <= Math.max(1e-3, step) ? edge : this.time + Math.sign(gap) * step;
    } else if (this.playing) {
      this.time = Math.min(this.end, this.time + passed * this.speed);
      if (this.time >= this.end) {
        this.playing = false;
        if (this.live) this.follow();
      }
    }
    const again = this.playing || (this.following && this.edge !== this.time);
    if (again) this.frame = this.pictures.request((later) => this.step(later));
    this.notify();
  }

  /** Sets a speed at which the clock reaches the current end when the next piece is due. */
  private keepPace(): void {
    const { edge, known } = this;
    if (edge === known.edge) return;
    const now = this.pictures.now();
    const { least, most } = CATCH_UP_S;
    const took = Math.min(most, Math.max(least, (now - known.since) / 1000));
    const every = known.edge < 0 ? least : known.every + 0.3 * (took - known.every);
    this.known = { edge, since: now, every, pace: Math.abs(edge - this.time) / (MARGIN * every) };
  }

  private notify(): void {
    for (const callback of this.callbacks) callback(this);
  }
}
