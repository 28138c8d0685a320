// What an answer points at: bands over all lanes, and their names where there is room for them.
import { colour } from "../theme.ts";
import { fitted, font } from "./frame.ts";
import type { Frame, Pen } from "./frame.ts";

export interface Interval {
  start: number;
  end: number;
  label: string;
}

/** A name beside where its band begins [pixels]. */
export interface Tag {
  text: string;
  x: number;
  width: number;
  row: number;
}

/** A name that is longer is cut. */
const WIDEST_PX = 170;
const ROW_PX = 15;
/** Between two names in one row, and round each. */
const APART_PX = 8;
const PADDING_PX = 3;
/** So many rows of names cover what is below them. */
export const ROWS = 3;

/** Names that overlap none: same ones that lie close are one with their number, others go a row up. What finds no row is left
 * out, and said by the pointer over it. */
export function tagsOf(bands: { x: number; label: string }[], measure: (text: string) => number, right: number): Tag[] {
  interface Group { x: number; label: string; count: number }
  const width = ({ label, count }: Group) => Math.min(WIDEST_PX, measure(titled(label, count)));
  const groups: Group[] = [];
  const lastOf = new Map<string, Group>();
  for (const { x, label } of [...bands].sort((a, b) => a.x - b.x)) {
    const last = lastOf.get(label);
    if (last && x < last.x + width(last) + APART_PX) {
      last.count++;
      continue;
    }
    const group = { x, label, count: 1 };
    groups.push(group);
    lastOf.set(label, group);
  }
  const ends = Array.from({ length: ROWS }, () => -Infinity);
  const tags: Tag[] = [];
  for (const group of groups) {
    const wide = width(group);
    const x = Math.min(group.x, right - wide);
    const row = ends.findIndex((end) => end + APART_PX <= x);
    if (row < 0) continue;
    ends[row] = x + wide;
    tags.push({ text: titled(group.label, group.count), x, width: wide, row });
  }
  return tags;
}

const titled = (label: string, count: number): string => (count > 1 ? `${label} \u00d7${count}` : label);

export function drawHighlights(pen: Pen, frame: Frame, highlights: readonly Interval[]): void {
  const top = frame.lane("rounds")?.top ?? 0;
  const right = frame.width - frame.right;
  const bands: { x: number; label: string }[] = [];
  pen.fillStyle = colour("highlight");
  for (const { start, end, label } of highlights) {
    if (end < frame.from || start > frame.to) continue;
    const from = Math.max(frame.left, frame.x(start));
    const to = Math.max(from + 2, Math.min(right, frame.x(end)));
    pen.globalAlpha = 0.28;
    pen.fillRect(from, top, to - from, frame.height - top);
    pen.globalAlpha = 1;
    pen.fillRect(from, top - 3, to - from, 3);
    if (label) bands.push({ x: from + PADDING_PX, label });
  }
  font(pen, 10, 600);
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  for (const { text, x, width, row } of tagsOf(bands, (label) => pen.measureText(label).width, right)) {
    const middle = frame.height - 4 - (row + 0.5) * ROW_PX;
    pen.globalAlpha = 0.85;
    pen.fillStyle = colour("paper");
    pen.beginPath();
    pen.roundRect(x - PADDING_PX, middle - ROW_PX / 2 + 1, width + 2 * PADDING_PX, ROW_PX - 2, 3);
    pen.fill();
    pen.globalAlpha = 1;
    pen.fillStyle = colour("ink");
    fitted(pen, text, x, middle + 0.5, width + 1);
  }
}
