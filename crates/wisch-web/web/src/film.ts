// Records the scene as a video that stands by itself: title, clock, phase and result are in the picture.
import type { Clock } from "./clock.ts";
import { clockText, el, estimateText, percent, say } from "./dom.ts";
import type { Stage } from "./scene/stage.ts";
import type { Recording } from "./store.ts";
import { colour } from "./theme.ts";
import { headlineOf } from "./words.ts";

const TYPES = ["video/webm;codecs=vp8", "video/webm"];
const BITS_PER_SECOND = 5e6;
/** How long the last picture stays, so that the result can be read, and time between its copies: an encoder that lags drops the end [ms]. */
const HOLD_MS = 1500;
const COPY_MS = 100;
/** A longer step of the clock at speed 1 is a jump [s]. */
const JUMP_S = 3.1;
/** A clip whose duration differs by a larger share is not of the stated speed [1]. */
const TOLERANCE = 0.05;
/** Height of the bars with texts, and size of their letters [pixels at ratio 1]. */
const BAR = 34;
const LETTERS = 15;

/** Returns why this browser cannot record, null if it can. */
function findObstacle(): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return "This browser cannot record video: it has no MediaRecorder for a canvas.";
  return TYPES.some((type) => MediaRecorder.isTypeSupported(type)) ? null : "This browser cannot record WebM video.";
}

/** A recording in progress. */
class Take {
  private readonly canvas = el("canvas");
  private readonly pen = this.canvas.getContext("2d")!;
  private readonly ratio = Math.min(2, devicePixelRatio || 1);
  private readonly chunks: Blob[] = [];
  private readonly recorder: MediaRecorder;
  private readonly track: CanvasCaptureMediaStreamTrack;
  private begun = 0;
  /** Whether the clock plays what is recorded. */
  isRunning = false;

  constructor(private readonly stage: Stage, private readonly recording: Recording, private readonly clock: Clock, readonly from: number, readonly to: number, readonly speed: number) {
    const { clientWidth, clientHeight } = stage.canvas;
    // Encoders need even sizes.
    const even = (size: number) => 2 * Math.round((size * this.ratio) / 2);
    Object.assign(this.canvas, { width: even(clientWidth), height: even(clientHeight + 2 * BAR) });
    const stream = this.canvas.captureStream(0);
    this.track = stream.getVideoTracks()[0] as CanvasCaptureMediaStreamTrack;
    this.recorder = new MediaRecorder(stream, { mimeType: TYPES.find((type) => MediaRecorder.isTypeSupported(type))!, videoBitsPerSecond: BITS_PER_SECOND });
    this.recorder.addEventListener("dataavailable", ({ data }) => this.chunks.push(data));
  }

  /** Starts the recorder with the current picture, without which it would wait; calls `then` when it records. */
  start(then: () => void): void {
    this.recorder.addEventListener("start", () => {
      this.begun = performance.now();
      this.isRunning = true;
      then();
    });
    this.recorder.start(1000);
    this.draw();
  }

  /** Adds the picture that the stage has just drawn. */
  draw(): void {
    const { canvas, pen, clock, recording, ratio } = this;
    const instant = recording.at(clock.time);
    const bar = BAR * ratio;
    pen.fillStyle = colour("scene");
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(this.stage.canvas, 0, bar, canvas.width, canvas.height - 2 * bar);
    const result = recording.resultAt(clock.time)?.interpreted;
    const performance = result ? `Estimated ${estimateText(result.estimate)}` : typeof instant?.performance === "number" ? `Predicted ${percent(instant.performance)}` : "";
    const time = `${clockText(clock.time)} / ${clockText(clock.duration)}${this.speed === 1 ? "" : ` \u00b7 ${this.speed}\u00d7`}`;
    this.write(0, recording.head?.title || "Recording", time);
    this.write(canvas.height - bar, instant ? `Round ${instant.round.number} of ${recording.rounds.length} \u00b7 ${headlineOf(recording, instant)}` : "", performance);
    this.track.requestFrame();
  }

  private write(top: number, left: string, right: string): void {
    const { canvas, pen, ratio } = this;
    const [edge, base] = [12 * ratio, top + (BAR / 2 + 0.36 * LETTERS) * ratio];
    pen.fillStyle = colour("paper");
    pen.fillRect(0, top, canvas.width, BAR * ratio);
    pen.fillStyle = colour("ink");
    pen.font = `600 ${LETTERS * ratio}px system-ui, sans-serif`;
    const width = Math.min(pen.measureText(right).width, canvas.width / 2);
    pen.fillText(right, canvas.width - edge - width, base, width);
    pen.fillText(left, edge, base, canvas.width - width - 3 * edge);
  }

  /** Ends the recording; returns the clip and its duration without the time of its last picture [s]. */
  async finish(): Promise<{ clip: Blob; took: number }> {
    const took = (performance.now() - this.begun) / 1000;
    // The stream takes pictures only in animation frames, and only of a canvas that is drawn on: here on a corner of the title.
    this.pen.fillStyle = colour("paper");
    for (const until = performance.now() + HOLD_MS; performance.now() < until;) {
      await new Promise((done) => setTimeout(() => requestAnimationFrame(done), COPY_MS));
      this.pen.fillRect(0, 0, 1, 1);
      this.track.requestFrame();
    }
    await this.stop();
    return { clip: new Blob(this.chunks, { type: "video/webm" }), took };
  }

