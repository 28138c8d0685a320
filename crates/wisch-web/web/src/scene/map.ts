// The map of a treated surface: one coloured cell for each place.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshBasicMaterial } from "three";
import { metres } from "../particles.ts";
import { colour } from "../theme.ts";
import { binOf, binsOf, CELL_REACH, type SurfaceValues } from "../treated.ts";
import { lift } from "./bend.ts";
import { placeAt, shiftDepth } from "./solids.ts";
import { ABOVE } from "./surface.ts";

/** Directions from the middle of a cell to its corners. */
const CORNERS = [[-1, -1], [1, -1], [1, 1], [-1, 1]] as const;

/** Makes the cells of a map over their surface. */
function makeCells({ record, shape }: SurfaceValues): BufferGeometry {
  const places = metres(record.places);
  const [across, up] = record.cell.map((side) => CELL_REACH * side) as [number, number];
  const count = places.length / 2;
  const positions = new Float32Array(12 * count);
  const index: number[] = [];
  for (let i = 0; i < count; i++) {
    CORNERS.forEach(([x, y], k) => positions.set(lift(shape, places[2 * i]! + x * across, places[2 * i + 1]! + y * up, ABOVE / 2), 12 * i + 3 * k));
    index.push(4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3);
  }
  const colours = new BufferAttribute(new Float32Array(12 * count), 3);
  return new BufferGeometry().setAttribute("position", new BufferAttribute(positions, 3)).setAttribute("color", colours).setIndex(index);
}

export class SurfaceMap {
  /** Its depth is shifted as that of the surface, and a little more. */
  readonly mesh = new Mesh(new BufferGeometry(), shiftDepth(new MeshBasicMaterial({ vertexColors: true, side: DoubleSide, toneMapped: false, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 }), 0.997));
  /** The shown map, and the theme of its colours. */
  private shown: SurfaceValues | null = null;
  private theme = "";

  constructor() {
    this.mesh.frustumCulled = false;
  }

  /** Shows a map; null hides it. */
  show(map: SurfaceValues | null, theme: string): void {
    this.mesh.visible = map !== null;
    if (!map) return;
    placeAt(this.mesh, map.pose);
    const sameCells = this.shown?.record === map.record && this.shown.shape === map.shape;
    if (!sameCells) {
      this.mesh.geometry.dispose();
      this.mesh.geometry = makeCells(map);
    }
    if (!sameCells || this.shown?.values !== map.values || this.theme !== theme) this.paint(map);
    this.shown = map;
    this.theme = theme;
  }

  private paint({ record, values }: SurfaceValues): void {
    const bins = binsOf(record);
    const colours = bins.map((bin) => new Color(colour(bin.colour)));
    const attribute = this.mesh.geometry.getAttribute("color") as BufferAttribute;
    values.forEach((value, i) => {
      const { r, g, b } = colours[binOf(bins, record, value)]!;
      for (let k = 0; k < 4; k++) attribute.setXYZ(4 * i + k, r, g, b);
    });
    attribute.needsUpdate = true;
  }
}
