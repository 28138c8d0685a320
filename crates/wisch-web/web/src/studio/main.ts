// The page of the studio: the list of runs, the shown recordings and the query. The address holds the shown state.
import "./studio.css";
import { el } from "../dom.ts";
import { isSame, read, replace, write, type Place } from "./address.ts";
import { Ask } from "./ask.ts";
import { Health } from "./health.ts";
import { LiveSource, loadEpisode, onChanged, overview, Refused, type Answers, type Overview } from "./server.ts";
import { Side } from "./side.ts";
import { Stage, type Source } from "./stage.ts";
import { StartDialog } from "./start.ts";

type Part = "runs" | "ask" | "health";

const HOME: Place = { kind: "home", ids: [], time: null, query: null };

class Studio {
  private readonly side: Side;
  private readonly stage: Stage;
  private readonly ask: Ask;
  private readonly health = new Health();
  private readonly dialog: StartDialog;
  private readonly tabs: Record<Part, HTMLButtonElement>;
  private readonly offline = el("p", { class: "s-offline", role: "status", hidden: true }, "The studio does not respond. If it has ended, start it again: wisch studio.");
  private readonly aside: HTMLElement;
  private known: Overview | null = null;
  private place: Place = HOME;
  private live: LiveSource[] = [];
  /** Whether a place could not be chosen because the list of runs is unknown; the stage shows why. */
  private waits = false;
  /** Number of started loads; the result of an outdated load is dropped. */
  private opened = 0;

  constructor(root: HTMLElement, corner: HTMLElement) {
    this.side = new Side({
      find: () => void this.refresh(),
      start: () => this.dialog.open(),
      pick: (id) => this.compare(id),
    });
    this.ask = new Ask({
      show: (answers, row, id) => void this.show(answers, row, id),
      clear: () => { for (const { view } of this.stage.shown) view.show(); },
      asked: (query) => this.keep({ query }),
    });
    this.stage = new Stage({
      rests: (time) => this.keep({ time }),
      compare: () => {
        this.open("runs");
        this.side.compareWith(this.place.ids[0] ?? null);
      },
      isKept: (id) => this.isKept(id),
    });
    this.dialog = new StartDialog((id) => void this.go({ ...HOME, kind: "run", ids: [id] }).then(() => this.stage.focus()));
    const tab = (name: Part, words: string, title: string) => el("button", {
      class: "w-button", type: "button", "aria-pressed": "false", title,
      click: () => (this.isNarrow && this.aside.dataset.open === name ? this.open(null) : this.open(name)),
    }, words);
    this.tabs = { runs: tab("runs", "Runs", "Runs and episodes"), ask: tab("ask", "Ask", "Ask the memory ( / )"), health: tab("health", "Health", "What changes from run to run") };
    this.aside = el("aside", { class: "s-side" },
      el("header", { class: "s-top" }, el("h2", { class: "s-name" }, "wisch studio"), this.tabs.runs, this.tabs.ask, this.tabs.health, corner),
      this.offline, this.side.element, this.ask.element, this.health.element);
    root.classList.add("s-studio");
    root.append(this.aside, this.stage.element, this.dialog.element);
    this.open("runs");
  }

