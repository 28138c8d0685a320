// One view of a recording: scene, words, clock and timeline.
import { Clock } from "./clock.ts";
import { clockText, el } from "./dom.ts";
import { calmly, frames } from "./frames.ts";
import { listenKeys } from "./keys.ts";
import { colour } from "./theme.ts";
import { askedColour } from "./scene/asked.ts";
import type { ShownParticles } from "./scene/asked.ts";
import { ScenePanel } from "./scene/panel.ts";
import { safeColour } from "./scene/path.ts";
import type { Trajectory } from "./scene/path.ts";
import { drawnBySoftware } from "./software.ts";
import { Timeline } from "./timeline.ts";
import type { Interval } from "./timeline/highlights.ts";
import { transport } from "./transport.ts";
import { Words } from "./words.ts";
import type { Recording } from "./store.ts";

export type { Interval, ShownParticles, Trajectory };

/** Without a graphics card every word that changes costs; numbers that run change so often [ms]. */
const TOLD_MS = 150;

export interface ViewOptions {
  /** Little room: no words, fewer lanes. */
  compact?: boolean;
  /** Shared with other views, which then show the same time. */
  clock?: Clock;
}

export interface View {
  readonly element: HTMLElement;
  readonly clock: Clock;
  seek(time: number): void;
  /** Bands in the timeline and along the tool's path, in times of the common clock. */
  highlight(intervals: Interval[]): void;
  showTrajectories(list: Trajectory[]): void;
  /** The robot as it was at these times, see-through. */
  showRobotAt(times: number[]): void;
  /** Particles beside the recording's own. */
  showParticles(list: ShownParticles[]): void;
  /** Takes away what the four above showed. */
  clearShown(): void;
  /** Frames of the scene that were drawn so far. */
  readonly frames: number;
  destroy(): void;
}

export function mountView(root: HTMLElement, recording: Recording, { compact = false, clock: shared }: ViewOptions = {}): View {
  const clock = shared ?? new Clock();
  const leave = clock.join(recording);
  const panel = new ScenePanel(recording, compact, (time) => {
    if (clock.playing) clock.pause();
    clock.seek(time);
  });
  const timeline = new Timeline(recording, clock, compact);
  const words = compact ? null : new Words(recording, clock);
  const bar = transport(clock, recording);
  const element = el("div", { class: `w-view${compact ? " w-compact" : ""}` },
    el("div", { class: "w-grid" }, panel.element, words?.element, el("div", { class: "w-below" }, bar.element, timeline.element)));
  root.append(element);

  const told = calmly(drawnBySoftware() ? TOLD_MS : 0, () => {
    words?.show();
    bar.show();
  });
  const show = () => {
    panel.show(clock.time);
    told.ask();
  };
  const ask = () => frames.draw(show);
  const stops = [
    leave,
    clock.subscribe(ask),
    recording.onChange(() => {
      clock.grown();
      ask();
    }),
    listenKeys(element, clock, recording, (key) => {
      if (key === "f") panel.look("all");
      else if (key === "v") panel.look("above");
      else if (key === "t") panel.toggleFollow();
      else if (key === "l" && clock.live) clock.follow();
      else return false;
      return true;
    }),
  ];
  if (recording.live) clock.follow();
  show();

  const named = { trajectories: [] as Trajectory[], ghosts: [] as number[], particles: [] as ShownParticles[] };
  const name = () => panel.name([
    ...named.trajectories.map(({ name, color }, i) => ({ name, colour: safeColour(color, i) })),
    ...named.ghosts.map((time) => ({ name: `robot at ${clockText(time)}`, colour: colour("ghost") })),
    ...named.particles.map(({ name, color, state }) => ({ name, colour: askedColour(color), form: state })),
  ]);
  const showTrajectories = (list: Trajectory[]) => {
    named.trajectories = list;
    panel.stage?.showTrajectories(list);
    name();
  };
  const showRobotAt = (times: number[]) => {
    named.ghosts = times;
    panel.stage?.showGhosts(times);
    name();
  };
  const showParticles = (list: ShownParticles[]) => {
    named.particles = list;
    panel.stage?.showParticles(list);
    name();
  };
  const highlight = (intervals: Interval[]) => {
    timeline.highlight(intervals);
    panel.stage?.highlight(intervals);
  };
  return {
    element, clock, showTrajectories, showRobotAt, showParticles, highlight,
    seek: (time) => clock.seek(time),
    clearShown: () => {
      showTrajectories([]);
      showRobotAt([]);
      showParticles([]);
      highlight([]);
    },
    get frames() { return panel.stage?.drawn ?? 0; },
    destroy: () => {
      frames.drop(show);
      told.stop();
      for (const stop of stops) stop();
      panel.destroy();
      timeline.destroy();
      if (!shared) clock.destroy();
      element.remove();
    },
  };
}
