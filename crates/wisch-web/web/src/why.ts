// Why this plan: its reasons, the candidate plans, and what each stroke is predicted to gain.
import { el, estimateText, fixed, formatKnown, makeList, makeRow, makeTable, percent } from "./dom.ts";
import { describeStroke, findGains, LEAST_SHARE, makeStrokeFigures, predictWhole, type StrokeGain } from "./strokes.ts";
import type { Considered, Places, RoundPiece } from "./recording.ts";
import { pushOf, type Round } from "./round.ts";

/** Strokes that are not part of the plan. */
export interface Rejected {
  name: string;
  lines: readonly Places[];
}

/** What a reader chose of the plan of a round: one of its strokes, and strokes that are not part of it. */
export interface Choice {
  round: Round;
  stroke: number | null;
  rejected: Rejected | null;
}

/** Number of groups of strokes whose headings are stated. */
const MOST_GROUPS = 3;

/** Formats a difference of shares. */
const signed = (gain: number): string => `${gain > 0 ? "+" : ""}${fixed(100 * gain, 1)}`;

/** Lists numbers in words, such as "1, 2 and 5". */
const listNumbers = (numbers: readonly number[]): string => (numbers.length > 1 ? `${numbers.slice(0, -1).join(", ")} and ${numbers.at(-1)}` : String(numbers[0]));

/** Says which strokes the plan needs most and least, by its predictions without each of them. */
function describeNeed(gains: readonly StrokeGain[], whole: number): string[] {
  const known = gains.filter((one): one is StrokeGain & { marginal: number } => one.marginal !== null);
  if (known.length < 2) return [];
  const most = known.reduce((a, b) => (b.marginal > a.marginal ? b : a));
  const spare = known.filter(({ marginal }) => marginal < LEAST_SHARE).map(({ stroke }) => stroke + 1);
  return [
    ...(most.marginal >= LEAST_SHARE ? [`Stroke ${most.stroke + 1} is predicted to matter most: without it, the plan reaches ${percent(whole - most.marginal, 1)} instead of ${percent(whole, 1)}.`] : []),
    ...(spare.length ? [`Without stroke ${listNumbers(spare).replace(" and ", " or ")} alone, the plan is predicted to reach ${spare.some((stroke) => known.find((one) => one.stroke + 1 === stroke)!.marginal <= -LEAST_SHARE) ? "as much or more" : "as much"}. It may still help if dirt or tool differ from the belief.`] : []),
  ];
}

/** Difference of a prediction's begin from the estimate before it that is explained [1]. */
const FAR = 0.05;

/** Says why the prediction of a round begins away from the estimate after the round before. */
export function describeBegin(round: Round, before: Round | null): string[] {
  const begin = round.growthAt(0);
  const estimate = before?.interpreted?.estimate;
  if (!before || !estimate || begin === null || Math.abs(begin - estimate.mean) < FAR) return [];
  return [
    `The prediction begins at ${percent(begin, 1)}, ${begin < estimate.mean ? "below" : "above"} the estimate of ${estimateText(estimate)} after round ${before.number}. It starts from one random draw from the new belief; the estimate is the mean of all draws.${
      before.events.some(pushOf) ? ` A push, a collision or hand guiding in round ${before.number} may have left open what was wiped there.` : ""}`,
  ];
}

/** Says which strokes take dirt out of the goal area, where later ones are predicted to bring it back. */
export function describeDetours({ plan: { goal } }: Round, gains: readonly StrokeGain[], whole: number): string[] {
  const away = gains.filter(({ gain }, i) => {
    let change = 0;
    return gain <= -LEAST_SHARE && gains.slice(i).some((one) => (change += one.gain) > -LEAST_SHARE);
  });
  if (goal?.kind !== "collected" || !away.length) return [];
  const most = Math.max(...away.map(({ gain }) => -gain));
  return [
    `${away.length > 1 ? "Strokes" : "Stroke"} ${listNumbers(away.map(({ stroke }) => stroke + 1))} ${away.length > 1 ? "are" : "is"} predicted to take dirt out of the goal area, ${fixed(100 * most, 1)} points at most. The tool pushes all dirt in its way; later strokes bring it back, and the plan reaches ${percent(whole, 1)}.`,
  ];
}

