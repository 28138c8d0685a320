// Light or dark, and the colours of the page for what is drawn on canvases.

const KEY = "wisch-theme";
export type Theme = "light" | "dark";

const root = (): HTMLElement => document.documentElement;
const callbacks = new Set<() => void>();
let printing = false;
/** What somebody asked for, whatever the system prefers. */
let chosen: Theme | null = null;

const kept = (): Theme | null => {
  try {
    const theme = localStorage.getItem(KEY);
    return theme === "light" || theme === "dark" ? theme : null;
  } catch {
    return null;
  }
};

/** What is shown now. */
export function theme(): Theme {
  if (printing) return "light";
  return chosen ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
}

export function setTheme(wanted: Theme): void {
  chosen = wanted;
  try {
    localStorage.setItem(KEY, wanted);
  } catch {
    // A page from a file may not keep anything.
  }
  tell();
}

/** Calls back whenever colours change. */
export function onTheme(callback: () => void): () => void {
  callbacks.add(callback);
  return () => callbacks.delete(callback);
}

function tell(): void {
  root().dataset.theme = theme();
  colours = null;
  for (const callback of callbacks) callback();
}

/** To be called once, before anything is drawn. */
export function startTheme(): void {
  chosen = kept();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", tell);
  const print = (now: boolean) => {
    if (printing === now) return;
    printing = now;
    tell();
  };
  matchMedia("print").addEventListener("change", ({ matches }) => print(matches));
  addEventListener("beforeprint", () => print(true));
  addEventListener("afterprint", () => print(false));
  tell();
}

export const isPrinting = (): boolean => printing;

let colours: Map<string, string> | null = null;

/** A colour of the page by its name. */
export function colour(name: string): string {
  colours ??= new Map();
  let value = colours.get(name);
  if (value === undefined) {
    value = getComputedStyle(root()).getPropertyValue(`--${name}`).trim() || "#888888";
    colours.set(name, value);
  }
  return value;
}
