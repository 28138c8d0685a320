// Positions of the tool at events.
import { BufferGeometry, Color, Float32BufferAttribute, Points, PointsMaterial } from "three";
import { colour } from "../theme.ts";
import { eventColour } from "../timeline/lanes.ts";
import { dotTexture } from "./dirt.ts";
import { shiftDepth } from "./solids.ts";
import type { Round } from "../round.ts";
import type { Recording } from "../store.ts";

const SIZE = 13;

export class Marks {
  readonly points = new Points(new BufferGeometry(), shiftDepth(new PointsMaterial({
    size: SIZE, sizeAttenuation: false, vertexColors: true, map: dotTexture(), alphaTest: 0.3, transparent: true,
  }), 0.985));
  private key = "";
  private starts: number[] = [];

  constructor() {
    this.points.frustumCulled = false;
    this.points.renderOrder = 7;
  }

  /** Shows the events of a round up to a time of that round. */
  show(recording: Recording, round: Round, time: number, visible: boolean, themed: string): void {
    const key = `${round.start} ${round.number} ${recording.happenings.length} ${round.count > 0} ${themed}`;
    if (key !== this.key) {
      this.key = key;
      this.build(recording, round);
    }
    const shown = this.starts.filter((start) => start <= time).length;
    this.points.visible = visible && shown > 0;
    this.points.geometry.setDrawRange(0, shown);
  }

  private build(recording: Recording, round: Round): void {
    const places: number[] = [];
    const colours: number[] = [];
    this.starts = [];
    for (const happening of recording.happenings) {
      const [start, end] = [happening.start - round.start, happening.end - round.start];
      if (start < 0 || start > round.length) continue;
      // A detected event hides the true push that it overlaps.
      const isDetected = happening.source === "push" && recording.happenings.some((other) => other.source === "event" && other.start < happening.end && other.end > happening.start);
      if (isDetected) continue;
      const tool = round.toolAt((start + end) / 2);
      if (!tool) continue;
      this.starts.push(start);
      places.push(tool[0], tool[1], tool[2]);
      colours.push(...new Color(colour(eventColour(happening))).toArray());
    }
    this.points.geometry.dispose();
    this.points.geometry = new BufferGeometry();
    this.points.geometry.setAttribute("position", new Float32BufferAttribute(places, 3));
    this.points.geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
  }
}
