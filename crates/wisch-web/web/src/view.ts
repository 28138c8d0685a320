// A view of a recording: scene, details, clock and timeline.
import { Clock, SPEEDS } from "./clock.ts";
import { clockText, el, say } from "./dom.ts";
import { makeFilm } from "./film.ts";
import { frames, isSoftwareRendered, throttle } from "./frames.ts";
import { icon } from "./icons.ts";
import { KEYS, listenKeys, nextStop } from "./keys.ts";
import { ScenePanel } from "./scene/panel.ts";
import { NOTHING_SHOWN, type Shown } from "./scene/stage.ts";
import { Timeline } from "./timeline.ts";
import { Words } from "./words.ts";
import type { Recording } from "./store.ts";

/** Interval between updates of the texts without a graphics card, where they are slow [ms]. */
const TEXT_MS = 150;

export type View = ReturnType<typeof mountView>;

/** Closes the open menu beside the clock. Returns whether one was open. */
function closeMenu(view: HTMLElement): boolean {
  const menu = view.querySelector<HTMLDetailsElement>("details[name=w-menu][open]");
  if (!menu) return false;
  menu.open = false;
  menu.querySelector("summary")!.focus();
  return true;
}

/** Returns the buttons. `more`: an element at their end. */
function makeTransport(clock: Clock, recording: Recording, more: HTMLElement | null): { element: HTMLElement; show(): void } {
  const play = el("button", { class: "w-button w-play", type: "button", click: () => clock.toggle() });
  const stop = (way: 1 | -1, label: string, key: string) =>
    el("button", { class: "w-button w-icon", type: "button", "aria-label": label, title: `${label}  ${key}`, click: () => clock.seek(nextStop(recording.stops, clock.time, way)) }, icon(way < 0 ? "before" : "after"));
  const live = el("button", { class: "w-button w-live", type: "button", title: "Follow the live run  L", click: () => clock.follow() }, "LIVE");
  const time = el("output", { class: "w-time", "aria-live": "off" });
  const speed = el("select", { class: "w-select", "aria-label": "Playback speed", change: () => clock.setSpeed(Number(speed.value)) },
    ...SPEEDS.map((value) => el("option", { value }, `${value}\u00d7`)));
  const help = el("details", { class: "w-keys", name: "w-menu" }, el("summary", {}, "Keys"),
    el("dl", {}, ...KEYS.flatMap(([key, what]) => [el("dt", {}, key), el("dd", {}, what)])));
  let playing: boolean | null = null;
  const show = () => {
    const runs = clock.playing || clock.following;
    if (runs !== playing) {
      playing = runs;
      play.replaceChildren(icon(runs ? "pause" : "play"), el("span", {}, runs ? "Pause" : "Play"));
      play.setAttribute("aria-label", runs ? "Pause" : "Play");
    }
    live.hidden = !clock.live;
    live.setAttribute("aria-pressed", String(clock.following));
    say(time, `${clockText(clock.time)} / ${clockText(clock.duration)}${clock.isLate ? " (slower than real time)" : ""}`);
    if (Number(speed.value) !== clock.speed) speed.value = String(clock.speed);
  };
  show();
  return {
    element: el("div", { class: "w-transport", role: "group", "aria-label": "Playback" },
      play, stop(-1, "Previous event or stroke", "["), stop(1, "Next event or stroke", "]"), live, time, speed, more, help),
    show,
  };
}

/** Shows a recording. A compact view has no details, and fewer lanes. Views that share a clock show the same time. */
export function mountView(root: HTMLElement, recording: Recording, { compact = false, clock: shared }: { compact?: boolean; clock?: Clock } = {}) {
  const clock = shared ?? new Clock();
  const leave = clock.join(recording);
  const panel = new ScenePanel(recording, compact, (time) => {
    if (clock.playing) clock.pause();
    clock.seek(time);
  });
  const timeline = new Timeline(recording, clock, compact, (interval) => panel.stage?.select(interval));
  const words = compact ? null : new Words(recording, clock, (choice) => panel.choose(choice));
  const film = panel.stage && !compact ? makeFilm(panel.stage, recording, clock) : null;
  const bar = makeTransport(clock, recording, film?.element ?? null);
  const element = el("div", { class: `w-view${compact ? " w-compact" : ""}` },
    el("div", { class: "w-grid" }, panel.element, words?.element, el("div", { class: "w-below" }, bar.element, timeline.element)));
  root.append(element);

  const texts = throttle(isSoftwareRendered() ? TEXT_MS : 0, () => {
    words?.show();
    bar.show();
    film?.show();
  });
  const show = () => {
    panel.show(clock.time);
    texts.ask();
  };
  const ask = () => frames.draw(show);
  const stops = [
    leave,
    clock.subscribe(ask),
    recording.onChange(() => {
      clock.onGrowth();
      ask();
    }),
    listenKeys(element, clock, recording, {
      f: () => panel.look("all"), v: () => panel.look("above"), t: () => panel.toggleFollow(), l: () => clock.live && clock.follow(),
      i: () => timeline.selectTo(false), o: () => timeline.selectTo(true), Escape: () => closeMenu(element) || timeline.select(null),
    }),
  ];
  if (recording.live) clock.follow();
  show();

  return {
    element, clock,
    /** The scene; null where the browser cannot draw it. */
    stage: panel.stage,
    seek: (time: number) => clock.seek(time),
    /** Shows data of a query instead of those before; without an argument, none. */
    show: (data: Partial<Shown> = {}) => {
      const shown = { ...NOTHING_SHOWN, ...data };
      timeline.highlight(shown.intervals);
      panel.showData(shown);
    },
    destroy: () => {
      frames.drop(show);
      texts.stop();
      film?.destroy();
      for (const stop of stops) stop();
      panel.destroy();
      timeline.destroy();
      if (!shared) clock.destroy();
      element.remove();
    },
  };
}
