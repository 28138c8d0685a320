// The answers of a query in one file, with the recordings that they show.
import "./studio/studio.css";
import { el } from "./dom.ts";
import { Recording } from "./store.ts";
import { drawAnswers, hasView } from "./studio/answers.ts";
import { episodesOf } from "./studio/shown.ts";
import { Stage } from "./studio/stage.ts";
import type { Answers } from "./studio/server.ts";

/** Decompresses a recording, which the page holds as gzip in base64. */
async function unpack(text: string): Promise<Recording> {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return Recording.parse(await new Response(unpacked).text());
}

/** Shows the answers that the document holds. `corner`: an element beside the title. */
export function startAnswers(root: HTMLElement, corner: HTMLElement): void {
  const text = (id: string) => document.getElementById(id)?.textContent ?? "";
  const packed = new Map([...document.querySelectorAll<HTMLElement>("script[data-episode]")].map((one) => [one.dataset.episode!, one.textContent ?? ""]));
  const answers = JSON.parse(text("answers")) as Answers;
  const stage = new Stage({ rests: () => {}, compare: null, isKept: () => true });
  const recordings = new Map<string, Promise<Recording>>();
  /** Number of requests to show something; the result of an outdated one is dropped. */
  let asked = 0;

  /** Shows one answer or all (`row` null), in an episode or in the shown or first one of the answers (`wanted` null). */
  const show = (row: number | null, wanted: string | null): Promise<void> => {
    const mine = ++asked;
    return stage.answer(answers, row, wanted, (ids) => ids.find((one) => packed.has(one)) ?? ids[0], async (id) => {
      const bytes = packed.get(id);
      if (bytes === undefined) return stage.say("note", `This page holds no recording of episode ${id}.`);
      stage.say("wait", "Loading \u2026");
      const loaded = recordings.get(id) ?? unpack(bytes);
      recordings.set(id, loaded);
      try {
        const recording = await loaded;
        if (mine === asked) stage.show([{ id, recording, live: null }], null);
      } catch (error) {
        if (mine === asked) stage.say("fault", `The recording of episode ${id} cannot be decompressed: ${String(error)}`);
      }
    });
  };
  const result = drawAnswers(answers, { show: (_, row, episode) => void show(row, episode), clear: () => { for (const { view } of stage.shown) view.show(); } });
  root.classList.add("s-studio");
  root.append(
    el("aside", { class: "s-side s-asked" },
      el("header", { class: "s-top" }, el("h2", { class: "s-name" }, "Answers of the memory"), corner),
      el("section", { class: "s-ask" }, el("pre", { class: "s-printed" }, text("query")), el("div", { class: "s-answers" }, ...result))),
    stage.element);
  // For measurements, and for use from the browser's console.
  Object.assign(window, { wisch: { stage } });
  const episode = [...episodesOf(answers, null), ...packed.keys()].find((id) => packed.has(id));
  if (episode || hasView(answers)) void show(null, episode ?? null);
  else stage.say("note", "The answers name no episode that the page could show.");
}
