// The path of the tool in a round up to the shown time, coloured by contact.
import { Color, Group, Vector3 } from "three";
import { lastAtMost } from "../columns.ts";
import { colour } from "../theme.ts";
import { normalUnder } from "./bend.ts";
import { Ribbon } from "./ribbon.ts";
import { ABOVE } from "./surface.ts";
import { GrowingSegments } from "./lines.ts";
import { LEAST_SAMPLES, type Contact, type Round } from "../round.ts";

/** Initial minimum distance between drawn samples [m]. */
const STEP_M = 0.0015;
/** Maximum number of segments; a longer path gets longer segments. */
const MOST_SEGMENTS = 4000;
/** Least force that is drawn as wide as a target, where no target is known [N]. */
const REFERENCE_N = 5;

/** Places of the states in the palette. */
const KINDS: Record<Contact, number> = { none: 0, contact: 1, pushed: 2 };
const palette = (): Color[] => ["lifted", "contact", "pushed"].map((name) => new Color(colour(name)));

export class Path {
  readonly object = new Group();
  readonly ribbon: Ribbon;
  private readonly lines = new GrowingSegments(3, palette());
  private readonly times: number[] = [];
  private taken = 0;
  private step = STEP_M;
  private last: Vector3 | null = null;
  private kind = KINDS.none;
  /** What the colours follow from. */
  private basis = "";

  constructor(readonly round: Round) {
    this.ribbon = new Ribbon(MOST_SEGMENTS, round.target);
    this.object.add(this.lines.line, this.ribbon.mesh);
  }

  show(time: number, layers: { path: boolean; ribbon: boolean }): void {
    this.grow();
    const shown = lastAtMost(this.times, time) + 1;
    this.lines.show(layers.path ? shown : 0);
    this.ribbon.show(time, layers.ribbon);
  }

  paint(): void {
    this.lines.paint(palette());
    this.ribbon.paint();
  }

  /** Returns the ends of the path's segments between two times. */
  between(from: number, to: number): number[] {
    const ends: number[] = [];
    const { round } = this;
    const step = Math.max(1, Math.floor(round.count / 20000));
    let before: Vector3 | null = null;
    for (let i = Math.max(0, round.place(from)[0]); i < round.count && round.t[i]! <= to; i += step) {
      const { place } = this.place(i);
      if (before) ends.push(...before.toArray(), ...place.toArray());
      before = place;
    }
    return ends;
  }

  /** Returns the time at which the path, or with `pressed` its part in contact, is nearest to a point on the screen, the last one
   * of several; null beyond `within` [pixels]. */
  nearest(toScreen: (place: Vector3) => { x: number; y: number }, x: number, y: number, until: number, within: number, pressed: boolean): number | null {
    let [best, time] = [within ** 2, null as number | null];
    for (let k = 0; k < this.times.length && this.times[k]! <= until; k++) {
      if (pressed && !this.round.isPressed(this.times[k]!)) continue;
      const at = toScreen(this.lines.end(k));
      const away = (at.x - x) ** 2 + (at.y - y) ** 2;
      if (away <= best) [best, time] = [away, this.times[k]!];
    }
    return time;
  }

  /** Returns the place of the tool at a sample, slightly over it, and the normal of the surface there. */
  private place(i: number): { place: Vector3; normal: Vector3 } {
    const place = new Vector3().fromArray(this.round.tool, 7 * i);
    const normal = normalUnder(this.round.plan.surface, place);
    return { place: place.addScaledVector(normal, 1.5 * ABOVE), normal };
  }

  /** Continues the band of force to a sample: on the believed surface, which is drawn. */
  private press(i: number, { place, normal }: { place: Vector3; normal: Vector3 }): void {
    const { round, step } = this;
    const height = round.height.data[i]!;
    const foot = Number.isFinite(height) ? place.clone().addScaledVector(normal, -height) : place;
    const reference = round.target ?? Math.max(REFERENCE_N, round.normal.largest);
    this.ribbon.push(round.t[i]!, foot, normal, round.normal.data[i]!, { step, reference });
  }

  private restart(): void {
    this.taken = 0;
    this.last = null;
    this.lines.clear();
    this.times.length = 0;
    this.ribbon.clear();
  }

  private grow(): void {
    const { round } = this;
    if (this.basis !== round.basis) this.restart();
    this.basis = round.basis;
    // The next samples may still show that the last ones are in contact.
    const settled = round.over || round.interpreted ? round.count : round.count - LEAST_SAMPLES + 1;
    while (this.taken < settled) {
      const i = this.taken++;
      const time = round.t[i]!;
      const at = this.place(i);
      const { place } = at;
      if (!Number.isFinite(place.x + place.y + place.z)) continue;
      if (round.isPressed(time) && Number.isFinite(round.normal.data[i]!)) this.press(i, at);
      else this.ribbon.breakOff();
      const kind = KINDS[round.contactAt(time)];
      if (this.last && this.last.distanceToSquared(place) < this.step ** 2 && (kind === this.kind || this.step > 2 * STEP_M)) continue;
      if (this.last) {
        this.lines.push([...this.last.toArray(), ...place.toArray()], kind);
        this.times.push(time);
      }
      this.last = place;
      this.kind = kind;
      if (this.lines.count > MOST_SEGMENTS) {
        // Restarts with segments twice as long.
        this.step *= 2;
        this.restart();
      }
    }
  }
}
