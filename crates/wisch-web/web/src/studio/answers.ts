// The answers of a query: number, table, remarks and diagrams.
import { el, fixed } from "../dom.ts";
import { drawPlot } from "./plots.ts";
import { episodesOf, shorten } from "./shown.ts";
import type { Answers, Cell } from "./server.ts";

/** Maximum number of listed answers. */
const MOST_ROWS = 200;
/** Maximum number of episodes listed below the answers. */
const MOST_NAMED = 8;
/** A number in this range counts as a time since 1970 [s]: the years 2001 to 2286. */
const TIME_FROM = 1e9;
const TIME_TO = 1e10;

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
        el("button", { class: "s-chip", type: "button", click: () => actions.show(answers, null, id) }, id))));
    }
  }
  const leftOut = view?.left_out ?? 0;
  if (leftOut) parts.push(el("p", { class: "w-quiet s-remark" }, `The picture is full: ${leftOut} more queried ${leftOut === 1 ? "object is" : "objects are"} not drawn.`));
  for (const remark of remarks) parts.push(el("p", { class: "w-quiet s-remark" }, remark));
  if (printed) parts.push(el("pre", { class: "s-printed" }, printed));
  for (const one of view?.plots ?? []) parts.push(drawPlot(one));
  if (rows.length && columns.length) parts.push(makeTable(answers, actions));
  else if (rows.length && about.every((mentions) => !mentions.length)) parts.push(el("p", {}, "True."));
  if (rows.length > MOST_ROWS) parts.push(el("p", { class: "w-quiet" }, `The table lists the first ${MOST_ROWS} of ${rows.length} answers.`));
  return parts;
}

function makeTable(answers: Answers, actions: AnswerActions): HTMLElement {
  const { rows, columns, about } = answers;
  const head = el("tr", {}, el("th", { scope: "col" }, el("span", { class: "s-hidden" }, "show")), ...columns.map((name) => el("th", { scope: "col" }, name)));
  const body = rows.slice(0, MOST_ROWS).map((row, i) => {
    const can = about[i]?.length;
    return el("tr", {},
      el("td", {}, can ? el("button", { class: "w-button s-show", type: "button", "data-row": i, "aria-label": `Show answer ${i + 1}`, click: () => actions.show(answers, i, null) }, "Show") : ""),
      ...row.map((value) => makeCell(value)));
  });
  return el("div", { class: "s-table", tabindex: 0, role: "group", "aria-label": "Answers" }, el("table", {}, el("thead", {}, head), el("tbody", {}, ...body)));
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

/** Formats a time since 1970 as the time of day in UTC, as in the names of episodes. */
const formatTimeOfDay = (time: number): string => new Date(1000 * time).toISOString().slice(11, 23);
