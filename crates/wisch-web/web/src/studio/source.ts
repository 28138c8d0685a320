// Where recordings come from: episodes that are kept, and runs that go on.
import { Recording } from "../store.ts";
import { readRecording } from "./server.ts";

/** Most recordings that are kept for a later look. */
const MOST_KEPT = 4;
/** How long until a broken connection is tried again [ms]. */
const RETRY_MS = 1000;

export type Connection = "connecting" | "live" | "reconnecting" | "ended" | "lost" | "gone";

const kept = new Map<string, Recording>();

/** The recording of an episode. */
export async function episode(id: string): Promise<Recording> {
  const known = kept.get(id);
  kept.delete(id);
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

/** Whether it is here already. */
export const isHere = (id: string): boolean => kept.has(id);

function keep(id: string, recording: Recording): void {
  kept.set(id, recording);
  const [oldest] = kept.keys();
  if (kept.size > MOST_KEPT && oldest !== undefined) kept.delete(oldest);
}

/** A run that goes on: its recording grows as lines come in; a connection that breaks goes on where it was. */
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
      // Twice is once.
      if (line <= this.lines) return;
      this.lines = line;
      this.recording.applyLine(data);
    });
    events.addEventListener("end", ({ data }: MessageEvent<string>) => this.end(data));
    events.addEventListener("error", () => {
      this.set("reconnecting");
      if (events.readyState !== EventSource.CLOSED) return;
      // It was refused: the run is gone, or too many look on.
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
    const said = JSON.parse(data) as { state: string; message: string };
    this.message = said.message;
    this.recording.close();
    const ended = said.state === "ended";
    // The episode may not lie in the memory yet; what was seen of it is the same.
    if (ended && this.recording.ended) keep(this.episode, this.recording);
    this.set(ended ? "ended" : "lost");
  }

  /** The name of the episode that the run becomes. */
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
