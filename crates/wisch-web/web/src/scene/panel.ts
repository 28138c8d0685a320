// The scene with its overlays: legend with toggles, and buttons for views.
import { clockText, el, fixed, makeSwatches, percent, say, uniqueId } from "../dom.ts";
import { diamond, mark } from "../icons.ts";
import { makeReachScale } from "../bases.ts";
import { makeScale } from "../maps.ts";
import { colour, onTheme, isPrinting } from "../theme.ts";
import { FORCES } from "./ribbon.ts";
import { collisionOf, hasMadeBody } from "./robot.ts";
import { LAYERS, NOTHING_SHOWN, Stage, type Layers, type Look, type Shown } from "./stage.ts";
import { askedColour, hexOr, safeColour, type ShownParticles } from "./queried.ts";
import type { Recording } from "../store.ts";
import { isTreated, mapAt, quantityOf } from "../treated.ts";
import { heightText } from "../words.ts";
import type { TreatmentRecord } from "../recording.ts";
import type { Round } from "../round.ts";
import type { Choice } from "../why.ts";

/** Labels of the layers, and whether a recording has data for them: layers without data get no toggle. */
const LISTED: Record<keyof Layers, [label: string, has: (recording: Recording) => unknown]> = {
  believed: ["Believed and predicted dirt", ({ rounds }) => rounds.some((round) => (isTreated(round) ? round.treated !== null : round.plan.particles.length > 0))],
  estimated: ["Estimated dirt after the round", ({ rounds }) => rounds.some((round) => (isTreated(round) ? round.interpreted?.treated : round.interpreted) != null)],
  actual: ["True dirt after the round", ({ rounds }) => rounds.some((round) => (isTreated(round) ? round.truth?.treated : round.truth?.particles) != null)],
  seen: ["Observed dirt", ({ rounds, before }) => before.observed ?? rounds.some(({ observed }) => observed)],
  path: ["Tool path", ({ rounds }) => rounds.some(({ count }) => count)],
  ribbon: ["Force along the path", ({ rounds }) => rounds.some(({ count }) => count)],
  strokes: ["Planned strokes", ({ rounds }) => rounds.some(({ plan }) => plan.strokes.length)],
  rejected: ["Rejected plan, chosen in its table", ({ rounds }) => rounds.some(({ plan }) => plan.another || plan.considered?.some(({ lines }) => lines?.length))],
  bases: ["Rated base poses", ({ rounds }) => rounds.some(({ plan }) => plan.bases?.poses.length)],
  force: ["Force", ({ rounds }) => rounds.some(({ count }) => count)],
  events: ["Events, force at pushes or collisions", ({ happenings }) => happenings.length],
  found: ["Surface found by touch", ({ rounds }) => rounds.some(({ interpreted }) => interpreted?.found)],
  actualSurface: ["True surface", ({ rounds }) => rounds.some(({ truth }) => truth?.surface)],
  collision: ["Collision shapes", ({ head }) => head?.robot?.links.some((link) => collisionOf(link).length)],
};

/** Distance of the label from the pointer [pixels]. */
const POINT_PX = 24;

/** A legend entry of queried data: a line, or particles in a state. */
interface Named {
  name: string;
  colour: string;
  form?: ShownParticles["state"];
}

export class ScenePanel {
  readonly element: HTMLElement;
  readonly stage: Stage | null;
  private readonly boxes = new Map<keyof Layers, HTMLElement>();
  private readonly extra = el("ul", { class: "w-named" });
  private readonly follow: HTMLButtonElement;
  private readonly still = el("img", { class: "w-still", alt: "The robot and the surface at the shown time" });
  private readonly stop: (() => void)[] = [];
  private readonly mapTitle = el("strong");
  private readonly mapScale = el("div", { class: "w-map-scale", hidden: true }, this.mapTitle);
  private readonly forceTitle = el("strong");
  private readonly forceScale = el("div", { class: "w-force-scale", hidden: true }, this.forceTitle, makeSwatches(FORCES));
  private readonly point = el("div", { class: "w-point", hidden: true });
  private readonly reach = makeReachScale();
  private shown = NOTHING_SHOWN;
  private choice: Choice | null = null;
  private scaleOf: TreatmentRecord | null = null;
  private treats = false;
  private version = -1;
  private time = 0;

