// The health panel: what changes from run to run, in the words of `wisch memory health`.
import { capitalise, DASH, el, hasChanged, makeTable } from "../dom.ts";
import { health, type GroupWords, type HealthWords } from "./server.ts";

const TITLES = ["Channel", "Finding", "Now", "Per run (95\u202f% interval)", "p", "Runs"];

export class Health {
  readonly element = el("section", { class: "s-health", hidden: true, "aria-label": "Health of the memory" });

  /** Loads the assessment of the present memory, and shows it. */
  async load(): Promise<void> {
    if (!this.element.children.length) this.element.replaceChildren(el("p", { class: "w-quiet" }, "Assessing the memory \u2026"));
    try {
      const words = await health();
      if (hasChanged(this.element, words)) this.element.replaceChildren(...draw(words));
    } catch (error) {
      const { message } = error as Error;
      if (hasChanged(this.element, message)) this.element.replaceChildren(el("p", { class: "w-complaint", role: "alert" }, message));
    }
  }
}

/** Puts first what needs attention, and last what has too few runs. */
const rank = ({ needs_attention, too_few }: GroupWords): number => (needs_attention ? 0 : too_few ? 2 : 1);

function draw({ groups, summary, remarks }: HealthWords): Node[] {
  const sorted = [...groups].sort((a, b) => rank(a) - rank(b));
  return [
    el("p", { class: "s-count" }, el("b", {}, capitalise(summary))),
    ...sorted.map(makeGroup),
    ...remarks.map((remark) => el("p", { class: "w-quiet s-remark" }, remark)),
  ];
}

function makeGroup({ things, runs, too_few, needs_attention, channels }: GroupWords): HTMLElement {
  const [state, text] = needs_attention ? ["unmet", "needs attention"] : ["none", too_few ? "too few runs" : "nothing found"];
  const sorted = [...channels].sort((a, b) => Number(b.needs_attention) - Number(a.needs_attention));
  return el("article", { class: "s-group" },
    el("h3", {}, el("span", {}, things), el("span", { class: "s-badge", "data-state": state }, text)),
    el("p", { class: "s-what" }, runs),
    too_few ? el("p", {}, `${capitalise(too_few)}. A drift cannot be assessed.`)
      : el("div", { class: "s-table s-stacks", tabindex: 0, role: "group", "aria-label": `Channels of ${things}` }, makeTable(TITLES, sorted.flatMap(makeRows))));
}

/** Makes the row of a channel, and a row for its sentences. */
function makeRows({ channel, recorded, now, per_run, p, unknown, finding, needs_attention, sentences }: GroupWords["channels"][number]): HTMLElement[] {
  const course = unknown === undefined ? [now, per_run, p] : [unknown];
  const mark = needs_attention ? el("span", { "aria-hidden": "true" }, "\u25b2 ") : null;
  const cells = [
    el("td", { class: "s-finding" }, el("span", {}, mark, finding ?? DASH)),
    ...course.map((text) => el("td", unknown === undefined ? {} : { class: "s-unknown", colspan: 3 }, text)),
    el("td", {}, String(recorded)),
  ];
  // A narrow page shows each channel as a list of titles and values.
  cells.forEach((cell, i) => cell.setAttribute("data-title", i === cells.length - 1 ? "Runs" : TITLES[i + 1]!));
  const rows = [el("tr", { "data-attention": String(needs_attention) }, el("th", { scope: "row" }, channel), ...cells)];
  if (sentences.length) {
    rows.push(el("tr", { class: "s-sentences", "data-attention": String(needs_attention) },
      el("td", { colspan: TITLES.length }, ...sentences.map((sentence) => el("p", {}, capitalise(sentence))))));
  }
  return rows;
}
