// Entry point of the page: a report shows its embedded recording, answers show theirs, the studio fetches recordings from its
// server.
import "./style/page.css";
import "./style/view.css";
import "./style/story.css";
import { startAnswers } from "./answers.ts";
import { onRest } from "./clock.ts";
import { el, say } from "./dom.ts";
import { setTheme, startTheme, onTheme, theme } from "./theme.ts";
import { Recording } from "./store.ts";
import { Story } from "./story.ts";
import { read } from "./studio/address.ts";
import { startStudio } from "./studio/main.ts";
import { mountView, type View } from "./view.ts";

/** Returns a button that switches between the light and the dark theme. */
function themeButton(): HTMLButtonElement {
  const button = el("button", { class: "w-button w-theme", type: "button", click: () => setTheme(theme() === "dark" ? "light" : "dark") });
  const show = () => say(button, theme() === "dark" ? "Light" : "Dark");
  onTheme(show);
  show();
  return button;
}

/** Writes the shown time into the address whenever the clock rests. */
function keepAddress({ clock }: View): void {
  onRest(clock, (time) => {
    const hash = `#t=${time.toFixed(1)}`;
    if (location.hash === hash || (!location.hash && time === 0)) return;
    try {
      history.replaceState(null, "", hash);
    } catch {
      // Some viewers of local files forbid changes of the address.
    }
  });
  addEventListener("hashchange", () => {
    const { time } = read(location.hash);
    if (time !== null && Math.abs(time - clock.time) > 0.06) clock.seek(time);
  });
}

function startReport(app: HTMLElement): void {
  const recording = Recording.parse(document.getElementById("recording")?.textContent ?? "");
  app.classList.add("w-report");
  const story = new Story(recording, (time) => {
    view.seek(time);
    view.element.scrollIntoView({ block: "start" });
  }, themeButton());
  app.append(story.element);
  const view = mountView(app, recording);
  view.seek(read(location.hash).time ?? 0);
  keepAddress(view);
  // For measurements, and for use from the browser's console.
  Object.assign(window, { wisch: { recording, view, Recording, mountView } });
}

startTheme();
const app = document.getElementById("app");
const { page } = document.documentElement.dataset;
if (app && page === "report") startReport(app);
else if (app && page === "answers") startAnswers(app, themeButton());
else if (app) startStudio(app, themeButton());
