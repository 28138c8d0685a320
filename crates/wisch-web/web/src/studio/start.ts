// The dialog that starts a run.
import { el, hasChanged, say } from "../dom.ts";
import { Refused, startRun, type Scenario } from "./server.ts";

const STRATEGIES = ["best", "adaptive", "grid", "rrt", "kde"];

export class StartDialog {
  readonly element: HTMLDialogElement;
  private readonly list = el("ul", { class: "s-scenarios" });
  private readonly seed = el("input", { type: "number", min: 0, step: 1, placeholder: "from the task", "aria-label": "Seed" });
  private readonly strategy = el("select", { class: "w-select", "aria-label": "Strategy" },
    el("option", { value: "" }, "from the task"), ...STRATEGIES.map((name) => el("option", { value: name }, name)));
  private readonly path = el("input", { type: "text", placeholder: "/path/to/task.toml", "aria-label": "Task file on this machine", autocomplete: "off", spellcheck: "false" });
  private readonly fault = el("p", { class: "w-complaint", role: "alert", hidden: true });
  private busy = false;

  constructor(private readonly begun: (id: string) => void) {
    const own = el("form", {
      class: "s-own",
      submit: (event: Event) => {
        event.preventDefault();
        void this.start(this.path.value.trim());
      },
    }, el("label", {}, "Your own task file", this.path), el("button", { class: "w-button", type: "submit" }, "Start"));
    this.element = el("dialog", { class: "s-dialog", "aria-labelledby": "s-start-title" },
      el("header", {}, el("h1", { id: "s-start-title" }, "Start a task"),
        el("button", { class: "w-button", type: "button", "aria-label": "Close", click: () => this.element.close() }, "\u00d7")),
      this.fault, this.list, own,
      el("div", { class: "s-options" }, el("label", {}, "Seed", this.seed), el("label", {}, "Strategy", this.strategy)));
    this.list.append(el("li", {}, "Loading \u2026"));
    // A click outside the dialog closes it.
    this.element.addEventListener("click", (event) => { if (event.target === this.element) this.element.close(); });
    this.element.addEventListener("input", () => { this.fault.hidden = true; });
  }

  open(): void {
    this.fault.hidden = true;
    this.element.showModal();
  }

  /** Lists the shipped tasks. */
  setScenarios(scenarios: Scenario[]): void {
    if (!hasChanged(this.list, scenarios)) return;
    this.list.replaceChildren(...scenarios.map(({ name, about }) => el("li", {},
      el("div", {}, el("b", {}, name), el("p", {}, about)),
      el("button", { class: "w-button s-primary", type: "button", "data-task": name, "aria-label": `Start ${name}`, click: () => void this.start(name) }, "Start"))));
    if (!scenarios.length) this.list.append(el("li", {}, "No shipped tasks were found."));
  }

  private async start(task: string): Promise<void> {
    if (this.busy) return;
    const seed = this.seed.value.trim();
    if (!task) return this.complain("The path is empty. Enter the path of a task file.");
    if (seed && !/^\d+$/.test(seed)) return this.complain("The seed must be a whole number, 0 or greater.");
    this.fault.hidden = true;
    this.setBusy(true);
    try {
      const id = await startRun(task, seed ? Number(seed) : null, this.strategy.value || null);
      this.element.close();
      this.begun(id);
    } catch (error) {
      this.complain(error instanceof Refused ? error.message : String(error));
    } finally {
      this.setBusy(false);
    }
  }

  private setBusy(busy: boolean): void {
    this.busy = busy;
    this.element.toggleAttribute("data-busy", busy);
    for (const button of this.element.querySelectorAll("button")) button.disabled = busy;
  }

  private complain(message: string): void {
    this.fault.hidden = false;
    say(this.fault, message);
    this.fault.scrollIntoView({ block: "nearest" });
  }
}
