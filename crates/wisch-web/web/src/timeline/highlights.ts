// Highlighted intervals: bands over all lanes, with their names where space permits.
import { colour } from "../theme.ts";
import { drawText, fillBox, setText, type Frame, type Lane, type Pen } from "./frame.ts";

export interface Interval {
  start: number;
  end: number;
  label: string;
}

/** A name beside the start of its band [pixels]. */
export interface Tag {
  text: string;
  x: number;
  width: number;
  row: number;
}

/** Maximum width of a name [pixels]. */
const WIDEST_PX = 170;
const ROW_PX = 15;
/** Gap between two names in a row, and padding around each [pixels]. */
const GAP_PX = 8;
const PADDING_PX = 3;
/** Maximum number of rows of names. */
export const ROWS = 3;

/** Places names without overlap. Equal names that would overlap become one with their count; others move up a row. Names that
 * fit in no row are omitted; the tooltip still shows them. */
export function tagsOf(bands: { x: number; label: string }[], measure: (text: string) => number, right: number): Tag[] {
  interface Group { x: number; label: string; count: number }
  const width = ({ label, count }: Group) => Math.min(WIDEST_PX, measure(titleOf(label, count)));
  const groups: Group[] = [];
  const lastOf = new Map<string, Group>();
  for (const { x, label } of [...bands].sort((a, b) => a.x - b.x)) {
    const last = lastOf.get(label);
    if (last && x < last.x + width(last) + GAP_PX) {
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
    const row = ends.findIndex((end) => end + GAP_PX <= x);
    if (row < 0) continue;
    ends[row] = x + wide;
    tags.push({ text: titleOf(group.label, group.count), x, width: wide, row });
  }
  return tags;
}

const titleOf = (label: string, count: number): string => (count > 1 ? `${label} \u00d7${count}` : label);

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
  const look = { size: 10, weight: 600, name: "ink" };
  setText(pen, look);
  for (const { text, x, width, row } of tagsOf(bands, (label) => pen.measureText(label).width, right)) {
    const middle = frame.height - 4 - (row + 0.5) * ROW_PX;
    pen.globalAlpha = 0.85;
    pen.fillStyle = colour("paper");
    pen.beginPath();
    pen.roundRect(x - PADDING_PX, middle - ROW_PX / 2 + 1, width + 2 * PADDING_PX, ROW_PX - 2, 3);
    pen.fill();
    pen.globalAlpha = 1;
    drawText(pen, text, x, middle + 0.5, { ...look, room: width + 1 });
  }
}

/** Draws a selected interval as a frame with a text in a lane, beside which the lane is faded. */
export function drawSelection(pen: Pen, frame: Frame, { top, height }: Lane, [start, end]: [number, number], text: string): void {
  if (end < frame.from || start > frame.to) return;
  const right = frame.width - frame.right;
  const [from, to] = [start, end].map((time) => Math.min(right, Math.max(frame.left, frame.x(time)))) as [number, number];
  pen.globalAlpha = 0.65;
  fillBox(pen, "paper", frame.left, top - 2, from - frame.left, height + 4);
  fillBox(pen, "paper", to, top - 2, right - to, height + 4);
  pen.globalAlpha = 1;
  pen.strokeStyle = colour("accent");
  pen.lineWidth = 1.5;
  pen.strokeRect(from, top - 1, to - from, height + 2);
  drawText(pen, text, from + 5, top + 7, { size: 10, name: "ink", room: to - from - 10 });
}
