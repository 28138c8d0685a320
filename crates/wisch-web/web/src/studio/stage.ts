// The main area: one recording, or two side by side on one clock.
import { Vector3 } from "three";
import { Clock, onRest } from "../clock.ts";
import { el, percent, say } from "../dom.ts";
import { onNews } from "../frames.ts";
import { Story } from "../story.ts";
import { mountView, type View } from "../view.ts";
import type { Recording } from "../store.ts";
import { write } from "./address.ts";
import { Comparison, makeLetter } from "./compare.ts";
import { stopRun, type Answers, type LiveSource } from "./server.ts";
import { apply, episodesOf, shownOf } from "./shown.ts";

export interface Source {
  id: string;
  recording: Recording;
  live: LiveSource | null;
}

export interface StageActions {
  /** Called with the time at which the clock rests [s]. */
  rests(time: number): void;
  /** Called when the user wants to compare the shown recording; null where nothing can be compared. */
  compare: (() => void) | null;
  /** Whether a recording is in the memory, as an episode of this name. */
  isKept(id: string): boolean;
}

interface Pane extends Source {
  view: View;
  head: Head;
}

export class Stage {
  readonly element = el("section", { class: "s-stage", "aria-label": "Recording" });
  private panes: Pane[] = [];
  private clock: Clock | null = null;
  private stops: (() => void)[] = [];

  constructor(private readonly actions: StageActions) {}

  get shown(): readonly { id: string; recording: Recording; view: View }[] {
    return this.panes;
  }

  get time(): number {
    return this.panes[0]?.view.clock.time ?? 0;
  }

  /** Shows a message instead of a recording. */
  say(kind: "note" | "fault" | "wait", message: string, ...more: (Node | string)[]): void {
    this.clear();
    this.element.append(el("div", { class: `s-said s-${kind}`, role: kind === "fault" ? "alert" : "status" }, el("p", {}, message), ...more));
  }

  show(sources: Source[], time: number | null): void {
    this.clear();
    const compact = sources.length > 1;
    this.element.classList.toggle("s-two", compact);
    const shared = compact ? new Clock() : undefined;
    this.clock = shared ?? null;
    this.panes = sources.map((source, i) => this.makePane(source, shared, i));
    if (shared) this.compare(shared);
    const clock = this.panes[0]!.view.clock;
    if (time !== null) clock.seek(time);
    this.stops.push(onRest(clock, this.actions.rests));
  }

  /** Links the views, and shows what differs between their recordings. */
  private compare(clock: Clock): void {
    const [first, second] = this.panes;
    if (!first || !second) return;
    const comparison = new Comparison([first.recording, second.recording], [first.id, second.id], clock);
    this.element.append(comparison.element);
    this.stops.push(() => comparison.destroy(), linkCameras(this.panes));
  }

  private makePane(source: Source, shared: Clock | undefined, i: number): Pane {
    const { recording } = source;
    const head = new Head(source, !shared, this.actions, (time) => view.seek(time));
    if (shared) head.element.prepend(makeLetter(i));
    const box = el("div", { class: "s-view" });
    this.element.append(el("div", { class: "s-pane" }, head.element, head.story, box));
    const view = mountView(box, recording, shared ? { compact: true, clock: shared } : {});
    return { ...source, view, head };
  }

  /** Shows one answer or all (`row` null): in an episode (`wanted`), or else in a shown one that they mention, or else in the one
   * that `choose` returns. `load` shows another episode. */
  async answer(answers: Answers, row: number | null, wanted: string | null, choose: (episodes: string[]) => string | undefined, load: (id: string) => Promise<void>): Promise<void> {
    const episodes = episodesOf(answers, row);
    const id = wanted ?? this.panes.find((one) => episodes.includes(one.id))?.id ?? choose(episodes);
    if (!id) return;
    const find = () => this.panes.find((one) => one.id === id);
    if (!find()) await load(id);
    const now = find();
    if (!now) return;
    for (const { head } of this.panes) head.toggle(false);
    apply(now.view, shownOf(answers, row, id, now.recording));
  }

  /** Gives the focus to the shown view. */
  focus(): void {
    const element = this.panes[0]?.view.element;
    if (!element) return;
    element.tabIndex = -1;
    element.focus({ preventScroll: true });
  }

  /** Updates the heads after a change of a connection. */
  onConnectionChanged(): void {
    for (const { head } of this.panes) head.show();
  }

  clear(): void {
    for (const stop of this.stops) stop();
    this.stops = [];
    for (const { view, head } of this.panes) {
      head.destroy();
      view.destroy();
    }
    this.clock?.destroy();
    this.clock = null;
    this.panes = [];
    this.element.classList.remove("s-two");
    this.element.replaceChildren();
  }
}

