// DOM elements, and numbers as text. Texts of a recording are inserted as text nodes, never as markup.

import type { Estimate } from "./recording.ts";

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

function fill<E extends Element>(element: E, attributes: Attributes, children: Child[]): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value as unknown as EventListener);
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return element;
}

/** Creates an element. Attributes that are functions become event listeners. */
export const el = <K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] =>
  fill(document.createElement(tag), attributes, children);

export const svg = <K extends keyof SVGElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): SVGElementTagNameMap[K] =>
  fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);

/** Sets the text of an element, if it differs. */
export function say(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

const shownIn = new WeakMap<Element, string>();

/** Whether the content of an element is not what it was at the last call. What shows the same is not made again: a button that has
 * the focus would lose it. */
export function hasChanged(element: Element, content: unknown): boolean {
  const [before, now] = [shownIn.get(element), JSON.stringify(content)];
  shownIn.set(element, now);
  return before !== now;
}

/** Makes a list of sentences. */
export const makeList = (list: readonly string[]): HTMLElement => el("ul", { class: "w-sentences" }, ...list.map((text) => el("li", {}, String(text))));

/** Makes a table with names of its columns. */
export const makeTable = (names: readonly (Node | string)[], rows: readonly Node[], caption = ""): HTMLElement =>
  el("table", {}, caption && el("caption", {}, caption), el("thead", {}, el("tr", {}, ...names.map((name) => el("th", { scope: "col" }, name)))), el("tbody", {}, ...rows));

/** Makes a row of a table from its name and its values. */
export const makeRow = (name: Node | string, values: readonly string[]): HTMLElement =>
  el("tr", {}, el("th", { scope: "row" }, name), ...values.map((value) => el("td", {}, value)));

/** Makes a list of labels with colours of the page. */
export const makeSwatches = (list: readonly { colour: string; label: string }[], label: string | null = null): HTMLElement =>
  el("ul", { "aria-label": label }, ...list.map(({ colour, label }) => el("li", {}, el("i", { "aria-hidden": "true", style: `background:var(--${colour})` }), label)));

/** Makes a text of a drawing. */
export const svgText = (x: number, y: number, words: string, anchor: "start" | "middle" | "end" = "start", look: Attributes = {}): SVGElement =>
  svg("text", { x, y, "text-anchor": anchor, fill: "var(--ink)", "font-size": 11.5, ...look }, words);

const MINUS = "\u2212";
/** Formats a number as Rust does: a tie, which has no nearest number, gets an even last digit. */
export const fixed = (value: number, digits: number): string => {
  const isTie = Math.abs((value * 2 ** (digits + 1)) % 2) === 1;
  const text = (isTie ? (2 * Math.round((value * 10 ** digits) / 2)) / 10 ** digits : value).toFixed(digits);
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text.replace("-", MINUS);
};

/** Counts names: "2 × push, 1 × landing". */
export function countNames(names: readonly string[]): string {
  const counts = new Map<string, number>();
  for (const name of names) counts.set(name, (counts.get(name) ?? 0) + 1);
  return [...counts].map(([name, count]) => `${count}\u00a0\u00d7\u00a0${name}`).join(", ");
}

export const capitalise = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The name of a phase for people; files have "transfer". */
export const phaseText = (name: string): string => (name === "transfer" ? "free motion" : name);

export const percent = (share: number, digits = 0): string => `${fixed(100 * share, digits)}\u202f%`;

/** Returns an estimate with its interval; `result` stands for a mean that says nothing. */
export const estimateText = ({ mean, low, high }: Estimate, digits = 0, result = percent(mean, digits)): string => `${result} (90\u202f%: ${percent(low, digits)} to ${percent(high, digits)})`;

/** What stands for an unknown value. */
export const DASH = "\u2013";

export const formatKnown = (value: number | null | undefined, text: (value: number) => string): string => (typeof value === "number" ? text(value) : DASH);

/** Formats a time: seconds below a minute, else minutes and seconds, with hours if needed. */
export function clockText(seconds: number, digits = 1): string {
  const text = fixed(seconds, digits);
  const whole = Number(text);
  if (!(whole >= 60)) return `${text} s`;
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  const rest = (whole % 60).toFixed(digits).padStart(digits ? digits + 3 : 2, "0");
  return hours ? `${hours}:${String(minutes).padStart(2, "0")}:${rest}` : `${minutes}:${rest}`;
}

let last = 0;
/** Returns an id that is unique on the page. */
export const uniqueId = (): string => `w${++last}`;
