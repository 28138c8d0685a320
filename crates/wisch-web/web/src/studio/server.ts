// The interface of the studio's server: queries, and recordings of episodes and live runs. Addresses are relative, so that requests
// keep the token in the page's address.
import { Recording } from "../store.ts";
import type { Pose } from "../recording.ts";

/** An episode, as far as the page reads it. */
export interface Listed {
  id: string;
  title: string;
  /** Seconds since 1970. */
  begun: number;
  seconds: number;
  rounds: number;
  performance: number | null;
  low: number | null;
  high: number | null;
  met: boolean;
  /** Verdict on the last round, and how the run ended, where its recording states it. */
  verdict: string | null;
  badge?: string | null;
  /** Target performance, in [0, 1]. */
  target: number | null;
  /** Begins of the rounds, since the episode began [s]. */
  round_starts: number[];
  /** Events of a class that follow each other closely are one. */
  events: { class: string; start: number; end: number; count: number }[];
  has_recording: boolean;
}

export interface LiveRun {
  id: string;
  task: string;
  begun: string | null;
  state: "running" | "ended" | "lost";
  message?: string | null;
}

export interface Scenario {
  name: string;
  about: string;
}

export interface Overview {
  memory: string;
  list: { episodes: Listed[]; total: number; broken: string[] };
  runs: LiveRun[];
  scenarios: Scenario[];
}

/** The names that queries may have. */
export interface Vocabulary extends Record<"classes" | "properties" | "individuals", { name: string; label: string; comment: string }[]> {
  predicates: { name: string; arity: number; meaning: string }[];
  builtins: string[];
  examples: { title: string; query: string }[];
}

/** A channel of comparable runs in words: a line, or the reason why there is none. */
interface ChannelWords {
  channel: string;
  recorded: number;
  now?: string;
  per_run?: string;
  p?: string;
  unknown?: string;
  /** Null for a channel that is not assessed. */
  finding: string | null;
  needs_attention: boolean;
  sentences: string[];
}

export interface GroupWords {
  things: string;
  runs: string;
  too_few: string | null;
  needs_attention: boolean;
  channels: ChannelWords[];
}

/** The words of `wisch memory health`. */
export interface HealthWords {
  groups: GroupWords[];
  summary: string;
  remarks: string[];
}

export type Cell = string | number | null | Cell[];

/** An individual of an episode that an answer names. */
export interface Mention {
  episode: string;
  /** Task and begin of the episode [s since 1970]. */
  task: string;
  begun: number;
  class: string;
  interval: [number, number] | null;
}

export interface Plot {
  diagram: "piechart" | "barchart" | "timeline" | "linechart" | "scatter";
  id: string;
  title: string;
  x_label: string;
  y_label: string;
  amounts?: [string, number][];
  spans?: [string, [number, number]][];
  points?: [number, number][];
}

/** An individual of an episode that a query shows. */
interface ShownThing {
  thing: string;
  episode: string;
  strong: boolean;
  colour: string | null;
}

/** All that a query shows. */
interface Seen {
  /** `rounds`: when each round began, in seconds since 1970. */
  episodes: { id: string; interval: [number, number]; rounds: number[] | null; shown: [number, number][] }[];
  tracks: (ShownThing & { interval: [number, number]; path: [number, number, number][]; samples: [number, number, number, number][] })[];
  /** Poses of the bodies' frames in the world. */
  bodies: (ShownThing & { kind: "robot" | "tool" | "surface" | "frame"; time: number; pose: Pose })[];
  /** Particles of rounds, in the frames of their surfaces [m]. */
  particles: { episode: string; round: number; state: "before" | "estimated"; positions: [number, number][]; colour: string | null }[];
  plots: Plot[];
  left_out: number;
}

export interface Answers {
  columns: string[];
  /** Unit of each column, where the query states it; "share" for values from 0 to 1. */
  units: (string | null)[];
  /** Titles of named individuals, such as "round 2, stroke 3", by their names with prefix. */
  names: Record<string, string>;
  rows: Cell[][];
  about: Mention[][];
  holds: boolean;
  more: boolean;
  /** Duration of the query, where it was measured. */
  seconds?: number;
  printed: string;
  remarks: string[];
  view: Seen | null;
}

export interface Fault {
  message: string;
  /** In the query, in UTF-16 units. */
  offset?: number;
  length?: number;
  line?: number;
  column?: number;
}

/** A request that the server refused, with its message. */
export class Refused extends Error {
  constructor(readonly fault: Fault, readonly status: number) {
    super(fault.message);
  }
}

const GONE = "The studio does not respond. If it has ended, start it again: wisch studio.";

async function request(path: string, init?: RequestInit): Promise<Response> {
  const response = await fetch(path, { ...init, cache: "no-store" }).catch(() => { throw new Refused({ message: GONE }, 0); });
  if (response.ok) return response;
  const { status } = response;
  // A refusal may have no readable message.
  const body = (await response.json().catch(() => null)) as { error?: Fault } | null;
  throw new Refused(body?.error ?? { message: `The studio refused the request with HTTP status ${status}.` }, status);
}

const post = async <T>(path: string, body: unknown, signal?: AbortSignal): Promise<T> => {
  const headers = { "content-type": "application/json" };
  return (await (await request(path, { method: "POST", headers, body: JSON.stringify(body), signal: signal ?? null })).json()) as T;
};

export const overview = async (find: string): Promise<Overview> =>
  (await (await request(`api/overview?find=${encodeURIComponent(find)}`)).json()) as Overview;