/** Says how the tool is turned, once for all strokes with the same reason. */
function describeHeadings(headings: readonly string[]): string[] {
  const groups = new Map<string, number[]>();
  headings.forEach((text, i) => groups.set(text, [...groups.get(text) ?? [], i + 1]));
  const sorted = [...groups].sort(([, a], [, b]) => b.length - a.length);
  const shown = sorted.slice(0, MOST_GROUPS).map(([text, strokes]) => `${groups.size === 1 && headings.length > 1 ? "All strokes" : strokes.length > 1 ? `Strokes ${listNumbers(strokes)}` : `Stroke ${strokes[0]}`}: ${text}`);
  return groups.size > MOST_GROUPS ? [...shown, "Choose another stroke in the table to see how the tool is turned in it."] : shown;
}

const makeChoice = (label: string, table: HTMLElement) => el("div", { class: "w-choice", tabindex: 0, role: "group", "aria-label": label }, table);

export class Why {
  readonly element = el("div");
  private round: Round | null = null;
  private stroke: number | null = null;
  /** The shown strokes that are not part of the plan, and those that stay shown. */
  private rejected: Rejected | null = null;
  private kept: Rejected | null = null;

  constructor(private readonly seek: (time: number) => void, private readonly choose: (choice: Choice | null) => void) {}

  /** Explains the plan of a round. `before`: the previous round; `otherwise`: the text if there are no reasons. */
  show(round: Round | null, before: Round | null, otherwise: string): void {
    if (round && round === this.round) return;
    if (this.stroke !== null || this.rejected) this.choose(null);
    [this.round, this.stroke, this.rejected, this.kept] = [round, null, null, null];
    const gains = round ? findGains(round) : [];
    const { without, predicted, another = without?.length ? null : undefined, ...plan }: Partial<RoundPiece> = round?.plan ?? {};
    const [why, considered, headings] = [plan.why ?? [], plan.considered ?? [], plan.headings ?? []];
    const whole = round ? predictWhole(round) : NaN;
    const list = makeList(round ? [...describeBegin(round, before), ...describeNeed(gains, whole), ...describeDetours(round, gains, whole)] : []);
    if (round && another) list.append(el("li", {}, ...this.describeAnother(round, another)));
    list.append(...makeList([...(another === null && (predicted ?? 0) < 1 - LEAST_SHARE ? ["A repetition of a stroke at the end is predicted to gain nothing."] : []), ...describeHeadings(headings), ...why]).children);
    this.element.replaceChildren(list.childElementCount ? list : el("p", { class: "w-quiet" }, otherwise),
      ...(considered.length ? [this.makeCandidates(considered)] : []), ...(round && gains.length ? [this.makeStrokes(round, gains)] : []));
  }

  private publish(): void {
    if (this.round) this.choose({ round: this.round, stroke: this.stroke, rejected: this.rejected });
  }

  /** Returns the listeners that show strokes which are not part of the plan, while pointer or focus is on their element. */
  private preview(rejected: Rejected | null): Record<string, () => void> {
    const show = (shown: Rejected | null) => () => {
      if (this.rejected === shown) return;
      this.rejected = shown;
      this.publish();
    };
    const leave = () => show(this.kept)();
    return rejected ? { pointerenter: show(rejected), pointerleave: leave, focusin: show(rejected), focusout: leave } : {};
  }

  /** Returns a button that keeps strokes shown which are not part of the plan, or no longer. */
  private makeKeeper(text: string, rejected: Rejected): HTMLElement {
    return el("button", { type: "button", class: "w-link", "aria-pressed": "false", title: "Show its strokes in the scene", click: ({ currentTarget }: MouseEvent) => {
      this.kept = this.kept === rejected ? null : rejected;
      for (const button of this.element.querySelectorAll(".w-link[aria-pressed]")) button.setAttribute("aria-pressed", String(button === currentTarget && this.kept !== null));
      this.rejected = this.kept;
      this.publish();
    } }, text);
  }

