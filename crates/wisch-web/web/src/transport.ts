// The buttons of the clock, between scene and timeline.
import { SPEEDS, type Clock } from "./clock.ts";
import { clockText, el, say } from "./dom.ts";
import { icon } from "./icons.ts";
import { KEYS, nextStop } from "./keys.ts";
import type { Recording } from "./store.ts";

/** Returns the buttons. `more`: an element at their end. */
export function makeTransport(clock: Clock, recording: Recording, more: HTMLElement | null): { element: HTMLElement; show(): void } {
  const play = el("button", { class: "w-button w-play", type: "button", click: () => clock.toggle() });
  const stop = (way: 1 | -1) => el("button", {
    class: "w-button w-icon", type: "button",
    "aria-label": way < 0 ? "Previous event or stroke" : "Next event or stroke", title: way < 0 ? "Previous event or stroke  [" : "Next event or stroke  ]",
    click: () => clock.seek(nextStop(recording.stops, clock.time, way)),
  }, icon(way < 0 ? "before" : "after"));
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
    element: el("div", { class: "w-transport", role: "group", "aria-label": "Playback" }, play, stop(-1), stop(1), live, time, speed, more, help),
    show,
  };
}