/** Position of the surface, relative to which the camera moves. */
const anchorOf = ({ rounds }: Recording): Vector3 => new Vector3(...(rounds[0]?.plan.surface.pose.slice(0, 3) ?? []));

/** Links the cameras of views: each looks at its surface from the same direction and distance. Returns a function that ends this. */
function linkCameras(panes: readonly Pane[]): () => void {
  let copying = false;
  const stops = panes.map(({ view: { stage }, recording }) => {
    const moved = () => {
      if (copying || !stage) return;
      copying = true;
      for (const other of panes) {
        if (!other.view.stage || other.view.stage === stage) continue;
        const shift = anchorOf(other.recording).sub(anchorOf(recording));
        const { target, eye } = stage.camera.view;
        other.view.stage.camera.followLinked({ target: target.add(shift), eye: eye.add(shift) }, stage.camera.asked);
      }
      copying = false;
    };
    stage?.camera.controls.addEventListener("change", moved);
    return () => stage?.camera.controls.removeEventListener("change", moved);
  });
  return () => { for (const stop of stops) stop(); };
}

const CONNECTIONS = {
  connecting: "connecting \u2026",
  live: "live",
  reconnecting: "connection lost, reconnecting \u2026",
  ended: "",
  lost: "the run ended unexpectedly",
  gone: "the run no longer exists",
} as const;

/** The head of a view: title, result and buttons. */
class Head {
  readonly element: HTMLElement;
  readonly story: HTMLElement;
  private readonly result = el("b", { title: "estimated performance, 90 % interval" });
  private readonly connection = el("span", { class: "s-connection", role: "status" });
  private readonly kept = el("span", { class: "s-kept w-quiet" });
  private readonly stopButton: HTMLButtonElement;
  private readonly storyButton: HTMLButtonElement;
  private readonly summary: Story;
  private wasLive: boolean;
  private readonly stop: () => void;

  constructor(private readonly source: Source, private readonly whole: boolean, private readonly actions: StageActions, seek: (time: number) => void) {
    const { recording, id } = source;
    this.wasLive = source.live !== null;
    this.summary = new Story(recording, seek);
    this.story = el("div", { class: "s-story", hidden: true }, this.summary.element);
    this.stopButton = el("button", { class: "w-button s-stop", type: "button", hidden: true, click: () => this.stopIt(id) }, "Stop");
    this.storyButton = el("button", { class: "w-button", type: "button", "aria-pressed": "false", click: () => this.toggle(this.story.hidden) }, "Summary");
    this.element = el("header", { class: "s-head" }, this.summary.title, el("span", { class: "s-result" }, this.result, this.summary.badge), this.connection, this.kept,
      el("span", { class: "s-actions" }, this.stopButton, this.storyButton,
        whole && actions.compare && el("button", { class: "w-button", type: "button", click: () => actions.compare?.() }, "Compare")));
    this.stop = onNews(recording, () => this.show());
    this.show();
  }

  toggle(open: boolean): void {
    this.story.hidden = !open;
    this.storyButton.setAttribute("aria-pressed", String(open));
  }

  private stopIt(id: string): void {
    this.stopButton.disabled = true;
    say(this.stopButton, "Stopping \u2026");
    stopRun(id).catch((error: Error) => {
      this.stopButton.disabled = false;
      say(this.stopButton, "Stop");
      say(this.connection, error.message);
    });
  }

  show(): void {
    const { recording, live, id } = this.source;
    const estimate = recording.rounds.findLast((round) => round.interpreted)?.interpreted?.estimate;
    if (estimate) this.result.replaceChildren(percent(estimate.mean), el("small", {}, ` ${percent(estimate.low)} \u2013 ${percent(estimate.high)}`));
    this.summary.badge.hidden = recording.live;
    const connection = live?.connection ?? "ended";
    this.connection.dataset.state = connection;
    say(this.connection, [CONNECTIONS[connection], live?.message ?? ""].filter((words) => words).join(": "));
    this.stopButton.hidden = !live || connection === "ended" || connection === "lost" || connection === "gone";
    const episode = live?.episode ?? id;
    this.summary.title.title = id;
    if (live && connection === "ended") {
      this.kept.replaceChildren(this.actions.isKept(episode)
        ? el("a", { href: write({ kind: "episode", ids: [episode], time: null, query: null }), title: episode }, "kept as an episode") : "not kept as an episode");
    }
    if (this.wasLive && recording.ended) {
      // When a live run ends, its summary opens.
      this.wasLive = false;
      if (this.whole) this.toggle(true);
    }
  }

  destroy(): void {
    this.stop();
    this.summary.destroy();
  }
}
