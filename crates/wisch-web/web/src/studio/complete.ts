// Completion of names in a query: predicates, classes, properties, things.
import { el } from "../dom.ts";
import type { Vocabulary } from "./server.ts";

const MOST = 12;

export interface Proposal {
  /** What is shown, and what it means. */
  name: string;
  kind: "predicate" | "class" | "property" | "thing" | "Prolog";
  meaning: string;
  /** What comes into the text. */
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
    ({ name, kind, meaning: comment || label, text: quoted(name) });
  list.push(...words.classes.map(named("class")), ...words.properties.map(named("property")), ...words.individuals.map(named("thing")));
  for (const name of words.builtins) list.push({ name, kind: "Prolog", meaning: "Prolog's own", text: name.replace(/\/\d+$/, /\/0$/.test(name) ? "" : "(") });
  return list;
}

function quoted(name: string): string {
  const [prefix, local] = name.split(":") as [string, string];
  return /^[a-z][A-Za-z0-9_]*$/.test(local) ? name : `${prefix}:'${local}'`;
}

export interface Completion {
  from: number;
  found: Proposal[];
}

/** What fits the name before the caret: those that begin so before those that contain it. */
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
  const found = places.slice(0, MOST).map(({ proposal }) => proposal);
  return found.length ? { from: caret - whole.length, found } : null;
}

const order = ({ kind }: Proposal): number => ["predicate", "class", "property", "thing", "Prolog"].indexOf(kind);

/** A list below a text field, by keyboard and pointer. */
export class Completer {
  readonly list = el("ul", { class: "s-proposals", id: "s-proposals", role: "listbox", "aria-label": "Names that fit", hidden: true });
  private all: Proposal[] = [];
  private now: Completion | null = null;
  private chosen = 0;

  constructor(private readonly field: HTMLTextAreaElement) {
    field.setAttribute("role", "combobox");
    field.setAttribute("aria-autocomplete", "list");
    field.setAttribute("aria-controls", "s-proposals");
    field.setAttribute("aria-expanded", "false");
    field.addEventListener("input", () => this.look());
    field.addEventListener("blur", () => this.close());
    field.addEventListener("keydown", (event) => this.key(event));
  }

  know(words: Vocabulary): void {
    this.all = proposals(words);
  }

  get isOpen(): boolean {
    return this.now !== null;
  }

  close(): void {
    this.now = null;
    this.list.hidden = true;
    this.field.setAttribute("aria-expanded", "false");
    this.field.removeAttribute("aria-activedescendant");
  }

  private look(): void {
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
      // Before the field loses the focus.
      pointerdown: (event: PointerEvent) => {
        event.preventDefault();
        this.chosen = i;
        this.take();
      },
    }, el("b", {}, name), el("i", {}, kind), el("span", {}, meaning)));
    this.list.replaceChildren(...items);
    this.list.hidden = false;
    this.field.setAttribute("aria-expanded", "true");
    this.field.setAttribute("aria-activedescendant", `s-proposal-${this.chosen}`);
    items[this.chosen]?.scrollIntoView({ block: "nearest" });
  }

  private key(event: KeyboardEvent): void {
    if (!this.now) return;
    const count = this.now.found.length;
    if (event.key === "ArrowDown") this.chosen = (this.chosen + 1) % count;
    else if (event.key === "ArrowUp") this.chosen = (this.chosen + count - 1) % count;
    else if (event.key === "Tab") return this.take(event);
    else if (event.key === "Escape") {
      event.preventDefault();
      event.stopPropagation();
      return this.close();
    } else return;
    event.preventDefault();
    this.draw();
  }

  private take(event?: KeyboardEvent): void {
    event?.preventDefault();
    const { from, found } = this.now!;
    const { text } = found[this.chosen]!;
    const { value, selectionStart } = this.field;
    this.field.setRangeText(text, from, selectionStart, "end");
    const caret = this.field.selectionStart;
    const after = value.slice(selectionStart);
    // Two brackets that open are one too many.
    if (text.endsWith("(") && after.startsWith("(")) this.field.setRangeText("", caret - 1, caret, "end");
    this.close();
  }
}
