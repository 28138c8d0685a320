// Sources of recordings: episodes and live runs.
import { Recording } from "../store.ts";
import { readRecording } from "./server.ts";

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
  const recording = known ?? (await read(id));
  keep(id, recording);
  return recording;
}

async function read(id: string): Promise<Recording> {
  const recording = new Recording();
  await readRecording(id, (line) => recording.applyLine(line));
  recording.close();
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
