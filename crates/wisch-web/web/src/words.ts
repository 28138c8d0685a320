// The panel beside the scene: current phase, reasons of the plan, results, events, numbers and log.
import { DASH, capitalise, clockText, el, estimateText, fixed, formatKnown, hasChanged, makeList, percent, phaseText, say } from "./dom.ts";
import { isOver } from "./scene/bend.ts";
import type { Clock } from "./clock.ts";
import type { EndedPiece, Fact } from "./recording.ts";
import type { Round } from "./round.ts";
import type { Instant, Recording } from "./store.ts";
import { Why, type Choice } from "./why.ts";

const makeSection = (title: string, open: boolean, ...children: (Node | string)[]) =>
  el("details", { class: "w-section", open }, el("summary", {}, el("h2", {}, title)), ...children);

/** Verdicts that are neither success nor failure; recordings of version 0.2.0 have the last two. */
const UNKNOWN = ["performance unknown", "undecided by touch", "cannot be told", "unknowable by touch"];

/** Verdict on a round that is no ending of a run. */
const AGAIN = "wipe again";

/** How a run ended: whether its goal is met, the verdict on its last round, which is null for a stopped run, and in a few words, where
 * they are known, how it ended. */
export type Ending = Pick<EndedPiece, "met" | "verdict" | "badge">;

/** Returns the state of the goal, for its colour, and words for the end of a run. List, first screen and report have the same ones. */
export const endOf = ({ met, verdict, badge }: Ending): { state: "met" | "unmet" | "unknown"; text: string } => ({
  state: met ? "met" : UNKNOWN.includes(badge ?? "") || UNKNOWN.includes(verdict ?? "") ? "unknown" : "unmet",
  text: badge ?? (verdict === AGAIN ? "not met" : verdict) ?? (met ? "goal met" : "stopped"),
});

export type State = "live" | "planned" | "logged" | "broken" | "met" | "unmet" | "unknown";

/** Returns the state of a run and, in a few words, how it ended. */
export function stateOf({ rounds, ended, live }: Recording): { state: State; text: string } {
  const isAll = (kind: string) => rounds.length > 0 && rounds.every(({ plan }) => plan.kind === kind);
  if (live) return { state: "live", text: "running" };
  if (isAll("planned")) return { state: "planned", text: "planned only" };
  if (isAll("logged")) return { state: "logged", text: "from the log" };
  if (!ended) return { state: "broken", text: "ended early" };
  return endOf(ended);
}

/** Returns the result of a round in a few words: of the last one with a result, how the run ended. */
export function endText({ rounds, ended }: Recording, { number, plan: { kind }, interpreted, over }: Round): string {
  if (kind === "planned") return "planned only";
  if (kind === "logged") return "from the log";
  if (!interpreted) return over ? "no result" : "running";
  const isLast = rounds.findLast((round) => round.interpreted)?.number === number;
  return (isLast ? ended?.badge : null) ?? interpreted.verdict;
}

/** Returns the phase of a time and its stroke; at the end of a round, its result. */
export function headlineOf(recording: Recording, { round, time, phase: index }: Instant): string {
  if (time >= round.length - 1e-6 && round.interpreted) return endText(recording, round);
  const phase = round.plan.phases[index];
  const stroke = typeof phase?.stroke === "number" ? ` \u00b7 stroke ${phase.stroke + 1} of ${round.plan.strokes.length}` : "";
  return `${phase ? phaseText(phase.name) : "starting"}${stroke}`;
}

const makeFact = (label: string, value: string) => [el("dt", {}, label), el("dd", {}, value)];

const BESIDE = "beside the surface";

/** Returns the height of the tool over the surface as believed, or that it is beside the surface. */
export function heightText({ height, tool, contact, round: { plan } }: Instant): string {
  if (height === null) return DASH;
  return tool && contact !== "contact" && !isOver(plan.surface, tool) ? BESIDE : `${fixed(1000 * height, 1)} mm`;
}

/** What replaces plan and result of an episode that was kept without a recording. */
export const LOGGED = "The episode was kept without a recording: the page shows its telemetry and its events.";

/** Maximum number of listed events. */
const MOST_EVENTS = 300;