  stop(): Promise<void> {
    if (this.recorder.state === "inactive") return Promise.resolve();
    const stopped = new Promise<void>((done) => this.recorder.addEventListener("stop", () => {
      this.track.stop();
      done();
    }));
    this.recorder.stop();
    return stopped;
  }
}

/** Time before the end of a round at which it is still shown: at its end the next one begins [s]. */
const BEFORE_NEXT_S = 5e-7;

/** Returns a menu that records the current view over a round or the run. The clock of the view plays it. */
export function makeFilm(stage: Stage, recording: Recording, clock: Clock): { element: HTMLElement; show(): void; destroy(): void } {
  const obstacle = findObstacle();
  let take: Take | null = null;
  let last = 0;
  const part = el("select", { class: "w-select", "aria-label": "Part of the run" });
  const start = el("button", { class: "w-button", type: "button", click: () => begin() });
  const cancel = el("button", { class: "w-button", type: "button", hidden: true, click: () => end("The recording was cancelled.") }, "Cancel");
  const progress = el("progress", { max: 1, value: 0, hidden: true, "aria-label": "Progress of the recording" });
  const said = el("p", { role: "status" }, obstacle ?? "The clip shows the current view, with title, clock and result.");
  const clip = el("a", { class: "w-button", hidden: true }, "Save the clip");
  start.disabled = obstacle !== null;

  const end = (words: string) => {
    void take?.stop();
    take = null;
    stage.onDrawn = null;
    for (const busy of [cancel, progress]) busy.hidden = true;
    say(said, words);
    if (clock.playing) clock.pause();
    show();
  };
  const begin = () => {
    const round = recording.rounds[Number(part.value) - 1];
    const [from, to] = round ? [round.start, Math.min(round.end - (round === recording.rounds.at(-1) ? 0 : BEFORE_NEXT_S), clock.end)] : [0, clock.end];
    if (!(to > from)) return end("Nothing to record: this part takes no time.");
    const speed = Math.max(1, clock.speed);
    clock.pause();
    clock.setSpeed(speed);
    clock.seek(from);
    try {
      take = new Take(stage, recording, clock, from, to, speed);
    } catch (error) {
      return end(`The recording cannot start: ${(error as Error).message}`);
    }
    for (const busy of [cancel, progress]) busy.hidden = false;
    clip.hidden = true;
    say(said, `Recording ${clockText(to - from, 0)} at ${speed}\u00d7.`);
    // The first picture is there before the clock runs.
    const begun = take;
    last = from;
    stage.onDrawn = () => {
      stage.onDrawn = () => begun.draw();
      begun.start(() => { if (take === begun) clock.play(); });
    };
    stage.ask();
    show();
  };
  const finish = async (done: Take) => {
    done.isRunning = false;
    clock.pause();
    clock.seek(done.to);
    const { clip: blob, took } = await done.finish();
    if (take !== done) return;
    const wanted = (done.to - done.from) / done.speed;
    const isRight = Math.abs(took - wanted) <= TOLERANCE * wanted + 0.2;
    URL.revokeObjectURL(clip.href);
    Object.assign(clip, { href: URL.createObjectURL(blob), hidden: false, download: `${(recording.head?.title || "recording").replace(/[^\p{L}\p{N}]+/gu, "-")}.webm` });
    end(`${clockText(took)} at ${done.speed}\u00d7, ${(blob.size / 1e6).toFixed(1)} MB.${isRight ? "" : ` The clip is not of this speed: it should take ${clockText(wanted)}. This machine draws too slowly.`}`);
  };
  const watch = clock.subscribe(() => {
    if (!take?.isRunning) return;
    const { from, to, speed } = take;
    const step = clock.time - last;
    last = clock.time;
    progress.value = (clock.time - from) / (to - from);
    if (clock.time >= to - 1e-6) void finish(take);
    else if (!clock.playing || clock.speed !== speed || step < 0 || step > JUMP_S * speed) end("The recording was cancelled, because the clock was changed.");
  });
  const hide = () => { if (document.hidden && take) end("The recording was cancelled, because the page was hidden."); };
  document.addEventListener("visibilitychange", hide);

  const show = () => {
    const { rounds, live } = recording;
    if (part.length !== rounds.length + 1) {
      const chosen = part.value;
      part.replaceChildren(el("option", { value: 0 }, "Whole run"), ...rounds.map(({ number }, i) => el("option", { value: i + 1 }, `Round ${number}`)));
      if (chosen) part.value = chosen;
    }
    start.disabled = obstacle !== null || live || take !== null || !rounds.length;
    if (live && !obstacle) say(said, "A live run can be recorded once it has ended.");
    say(start, `Record at ${Math.max(1, clock.speed)}\u00d7`);
  };
  show();
  return {
    element: el("details", { class: "w-film", name: "w-menu" }, el("summary", {}, "Film"), el("div", {}, part, start, cancel, progress, clip, said)),
    show,
    destroy: () => {
      document.removeEventListener("visibilitychange", hide);
      watch();
      if (take) end("");
      URL.revokeObjectURL(clip.href);
    },
  };
}