  private describeAnother({ plan: { strokes } }: Round, { gain, line, way }: { gain: number; line: Places; way: number }): (Node | string)[] {
    const again = strokes.findIndex((stroke) => String(stroke) === String(line));
    const rejected = { name: again < 0 ? "One more stroke" : `Repetition of stroke ${again + 1}`, lines: [line] };
    const what = again < 0 ? "One more stroke" : `Stroke ${again + 1} once more at the end`;
    return [el("span", this.preview(rejected), this.makeKeeper(what, rejected)), ` is predicted to gain ${fixed(100 * gain, 1)} points with ${fixed(way, 2)} m in contact.`];
  }

  /** Makes the table of the candidate plans, by falling score. */
  private makeCandidates(considered: readonly Considered[]): HTMLElement {
    const names = ["Strategy", "Score", "Share", "Lost", "Contact", "Time"];
    const rows = [...considered].sort((a, b) => (b.score ?? -Infinity) - (a.score ?? -Infinity)).map((one) => {
      const { strategy, chosen, score, predicted, lost, strokes, in_contact: way, duration, error, lines } = one;
      const rejected = !chosen && lines?.length ? { name: `Rejected plan: ${strategy}, ${lines.length} strokes`, lines } : null;
      const cells = [formatKnown(score, (score) => fixed(score, 2)), formatKnown(predicted, percent), formatKnown(lost, percent), formatKnown(way, (way) => `${fixed(way, 2)} m`), formatKnown(duration, (time) => `${fixed(time, 0)} s`)];
      return el("tr", { "data-chosen": chosen, title: typeof strokes === "number" && `${strokes} strokes`, ...this.preview(rejected) },
        el("th", { scope: "row" }, chosen && "\u2713 ", rejected ? this.makeKeeper(strategy, rejected) : strategy, chosen && el("span", { class: "w-hidden" }, " (chosen)")),
        ...(error ? [el("td", { class: "w-none-found", colspan: names.length - 1 }, `no plan: ${error}`)] : cells.map((text) => el("td", {}, text))));
    });
    return makeChoice("Candidate plans", makeTable(names, rows, "Share: predicted performance. Lost: predicted share of lost dirt. Score: predicted share of the dirt that reaches the goal, minus three times the lost share, minus the share at risk in heaps near an edge, minus costs of remaining dirt by its distance, of path length and time."));
  }

  /** Makes the table of the strokes. A click on a stroke shows where it begins, and below it the board with and without it. */
  private makeStrokes(round: Round, gains: readonly StrokeGain[]): HTMLElement {
    const isKnown = gains.some(({ marginal }) => marginal !== null);
    const names = ["Stroke", "In turn", ...(isKnown ? ["Marginal"] : []), "Contact", "Time"];
    const detail = el("td", { colspan: names.length, class: "w-stroke" });
    const below = el("tr", {}, detail);
    const rows = gains.map((one) => {
      const { stroke, gain, marginal, way, start, time } = one;
      const button = el("button", { type: "button", class: "w-link", "aria-expanded": "false", "aria-label": `Stroke ${stroke + 1}`, click: () => {
        const isOpen = this.stroke === stroke;
        this.stroke = isOpen ? null : stroke;
        for (const row of rows) row.querySelector("button")!.setAttribute("aria-expanded", String(row === own && !isOpen));
        below.remove();
        if (!isOpen) {
          detail.replaceChildren(...makeStrokeFigures(round, stroke), makeList(describeStroke(round, one)));
          own.after(below);
          below.scrollIntoView({ block: "nearest" });
          this.seek(round.start + start);
        }
        this.publish();
      } }, String(stroke + 1));
      const own = makeRow(button, [signed(gain), ...(isKnown ? [formatKnown(marginal, signed)] : []), `${fixed(way, 2)} m`, `${fixed(time, 1)} s`]);
      return own;
    });
    return makeChoice("Strokes", makeTable(names, rows, `Predicted gain of each stroke in performance, in points. In turn: rise while it is wiped; a stroke without a rise may prepare a later one.${isKnown ? " Marginal: the whole plan minus the plan without it." : ""} Contact: its way in contact. Time: with the way to it.`));
  }
}
