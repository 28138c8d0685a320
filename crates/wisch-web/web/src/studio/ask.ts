// The query panel: a query with completion of its names (predicates, classes, properties and individuals), and its answers.
import { el, say } from "../dom.ts";
import { drawAnswers, hasView, type AnswerActions } from "./answers.ts";
import { ask, Refused, vocabulary, type Fault, type Vocabulary } from "./server.ts";

const MAX_PROPOSALS = 12;

interface Proposal {
  /** The shown name. */
  name: string;
  kind: "predicate" | "class" | "property" | "individual" | "Prolog";
  meaning: string;
  /** The inserted text. */
  text: string;
}

/** The name before the caret, with or without prefix and quote. */
const WORD = /(?:([a-z]+):)?('?)([A-Za-z_][A-Za-z0-9_]*)$/;

function proposals(words: Vocabulary): Proposal[] {
  const list: Proposal[] = [];
  const known = new Set<string>();
  for (const { name, arity, meaning } of words.predicates) {
    const call = /^([^:]*?\)|[^:]*?): /.exec(meaning)?.[1] ?? "";
    const text = call.startsWith(`${name}(`) ? call : arity ? `${name}(` : name;
    if (known.has(text)) continue;
    known.add(text);
    list.push({ name: `${name}/${arity}`, kind: "predicate", meaning, text });
  }
  const named = (kind: Proposal["kind"]) => ({ name, label, comment }: Vocabulary["classes"][number]): Proposal =>
    ({ name, kind, meaning: comment || label, text: quote(name) });
  list.push(...words.classes.map(named("class")), ...words.properties.map(named("property")), ...words.individuals.map(named("individual")));
  for (const name of words.builtins) list.push({ name, kind: "Prolog", meaning: "predicate of standard Prolog", text: name.replace(/\/\d+$/, /\/0$/.test(name) ? "" : "(") });
  return list;
}

function quote(name: string): string {
  const [prefix, local] = name.split(":") as [string, string];
  return /^[a-z][A-Za-z0-9_]*$/.test(local) ? name : `${prefix}:'${local}'`;
}

interface Completion {
  from: number;
  found: Proposal[];
}

/** Returns the names that match the name before the caret; names that start with it come before names that contain it. */
function complete(all: Proposal[], text: string, caret: number): Completion | null {
  const word = WORD.exec(text.slice(0, caret));
  if (!word || /^[A-Z_]/.test(word[0]) && !word[1] && !word[2] && word[0].length < 2) return null;
  const [whole, prefix, , typed] = word as unknown as [string, string | undefined, string, string];
  const wanted = typed.toLowerCase();
  const places = all.flatMap((proposal) => {
    const [namespace, local] = proposal.name.includes(":") ? (proposal.name.split(":") as [string, string]) : ["", proposal.name];
    if (prefix && namespace !== prefix) return [];
    const place = local.toLowerCase().indexOf(wanted);
    return place < 0 ? [] : [{ proposal, place: place ? 1 : 0, length: local.length }];
  });
  places.sort((a, b) => a.place - b.place || order(a.proposal) - order(b.proposal) || a.length - b.length);
  const found = places.slice(0, MAX_PROPOSALS).map(({ proposal }) => proposal);
  return found.length ? { from: caret - whole.length, found } : null;
}

const order = ({ kind }: Proposal): number => ["predicate", "class", "property", "individual", "Prolog"].indexOf(kind);

/** A list of completions below a text field, for keyboard and pointer. */
class Completer {
  readonly list = el("ul", { class: "s-proposals", id: "s-proposals", role: "listbox", "aria-label": "Completions", hidden: true });
  private all: Proposal[] = [];
  private now: Completion | null = null;
  private chosen = 0;

  constructor(private readonly field: HTMLTextAreaElement) {
    field.addEventListener("input", () => this.updateProposals());
    field.addEventListener("blur", () => this.close());
    field.addEventListener("keydown", (event) => this.onKey(event));
  }

  setVocabulary(words: Vocabulary): void {
    this.all = proposals(words);
  }

  close(): void {
    this.now = null;
    this.list.hidden = true;
    this.field.setAttribute("aria-expanded", "false");
    this.field.removeAttribute("aria-activedescendant");
  }

  private updateProposals(): void {
    const { value, selectionStart, selectionEnd } = this.field;
    const next = /^[A-Za-z0-9_]/.test(value.slice(selectionStart));
    this.now = selectionStart === selectionEnd && !next ? complete(this.all, value, selectionStart) : null;
    if (!this.now) return this.close();
    this.chosen = 0;
    this.draw();
  }

  private draw(): void {
    const items = this.now!.found.map(({ name, kind, meaning }, i) => el("li", {
      id: `s-proposal-${i}`, role: "option", "aria-selected": String(i === this.chosen),
      // This event comes before the field loses the focus.
      pointerdown: (event: PointerEvent) => {
        event.preventDefault();
        this.chosen = i;
        this.accept();
      },
    }, el("b", {}, name), el("i", {}, kind), el("span", {}, meaning)));
    this.list.replaceChildren(...items);
    this.list.hidden = false;
    this.field.setAttribute("aria-expanded", "true");
    this.field.setAttribute("aria-activedescendant", `s-proposal-${this.chosen}`);
    items[this.chosen]?.scrollIntoView({ block: "nearest" });
  }

  private onKey(event: KeyboardEvent): void {
    if (!this.now) return;
    const count = this.now.found.length;
    if (event.key === "ArrowDown") this.chosen = (this.chosen + 1) % count;
    else if (event.key === "ArrowUp") this.chosen = (this.chosen + count - 1) % count;
    else if (event.key === "Tab") return this.accept(event);
    else if (event.key === "Escape") {
      event.preventDefault();
      event.stopPropagation();
      return this.close();
    } else return;
    event.preventDefault();
    this.draw();
  }

  private accept(event?: KeyboardEvent): void {
    event?.preventDefault();
    const { from, found } = this.now!;
    const { text } = found[this.chosen]!;
    const { value, selectionStart } = this.field;
    this.field.setRangeText(text, from, selectionStart, "end");
    const caret = this.field.selectionStart;
    const after = value.slice(selectionStart);
    // An opening bracket after the caret is not doubled.
    if (text.endsWith("(") && after.startsWith("(")) this.field.setRangeText("", caret - 1, caret, "end");
    this.close();
  }
}

export class Ask {
  readonly element: HTMLElement;
  readonly field = el("textarea", {
    class: "s-query", rows: 3, spellcheck: "false", autocomplete: "off", "aria-label": "Query in Prolog", placeholder: "low_performance_round(Round, P)",
    role: "combobox", "aria-autocomplete": "list", "aria-controls": "s-proposals", "aria-expanded": "false",
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

  /** `asked` is called with a query when it is asked. */
  constructor(private readonly actions: AnswerActions & { asked(query: string | null): void }) {
    this.button = el("button", { class: "w-button s-primary", type: "button", click: () => (this.asking ? this.asking.abort() : void this.ask()) }, "Ask");
    this.element = el("section", { class: "s-ask", hidden: true },
      el("div", { class: "s-field" }, this.field, this.completer.list),
      el("div", { class: "s-row" }, this.button, el("span", { class: "w-quiet" }, "Enter: ask; Shift + Enter: new line; Tab: complete")),
      this.fault, this.examples, this.result);
    // A message is about the query as it was asked.
    this.field.addEventListener("input", () => { this.fault.hidden = true; });
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
      this.result.replaceChildren(...drawAnswers(answers, this.actions));
      if (hasView(answers)) this.actions.show(answers, null, null);
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
}
