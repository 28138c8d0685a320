// The first screen: task, result, confidence interval, what did not go as planned, and what to do next.
import { isComparable, isTruthOutside } from "./belief.ts";
import { clockText, el, estimateText, hasChanged, percent, say, svg } from "./dom.ts";
import { onNews } from "./frames.ts";
import { mark } from "./icons.ts";
import { makeMapFigures } from "./maps.ts";
import { metres } from "./particles.ts";
import { makeFigure, surfacePicture, viewOf, type Dots } from "./picture.ts";
import { Seam, makeDensityLegend } from "./seam.ts";
import type { IncidentRecord, InterpretedPiece, Places } from "./recording.ts";
import { namePushes, type Round } from "./round.ts";
import type { Recording } from "./store.ts";
import { isTreated } from "./treated.ts";
import { LOGGED, stateOf } from "./words.ts";

const NAMES: Record<string, string> = {
  believed: "believed before", estimated: "estimated after", actual: "true after", seen: "observed", sample: "estimated after: a typical sample",
  interval: "90\u202f% interval", "by-touch": "from touch only", target: "target", goal: "goal area",
};

const makeLegend = (names: string[], labels = NAMES) =>
  el("ul", { class: "w-legend" }, ...names.map((name) => el("li", {}, mark(name === "sample" ? "estimated" : name), labels[name]!)));

/** Keeps numbers and their percent signs on one line. */
const tiePercents = (text: string): string => text.replaceAll(/(?<=\d) %/g, "\u202f%");

/** Maximum number of shown incidents. */
const MOST_INCIDENTS = 6;

const describePrediction = (predicted: number | null): string => (predicted === null ? "" : ` Predicted performance: ${percent(predicted)}.`);

/** Returns a command with a button that copies it. */
function makeCommand(command: string): HTMLElement {
  const copy = el("button", { type: "button", class: "w-button", click: () => {
    // A page without a secure origin has no clipboard.
    const copied = navigator.clipboard ? navigator.clipboard.writeText(command) : Promise.reject();
    copied.then(() => say(copy, "Copied"), () => say(copy, "Not copied"));
  } }, "Copy");
  return el("div", { class: "w-command" }, el("code", {}, command), copy);
}

/** Returns what did not go as planned in a round: what its recording states, and a truth that the estimate misses. */
export function findIncidents(round: Round): IncidentRecord[] {
  const stated = (round.interpreted?.incidents ?? []).map((incident) => ({ ...incident, title: namePushes(incident.title) }));
  if (!isTruthOutside(round)) return stated;
  return [...stated, {
    time: null, title: "The ground truth lies outside the interval of the estimate",
    evidence: `Estimated ${estimateText(round.interpreted!.estimate, 1)}, true ${percent(round.truth!.performance!, 1)}.`,
    effect: "A correct 90\u202f% interval misses the ground truth in one of ten rounds. The ground truth is known only in simulation.", advice: "",
  }];
}

export class Story {
  readonly element: HTMLElement;
  /** Title and result, for the heads of pages. */
  readonly title = el("h1", {});
  readonly badge = el("p", { class: "w-badge" });
  private readonly pictures = el("div", { class: "w-pictures" });
  private readonly texts = el("div", { class: "w-texts" });
  private readonly seam = new Seam();
  /** Estimate against ground truth, in words. */
  private readonly comparison = el("div", { class: "w-comparison" });
  private readonly incidents = el("section", { class: "w-incidents", "aria-label": "Incidents" });
  readonly destroy: () => void;

  /** `seek` shows a time of the common clock. `corner`: an element beside title and result, which are elsewhere without it. */
  constructor(private readonly recording: Recording, private readonly seek: (time: number) => void, corner?: HTMLElement) {
    this.element = el("header", { class: "w-story" },
      corner && el("div", { class: "w-top" }, this.title, this.badge, corner),
      el("div", { class: "w-told" }, this.pictures, this.texts, this.incidents));
    this.destroy = onNews(recording, () => this.show());
    this.show();
  }

