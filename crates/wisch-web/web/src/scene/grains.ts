// Dirt as solids with a shadow: crumbs, or drops of a liquid. All of them are one mesh, and all shadows another one; without a
// graphics card, each instance of an instanced mesh takes as long as a mesh of its own.
import { BufferAttribute, BufferGeometry, CircleGeometry, ConeGeometry, Group, Material, Matrix4, Mesh, MeshBasicMaterial, MeshPhongMaterial, SphereGeometry, Vector3 } from "three";
import { colour } from "../theme.ts";
import { lift } from "./bend.ts";
import { alongAxis } from "./shell.ts";
import { placeAt } from "./solids.ts";
import type { Pose } from "../recording.ts";
import type { Bend } from "../store.ts";

export type Form = "crumb" | "drop";

/** Diameter of a grain, as long as at most FEW grains are shown; more of them are smaller [m]. */
export const GRAIN_M = 0.007;
const FEW = 600;
/** Limits of the diameter on the screen [pixels]. */
const LEAST_PX = 5.5;
const MOST_PX = 18;
/** Change of the diameter that is not drawn [1]. */
const SAME_SIZE = 0.03;
/** Number of grains from which on they have fewer faces, and no shadows. */
const MANY = 1500;
/** The shadow round a grain: its radius in that of the grain, and its opacity below the middle [1]. The sun's shadows are too coarse. */
const SHADOW_RADIUS = 1.7;
const SHADOW_OPACITY = 0.6;
/** Largest depth of a dent of a crumb in its radius. */
const UNEVEN = 0.35;
/** Share of its light that a grain has by itself, so that it stands out from what it lies on, and the light on its darkest side, to
 * which the stage adds that of the sky [1]. */
const OWN_LIGHT = 0.4;
export const LEAST_LIGHT = OWN_LIGHT + 0.32 * (1 - OWN_LIGHT);

/** Attributes that depend on where a copy lies. */
const PLACED = ["position", "normal"] as const;
const attributeOf = (geometry: BufferGeometry, name: string): BufferAttribute => geometry.getAttribute(name) as BufferAttribute;

/** Returns the form of the grains of a medium by its name; null for what lies as dust or film, and for an unknown medium. */
export function formOf(medium: string | null | undefined): Form | null {
  if (/crumb|chip|sand|gravel|debris/i.test(medium ?? "")) return "crumb";
  return /water|detergent|soap|juice|milk/i.test(medium ?? "") ? "drop" : null;
}

/** Returns a reproducible number in [0, 1) for two numbers. */
function hash(x: number, y: number): number {
  const mixed = Math.sin(12.9898 * x + 78.233 * y) * 43758.5453;
  return mixed - Math.floor(mixed);
}

/** Makes a dome of radius 1 on the plane z = 0, from a part of a sphere. */
const makeDome = (sides: number, rings: number, part: number, height: number): BufferGeometry =>
  new SphereGeometry(1, sides, rings, 0, 2 * Math.PI, 0, part * Math.PI).rotateX(Math.PI / 2).translate(0, 0, -Math.cos(part * Math.PI)).scale(1, 1, height);

/** Makes a crumb of a shape: uneven and flat-shaded. */
function makeCrumb(crumb: BufferGeometry): BufferGeometry {
  const at = attributeOf(crumb, "position");
  for (let i = 0; i < at.count; i++) {
    // Corners at the same place move alike.
    const share = 1 - UNEVEN * hash(Math.round(20 * at.getX(i)), Math.round(20 * at.getY(i)) + Math.round(20 * at.getZ(i)));
    at.setXYZ(i, share * at.getX(i), share * at.getY(i), share * at.getZ(i));
  }
  return crumb.deleteAttribute("normal");
}

/** Makes the shadow round a grain of radius 1: a disc that fades towards its edge. */
function makeShadow(): BufferGeometry {
  const disc = new CircleGeometry(SHADOW_RADIUS, 8);
  const { count } = disc.getAttribute("position");
  disc.setAttribute("color", new BufferAttribute(Float32Array.from({ length: 4 * count }, (_, i) => (i === 3 ? SHADOW_OPACITY : 0)), 4));
  return disc.deleteAttribute("normal");
}

/** Copies of a shape, one for each particle. */
class Copies<M extends Material> {
  readonly mesh: Mesh<BufferGeometry, M>;
  private shape: BufferGeometry | null = null;
  /** Largest number of copies that the buffers hold. */
  private capacity = 0;

  constructor(material: M) {
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
  }

