// A recording: it grows piece by piece and gives access to any of its times.
import { lastIndex } from "./columns.ts";
import { Round, pushOf, type Contact, type Happening, type Measured } from "./round.ts";
import { checkPiece, fromEarlierVersion } from "./shape.ts";
import type { EndedPiece, Head, MeshRecord, ObservedPiece, Piece, Places, Pose, StagePiece, SurfaceShape, TruthPiece } from "./recording.ts";

/** The state at a time of the common clock. */
export interface Instant extends Measured {
  round: Round;
  /** Time since the start of the round [s]. */
  time: number;
  /** Predicted performance, in [0, 1]. */
  performance: number | null;
  contact: Contact;
  /** Index of the phase in the plan, -1 before the first. */
  phase: number;
}

/** Tolerance for equal times [s]. */
export const SAME_S = 1e-3;

/** Shape of a surface; none for a plane. */
export type Bend = SurfaceShape | null | undefined;

/** Returns the true shape of a surface: the believed one if no other is stated. */
export function trueShape(truth: TruthPiece | null, believed: Bend): Bend {
  const shape = truth?.shape ?? believed;
  return shape && shape.kind !== "plane" ? shape : null;
}

/** Dirt on a surface, which is estimated or true as the dirt is. */
interface Deposit {
  places: Places | null | undefined;
  pose: Pose;
  shape: Bend;
}

export class Recording {
  head: Head | null = null;
  readonly rounds: Round[] = [];
  readonly stages: StagePiece[] = [];
  readonly meshes: MeshRecord[] = [];
  /** What was known before the first round. */
  readonly before: { observed: ObservedPiece | null; truth: TruthPiece | null } = { observed: null, truth: null };
  ended: EndedPiece | null = null;
  /** Number of unreadable lines, and of pieces of unknown kinds. */
  broken = 0;
  unknown = 0;
  /** Number of changes, by which views detect that they are outdated. */
  version = 0;
  private closed = false;
  private readonly callbacks = new Set<(piece: Piece | null) => void>();
  private cachedHappenings: { version: number; list: Happening[] } | null = null;

  /** Parses a whole recording from its JSON lines. */
  static parse(text: string): Recording {
    const recording = new Recording();
    for (const line of text.split("\n")) recording.applyLine(line);
    recording.close();
    return recording;
  }

  applyLine(line: string): void {
    if (!line.trim()) return;
    let piece: Piece | null = null;
    try {
      piece = JSON.parse(line) as Piece;
    } catch {
      // A line that is no JSON is counted as one without a piece.
    }
    this.apply(piece);
  }

  /** Adds the next piece; counts and skips an invalid one. */
  apply(piece: Piece | null): void {
    try {
      this.add(piece);
    } catch {
      this.broken++;
    }
    this.notify(piece);
  }

  /** Marks the recording as complete. */
  close(): void {
    this.closed = true;
    for (const round of this.rounds) round.over = true;
    this.layOutRounds();
    this.notify(null);
  }

  /** Whether more pieces may follow. */
  get live(): boolean {
    return !this.closed;
  }

  onChange(callback: (piece: Piece | null) => void): () => void {
    this.callbacks.add(callback);
    return () => this.callbacks.delete(callback);
  }

  private notify(piece: Piece | null): void {
    this.version++;
    for (const callback of this.callbacks) callback(piece);
  }

  private add(given: Piece | null): void {
    const piece = fromEarlierVersion(given);
    checkPiece(piece);
    switch (piece.piece) {
      case "head":
        this.meshes.push(...piece.meshes);
        this.head = piece;
        break;
      case "stage": this.stages.push(piece); break;
      case "round": {
        const round = new Round(piece, this.head?.robot?.variables.length ?? 0);
        this.meshes.push(...piece.meshes);
        const last = this.rounds.at(-1);
        if (last && last.number === round.number && !last.count && !last.interpreted) this.rounds.pop();
        else if (last) last.over = true;
        this.rounds.push(round);
        this.layOutRounds();
        break;
      }
      case "samples": {
        const round = this.round(piece.round);
        round.push(piece);
        if (round !== this.rounds.at(-1)) this.layOutRounds();
        break;
      }
      case "observed": this.placeOf(piece).observed = piece; break;
      case "interpreted": this.round(piece.round).interpreted = { ...piece }; this.layOutRounds(); break;
      case "truth": this.placeOf(piece).truth = piece; break;
      case "ended":
        this.ended = piece;
        this.close();
        break;
      default: this.unknown++;
    }
  }

