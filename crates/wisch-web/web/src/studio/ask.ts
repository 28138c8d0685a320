// The query panel: a query and its answers.
import { el, fixed, say } from "../dom.ts";
import { Completer } from "./complete.ts";
import { drawPlot } from "./plots.ts";
import { Refused, ask, vocabulary } from "./server.ts";
import { episodesOf, local } from "./shown.ts";
import type { Answers, Cell, Fault } from "./server.ts";

/** Maximum number of listed answers. */
const MOST_ROWS = 200;
/** Maximum number of episodes listed below the answers. */
const MOST_NAMED = 8;
/** A number in this range counts as a time since 1970 [s]: the years 2001 to 2286. */
const TIME_FROM = 1e9;
const TIME_TO = 1e10;

export interface AskActions {
  /** Shows one answer or all (`row` null), in an episode or in the one with most answers (`episode` null). */
  show(answers: Answers, row: number | null, episode: string | null): void;
  /** Removes the shown answers. */
  clear(): void;
  /** Called with a query when it is asked. */
  asked(query: string | null): void;
}

export class Ask {
  readonly element: HTMLElement;
  readonly field = el("textarea", {
    class: "s-query", rows: 3, spellcheck: "false", autocomplete: "off", "aria-label": "Query in Prolog", placeholder: "low_performance_round(Round, P)",
    keydown: (event: KeyboardEvent) => {
      if (event.key !== "Enter" || event.shiftKey || event.isComposing) return;
      event.preventDefault();
      void this.ask();
    },
  });
  private readonly completer = new Completer(this.field);
  private readonly fault = el("div", { class: "w-complaint s-fault", role: "alert", hidden: true });
  private readonly chips = el("div", { class: "s-chips" });
  private readonly examples = el("details", { class: "s-examples", open: true }, el("summary", {}, el("h2", {}, "Example questions")), this.chips);
  private readonly result = el("div", { class: "s-answers", "aria-live": "polite" });
  private readonly button: HTMLButtonElement;
  private asking: AbortController | null = null;

  constructor(private readonly actions: AskActions) {
    this.button = el("button", { class: "w-button s-primary", type: "button", click: () => (this.asking ? this.asking.abort() : void this.ask()) }, "Ask");
    this.element = el("section", { class: "s-ask", hidden: true },
      el("div", { class: "s-field" }, this.field, this.completer.list),
      el("div", { class: "s-row" }, this.button, el("span", { class: "w-quiet" }, "Enter: ask; Shift + Enter: new line; Tab: complete")),
      this.fault, this.examples, this.result);
    void this.loadVocabulary();
  }

  private async loadVocabulary(): Promise<void> {
    try {
      const words = await vocabulary();
      this.completer.setVocabulary(words);
      this.chips.replaceChildren(...words.examples.map(({ title, query }, i) => el("button", {
        class: "s-chip", type: "button", title: query, "data-example": i,
        click: () => {
          this.field.value = query;
          void this.ask();
        },
      }, title)));
    } catch (error) {
      this.complain({ message: (error as Error).message });
    }
  }

  /** Fills in a query from the address. It could write into the memory, so it runs only when the user asks it. */
  propose(query: string): void {
    this.asking?.abort();
    this.asking = null;
    say(this.button, "Ask");
    this.completer.close();
    this.field.value = query;
    this.fault.hidden = true;
    this.examples.open = false;
    this.actions.clear();
    this.result.replaceChildren(el("p", { class: "s-remark" }, "This query comes from the page's address. Press Ask to run it."));
  }

  /** Runs the query in the field, and shows its answers. */
  async ask(): Promise<void> {
    const query = this.field.value.trim();
    if (!query || this.asking) return;
    this.completer.close();
    this.fault.hidden = true;
    const asking = new AbortController();
    this.asking = asking;
    this.examples.open = false;
    say(this.button, "Cancel");
    this.result.replaceChildren(el("p", { class: "w-quiet" }, "Asking \u2026"));
    this.actions.asked(query);
    try {
      const answers = await ask(query, asking.signal);
      this.showAnswers(answers);
      if (episodesOf(answers, null).length && this.hasView(answers)) this.actions.show(answers, null, null);
      else this.actions.clear();
    } catch (error) {
      // By now, another query may have started.
      if (this.asking !== asking) return;
      this.result.replaceChildren();
      if (!asking.signal.aborted) this.complain(error instanceof Refused ? error.fault : { message: String(error) });
    } finally {
      if (this.asking === asking) {
        this.asking = null;
        say(this.button, "Ask");
      }
    }
  }

