// The side panel with the list of runs and episodes.
import { el, fixed, hasChanged, percent, say } from "../dom.ts";
import { endOf } from "../words.ts";
import { clearRun, type Listed, type LiveRun, type Overview } from "./server.ts";
import { describeEvents, makeStrip } from "./strip.ts";
import { write } from "./address.ts";

/** Time without typing until the search starts [ms]. */
const REST_MS = 200;

export interface SideActions {
  /** Searches the episodes. */
  find(words: string): void;
  start(): void;
  /** Called with the recording that the user chose for comparison. */
  pick(id: string): void;
}

export class Side {
  readonly element: HTMLElement;
  private readonly list = el("div", { class: "s-list" });
  private readonly search: HTMLInputElement;
  private readonly where = el("p", { class: "s-where w-quiet" });
  private readonly note = el("div", { class: "s-picking", hidden: true, role: "status" });
  private overview: Overview | null = null;
  private current: string[] = [];
  private picking: string | null = null;

  constructor(private readonly actions: SideActions) {
    let later: ReturnType<typeof setTimeout> | undefined;
    this.search = el("input", {
      class: "s-search", type: "search", placeholder: "Search episodes", "aria-label": "Search episodes", autocomplete: "off",
      input: () => {
        clearTimeout(later);
        later = setTimeout(() => actions.find(this.words), REST_MS);
      },
    });
    this.element = el("section", { class: "s-runs" },
      el("button", { class: "w-button s-primary", type: "button", click: () => actions.start() }, "Start a task"),
      this.search, this.note, this.list, this.where);
  }

  get words(): string {
    return this.search.value.trim();
  }

  show(overview: Overview): void {
    this.overview = overview;
    this.draw();
  }

  /** Marks the shown recordings in the list. */
  mark(ids: string[]): void {
    this.current = ids;
    this.draw();
  }

  /** Compares the next chosen recording with `id`; null cancels. */
  compareWith(id: string | null): void {
    this.picking = id;
    this.note.hidden = !id;
    this.note.replaceChildren(...(id ? [
      el("p", {}, "Choose a run or episode to compare with."),
      el("button", { class: "w-button", type: "button", click: () => this.compareWith(null) }, "Cancel"),
    ] : []));
  }

  private draw(): void {
    if (!this.overview) return;
    const { list, runs, memory } = this.overview;
    if (!hasChanged(this.list, [list, runs, this.current])) return;
    const focused = (document.activeElement as HTMLElement | null)?.dataset.key;
    const parts: Node[] = [];
    const unfinished = runs.filter(({ state }) => state !== "ended");
    if (unfinished.length) parts.push(el("h2", {}, "Now"), el("ul", {}, ...unfinished.map((run) => this.makeRun(run))));
    for (const [day, episodes] of groupByDay(list.episodes)) {
      parts.push(el("h2", {}, day), el("ul", {}, ...episodes.map((episode) => this.makeEpisode(episode))));
    }
    if (!list.episodes.length && (this.words || !unfinished.length)) parts.push(el("p", { class: "w-quiet" }, this.words ? "No matching episodes." : "There are no episodes yet. Start a task."));
    if (list.total > list.episodes.length) {
      parts.push(el("p", { class: "w-quiet" }, `The list shows the newest ${list.episodes.length} of ${list.total} episodes. Use the search for older ones.`));
    }
    if (list.broken.length) {
      parts.push(el("details", { class: "s-broken" },
        el("summary", {}, `${list.broken.length} unreadable ${list.broken.length === 1 ? "episode" : "episodes"}`),
        ...list.broken.map((why) => el("p", {}, why))));
    }
    this.list.replaceChildren(...parts);
    say(this.where, `Memory: ${memory}`);
    if (focused) this.list.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  private makeLink(kind: "episode" | "run", id: string, ...children: (Node | string | null)[]): HTMLElement {
    const current = this.current.includes(id);
    return el("a", {
      href: write({ kind, ids: [id], time: null, query: null }), "data-key": id, "aria-current": current ? "true" : null,
      click: (event: MouseEvent) => {
        if (!this.picking || event.ctrlKey || event.metaKey || event.shiftKey) return;
        event.preventDefault();
        this.actions.pick(id);
      },
    }, ...children);
  }

  private makeRun({ id, task, begun, state, message }: LiveRun): HTMLElement {
    const lost = state === "lost";
    const words = lost ? "ended unexpectedly" : `running${begun ? ` since ${formatStart(begun)}` : ""}`;
    return el("li", {}, this.makeLink("run", id,
      el("span", { class: "s-title" }, el("i", { class: `s-dot${lost ? " s-dot-lost" : ""}`, "aria-hidden": "true" }), task),
      el("span", { class: "s-what" }, el("span", {}, words)),
      lost && message ? el("span", { class: "s-what s-bad" }, message) : null),
    lost && el("button", { class: "w-button s-clear", type: "button", title: "Remove from the list", "aria-label": `Remove ${task} from the list`, click: () => void clearRun(id).catch(() => {}) }, "\u00d7"));
  }

  private makeEpisode(one: Listed): HTMLElement {
    const { performance, low, high, rounds } = one;
    const facts = [formatHour(new Date(1000 * one.begun)), `${rounds} ${rounds === 1 ? "round" : "rounds"}`, `${fixed(one.seconds, 0)} s`];
    if (one.events.length) facts.push(describeEvents(one));
    if (!one.has_recording) facts.push("no recording");
    if (one.verdict && !one.met) facts.push(endOf(one).text);
    const interval = low !== null && high !== null ? `, 90\u202f% interval ${percent(low)} to ${percent(high)}` : "";
    return el("li", {}, this.makeLink("episode", one.id,
      el("span", { class: "s-title" }, el("span", {}, one.title),
        performance === null ? null : el("b", { title: `estimated performance${interval}` }, percent(performance)),
        badge(one)),
      makeStrip(one),
      el("span", { class: "s-what" }, facts.join(" \u00b7 "))));
  }
}

/** Returns a badge with the state of the goal. */
export function badge(episode: Pick<Listed, "met" | "verdict" | "badge" | "performance">): HTMLElement {
  const { state: goal, text } = endOf(episode);
  const state = goal === "unmet" && episode.performance === null ? "none" : goal;
  return el("span", { class: "s-badge", "data-state": state, title: text }, { met: "met", unmet: "not met", unknown: "unknown", none: "\u2013" }[state]);
}

const formatHour = (date: Date): string => date.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });

/** Formats the local time of day at which a run started. `begun`: date and time in UTC. */
function formatStart(begun: string): string {
  const date = new Date(`${begun.replace(" ", "T").replace(/Z$/, "")}Z`);
  return Number.isNaN(date.getTime()) ? begun : formatHour(date);
}

function groupByDay(episodes: Listed[]): Map<string, Listed[]> {
  const days = new Map<string, Listed[]>();
  const name = (date: Date) => date.toLocaleDateString([], { weekday: "short", year: "numeric", month: "short", day: "numeric" });
  const today = name(new Date());
  for (const episode of episodes) {
    let day = name(new Date(1000 * episode.begun));
    if (day === today) day = "Today";
    days.set(day, [...(days.get(day) ?? []), episode]);
  }
  return days;
}
