// The query panel: a query and its answers.
import { el, say } from "../dom.ts";
import { drawAnswers, hasView, type AnswerActions } from "./answers.ts";
import { Completer } from "./complete.ts";
import { ask, Refused, vocabulary, type Fault } from "./server.ts";

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
