// The state of the studio in the page's address: #episode=ID&t=12.3&q=…, #run=ID, #compare=A,B.

export interface Place {
  kind: "home" | "episode" | "run" | "compare";
  /** Names of the shown recordings: one, or two that are compared. */
  ids: string[];
  /** Time of the clock [s]. */
  time: number | null;
  /** The query, if there is one. */
  query: string | null;
}

export function read(hash: string): Place {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const time = Number.parseFloat(parts.get("t") ?? "");
  const rest = { time: Number.isFinite(time) && time >= 0 ? time : null, query: parts.get("q") || null };
  for (const kind of ["episode", "run"] as const) {
    const id = parts.get(kind);
    if (id) return { kind, ids: [id], ...rest };
  }
  const ids = (parts.get("compare") ?? "").split(",").filter((id) => id);
  if (ids.length === 2) return { kind: "compare", ids, ...rest };
  return { kind: "home", ids: [], ...rest };
}

export function write({ kind, ids, time, query }: Place): string {
  const parts: string[] = [];
  if (kind !== "home") parts.push(`${kind}=${ids.map(encodeURIComponent).join(",")}`);
  if (time !== null && kind !== "home") parts.push(`t=${time.toFixed(1)}`);
  if (query) parts.push(`q=${encodeURIComponent(query)}`);
  return parts.length ? `#${parts.join("&")}` : "";
}

/** Whether both show the same recordings. */
export const isSame = (a: Place, b: Place): boolean => a.kind === b.kind && a.ids.join() === b.ids.join();

/** Replaces the address without a new entry in the browser's history. */
export function replace(place: Place): void {
  const hash = write(place);
  if (hash !== location.hash) history.replaceState(null, "", hash || location.pathname);
}
