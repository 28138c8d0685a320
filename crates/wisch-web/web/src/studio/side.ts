// The left side: what can be looked at.
import { el, fixed, percent, say } from "../dom.ts";
import { goalState } from "../words.ts";
import { clearRun } from "./server.ts";
import type { Listed, LiveRun, Overview } from "./server.ts";
import { write } from "./address.ts";

/** Until typing rests [ms]. */
const REST_MS = 200;

export interface SideActions {
  /** Asks for the list anew. */
  find(words: string): void;
  start(): void;
  /** Another recording is picked to compare with. */
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
  private drawn = "";

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

  /** What is being shown, which the list marks. */
  mark(ids: string[]): void {
    this.current = ids;
    this.draw();
  }

  /** The next that is chosen is compared with this one; null: no more. */
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
    const drawn = JSON.stringify([list, runs, this.current]);
    // What has the focus keeps it where nothing changes.
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    const focused = (document.activeElement as HTMLElement | null)?.dataset.key;
    const parts: Node[] = [];
    const going = runs.filter(({ state }) => state !== "ended");
    if (going.length) parts.push(el("h2", {}, "Now"), el("ul", {}, ...going.map((run) => this.run(run))));
    for (const [day, episodes] of byDay(list.episodes)) {
      parts.push(el("h2", {}, day), el("ul", {}, ...episodes.map((episode) => this.episode(episode))));
    }
    if (!list.episodes.length && (this.words || !going.length)) parts.push(el("p", { class: "w-quiet" }, this.words ? "No matching episodes." : "No episodes yet: start a task."));
    if (list.total > list.episodes.length) {
      parts.push(el("p", { class: "w-quiet" }, `The newest ${list.episodes.length} of ${list.total}; search for the others.`));
    }
    if (list.broken.length) {
      parts.push(el("details", { class: "s-broken" },
        el("summary", {}, `${list.broken.length} cannot be read`),
        ...list.broken.map((why) => el("p", {}, why))));
    }
    this.list.replaceChildren(...parts);
    say(this.where, `Memory: ${memory}`);
    if (focused) this.list.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  private link(kind: "episode" | "run", id: string, ...children: (Node | string | null)[]): HTMLElement {
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

  private run({ id, task, begun, state, message }: LiveRun): HTMLElement {
    const lost = state === "lost";
    const words = lost ? "ended unexpectedly" : `running${begun ? ` since ${hour(begun)}` : ""}`;
    return el("li", {}, this.link("run", id,
      el("span", { class: "s-title" }, el("i", { class: `s-dot${lost ? " s-dot-lost" : ""}`, "aria-hidden": "true" }), task),
      el("span", { class: "s-what" }, el("span", {}, words)),
      lost && message ? el("span", { class: "s-what s-bad" }, message) : null),
    lost && el("button", { class: "w-button s-clear", type: "button", title: "Remove from the list", "aria-label": `Remove ${task} from the list`, click: () => void clearRun(id).catch(() => {}) }, "\u00d7"));
  }

  private episode(one: Listed): HTMLElement {
    const { performance, low, high, rounds, collisions } = one;
    const facts = [hourOf(new Date(1000 * one.begun)), `${rounds} ${rounds === 1 ? "round" : "rounds"}`, `${fixed(one.seconds, 0)} s`];
    if (collisions) facts.push(`pushed ${collisions}\u00d7`);
    if (!one.has_recording) facts.push("no recording");
    const interval = low !== null && high !== null ? `, 90\u202f% interval ${percent(low)} to ${percent(high)}` : "";
    return el("li", {}, this.link("episode", one.id,
      el("span", { class: "s-title" }, el("span", {}, one.title),
        performance === null ? null : el("b", { title: `estimated performance${interval}` }, percent(performance)),
        badge(one)),
      el("span", { class: "s-what" }, facts.join(" \u00b7 "))));
  }
}

/** Whether the goal was met, in a word. */
export function badge({ met, verdict, performance }: Pick<Listed, "met" | "verdict" | "performance">): HTMLElement {
  const judged = goalState(met, verdict);
  const state = judged === "unmet" && performance === null ? "none" : judged;
  return el("span", { class: "s-badge", "data-state": state, title: verdict ?? "" }, { met: "met", unmet: "not met", unknown: "unknown", none: "\u2013" }[state]);
}

const hourOf = (date: Date): string => date.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });

/** Date and time of a run, in UTC. */
function hour(begun: string): string {
  const date = new Date(`${begun.replace(" ", "T").replace(/Z$/, "")}Z`);
  return Number.isNaN(date.getTime()) ? begun : hourOf(date);
}

function byDay(episodes: Listed[]): Map<string, Listed[]> {
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
