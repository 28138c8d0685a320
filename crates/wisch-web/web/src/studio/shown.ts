// The data that an answer shows, with times on the common clock of a recording.
import { clockText } from "../dom.ts";
import { colour as named } from "../theme.ts";
import { NOTHING_SHOWN, type Shown } from "../scene/stage.ts";
import { namePushes } from "../round.ts";
import type { View } from "../view.ts";
import { SAME_S, type Recording } from "../store.ts";
import type { Answers, Mention } from "./server.ts";

/** An individual that lasts longer than this share of an episode counts as the episode itself [1]. */
const ALMOST_ALL = 0.95;

/** Data of an answer. */
export interface ShownAnswer extends Shown {
  /** Times of the shown particles, used if nothing else has a time [s]. */
  since: number[];
}

const overlaps = ([from, to]: [number, number], [start, end]: [number, number]): boolean => from <= end + SAME_S && to >= start - SAME_S;

/** Returns the episodes that one answer or all (`row` null) mention or show, by falling number of answers. */
export function episodesOf({ about, view }: Answers, row: number | null): string[] {
  const counts = new Map<string, number>();
  const count = (id: string) => counts.set(id, (counts.get(id) ?? 0) + 1);
  const rows = row === null ? about : [about[row] ?? []];
  for (const mentions of rows) for (const id of new Set(mentions.map(({ episode }) => episode))) count(id);
  if (row === null && view) for (const { episode } of [...view.tracks, ...view.bodies, ...view.particles]) count(episode);
  return [...counts].sort((a, b) => b[1] - a[1]).map(([id]) => id);
}

/** Returns the data to show in one episode, for one answer or for all (`row` null). */
export function shownOf(answers: Answers, row: number | null, id: string, recording: Recording): ShownAnswer {
  const view = answers.view;
  const begins = view?.episodes.find((episode) => episode.id === id);
  const shown: ShownAnswer = { ...structuredClone(NOTHING_SHOWN), since: [] };
  if (!view || !begins) return shown;
  const at = (time: number) => clockTime(recording, begins.rounds ?? [begins.interval[0]], time);
  const mentions = mentionsOf(row === null ? answers.about.flat() : answers.about[row] ?? [], id, begins.interval);
  for (const { interval, class: label } of mentions) {
    if (interval) shown.intervals.push({ start: at(interval[0]), end: at(interval[1]), label: spaced(label) });
  }
  const belongs = (interval: [number, number]) =>
    row === null || !mentions.length || mentions.some((mention) => mention.interval && overlaps(mention.interval, interval));
  for (const { episode, thing, interval, path, samples, strong, colour } of view.tracks) {
    if (episode !== id || !belongs(interval)) continue;
    const name = `${local(thing)} ${clockText(at(interval[0]))} to ${clockText(at(interval[1]))}`;
    const places = samples.map(([, x, y, z]) => [x, y, z] as [number, number, number]);
    shown.trajectories.push({ name, points: path.length > 1 ? path : places, samples: places, ...tint(strong, colour) });
  }
  for (const { episode, thing, kind, time, pose, strong, colour } of view.bodies) {
    if (episode !== id || !belongs([time, time])) continue;
    if (kind === "robot" || kind === "tool") shown.ghosts.push({ time: at(time), ...tint(strong, colour) });
    else shown.frames.push({ name: `${local(thing)} at ${clockText(at(time))}`, time: at(time), pose, ...tint(strong, colour) });
  }
  for (const { episode, round: number, state, positions, colour } of view.particles) {
    const round = recording.rounds.find((one) => one.number === number);
    const begin = begins.rounds?.[number - 1] ?? begins.interval[0];
    if (episode !== id || !round || !belongs([begin, begin + round.length])) continue;
    const before = state === "before";
    const name = `${before ? "dirt before" : "estimated dirt after"} round ${number}, as queried`;
    const pose = (before ? null : round.interpreted?.found) ?? round.plan.surface.pose;
    shown.particles.push({ name, state, pose, shape: round.plan.surface.shape, places: positions, ...(colour ? { color: colour } : {}) });
    shown.since.push(before ? round.start : round.end);
  }
  // A robot and its tool at the same time are one ghost; the later command determines its colour.
  shown.ghosts = [...new Map(shown.ghosts.map((ghost) => [ghost.time, ghost])).values()].sort((a, b) => a.time - b.time);
  if (!shown.intervals.length) {
    for (const [from, to] of begins.shown) shown.intervals.push({ start: at(from), end: at(to), label: "shown" });
  }
  return shown;
}

/** Returns the colour that a query gives, or that of highlighted data; empty for the usual colour. */
const tint = (strong: boolean, colour: string | null): { color?: string } => (colour ? { color: colour } : strong ? { color: named("highlight") } : {});

/** Returns the name of a class as words: "contact loss". */
const spaced = (name: string): string => namePushes(name.replace(/([a-z])(?=[A-Z])/g, "$1 ")).toLowerCase();

/** Returns the mentions of parts of an episode, without duplicates. */
function mentionsOf(all: Mention[], id: string, [begin, end]: [number, number]): Mention[] {
  const known = new Set<string>();
  return all.filter(({ episode, interval, class: label }) => {
    if (episode !== id || !interval) return false;
    const key = `${label} ${interval.join()}`;
    if (known.has(key) || interval[1] - interval[0] > ALMOST_ALL * (end - begin)) return false;
    known.add(key);
    return true;
  });
}

/** Converts a time since 1970 to the common clock [s]. */
export function clockTime(recording: Recording, begins: number[], time: number): number {
  let place = begins.findLastIndex((begin) => begin <= time + SAME_S);
  place = Math.max(0, place);
  const round = recording.rounds.find(({ number }) => number === place + 1) ?? recording.rounds.at(-1);
  if (!round) return 0;
  return Math.min(round.end, Math.max(round.start, round.start + time - begins[place]!));
}

/** Shows the data in a view, and seeks to the first queried time: that of a pose, or else the start of an interval. */
export function apply(view: View, answer: ShownAnswer): void {
  view.show(answer);
  const { ghosts, frames, intervals, since } = answer;
  const times = [[...ghosts, ...frames].map(({ time }) => time), intervals.map(({ start }) => start), since].find((list) => list.length);
  if (times) view.seek(Math.min(...times));
}

export const local = (name: string): string => name.replace(/^[a-z]+:/, "");

/** Returns the episode that the name of an individual states; null if it states none. */
export const episodeIn = (name: string): string | null => /\d{8}-\d{6}-[0-9a-f]{4}/.exec(name)?.[0] ?? null;

/** Returns a title in which an event is called what the page calls it; titles that people gave stay as they are. */
const nameEvent = (title: string): string => (/(?:^|, )(?:human )?collision(?: \d+)?$/i.test(title) ? namePushes(title) : title);

/** Returns the title of an individual, or else its name without the name of its episode. */
export const titleOf = ({ names }: Pick<Answers, "names">, name: string): string =>
  Object.hasOwn(names, name) ? nameEvent(names[name]!) : local(name).replace(/_(\d{8}-\d{6}-[0-9a-f]{4})-(\d+)$/, " $2");

/** Returns the begin of an episode, in local time. */
export const beginText = (begun: number): string =>
  new Date(1000 * begun).toLocaleString("en-GB", { day: "numeric", month: "short", hour: "2-digit", minute: "2-digit" });

/** Returns task and begin of an episode, in local time. */
export const episodeTitle = ({ task, begun }: Pick<Mention, "task" | "begun">): string => `${task}, ${beginText(begun)}`;