export const vocabulary = async (): Promise<Vocabulary> => (await (await request("api/vocabulary")).json()) as Vocabulary;

export const health = async (): Promise<HealthWords> =>
  ((await (await request("api/health")).json()) as { words: HealthWords }).words;

/** Calls `take` with each JSON line of an episode's recording as it arrives, without holding the whole text. */
export async function readRecording(id: string, take: (line: string) => void): Promise<void> {
  const response = await request(`api/episodes/${encodeURIComponent(id)}/recording`);
  try {
    const decoder = new TextDecoder();
    const reader = response.body!.getReader();
    let rest = "";
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
      const text = decoder.decode(next.value, { stream: true });
      const end = text.lastIndexOf("\n");
      if (end >= 0) {
        for (const line of (rest + text.slice(0, end)).split("\n")) take(line);
        rest = "";
      }
      rest += text.slice(end + 1);
    }
    take(rest + decoder.decode());
  } catch {
    throw new Refused({ message: "The recording of this episode is damaged: it cannot be decompressed. To list damaged files, run: wisch memory verify." }, 0);
  }
}

export const startRun = async (task: string, seed: number | null, strategy: string | null): Promise<string> => {
  const order = { task, ...(seed === null ? {} : { seed }), ...(strategy ? { strategy } : {}) };
  return (await post<{ run: string }>("api/runs", order)).run;
};

export const stopRun = (id: string): Promise<unknown> => post(`api/runs/${encodeURIComponent(id)}/stop`, {});
export const clearRun = (id: string): Promise<unknown> => post(`api/runs/${encodeURIComponent(id)}/clear`, {});

export async function ask(query: string, signal: AbortSignal): Promise<Answers> {
  const reply = await post<Answers | { error: Fault }>("api/ask", { query }, signal);
  if ("error" in reply) throw new Refused(reply.error, 200);
  return reply;
}

/** Calls `callback` whenever the lists of episodes or runs change, and after a reconnection; `state` reports the connection. */
export function onChanged(callback: () => void, state: (connected: boolean) => void): void {
  const events = new EventSource("api/overview/events");
  events.addEventListener("changed", callback);
  let lost = false;
  events.addEventListener("open", () => {
    state(true);
    if (lost) callback();
    lost = false;
  });
  events.addEventListener("error", () => {
    lost = true;
    state(false);
    if (events.readyState === EventSource.CLOSED) setTimeout(() => onChanged(callback, state), 2000);
  });
}

/** Maximum number of cached recordings. */
const MOST_KEPT = 4;
/** Time until the first retry of a refused connection; each further retry waits this much longer [ms]. */
const RETRY_MS = 1000;

export type Connection = "connecting" | "live" | "reconnecting" | "ended" | "lost" | "gone";

const cache = new Map<string, Recording>();

/** Loads the recording of an episode, or returns it from the cache. */
export async function loadEpisode(id: string): Promise<Recording> {
  const known = cache.get(id);
  cache.delete(id);
  const recording = known ?? new Recording();
  if (!known) await readRecording(id, (line) => recording.applyLine(line));
  if (!known) recording.close();
  keep(id, recording);
  return recording;
}

function keep(id: string, recording: Recording): void {
  cache.set(id, recording);
  const [oldest] = cache.keys();
  if (cache.size > MOST_KEPT && oldest !== undefined) cache.delete(oldest);
}

/** A live run: its recording grows as lines arrive. After a lost connection it continues at the next line. */
export class LiveSource {
  readonly recording = new Recording();
  connection: Connection = "connecting";
  message = "";
  private lines = 0;
  private events: EventSource | null = null;
  private later: ReturnType<typeof setTimeout> | undefined;
  private failures = 0;

  constructor(readonly id: string, private readonly changed: () => void) {
    this.open();
  }

  private open(): void {
    const events = new EventSource(`api/runs/${encodeURIComponent(this.id)}/stream?after=${this.lines}`);
    this.events = events;
    events.addEventListener("open", () => {
      this.failures = 0;
      this.set("live");
    });
    events.addEventListener("message", ({ data, lastEventId }: MessageEvent<string>) => {
      const line = Number(lastEventId);
      // A repeated line is skipped.
      if (line <= this.lines) return;
      this.lines = line;
      this.recording.applyLine(data);
    });
    events.addEventListener("end", ({ data }: MessageEvent<string>) => this.end(data));
    events.addEventListener("error", () => {
      this.set("reconnecting");
      if (events.readyState !== EventSource.CLOSED) return;
      // The server refused: the run no longer exists, or has too many viewers.
      this.failures++;
      if (this.failures > 3) {
        this.recording.close();
        this.set("gone");
        return;
      }
      this.later = setTimeout(() => this.open(), RETRY_MS * this.failures);
    });
  }

  private end(data: string): void {
    this.close();
    const end = JSON.parse(data) as { state: string; message: string };
    this.message = end.message;
    this.recording.close();
    const ended = end.state === "ended";
    // The episode may not be in the memory yet; the received recording equals it.
    if (ended && this.recording.ended) keep(this.episode, this.recording);
    this.set(ended ? "ended" : "lost");
  }

  /** Name of the episode of this run. */
  get episode(): string {
    return this.recording.ended?.episode ?? this.id;
  }

  private set(connection: Connection): void {
    this.connection = connection;
    this.changed();
  }

  close(): void {
    clearTimeout(this.later);
    this.events?.close();
    this.events = null;
  }
}
