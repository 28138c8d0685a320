// Completion of names in a query: predicates, classes, properties and individuals.
import { el } from "../dom.ts";
import type { Vocabulary } from "./server.ts";

const MAX_PROPOSALS = 12;

export interface Proposal {
  /** The shown name. */
  name: string;
  kind: "predicate" | "class" | "property" | "individual" | "Prolog";
  meaning: string;
  /** The inserted text. */
  text: string;
}

/** The name before the caret, with or without prefix and quote. */
const WORD = /(?:([a-z]+):)?('?)([A-Za-z_][A-Za-z0-9_]*)$/;

export function proposals(words: Vocabulary): Proposal[] {
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

export interface Completion {
  from: number;
  found: Proposal[];
}

/** Returns the names that match the name before the caret; names that start with it come before names that contain it. */
export function complete(all: Proposal[], text: string, caret: number): Completion | null {
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
export class Completer {
  readonly list = el("ul", { class: "s-proposals", id: "s-proposals", role: "listbox", "aria-label": "Completions", hidden: true });
  private all: Proposal[] = [];
  private now: Completion | null = null;
  private chosen = 0;

  constructor(private readonly field: HTMLTextAreaElement) {
    field.setAttribute("role", "combobox");
    field.setAttribute("aria-autocomplete", "list");
    field.setAttribute("aria-controls", "s-proposals");
    field.setAttribute("aria-expanded", "false");
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
