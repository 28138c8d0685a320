// The light and the dark theme, and the page's colours for drawings on a canvas.

const KEY = "wisch-theme";
export type Theme = "light" | "dark";

const root = (): HTMLElement => document.documentElement;
const callbacks = new Set<() => void>();
let printing = false;
/** The user's choice, which overrides the system's preference. */
let chosen: Theme | null = null;

/** Uses the local storage, which browsers may forbid to a page from a file. */
const withStorage = <Result>(act: (storage: Storage) => Result): Result | null => {
  try {
    return act(localStorage);
  } catch {
    return null;
  }
};

/** Returns the current theme. */
export function theme(): Theme {
  if (printing) return "light";
  return chosen ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
}

export function setTheme(wanted: Theme): void {
  chosen = wanted;
  withStorage((storage) => storage.setItem(KEY, wanted));
  notify();
}

/** Calls `callback` whenever colours change; returns a function that stops this. */
export function onTheme(callback: () => void): () => void {
  callbacks.add(callback);
  return () => callbacks.delete(callback);
}

function notify(): void {
  root().dataset.theme = theme();
  colours = null;
  for (const callback of callbacks) callback();
}

/** Starts the theme; must be called once before the first drawing. */
export function startTheme(): void {
  chosen = (["light", "dark"] as const).find((theme) => theme === withStorage((storage) => storage.getItem(KEY))) ?? null;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", notify);
  const print = (now: boolean) => {
    if (printing === now) return;
    printing = now;
    notify();
  };
  matchMedia("print").addEventListener("change", ({ matches }) => print(matches));
  addEventListener("beforeprint", () => print(true));
  addEventListener("afterprint", () => print(false));
  notify();
}

export const isPrinting = (): boolean => printing;

let colours: Map<string, string> | null = null;

/** Returns a colour of the page by its name. */
export function colour(name: string): string {
  colours ??= new Map();
  let value = colours.get(name);
  if (value === undefined) {
    value = getComputedStyle(root()).getPropertyValue(`--${name}`).trim() || "#888888";
    colours.set(name, value);
  }
  return value;
}
