// The answers of a query: number, table, remarks and diagrams.
import { el, fixed, makeTable } from "../dom.ts";
import { drawPlot } from "./plots.ts";
import { beginText, episodeIn, episodeTitle, episodesOf, titleOf } from "./shown.ts";
import type { Answers, Cell, Mention, Plot } from "./server.ts";

/** Maximum number of listed answers. */
const MOST_ROWS = 200;
/** Maximum number of episodes listed below the answers. */
const MOST_NAMED = 8;
/** Maximum number of columns beside each other on a narrow page. */
const MOST_BESIDE = 3;
/** A number in this range counts as a time since 1970 [s]: the years 2001 to 2286. */
const TIME_FROM = 1e9;
const TIME_TO = 1e10;

/** How a unit of a query is shown: unit of the table and factor. */
const SHOWN: Record<string, [unit: string, factor: number]> = {
  share: ["%", 100], rad: ["\u00b0", 180 / Math.PI], m: ["mm", 1000], "m per episode": ["mm per episode", 1000],
};

export interface AnswerActions {
  /** Shows one answer or all (`row` null), in an episode or in the one with most answers (`episode` null). */
  show(answers: Answers, row: number | null, episode: string | null): void;
  /** Removes the shown answers. */
  clear(): void;
}

/** Whether answers can be shown in the recording of an episode. */
export function hasView(answers: Answers): boolean {
  const { view, about } = answers;
  return !!view && episodesOf(answers, null).length > 0 &&
    (view.tracks.length > 0 || view.bodies.length > 0 || view.particles.length > 0 || about.some((mentions) => mentions.some(({ interval }) => interval)));
}

export function drawAnswers(answers: Answers, actions: AnswerActions): Node[] {
  const { rows, columns, holds, more, seconds, printed, remarks, view, about } = answers;
  const count = holds ? `${rows.length}${more ? " or more" : ""} ${rows.length === 1 ? "answer" : "answers"}` : "No answer: false";
  const parts: Node[] = [el("p", { class: "s-count" }, el("b", {}, count), seconds === undefined ? "" : ` in ${fixed(seconds, 2)} s`)];
  if (hasView(answers)) {
    parts.push(el("div", { class: "s-row" },
      el("button", { class: "w-button", type: "button", click: () => actions.show(answers, null, null) }, "Show all"),
      el("button", { class: "w-button", type: "button", click: () => actions.clear() }, "Clear")));
    const episodes = episodesOf(answers, null);
    if (episodes.length > 1) {
      parts.push(el("div", { class: "s-in" }, el("span", { class: "w-quiet" }, "in "), ...episodes.slice(0, MOST_NAMED).map((id) =>
        el("button", { class: "s-chip", type: "button", title: id, click: () => actions.show(answers, null, id) }, nameEpisode(answers, id)))));
    }
  }
  const leftOut = view?.left_out ?? 0;
  if (leftOut) parts.push(el("p", { class: "w-quiet s-remark" }, `The picture is full: ${leftOut} more queried ${leftOut === 1 ? "object is" : "objects are"} not drawn.`));
  for (const remark of remarks) parts.push(el("p", { class: "w-quiet s-remark" }, remark));
  if (printed) parts.push(el("pre", { class: "s-printed" }, printed));
  for (const one of view?.plots ?? []) parts.push(drawPlot(one, titlesOf(answers, one)));
  if (rows.length && columns.length) parts.push(makeAnswerTable(answers, actions));
  else if (rows.length && about.every((mentions) => !mentions.length)) parts.push(el("p", {}, "True."));
  if (rows.length > MOST_ROWS) parts.push(el("p", { class: "w-quiet" }, `The table lists the first ${MOST_ROWS} of ${rows.length} answers.`));
  return parts;
}

const findMention = ({ about }: Answers, id: string): Mention | undefined => about.flat().find(({ episode }) => episode === id);

const nameEpisode = (answers: Answers, id: string): string => {
  const mention = findMention(answers, id);
  return mention ? episodeTitle(mention) : id;
};

/** Returns the titles of names in a diagram, each with begin and task of its episode in a second line if the diagram is about several. */
function titlesOf(answers: Answers, { amounts = [], spans = [] }: Plot): (name: string) => string {
  const episodes = new Set([...amounts, ...spans].map(([name]) => episodeIn(name)).filter((id) => id !== null));
  return (name) => {
    const [id, title] = [episodeIn(name), titleOf(answers, name)];
    if (id === null || episodes.size < 2) return title;
    const mention = findMention(answers, id);
    return `${title}\n${mention ? `${beginText(mention.begun)}, ${mention.task}` : id}`;
  };
}

function makeAnswerTable(answers: Answers, actions: AnswerActions): HTMLElement {
  const { rows, columns, units, about } = answers;
  const titles = columns.map((name, i) => (units[i] ? `${name} [${SHOWN[units[i]]?.[0] ?? units[i]}]` : name));
  const named = about.some((mentions) => mentions.length > 0);
  const names = [el("span", { class: "w-hidden" }, "show"), ...titles, ...(named ? ["Episode"] : [])];
  const body = rows.slice(0, MOST_ROWS).map((row, i) => {
    const mentions = about[i] ?? [];
    const cells = [...row.map((value, k) => makeCell(answers, value, units[k] ?? null)), ...(named ? [makeEpisodeCell(mentions)] : [])];
    // With many columns, a narrow page shows each answer as a list of titles and values.
    cells.forEach((cell, k) => cell.setAttribute("data-title", titles[k] ?? "Episode"));
    return el("tr", {},
      el("td", {}, mentions.length ? el("button", { class: "w-button s-show", type: "button", "data-row": i, "aria-label": `Show answer ${i + 1}`, click: () => actions.show(answers, i, null) }, "Show") : ""), ...cells);
  });
  return el("div", { class: `s-table${columns.length > MOST_BESIDE ? " s-stacks" : ""}`, tabindex: 0, role: "group", "aria-label": "Answers" }, makeTable(names, body));
}

function makeEpisodeCell(mentions: Mention[]): HTMLElement {
  const titles = new Map(mentions.map((mention) => [mention.episode, episodeTitle(mention)]));
  return el("td", { title: [...titles.keys()].join(", ") }, [...titles.values()].join("; "));
}

function makeCell(answers: Answers, value: Cell, unit: string | null): HTMLElement {
  if (typeof value === "number") {
    const isTime = !unit && value >= TIME_FROM && value < TIME_TO;
    const [, factor] = SHOWN[unit ?? ""] ?? ["", 1];
    const text = isTime ? formatTimeOfDay(value) : Number.isInteger(value) && !unit ? String(value) : unit === "share" ? fixed(factor * value, 1) : String(Number((factor * value).toPrecision(unit ? 3 : 5)));
    return el("td", { class: "s-number", title: `${value}${unit && unit !== "share" ? ` ${unit}` : ""}` }, text.replace("-", "\u2212"));
  }
  if (value === null) return el("td", { class: "w-quiet" }, "_");
  const text = formatCell(answers, value);
  return el("td", { title: typeof value === "string" ? value : text }, text);
}

const formatCell = (answers: Answers, value: Cell): string =>
  value === null ? "_" : Array.isArray(value) ? `[${value.map((one) => formatCell(answers, one)).join(", ")}]` : typeof value === "number" ? String(Number(value.toPrecision(6))) : titleOf(answers, value);

/** Formats a time since 1970 as the local time of day. */
const formatTimeOfDay = (time: number): string => {
  const date = new Date(1000 * time);
  return `${date.toLocaleTimeString("en-GB")}.${String(date.getMilliseconds()).padStart(3, "0")}`;
};
