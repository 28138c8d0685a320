// The scene with its overlays: legend with toggles, and buttons for views.
import { el, uniqueId } from "../dom.ts";
import { diamond, mark } from "../icons.ts";
import { onTheme, isPrinting } from "../theme.ts";
import { LAYERS, Stage } from "./stage.ts";
import type { Layers, Look } from "./stage.ts";
import type { Recording } from "../store.ts";

const NAMES: Record<keyof Layers, string> = {
  believed: "Believed and predicted dirt", estimated: "Estimated dirt after the round", actual: "True dirt after the round", seen: "Observed dirt",
  path: "Tool path", strokes: "Planned strokes", force: "Force", events: "Events", found: "Surface found by touch", actualSurface: "True surface", collision: "Collision shapes",
};

/** A legend entry of queried data: a line, or particles in a state. */
export interface Named {
  name: string;
  colour: string;
  form?: "before" | "estimated";
}

export class ScenePanel {
  readonly element: HTMLElement;
  readonly stage: Stage | null;
  private readonly boxes = new Map<keyof Layers, HTMLElement>();
  private readonly extra = el("ul", { class: "w-named" });
  private readonly follow: HTMLButtonElement;
  private readonly still = el("img", { class: "w-still", alt: "The robot and the surface at the shown time" });
  private readonly stop: (() => void)[] = [];
  private version = -1;

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
      this.stage && views, this.stage && this.legend(compact), this.extra, this.still);
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
    this.stop.push(() => sizes.disconnect(), onTheme(() => {
      stage.paint();
      if (isPrinting()) this.still.src = stage.picture();
    }));
  }

  show(time: number): void {
    this.stage?.show(time);
    if (this.version === this.recording.version) return;
    this.version = this.recording.version;
    // Layers without data get no toggle.
    const { rounds, observedBefore } = this.recording;
    const has: Record<keyof Layers, boolean> = {
      believed: rounds.some(({ plan }) => plan.particles.length > 0),
      estimated: rounds.some(({ interpreted }) => interpreted !== null),
      actual: rounds.some(({ truth }) => truth?.particles != null),
      seen: observedBefore !== null || rounds.some(({ observed }) => observed !== null),
      path: rounds.some(({ count }) => count > 0),
      strokes: rounds.some(({ plan }) => plan.strokes.length > 0),
      force: rounds.some(({ count }) => count > 0),
      events: this.recording.happenings.length > 0,
      found: rounds.some(({ interpreted }) => interpreted?.found != null),
      collision: this.recording.head?.robot?.links.some(({ collision }) => collision?.length) ?? false,
      actualSurface: rounds.some(({ truth }) => truth?.surface != null),
    };
    for (const [name, box] of this.boxes) box.hidden = !has[name];
    const layers = this.element.querySelector<HTMLElement>(".w-layers");
    if (layers) layers.hidden = !Object.values(has).some(Boolean);
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

  /** Lists queried data in the legend. */
  name(list: Named[]): void {
    this.extra.replaceChildren(...list.map(({ name, colour, form }) => {
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
      } });
      const item = el("li", {}, box, el("label", { for: id }, mark(name), NAMES[name]));
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