  async begin(): Promise<void> {
    addEventListener("hashchange", () => void this.route());
    document.addEventListener("keydown", (event) => {
      const target = event.target as HTMLElement;
      if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName)) return;
      event.preventDefault();
      this.open("ask");
      this.ask.field.focus();
    });
    onChanged(() => void this.refresh(), (connected) => { this.offline.hidden = connected; });
    // For measurements, and for use from the browser's console.
    Object.assign(window, { wisch: { studio: this, stage: this.stage } });
    const listed = this.refresh();
    // An episode can be fetched at once; everything else needs the list first.
    if (read(location.hash).kind !== "episode") await listed;
    await this.route();
  }

  private get isNarrow(): boolean {
    return matchMedia("(max-width: 760px)").matches;
  }

  /** Opens a part of the side panel; null closes it. */
  private open(part: Part | null): void {
    this.aside.dataset.open = part ?? "";
    this.side.element.hidden = part !== "runs";
    this.ask.element.hidden = part !== "ask";
    this.health.element.hidden = part !== "health";
    if (part === "health") void this.health.load();
    for (const name of ["runs", "ask", "health"] as const) this.tabs[name].setAttribute("aria-pressed", String(part === name));
  }

  private async refresh(): Promise<void> {
    try {
      this.known = await overview(this.side.words);
      this.side.show(this.known);
      this.dialog.setScenarios(this.known.scenarios);
      this.stage.onConnectionChanged();
      if (!this.health.element.hidden) void this.health.load();
      if (this.waits) void this.route();
    } catch (error) {
      if (!this.known) this.stage.say("fault", (error as Error).message);
    }
  }

  private isKept(id: string): boolean {
    return this.known?.list.episodes.some((one) => one.id === id) ?? false;
  }

  /** Opens another place, with an entry in the browser's history. */
  private async go(place: Place): Promise<void> {
    history.pushState(null, "", write(place) || location.pathname);
    await this.route();
  }

  /** Changes the address of the shown place. */
  private keep(change: Partial<Place>): void {
    this.place = { ...this.place, ...change };
    replace(this.place);
  }

  /** Shows the place in the address. */
  private async route(): Promise<void> {
    let place = read(location.hash);
    const { query } = place;
    if (place.kind === "home") place = { ...this.first(), query };
    const before = this.place;
    this.place = place;
    if (!isSame(before, place) || !this.stage.shown.length) await this.load(place);
    else if (place.time !== null && Math.abs(place.time - this.stage.time) > 0.06) this.stage.shown[0]!.view.seek(place.time);
    if (query && query !== before.query) {
      this.open("ask");
      this.ask.propose(query);
    }
  }

  /** Returns the place for an empty address: a live run, or else the newest episode. */
  private first(): Place {
    const run = this.known?.runs.find(({ state }) => state === "running");
    if (run) return { ...HOME, kind: "run", ids: [run.id] };
    const newest = this.known?.list.episodes.find(({ has_recording }) => has_recording);
    return newest ? { ...HOME, kind: "episode", ids: [newest.id] } : HOME;
  }

  private async load(place: Place): Promise<void> {
    const mine = ++this.opened;
    for (const live of this.live) live.close();
    this.live = [];
    this.side.compareWith(null);
    this.side.mark(place.ids);
    if (this.isNarrow && place.kind !== "home") this.open(null);
    this.waits = place.kind === "home" && !this.known;
    if (this.waits) return;
    if (place.kind === "home") {
      this.stage.say("note", "This memory has no runs yet.",
        el("button", { class: "w-button s-primary", type: "button", click: () => this.dialog.open() }, "Start a task"));
      return;
    }
    this.stage.say("wait", "Loading \u2026");
    try {
      const sources: Source[] = [];
      for (const id of place.ids) sources.push(await this.source(id, place.kind === "run"));
      if (mine !== this.opened) return;
      this.stage.show(sources, place.time);
      document.title = `${sources.map(({ id, recording }) => recording.head?.title ?? id).join(" | ")} \u2013 wisch studio`;
    } catch (error) {
      if (mine !== this.opened) return;
      const words = error instanceof Refused ? error.message : `The recording cannot be shown: ${String(error)}`;
      this.stage.say("fault", words, el("p", { class: "w-quiet" }, "Queries about this episode still work."));
    }
  }

  private async source(id: string, isRun: boolean): Promise<Source> {
    // A run that has just started is not listed yet.
    if (isRun && !this.isRun(id)) await this.refresh();
    if (this.isRun(id)) return this.liveSource(id);
    try {
      return { id, recording: await loadEpisode(id), live: null };
    } catch (error) {
      if (!(error instanceof Refused) || error.status !== 404) throw error;
      // The run may have just started.
      await this.refresh();
      if (this.isRun(id)) return this.liveSource(id);
      if (this.known && !this.isKept(id)) throw new Refused({ message: `There is no run or episode ${id}. A run that is stopped before its first motion is not kept.` }, 404);
      throw error;
    }
  }

  private isRun(id: string): boolean {
    return this.known?.runs.some((run) => run.id === id) ?? false;
  }

  private liveSource(id: string): Source {
    const live = new LiveSource(id, () => this.liveChanged(live));
    this.live.push(live);
    return { id, recording: live.recording, live };
  }

  private liveChanged(live: LiveSource): void {
    this.stage.onConnectionChanged();
    if (live.connection !== "ended") return;
    void this.refresh().then(() => {
      // The view stays the same; the address now names the episode.
      if (this.place.kind !== "run" || this.place.ids[0] !== live.id || !this.isKept(live.episode)) return;
      this.keep({ kind: "episode", ids: [live.episode] });
      this.side.mark(this.place.ids);
    });
  }

  private compare(id: string): void {
    const first = this.place.ids[0];
    this.side.compareWith(null);
    if (!first || first === id) return;
    void this.go({ kind: "compare", ids: [first, id], time: this.stage.time, query: null });
  }

  /** Shows answers: in the shown episode if they mention it, else in the episode with most of them. */
  private async show(answers: Answers, row: number | null, wanted: string | null): Promise<void> {
    await this.stage.answer(answers, row, wanted, ([most]) => most, async (id) => {
      const place: Place = { kind: "episode", ids: [id], time: null, query: this.place.query };
      history.pushState(null, "", write(place));
      this.place = place;
      await this.load(place);
    });
    if (this.isNarrow) this.open(null);
  }
}

/** Shows the studio. `corner`: an element beside its tabs. */
export function startStudio(root: HTMLElement, corner: HTMLElement): void {
  void new Studio(root, corner).begin();
}