  private show(): void {
    const { head, ended, rounds, stages, live } = this.recording;
    const interpreted = rounds.findLast((round) => round.interpreted) ?? null;
    say(this.title, head?.title || "Recording");
    const { state, text } = stateOf(this.recording);
    const [planned, logged] = [state === "planned", state === "logged"];
    this.badge.dataset.state = state;
    say(this.badge, text);
    const story = ended?.story;
    const happened = story?.happened ?? (live ? stages.at(-1)?.words ?? "The run is starting." : interpreted
      ? `The run ended early after round ${interpreted.number}: ${interpreted.interpreted!.verdict}.` : planned ? `Planned, not executed.${describePrediction(rounds.at(-1)!.plan.predicted)}` : logged ? LOGGED : rounds.length ? "The recording ends before the first round has a result." : "The recording has no rounds.");
    const known = rounds.map(({ number, interpreted, truth }) => [number, interpreted?.estimate, interpreted?.by_touch, truth?.performance]);
    if (hasChanged(this.texts, [head?.task, story, live, happened, state, known])) this.texts.replaceChildren(
      ...this.makePart("Task", story?.asked ?? head?.task?.asked ?? ""),
      ...this.makePart(live ? "Now" : "Result", happened),
      ...this.makePart("Confidence", story?.sure ?? (interpreted || planned || logged ? "" : "No round has a result yet."), this.drawBars()),
      this.comparison,
      ...this.makePart("More certainty", story?.surer ?? ""),
      ...this.makePart("Next", story?.next?.words ?? "", story?.next?.command ? makeCommand(story.next.command) : null));
    this.drawPictures();
    this.showIncidents();
  }

  /** Shows what did not go as planned, in order of time. */
  private showIncidents(): void {
    const all = this.recording.rounds.flatMap((round) => findIncidents(round).map((incident) => ({ round, incident })));
    const isKnown = this.recording.rounds.some((round) => round.interpreted?.incidents);
    const shown = all.slice(0, MOST_INCIDENTS);
    const more = all.length - shown.length;
    this.incidents.hidden = !isKnown && !all.length;
    const content = [more, shown.map(({ round: { number, start }, incident }) => [number, start, incident])];
    if (hasChanged(this.incidents, content)) this.incidents.replaceChildren(el("h2", {}, "What did not go as planned"), ...(all.length
      ? [el("ul", {}, ...shown.map(({ round, incident }) => this.makeCard(round, incident))), ...(more ? [el("p", { class: "w-quiet" }, `and ${more} more`)] : [])]
      : [el("p", { class: "w-quiet" }, "Nothing unusual was detected.")]));
  }

  private makeCard(round: Round, { time, title, evidence, effect, advice }: IncidentRecord): HTMLElement {
    const when = `Round ${round.number}${time === null ? "" : ` \u00b7 ${clockText(round.start + time)}`}`;
    return el("li", { "data-round": round.number },
      el("button", { type: "button", class: "w-when w-link", title: "Show this time", click: () => this.seek(round.start + (time ?? 0)) }, when),
      el("h3", {}, title),
      ...[evidence, effect].filter((text) => text).map((text) => el("p", {}, tiePercents(text))),
      advice ? el("p", { class: "w-advice" }, advice) : null);
  }

  private makePart(title: string, text: string, more: Node | null = null): Node[] {
    const parts = [...(text ? [el("p", {}, tiePercents(text))] : []), ...(more ? [more] : [])];
    return parts.length ? [el("h2", {}, title), ...parts] : [];
  }

  private drawPictures(): void {
    const { rounds, before } = this.recording;
    const first = rounds[0];
    const last = rounds.findLast((round) => round.interpreted ?? round.truth) ?? null;
    const known = rounds.map(({ plan, interpreted, truth, observed }) => [plan.round, plan.predicted, plan.duration, Boolean(interpreted), Boolean(truth), Boolean(observed)]);
    if (!hasChanged(this.pictures, [known, Boolean(before.observed)])) return;
    const seam = last && isComparable(last) ? this.seam.show(rounds) : null;
    this.comparison.replaceChildren(...(seam ? this.makePart("Ground truth", "", this.seam.table) : []));
    this.pictures.toggleAttribute("data-maps", Boolean(first && isTreated(first)));
    this.pictures.replaceChildren(...(!first ? [] : isTreated(first) ? makeMapFigures(this.recording, seam) : this.makeDirtFigures(first, last, seam)));
  }