  private hasView({ view, about }: Answers): boolean {
    return !!view && (view.tracks.length > 0 || view.bodies.length > 0 || view.particles.length > 0 || about.some((mentions) => mentions.some(({ interval }) => interval)));
  }

  private complain({ message, offset, length, line, column }: Fault): void {
    const query = this.field.value.trim();
    const parts: Node[] = [el("p", {}, message)];
    if (offset !== undefined && length !== undefined) {
      const end = offset + length;
      parts.push(el("pre", {}, query.slice(0, offset), el("mark", {}, query.slice(offset, end) || "\u2038"), query.slice(end)));
      if (query.includes("\n")) parts.push(el("p", { class: "w-quiet" }, `line ${line}, column ${column}`));
      this.field.value = query;
      // A selection moves the focus, so it is set only if the field has the focus.
      if (document.activeElement === this.field) this.field.setSelectionRange(offset, end);
    }
    this.fault.replaceChildren(...parts);
    this.fault.hidden = false;
  }

  private showAnswers(answers: Answers): void {
    const { rows, columns, holds, more, seconds, printed, remarks, view, about } = answers;
    const count = holds ? `${rows.length}${more ? " or more" : ""} ${rows.length === 1 ? "answer" : "answers"}` : "No answer: false";
    const parts: Node[] = [el("p", { class: "s-count" }, el("b", {}, count), ` in ${fixed(seconds, 2)} s`)];
    const episodes = episodesOf(answers, null);
    if (episodes.length && this.hasView(answers)) {
      parts.push(el("div", { class: "s-row" },
        el("button", { class: "w-button", type: "button", click: () => this.actions.show(answers, null, null) }, "Show all"),
        el("button", { class: "w-button", type: "button", click: () => this.actions.clear() }, "Clear")));
      if (episodes.length > 1) {
        parts.push(el("div", { class: "s-in" }, el("span", { class: "w-quiet" }, "in "), ...episodes.slice(0, MOST_NAMED).map((id) =>
          el("button", { class: "s-chip", type: "button", click: () => this.actions.show(answers, null, id) }, id))));
      }
    }
    for (const remark of remarks) parts.push(el("p", { class: "w-quiet s-remark" }, remark));
    if (printed) parts.push(el("pre", { class: "s-printed" }, printed));
    for (const one of view?.plots ?? []) parts.push(drawPlot(one));
    if (rows.length && columns.length) parts.push(this.makeTable(answers));
    else if (rows.length && about.every((mentions) => !mentions.length)) parts.push(el("p", {}, "True."));
    if (rows.length > MOST_ROWS) parts.push(el("p", { class: "w-quiet" }, `The table lists the first ${MOST_ROWS} of ${rows.length} answers.`));
    this.result.replaceChildren(...parts);
  }

  private makeTable(answers: Answers): HTMLElement {
    const { rows, columns, about } = answers;
    const head = el("tr", {}, el("th", { scope: "col" }, el("span", { class: "s-hidden" }, "show")), ...columns.map((name) => el("th", { scope: "col" }, name)));
    const body = rows.slice(0, MOST_ROWS).map((row, i) => {
      const can = about[i]?.length;
      return el("tr", {},
        el("td", {}, can ? el("button", { class: "w-button s-show", type: "button", "data-row": i, "aria-label": `Show answer ${i + 1}`, click: () => this.actions.show(answers, i, null) }, "Show") : ""),
        ...row.map((value) => makeCell(value)));
    });
    return el("div", { class: "s-table", tabindex: 0, role: "group", "aria-label": "Answers" }, el("table", {}, el("thead", {}, head), el("tbody", {}, ...body)));
  }
}

function makeCell(value: Cell): HTMLElement {
  if (typeof value === "number") {
    const isTime = value >= TIME_FROM && value < TIME_TO;
    const text = isTime ? formatTimeOfDay(value) : Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(5)));
    return el("td", { class: "s-number", title: String(value) }, text);
  }
  if (value === null) return el("td", { class: "w-quiet" }, "_");
  const text = formatCell(value);
  return el("td", { title: typeof value === "string" ? value : text }, text);
}

const formatCell = (value: Cell): string =>
  value === null ? "_" : Array.isArray(value) ? `[${value.map(formatCell).join(", ")}]` : typeof value === "number" ? String(Number(value.toPrecision(6))) : shorten(value);

/** Shortens a name: an individual keeps its class and number, without the name of its episode. */
const shorten = (name: string): string => local(name).replace(/_(\d{8}-\d{6}-[0-9a-f]{4})-(\d+)$/, " $2");

/** Formats a time since 1970 as the time of day in UTC, as in the names of episodes. */
const formatTimeOfDay = (time: number): string => new Date(1000 * time).toISOString().slice(11, 23);