  place(shape: BufferGeometry, places: Float32Array, radius: number, bend: Bend): void {
    const count = places.length / 2;
    if (this.shape !== shape || this.capacity < count) this.reserve(shape, 2 * count);
    const { geometry } = this.mesh;
    for (let i = 0; i < count; i++) placeCopy(geometry, shape, i, radius, bend, places[2 * i]!, places[2 * i + 1]!);
    for (const name of PLACED) if (geometry.hasAttribute(name)) attributeOf(geometry, name).needsUpdate = true;
    geometry.setDrawRange(0, count * shape.index!.count);
  }

  private reserve(shape: BufferGeometry, capacity: number): void {
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    const [corners, index] = [attributeOf(shape, "position").count, shape.index!];
    for (const name of [...PLACED, "color"].filter((name) => shape.hasAttribute(name))) {
      const { array, itemSize } = attributeOf(shape, name);
      geometry.setAttribute(name, new BufferAttribute(Float32Array.from({ length: array.length * capacity }, (_, i) => array[i % array.length]!), itemSize));
    }
    geometry.setIndex(new BufferAttribute(Uint32Array.from({ length: index.count * capacity }, (_, i) => index.array[i % index.count]! + corners * Math.floor(i / index.count)), 1));
    this.mesh.geometry = geometry;
    [this.shape, this.capacity] = [shape, capacity];
  }
}

export class Grains {
  readonly group = new Group();
  private readonly few: BufferGeometry;
  private readonly many: BufferGeometry;
  private readonly shadow = makeShadow();
  private readonly grains: Copies<MeshPhongMaterial>;
  private readonly shadows = new Copies(new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 }));
  /** What is drawn: grains of this radius at these places [m]. */
  private drawn: { places: Float32Array | null; radius: number } = { places: null, radius: 0 };

  constructor(form: Form) {
    [this.few, this.many] = form === "crumb" ? [makeCrumb(makeDome(5, 3, 0.62, 0.85)), makeCrumb(new ConeGeometry(1, 1, 4, 1, true).rotateX(Math.PI / 2).translate(0, 0, 0.5))] : [makeDome(8, 3, 0.5, 0.55), makeDome(6, 2, 0.5, 0.55)];
    this.grains = new Copies(new MeshPhongMaterial(form === "crumb" ? { flatShading: true, specular: 0x666666, shininess: 8 } : { specular: 0x999999, shininess: 60 }));
    this.group.add(this.grains.mesh, this.shadows.mesh);
    this.paint();
  }

  paint(): void {
    const { color, emissive } = this.grains.mesh.material;
    color.set(colour("believed"));
    emissive.copy(color).multiplyScalar(OWN_LIGHT);
    color.multiplyScalar(1 - OWN_LIGHT);
  }

  /** Shows grains at places of the chart of a surface; null hides them. */
  show(places: Float32Array | null, pose: Pose, bend: Bend, pixelsPerMetre: number): void {
    this.group.visible = places !== null && places.length > 0;
    if (!places || !this.group.visible) return;
    placeAt(this.group, pose);
    const count = places.length / 2;
    const natural = GRAIN_M * Math.min(1, Math.sqrt(FEW / count));
    const radius = Math.min(MOST_PX / pixelsPerMetre, Math.max(LEAST_PX / pixelsPerMetre, natural)) / 2;
    if (this.drawn.places === places && Math.abs(radius / this.drawn.radius - 1) < SAME_SIZE) return;
    this.drawn = { places, radius };
    this.grains.place(count < MANY ? this.few : this.many, places, radius, bend);
    this.shadows.mesh.visible = count < MANY;
    if (count < MANY) this.shadows.place(this.shadow, places, radius, bend);
  }
}

/** Writes a copy of a shape on a surface: upright along its normal, turned and sized by its place. */
function placeCopy(geometry: BufferGeometry, shape: BufferGeometry, i: number, radius: number, bend: Bend, x: number, y: number): void {
  const foot = new Vector3(...lift(bend, x, y, 0));
  const surfaceFromCopy = alongAxis(new Vector3(...lift(bend, x, y, 1)).sub(foot), foot).multiply(new Matrix4().makeRotationZ(2 * Math.PI * hash(x, y)));
  const size = radius * (0.75 + 0.5 * hash(y, x));
  const corner = new Vector3();
  for (const name of PLACED.filter((name) => shape.hasAttribute(name))) {
    const [from, to] = [attributeOf(shape, name), attributeOf(geometry, name)];
    for (let k = 0; k < from.count; k++) {
      corner.fromBufferAttribute(from, k);
      if (name === "position") corner.multiplyScalar(size).applyMatrix4(surfaceFromCopy);
      else corner.transformDirection(surfaceFromCopy);
      to.setXYZ(i * from.count + k, corner.x, corner.y, corner.z);
    }
  }
}
