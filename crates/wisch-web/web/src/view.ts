// A view of a recording: scene, details, clock and timeline.
import { Clock } from "./clock.ts";
import { el } from "./dom.ts";
import { makeFilm } from "./film.ts";
import { frames, throttle } from "./frames.ts";
import { listenKeys } from "./keys.ts";
import { ScenePanel } from "./scene/panel.ts";
import { NOTHING_SHOWN, type Shown, type Stage } from "./scene/stage.ts";
import { isSoftwareRendered } from "./software.ts";
import { Timeline } from "./timeline.ts";
import { makeTransport } from "./transport.ts";
import { Words } from "./words.ts";
import type { Recording } from "./store.ts";

/** Interval between updates of the texts without a graphics card, where they are slow [ms]. */
const TEXT_MS = 150;

export interface ViewOptions {
  /** Compact layout: no details, fewer lanes. */
  compact?: boolean;
  /** Clock shared with other views, which then show the same time. */
  clock?: Clock;
}

export interface View {
  readonly element: HTMLElement;
  readonly clock: Clock;
  seek(time: number): void;
  /** Shows data of a query instead of those before; without an argument, none. */
  show(data?: Partial<Shown>): void;
  /** The scene; null where the browser cannot draw it. */
  readonly stage: Stage | null;
  destroy(): void;
}

/** Closes the open menu beside the clock. Returns whether one was open. */
function closeMenu(view: HTMLElement): boolean {
  const menu = view.querySelector<HTMLDetailsElement>("details[name=w-menu][open]");
  if (!menu) return false;
  menu.open = false;
  menu.querySelector("summary")!.focus();
  return true;
}

export function mountView(root: HTMLElement, recording: Recording, { compact = false, clock: shared }: ViewOptions = {}): View {
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

  const showData = (data: Partial<Shown> = {}) => {
    const shown = { ...NOTHING_SHOWN, ...data };
    timeline.highlight(shown.intervals);
    panel.showData(shown);
  };
  return {
    element, clock, show: showData,
    seek: (time) => clock.seek(time),
    stage: panel.stage,
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