  /** Returns the last round with a number. */
  private round(number: number): Round {
    const round = this.rounds.findLast((one) => one.number === number);
    if (!round) throw new Error(`no round ${number}`);
    return round;
  }

  private placeOf({ round }: { round: number }): Recording["before"] {
    return round === 0 ? this.before : this.round(round);
  }

  private layOutRounds(): void {
    let start = 0;
    for (const round of this.rounds) {
      round.start = start;
      start += round.length;
    }
  }

  get duration(): number {
    return this.rounds.at(-1)?.end ?? 0;
  }

  /** End of the measured part [s]; the duration once the run is over. */
  get now(): number {
    const last = this.rounds.at(-1);
    if (!last || !this.live || last.interpreted || last.plan.kind === "planned") return this.duration;
    return last.start + (last.count ? last.t.at(-1)! : 0);
  }

  /** Returns the round at a time of the common clock; the later one at a boundary. */
  roundAt(t: number): Round | null {
    return this.rounds[Math.max(0, lastIndex(this.rounds.length, (i) => this.rounds[i]!.start <= t))] ?? null;
  }

  at(t: number): Instant | null {
    const round = this.roundAt(t);
    if (!round) return null;
    const time = Math.min(Math.max(0, t - round.start), round.length);
    return { round, time, ...round.measuredAt(time), performance: round.growthAt(time), contact: round.contactAt(time), phase: round.phaseAt(time) };
  }

  /** Returns the dirt after the last round that had ended at a time, or what was known before the first one. There must be a round. */
  outcomeAt(t: number): Record<"estimated" | "actual" | "seen", Deposit> {
    const done = this.rounds.findLast((round) => round.end <= t + 1e-6 && (round.interpreted || round.truth || round.observed));
    const { truth, observed } = done ?? this.before;
    const { shape, pose: believed } = (done ?? this.rounds[0]!).plan.surface;
    const pose = done?.interpreted?.found ?? believed;
    return {
      estimated: { places: done?.interpreted?.particles, pose, shape },
      actual: { places: truth?.particles, pose: truth?.surface ?? pose, shape: trueShape(truth, shape) },
      seen: { places: observed?.detections, pose, shape },
    };
  }

  /** Returns the last round that had ended at a time, until the robot wipes again. */
  endedAt(t: number): Round | null {
    const last = this.rounds.findLastIndex((round) => round.end <= t + 1e-6);
    const next = this.rounds[last + 1];
    return next && t >= next.start + next.firstContact ? null : this.rounds[last] ?? null;
  }

  /** Returns the round whose result holds at a time. */
  resultAt(t: number): Round | null {
    const ended = this.endedAt(t);
    return ended?.interpreted ? ended : null;
  }

  /** Returns where touch found the surface, as known at a time: at the end of the last round that had ended. */
  foundAt(t: number): Pose | null {
    return this.rounds.findLast((round) => round.end <= t + 1e-6)?.interpreted?.found ?? null;
  }

  /** Detected events and true pushes, by start time. */
  get happenings(): Happening[] {
    if (this.cachedHappenings?.version === this.version) return this.cachedHappenings.list;
    const list: Happening[] = [];
    for (const { number: round, start, events, truth } of this.rounds) {
      for (const event of events) list.push({ start: start + event.start, end: start + event.end, source: "event", round, kind: pushOf(event) ?? event.kind, words: event.words });
      for (const [from, to] of truth?.pushes ?? []) {
        list.push({ start: start + from, end: start + to, source: "push", round, kind: "true push", words: "A push in the simulated world." });
      }
    }
    list.sort((a, b) => a.start - b.start);
    this.cachedHappenings = { version: this.version, list };
    return list;
  }

  /** Start times of rounds, strokes and events, and the end, for stepping [s]. */
  get stops(): number[] {
    const stops = [0, this.duration];
    for (const { start, plan } of this.rounds) {
      stops.push(start);
      for (const phase of plan.phases) if (phase.contact) stops.push(start + phase.start);
    }
    for (const { start } of this.happenings) stops.push(start);
    return [...new Set(stops)].filter((t) => t <= this.duration).sort((a, b) => a - b);
  }
}