  /** Draws the dirt before the first round, and after the last one or as predicted, with a legend. */
  private makeDirtFigures(first: Round, last: Round | null, seam: HTMLElement | null): Element[] {
    const { surface, kind, goal } = first.plan;
    const dots = (mark: Dots["mark"], list: Places | null | undefined): Dots[] => (list ? [{ mark, places: metres(list) }] : []);
    const figure = (title: string, round: Round, layers: Dots[]) =>
      makeFigure(surfacePicture(round, layers, `${title}: ${viewOf(round)} with ${layers.map(({ places, mark }) => `${places.length / 2} particles ${NAMES[mark]}`).join(", ")}`), surface.shape ? `${title}, surface unrolled` : title);
    const before: Dots[] = [{ mark: "believed", places: first.particles.first }, ...dots("seen", this.recording.before.observed?.detections)];
    const after: Dots[] = last ? [...dots("estimated", last.interpreted?.particles), ...dots("actual", last.truth?.particles), ...dots("seen", last.observed?.detections)]
      : kind === "planned" ? [{ mark: "believed", places: first.particles.last }] : [];
    const second = seam ?? (last ? figure(`After ${last.number} ${last.number === 1 ? "round" : "rounds"}`, last, after) : after.length ? figure("Predicted", first, after) : null);
    const density = seam && last?.interpreted?.density;
    const later = !seam ? after.map(({ mark }) => mark) : density ? ["actual"] : ["sample", "actual"];
    const legend = makeLegend([...new Set([...before.map(({ mark }) => mark), ...later]), ...(goal?.kind === "collected" ? ["goal"] : [])]);
    if (density) legend.append(makeDensityLegend(density));
    const arrow = svg("svg", { viewBox: "0 0 24 24", class: "w-arrow", "aria-hidden": "true" }, svg("path", { d: "M3 12h16M13 6l6 6-6 6" }));
    return [figure(second ? "Before" : "Believed before", first, before), ...(second ? [arrow, second] : []), legend];
  }

  /** Draws the estimate of each finished round as a bar, with the target. */
  private drawBars(): HTMLElement | null {
    const { rounds, head } = this.recording;
    const interpreted = rounds.filter((round) => round.interpreted).slice(-8);
    if (!interpreted.length) return null;
    const target = head?.task?.target ?? null;
    // Without a camera both estimates are one.
    const differs = ({ estimate, by_touch }: InterpretedPiece) => by_touch.low !== estimate.low || by_touch.high !== estimate.high;
    const rows = interpreted.map(({ number, interpreted, truth }) => {
      const { estimate, by_touch } = interpreted!;
      const truly = truth?.performance ?? null;
      const x = (share: number) => `${(1.5 + 97 * Math.min(1, Math.max(0, share))).toFixed(2)}%`;
      const width = (from: number, to: number) => `${Math.max(0.6, 97 * (Math.min(1, to) - Math.max(0, from))).toFixed(2)}%`;
      const upright = (share: number, y1: number, y2: number, look: Record<string, string | number>) => svg("line", { x1: x(share), x2: x(share), y1, y2, ...look });
      const label = `Round ${number}: estimated ${percent(estimate.mean)}, 90 % interval ${percent(estimate.low)} to ${percent(estimate.high)}; from touch only ${estimateText(by_touch)}${truly === null ? "" : `; true ${percent(truly)}`}${target === null ? "" : `; target ${percent(target)}`}`;
      return el("div", { class: "w-bar" }, el("span", {}, `Round ${number}`),
        svg("svg", { role: "img", "aria-label": label },
          svg("rect", { x: x(0), y: 8, width: "97%", height: 10, rx: 5, fill: "var(--lane)" }),
          differs(interpreted!) && svg("rect", { x: x(by_touch.low), y: 21.5, width: width(by_touch.low, by_touch.high), height: 2, fill: "var(--by-touch)" }),
          svg("rect", { x: x(estimate.low), y: 6, width: width(estimate.low, estimate.high), height: 14, rx: 4, fill: "var(--estimated)", "fill-opacity": 0.35, stroke: "var(--estimated)", "stroke-width": 1.6 }),
          upright(estimate.mean, 4, 22, { stroke: "var(--estimated)", "stroke-width": 3 }),
          target !== null && upright(target, 0, 26, { stroke: "var(--target)", "stroke-width": 2, "stroke-dasharray": "4 3" }),
          truly !== null && svg("svg", { x: x(truly), y: 13, overflow: "visible" },
            svg("path", { d: "M-5 -5L5 5M5 -5L-5 5", stroke: "var(--actual)", "stroke-width": 2.6, fill: "none" }))),
        el("b", {}, percent(estimate.mean)));
    });
    const anyTruth = interpreted.some(({ truth }) => typeof truth?.performance === "number");
    const labels = { ...NAMES, actual: "true", target: `target ${percent(target ?? NaN)}` };
    const anyTouch = interpreted.some((round) => differs(round.interpreted!));
    return el("div", { class: "w-bars" }, ...rows, makeLegend(["interval", ...(anyTouch ? ["by-touch"] : []), ...(anyTruth ? ["actual"] : []), ...(target === null ? [] : ["target"])], labels));
  }
}