export class Words {
  readonly element: HTMLElement;
  private readonly headline = el("p", { class: "w-headline" });
  private readonly below = el("p", { class: "w-quiet" });
  private readonly live = { contact: el("dd"), force: el("dd"), height: el("dd"), performance: el("dd") };
  private readonly performanceName = el("dt", {}, "Predicted");
  private readonly why: Why;
  private readonly after = el("div");
  private readonly events = el("div");
  private readonly numbers = el("div");
  private readonly log = el("ol", { class: "w-log" });
  private readonly logCount = el("span", { class: "w-quiet" });
  private readonly complaint = el("p", { class: "w-complaint", hidden: true });
  private shownEvents: { element: HTMLElement; start: number; end: number }[] = [];

  /** `choose` shows in the scene what a reader chose of a plan. */
  constructor(private readonly recording: Recording, private readonly clock: Clock, choose: (choice: Choice | null) => void) {
    this.why = new Why((time) => clock.seek(time), choose);
    const { contact, force, height, performance } = this.live;
    this.element = el("aside", { class: "w-words", "aria-label": "Details of the run", tabindex: 0 },
      el("div", { class: "w-now" }, this.headline, this.below,
        el("dl", { class: "w-values" },
          el("div", {}, el("dt", {}, "Contact"), contact), el("div", {}, el("dt", {}, "Force"), force),
          el("div", {}, el("dt", { title: "Height of the tool over the surface as believed" }, "Tool height"), height), el("div", {}, this.performanceName, performance))),
      this.complaint,
      makeSection("Why this plan", true, this.why.element),
      makeSection("Result", true, this.after),
      makeSection("Events", true, this.events),
      makeSection("Numbers", true, this.numbers),
      makeSection("Log", false, this.logCount, this.log),
    );
  }

  /** Updates the panel; called once per frame. */
  show(): void {
    const { recording, clock } = this;
    const instant = recording.at(clock.time);
    this.showNow(instant);
    const round = instant?.round;
    if (hasChanged(this.after, [round?.number, round?.start, recording.rounds.length, Boolean(round?.interpreted), Boolean(round?.truth), recording.live, recording.ended?.badge])) this.showRound(round ?? null);
    const { stages, happenings, head, ended, broken, unknown } = recording;
    if (hasChanged(this.events, [stages.length, happenings.length, Boolean(head), Boolean(ended), broken, unknown])) this.showRun();
    for (const { element, start, end } of this.shownEvents) {
      element.toggleAttribute("data-now", clock.time >= start - 0.05 && clock.time <= end + 0.05);
    }
  }

  private showNow(instant: Instant | null): void {
    const { recording, clock } = this;
    const stage = recording.live && (clock.following || !instant) ? recording.stages.at(-1) : undefined;
    if (!instant) {
      say(this.headline, stage?.words ?? (!recording.live ? "The recording has no rounds." : recording.head ? "No round has begun." : "The recording is empty so far."));
      say(this.below, "");
      for (const value of Object.values(this.live)) say(value, DASH);
      delete this.live.height.dataset.words;
      return;
    }
    const { round, time, normal, performance, contact } = instant;
    const rounds = recording.rounds.length;
    say(this.headline, capitalise(stage && stage.stage !== "executing" ? stage.words : headlineOf(recording, instant)));
    say(this.below, `Round ${round.number} of ${rounds}${round.plan.kind === "planned" ? " (planned only)" : ""} \u00b7 ${clockText(time)} of ${clockText(round.length)}`);
    say(this.live.contact, contact === "contact" ? "yes" : contact === "pushed" ? "pushed" : "none");
    say(this.live.force, formatKnown(normal, (force) => `${fixed(force, 1)} N`));
    const height = heightText(instant);
    say(this.live.height, height);
    this.live.height.toggleAttribute("data-words", height === BESIDE);
    const result = recording.resultAt(clock.time)?.interpreted;
    say(this.performanceName, result ? "Estimated" : "Predicted");
    say(this.live.performance, result ? percent(result.estimate.mean) : formatKnown(performance, percent));
  }

  private showRound(round: Round | null): void {
    const { rounds } = this.recording;
    this.why.show(round, rounds[rounds.indexOf(round!) - 1] ?? null, !round ? "No plan yet." : round.plan.kind === "logged" ? LOGGED : "The recording states no reasons for this plan.");
    if (!round?.interpreted) {
      const text = !round ? "No round yet." : round.plan.kind === "planned" ? "This plan was not executed." : round.plan.kind === "logged" ? LOGGED : this.recording.live ? "The round is not finished." : "The round has no result because the run ended early.";
      this.after.replaceChildren(el("p", { class: "w-quiet" }, text));
      return;
    }
    const { interpreted, truth } = round;
    this.after.replaceChildren(
      el("p", { class: "w-quiet" }, `Round ${round.number}, known from ${clockText(round.end)} on.`),
      el("p", {}, el("strong", {}, endText(this.recording, round)), interpreted.ending ? ` \u00b7 ${interpreted.ending}` : ""),
      el("dl", { class: "w-facts" },
        ...makeFact("Predicted", formatKnown(round.plan.predicted, percent)),
        ...makeFact("Estimated", estimateText(interpreted.estimate)),
        ...makeFact("From touch only", estimateText(interpreted.by_touch)),
        ...(typeof truth?.performance === "number" ? makeFact("True", percent(truth.performance)) : []),
        ...(interpreted.found ? makeFact("Surface", "not at its believed pose") : [])),
      makeList(interpreted.words),
    );
  }

