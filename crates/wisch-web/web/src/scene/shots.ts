// What the camera shows of a round: all, the surface, or, while it follows, what the current phase is about.
import { Box3, Vector3 } from "three";
import { liftLine, normalUnder } from "./bend.ts";
import { matrix } from "./solids.ts";
import { corners, type Still } from "./surface.ts";
import { blocksOf, chooseDirection, cornersOf, cornersOfBox, type Moment } from "./viewpoint.ts";
import type { Robot } from "./robot.ts";
import type { RoundPiece } from "../recording.ts";
import type { Round } from "../round.ts";
import type { Recording } from "../store.ts";

type Phase = RoundPiece["phases"][number];

/** Maximum number of contact times at which sight is tested. */
const MOMENTS = 5;
/** The camera is close from this time before a stroke until this time after it [s]. */
const LEAD_S = 1.5;
/** Space around a planned stroke [m]. */
const ROOM_M = 0.07;
/** Height over the surface at which its points are tested for sight [m]. */
const OVER_M = 0.01;

/** Points to show. Equal keys mean equal points. */
export interface Shot {
  key: string;
  points: Vector3[];
}

export class Shots {
  private direction: { samples: number; from: Vector3 } | null = null;

  constructor(private readonly recording: Recording, private readonly robot: Robot | null, private readonly still: Still) {
    still.group.updateMatrixWorld(true);
  }

  /** Direction to look from. It moves the robot to other times. */
  get from(): Vector3 {
    const { count, over } = this.still.round;
    if (!this.direction || (!over && this.direction.samples !== count)) this.direction = { samples: count, from: this.findDirection() };
    return this.direction.from;
  }

  /** Returns the corners of robot, furniture and surface at a time of the round [s]. */
  all(time: number): Vector3[] {
    this.move(time);
    return orSome(cornersOf([...(this.robot ? [this.robot.group] : []), this.still.bodies]));
  }

  /** Returns the corners of the surface, and of the tool while it touches the surface. */
  surface(): Vector3[] {
    const { corners } = this.still;
    if (!corners.length) return this.all(0);
    const tool = this.contacts.flatMap((time) => {
      this.move(time);
      return this.robot ? cornersOf([this.robot.tool]) : [];
    });
    return [...corners, ...tool];
  }

  /** Returns the shot of a time of the round [s]: close at a stroke, else wide enough for the whole free motion. */
  at(time: number): Shot {
    const { round } = this.still;
    const strokes = round.plan.phases.filter(({ contact }) => contact);
    const next = strokes.findIndex(({ end }) => end > time);
    const [before, after] = [strokes.at(next < 0 ? -1 : next - 1), next < 0 ? undefined : strokes[next]];
    const from = next === 0 ? 0 : before?.end ?? 0;
    const to = after?.start ?? round.length;
    const middle = (from + to) / 2;
    if (after && time >= Math.max(to - LEAD_S, Math.min(middle, to))) return this.stroke(after);
    if (before && next !== 0 && time < Math.min(from + LEAD_S, middle)) return this.stroke(before);
    // A live run does not have the samples of the whole motion yet, but it leads from one planned stroke to another.
    const measured = [from, middle, to].filter((instant) => round.over || instant <= round.t.at(-1)!);
    const ends = [before, after].flatMap((phase) => (phase ? strokePoints(round, phase) : []));
    return { key: `${round.number} free ${from}`, points: [...(measured.length ? measured : [time]).flatMap((instant) => this.all(instant)), ...ends] };
  }

  private stroke(phase: Phase): Shot {
    const points = strokePoints(this.still.round, phase);
    return { key: `${this.still.round.number} stroke ${phase.start}`, points: points.length ? points : this.surface() };
  }

  /** Middles of the strokes, at most MOMENTS of them, as far as the round has samples [s]. */
  private get contacts(): number[] {
    const { count, t, plan } = this.still.round;
    const middles = plan.phases.filter(({ contact, end }) => contact && count > 0 && end <= t.at(-1)!).map(({ start, end }) => (start + end) / 2);
    const step = Math.max(1, middles.length / MOMENTS);
    return Array.from({ length: Math.min(MOMENTS, middles.length) }, (_, i) => middles[Math.floor(i * step)]!);
  }

  private move(time: number): void {
    const { round } = this.still;
    const instant = this.recording.at(round.start + Math.min(time, round.length));
    if (instant && this.robot) {
      this.robot.show(round.plan.root, instant.q, instant.tool);
      this.robot.group.updateMatrixWorld(true);
    }
  }

  private findDirection(): Vector3 {
    const { plan } = this.still.round;
    const moments = this.contacts.map((time): Moment => {
      this.move(time);
      return { blocks: this.robot ? blocksOf(this.robot.links) : [], tool: this.robot ? [this.robot.toolPlace, ...cornersOf([this.robot.tool])] : [] };
    });
    const points = this.still.pointsOver(OVER_M);
    const middle = points[0]!;
    const normal = normalUnder(plan.surface, middle);
    // Looking towards the robot shows its face.
    const preferred = this.robot && moments.length ? middle.clone().sub(this.robot.rootPlace) : new Vector3(0.75, -1, 0);
    if (preferred.setZ(0).length() < 1e-3) preferred.set(1, 0, 0);
    return chooseDirection(moments, points, normal, preferred.normalize().setZ(0.6).normalize());
  }
}

/** Returns points around a planned stroke, in the world. */
export function strokePoints({ plan: { strokes, surface } }: Round, { stroke }: Phase): Vector3[] {
  const line = liftLine(surface.shape, corners(strokes[stroke ?? -1] ?? []), false);
  const worldFromSurface = matrix(surface.pose);
  return line.flatMap((corner) => {
    const box = new Box3().expandByPoint(new Vector3(...corner).applyMatrix4(worldFromSurface)).expandByScalar(ROOM_M);
    box.min.z += ROOM_M;
    return cornersOfBox(box);
  });
}

const orSome = (points: Vector3[]): Vector3[] => (points.length ? points : [new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 0.5)]);