  constructor(private readonly recording: Recording, compact: boolean, seek: (time: number) => void) {
    const canvas = el("canvas", { class: "w-canvas", tabindex: 0, role: "application", "aria-label": "Robot, tool and surface in 3-D. W A S D turn the scene, Z and X zoom." });
    this.stage = makeStage(canvas, recording, () => this.follow.setAttribute("aria-pressed", "false"));
    const button = (text: string, title: string, act: () => void) => el("button", { class: "w-button", type: "button", title, click: act }, text);
    this.follow = button("Follow", "Follow the work: wide in free motion, close at strokes  T", () => this.toggleFollow());
    this.follow.setAttribute("aria-pressed", "false");
    const xray = el("input", { type: "range", min: 0, max: 0.95, step: 0.05, value: 0, "aria-label": "Transparency of the robot", input: () => { if (this.stage) this.stage.xray = Number(xray.value); } });
    const views = el("div", { class: "w-views", role: "group", "aria-label": "View" },
      button("Fit", "Show all of robot and surface  F", () => this.look("all")),
      button("Surface", "Close view of the surface", () => this.look("surface")),
      button("Above", "View from above  V", () => this.look("above")), this.follow,
      el("label", { class: "w-button w-xray", title: "Look through the robot" }, "X-ray", xray));
    this.element = el("section", { class: "w-scene", "aria-label": "Scene" },
      this.stage ? canvas : el("p", { class: "w-none" }, "This browser cannot draw 3-D graphics. The other panels still work."),
      this.stage && views, this.stage && this.legend(compact), el("div", { class: "w-scene-scale" }, this.forceScale, this.reach, this.mapScale), this.extra, this.point, this.still);
    if (!this.stage) return;
    const { stage } = this;
    let shaped = false;
    const shape = () => {
      const { clientWidth, clientHeight } = canvas;
      const layers = this.element.querySelector<HTMLDetailsElement>(".w-layers");
      // On a small canvas the legend starts closed.
      if (!shaped && clientWidth && clientWidth <= 640 && layers) layers.open = false;
      shaped ||= clientWidth > 0;
      stage.resize(clientWidth, clientHeight, layers?.open && clientWidth > 640 ? layers.offsetWidth : 0);
    };
    const sizes = new ResizeObserver(shape);
    sizes.observe(canvas);
    this.element.addEventListener("toggle", shape, true);
    // A click on the path seeks to the time at which the tool was there.
    let down = { x: 0, y: 0 };
    canvas.addEventListener("pointerdown", ({ offsetX, offsetY }) => { down = { x: offsetX, y: offsetY }; });
    canvas.addEventListener("click", ({ offsetX, offsetY }) => {
      if (Math.hypot(offsetX - down.x, offsetY - down.y) > 3) return;
      const time = stage.timeAt(offsetX, offsetY);
      if (time !== null) seek(time);
    });
    canvas.addEventListener("pointermove", ({ offsetX, offsetY, buttons }) => this.explain(buttons ? null : [offsetX, offsetY]));
    canvas.addEventListener("pointerleave", () => this.explain(null));
    this.stop.push(() => sizes.disconnect(), onTheme(() => {
      stage.paint();
      this.listNamed();
      if (isPrinting()) this.still.src = stage.picture();
    }));
  }

  show(time: number): void {
    this.stage?.show(time);
    this.time = time;
    this.showScale();
    if (this.version === this.recording.version) return;
    this.version = this.recording.version;
    const { rounds, head } = this.recording;
    const robot = head?.robot;
    if (robot && hasMadeBody(robot)) this.boxes.get("collision")?.querySelector("label")!.replaceChildren(mark("collision"), "Collision shapes (the robot's shell is drawn from them)");
    const treated = rounds.find(isTreated);
    if (this.stage && treated && !this.treats) this.nameMaps(treated);
    this.element.toggleAttribute("data-target", rounds.some(({ target }) => target !== null));
    for (const [name, box] of this.boxes) box.hidden = !LISTED[name][1](this.recording);
    const layers = this.element.querySelector<HTMLElement>(".w-layers");
    if (layers) layers.hidden = [...this.boxes.values()].every(({ hidden }) => hidden);
  }

  /** Shows force and height of the tool at the place of its path that is under the pointer. */
  private explain(pointer: [number, number] | null): void {
    const time = pointer && this.stage!.timeAt(...pointer);
    const instant = time === null ? null : this.recording.at(time);
    this.point.hidden = instant?.normal == null;
    if (!pointer || instant?.normal == null) return;
    const { normal, height, round } = instant;
    const target = round.isPressed(instant.time) ? round.target : null;
    say(this.point, [
      `${fixed(normal, 1)} N${target === null ? "" : `, ${percent(normal / target)} of the target of ${fixed(target, 1)} N`}`,
      height === null ? "" : `tool height ${heightText(instant)}`,
      `${clockText(time!, 2)} (click to go there)`,
    ].filter((line) => line).join("\n"));
    const [x, y] = pointer;
    const { offsetWidth, offsetHeight } = this.point;
    // Beside the pointer, so that the label covers none of what it explains.
    const isLeft = x + offsetWidth + POINT_PX > this.element.clientWidth;
    Object.assign(this.point.style, { left: `${isLeft ? x - offsetWidth - POINT_PX : x + POINT_PX}px`, top: `${Math.max(2, y - offsetHeight - POINT_PX)}px` });
  }

