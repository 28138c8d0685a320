// Lanes of the timeline: rounds, phases and strokes, contact, events.
import { clockText, phaseText } from "../dom.ts";
import { colour } from "../theme.ts";
import { endText } from "../words.ts";
import { drawClipped, drawLine, drawText, fillBox, setText, ticks, TRUTH_DASH, type Frame, type Lane, type Pen } from "./frame.ts";
import { PUSH, type Happening } from "../round.ts";
import type { Recording } from "../store.ts";

export function drawAxis(pen: Pen, frame: Frame, lane: Lane): void {
  const { step, times } = ticks(frame.from, frame.to, Math.max(2, frame.span / 76));
  const digits = step < 0.1 ? 2 : step < 1 ? 1 : 0;
  for (const t of times) {
    const x = frame.x(t);
    drawLine(pen, x, lane.top + lane.height, x, frame.height, "grid");
    drawText(pen, clockText(t, digits), Math.min(Math.max(x, frame.left + 10), frame.width - 16), lane.top + lane.height / 2, { align: "center" });
  }
}

/** Returns the visible part of an interval as left and right end, at least `least` wide [pixels]; null if it is not visible. */
function clipInterval(frame: Frame, start: number, end: number, least = 1): [number, number] | null {
  if (end < frame.from || start > frame.to) return null;
  const from = Math.max(frame.x(start), frame.left);
  return [from, Math.max(Math.min(frame.x(end), frame.width - frame.right), from + least)];
}

export function drawRounds(pen: Pen, frame: Frame, lane: Lane, recording: Recording): void {
  for (const round of recording.rounds) {
    const place = clipInterval(frame, round.start, round.end);
    if (!place) continue;
    const [from, to] = place;
    pen.fillStyle = colour("round");
    pen.beginPath();
    pen.roundRect(from + 0.5, lane.top, Math.max(1, to - from - 1), lane.height, 4);
    pen.fill();
    drawText(pen, `${round.number} \u00b7 ${endText(recording, round)}`, from + 7, lane.top + lane.height / 2 + 0.5, { weight: 600, name: "ink", room: to - from - 12 });
    if (round.start > frame.from) drawLine(pen, frame.x(round.start), lane.top, frame.x(round.start), frame.height, "rule");
  }
}

export function drawPhases(pen: Pen, frame: Frame, lane: Lane, recording: Recording): void {
  for (const { start, plan, length } of recording.rounds) {
    for (const phase of plan.phases) {
      const place = clipInterval(frame, start + phase.start, start + Math.min(phase.end, Math.max(length, phase.start)));
      if (!place) continue;
      const [from, to] = place;
      fillBox(pen, phase.contact ? "wiping" : "lane", from, lane.top, Math.max(1, to - from - 1), lane.height);
      // Without space for its name, a stroke still gets its number.
      const number = phase.stroke === null ? "" : String(phase.stroke + 1);
      const text = number ? `${number} ${phase.name}` : phaseText(phase.name);
      const [y, look] = [lane.top + lane.height / 2 + 0.5, { size: 10.5, name: phase.contact ? "ink" : "quiet" }];
      setText(pen, look);
      if (!number || pen.measureText(text).width <= to - from - 7) drawText(pen, text, from + 4, y, { ...look, room: to - from - 7 });
      else if (pen.measureText(number).width <= to - from - 3) drawText(pen, number, (from + to) / 2, y, { ...look, align: "center" });
    }
  }
}

export function drawContact(pen: Pen, frame: Frame, { top, height }: Lane, recording: Recording): void {
  fillBox(pen, "lane", frame.left, top, frame.span, height);
  for (const { start, contacts } of recording.rounds) for (const name of ["contact", "pushed"] as const) for (const [from, to] of contacts[name]) {
    const place = clipInterval(frame, start + from, start + to);
    if (!place) continue;
    const box: [number, number, number, number] = [place[0], top, place[1] - place[0], height];
    fillBox(pen, name, ...box);
    // Stripes, so that more than its colour tells a push from contact.
    if (name === "pushed") drawClipped(pen, box, () => {
      for (let x = place[0] - height; x < place[1]; x += 5) drawLine(pen, x, top + height, x + height, top, "paper", 1.4);
    });
  }
}

/** Marks of events, about the places where they begin [pixels], by the names of their colours. Their shapes differ too. */
export const MARKS = { collision: "M-6 5.5H6L0 -6z", hand: "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0", event: "M-4 -4h8v8h-8z" };

/** Returns the name of an event's colour. */
export const eventColour = ({ source, kind }: Happening): keyof typeof MARKS | "actual" =>
  source === "push" ? "actual" : kind === PUSH ? "collision" : kind === "hand guiding" ? "hand" : "event";

export function drawEvents(pen: Pen, frame: Frame, lane: Lane, recording: Recording): void {
  fillBox(pen, "lane", frame.left, lane.top, frame.span, lane.height);
  const middle = lane.top + lane.height / 2;
  for (const event of recording.happenings) {
    const place = clipInterval(frame, event.start, event.end, 3);
    if (!place) continue;
    const [from, to] = place;
    const name = eventColour(event);
    pen.fillStyle = pen.strokeStyle = colour(name);
    if (name === "actual") {
      pen.lineWidth = 1.5;
      pen.setLineDash(TRUTH_DASH);
      pen.strokeRect(from + 0.5, lane.top + 1.5, Math.max(2, to - from - 1), lane.height - 3);
      pen.setLineDash([]);
      continue;
    }
    pen.fillRect(from, middle - 2.5, to - from, 5);
    drawMark(pen, MARKS[name], from, middle);
  }
}

function drawMark(pen: Pen, shape: string, x: number, y: number): void {
  const mark = new Path2D(shape);
  pen.save();
  pen.translate(x, y);
  pen.fill(mark);
  pen.strokeStyle = colour("paper");
  pen.lineWidth = 1;
  pen.stroke(mark);
  pen.restore();
}
