// Keyboard shortcuts of a view: those of the clock, and those of its owner.
import type { Clock } from "./clock.ts";
import type { Recording } from "./store.ts";

const STEP_S = 0.1;
const LONG_STEP_S = 1;
/** A stop closer than this to the current time is skipped [s]. */
const SAME_S = 0.05;

export const KEYS: [string, string][] = [
  ["Space", "play, pause"],
  ["\u2190 \u2192", "0.1 s back, forward (with Shift: 1 s)"],
  ["[ ]", "previous, next event or stroke"],
  ["Home End", "start, end"],
  ["+ \u2212", "faster, slower"],
  ["L", "follow a live run"],
  ["F", "fit view"],
  ["T", "follow the work: wide in free motion, close at strokes"],
  ["V", "view from above"],
  ["W A S D", "turn the scene (while it has the focus)"],
  ["Z X", "zoom in, out (while the scene has the focus)"],
  ["I O", "start (I) or end (O) the selected part of the path at the shown time (or drag on the plot of forces)"],
  ["Esc", "end the selection; close a menu"],
];

/** Returns the nearest stop before (-1) or after (1) a time. */
export function nextStop(stops: number[], time: number, way: 1 | -1): number {
  const found = way > 0 ? stops.find((stop) => stop > time + SAME_S) : stops.findLast((stop) => stop < time - SAME_S);
  return found ?? (way > 0 ? stops.at(-1) ?? time : stops[0] ?? time);
}

const views: HTMLElement[] = [];

/** Whether the focused element uses a key itself, as a text field or a list does. */
const isTaken = (target: EventTarget | null, key: string): boolean => {
  if (!(target instanceof HTMLElement) || key === "Escape") return false;
  if (target.isContentEditable || /^(TEXTAREA|SELECT)$/.test(target.tagName)) return true;
  if (target instanceof HTMLInputElement && target.type === "range") return /^(Arrow|Page|Home$|End$)/.test(key);
  if (target instanceof HTMLInputElement) return !(target.type === "checkbox" && key !== " ");
  return key === " " && /^(BUTTON|A|SUMMARY)$/.test(target.tagName);
};

/** An act returns false where it has nothing to do, so that the browser handles the key. */
type Acts = Record<string, (shift: boolean) => void | boolean>;

/** Listens to the keys of the clock, and to those of `more`, while the focus is in `root`; returns a function that stops this. */
export function listenKeys(root: HTMLElement, clock: Clock, recording: Recording, more: Acts): () => void {
  views.push(root);
  const step = (by: number) => {
    if (clock.playing) clock.pause();
    clock.seek(clock.time + by);
  };
  const acts: Acts = {
    ...more,
    " ": () => clock.toggle(),
    ArrowLeft: (shift) => step(shift ? -LONG_STEP_S : -STEP_S),
    ArrowRight: (shift) => step(shift ? LONG_STEP_S : STEP_S),
    "[": () => clock.seek(nextStop(recording.stops, clock.time, -1)),
    "]": () => clock.seek(nextStop(recording.stops, clock.time, 1)),
    Home: () => clock.seek(0),
    End: () => clock.seek(clock.end),
    "+": () => clock.faster(1),
    "=": () => clock.faster(1),
    "-": () => clock.faster(-1),
  };
  const down = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || isTaken(event.target, event.key)) return;
    const target = event.target as Node;
    // If no element has the focus, the first view handles the keys.
    const unfocused = target === document.body || target === document.documentElement;
    if (!root.contains(target) && !(unfocused && views[0] === root)) return;
    const act = acts[event.key] ?? acts[event.key.toLowerCase()];
    if (act && act(event.shiftKey) !== false) event.preventDefault();
  };
  document.addEventListener("keydown", down);
  return () => {
    document.removeEventListener("keydown", down);
    views.splice(views.indexOf(root), 1);
  };
}