  /** Shows the scales of the force along the path, of the base poses, and of the current map, and whether the map is predicted, estimated or true. */
  private showScale(): void {
    const round = this.stage && this.recording.roundAt(this.time);
    this.forceScale.hidden = !round?.target || !round.count || !this.stage!.layers.ribbon;
    if (round?.target) say(this.forceTitle, `Force along the path, target ${fixed(round.target, 1)}\u202fN`);
    const map = round && mapAt(this.recording, this.time, round, this.stage!.layers);
    this.reach.hidden = !round?.plan.bases || !this.stage!.layers.bases;
    this.mapScale.hidden = !map;
    if (!map) return;
    say(this.mapTitle, map.title);
    if (this.scaleOf === map.record) return;
    this.scaleOf = map.record;
    this.mapScale.replaceChildren(this.mapTitle, makeScale(map.record));
  }

  /** Names the layers of dirt as maps of a treated surface. Only one map is shown at a time: the true one on
   * request, and so is the force along the path, which would cover the map. */
  private nameMaps(round: Round): void {
    this.treats = true;
    const quantity = quantityOf(round);
    const names = { believed: `Predicted ${quantity}`, estimated: `Estimated ${quantity} after the round`, actual: `True ${quantity} after the round` };
    for (const [name, text] of Object.entries(names)) this.boxes.get(name as keyof typeof names)?.querySelector("label")!.replaceChildren(mark("map"), text);
    for (const name of ["actual", "ribbon"] as const) {
      this.stage!.layers[name] = false;
      this.boxes.get(name)!.querySelector("input")!.checked = false;
    }
  }

  look(at: Look): void {
    this.follow.setAttribute("aria-pressed", "false");
    this.stage?.look(at);
  }

  toggleFollow(): void {
    if (!this.stage) return;
    this.stage.follow = !this.stage.follow;
    this.follow.setAttribute("aria-pressed", String(this.stage.follow));
  }

  /** Shows data of a query, and lists them in the legend. */
  showData(shown: Shown): void {
    this.shown = shown;
    this.stage?.showData(shown);
    this.listNamed();
  }

  /** Returns the legend entries of the shown data of a query. */
  private get queried(): Named[] {
    const { trajectories, ghosts, frames, particles } = this.shown;
    return [
      ...trajectories.map(({ name, color }, i) => ({ name, colour: safeColour(color, i) })),
      ...ghosts.map(({ time, color }) => ({ name: `${this.recording.head?.robot ? "robot" : "tool"} at ${clockText(time)}`, colour: hexOr(color, colour("ghost")) })),
      ...frames.map(({ name, color }) => ({ name, colour: hexOr(color, colour("axis-z")) })),
      ...particles.map(({ name, color, state }) => ({ name, colour: askedColour(color), form: state })),
    ];
  }

  /** Shows what a reader chose of a plan. */
  choose(choice: Choice | null): void {
    this.choice = choice;
    this.stage?.choose(choice);
    this.listNamed();
  }

  private listNamed(): void {
    const { stroke = null, rejected = null } = this.choice ?? {};
    const chosen: Named[] = [
      ...(stroke === null ? [] : [{ name: `Stroke ${stroke + 1}`, colour: "var(--chosen)" }]),
      ...(rejected && this.stage?.layers.rejected ? [{ name: rejected.name, colour: "var(--rejected)" }] : []),
    ];
    this.extra.replaceChildren(...[...chosen, ...this.queried].map(({ name, colour, form }) => {
      if (form) return el("li", {}, diamond(colour, form === "estimated"), name);
      const line = el("i", { "aria-hidden": "true" });
      line.style.background = colour;
      return el("li", {}, line, name);
    }));
  }

  destroy(): void {
    for (const stop of this.stop) stop();
    this.stage?.destroy();
  }

  private legend(compact: boolean): HTMLElement {
    const list = (Object.keys(LAYERS) as (keyof Layers)[]).map((name) => {
      const id = uniqueId();
      const box = el("input", { type: "checkbox", id, checked: LAYERS[name], change: () => {
        if (!this.stage) return;
        this.stage.layers[name] = box.checked;
        this.stage.ask();
        this.showScale();
        this.listNamed();
      } });
      const item = el("li", {}, box, el("label", { for: id }, mark(name), LISTED[name][0]));
      this.boxes.set(name, item);
      return item;
    });
    return el("details", { class: "w-layers", open: !compact }, el("summary", {}, "Layers"), el("ul", {}, ...list));
  }
}

function makeStage(canvas: HTMLCanvasElement, recording: Recording, left: () => void): Stage | null {
  try {
    return new Stage(canvas, recording, left);
  } catch {
    return null;
  }
}