  private showRun(): void {
    const { recording, clock } = this;
    const list = recording.happenings.slice(0, MOST_EVENTS);
    this.shownEvents = [];
    this.events.replaceChildren(list.length ? el("ul", { class: "w-events" }, ...list.map(({ start, end, round, kind, words, source }) => {
      const button = el("button", { type: "button", "data-source": source, click: () => clock.seek(start) },
        el("span", { class: "w-when" }, clockText(start)), el("span", {}, el("strong", {}, kind), ` in round ${round}: ${words}`));
      this.shownEvents.push({ element: button, start, end });
      return el("li", {}, button);
    }), recording.happenings.length > MOST_EVENTS && el("li", { class: "w-quiet" }, `and ${recording.happenings.length - MOST_EVENTS} more`)) : el("p", { class: "w-quiet" }, "None."));
    this.showNumbers();
    this.log.replaceChildren(...recording.stages.slice(-500).map(({ round, stage, words }) =>
      el("li", {}, el("span", { class: "w-when" }, `${round} ${stage}`), ` ${words}`)));
    say(this.logCount, recording.stages.length > 500 ? `The list shows the last 500 of ${recording.stages.length} entries.` : "");
    const { broken, unknown } = recording;
    this.complaint.hidden = !broken && !unknown;
    say(this.complaint, [
      broken ? `${broken} ${broken === 1 ? "line" : "lines"} of this recording could not be read.` : "",
      unknown ? `${unknown} ${unknown === 1 ? "piece" : "pieces"} of unknown kind ${unknown === 1 ? "was" : "were"} skipped.` : "",
    ].join(" ").trim());
  }

  /** Lists the numbers of the run and, if it has several rounds, apart from them those of single rounds. */
  private showNumbers(): void {
    const { head, ended, rounds } = this.recording;
    if (!head) return;
    const { task, robot } = head;
    const run: Row[] = [
      ...(task ? [
        ["Task", `${task.action} ${task.medium} with ${task.tool} on ${task.surface}`],
        ["Strategy", task.strategy], ["Target", percent(task.target)], ["Seed", String(task.seed)],
      ] as Row[] : []),
      ...(robot ? [["Robot", `${robot.name}, ${robot.variables.length} variables`] as Row] : []),
      ["Program", head.program],
      ...(head.begun ? [["Started", head.begun] as Row] : []),
      ...(ended?.episode ? [["Episode", ended.episode] as Row] : []),
    ];
    const known = new Set(run.map(([label]) => label));
    const groups = new Map<number | null, Row[]>([[null, run]]);
    for (const fact of ended?.facts ?? []) {
      if (known.has(fact[0])) continue;
      const round = rounds.length > 1 ? roundOf(fact, rounds[0]!.number) : null;
      groups.set(round, [...groups.get(round) ?? [], [fact[0], fact[1]]]);
    }
    this.numbers.replaceChildren(...[...groups].flatMap(([round, rows]) => [
      ...(groups.size > 1 ? [el("h3", {}, round === null ? `Whole run, ${rounds.length} rounds` : `Round ${round}`)] : []),
      el("dl", { class: "w-facts" }, ...rows.flatMap(([label, value]) => makeFact(String(label), String(value)))),
    ]));
  }
}

type Row = [label: string, value: string];

/** Returns the round that a number is about; null for the whole run. A recording of version 0.2.0 does not state it:
 * it has the numbers of the first plan, and these of the run. */
const roundOf = ([label, value, round]: Fact, first: number): number | null =>
  round !== undefined ? round : / in \d+ rounds$/.test(value) || /^(Target performance|Tool held|Maximum path error|Minimum clearance|Distance in contact|Distance in total|Goal|Steps|Links|Joints held at their ready positions)$/.test(label) ? null : first;
