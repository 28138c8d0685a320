// Converts shapes to geometries and poses to matrices.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, CylinderGeometry, Matrix4, Quaternion, SphereGeometry, Vector3,
  type Color, type Material, type Mesh, type Object3D, type Texture,
} from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { once } from "../columns.ts";
import { colour } from "../theme.ts";
import { metres } from "../particles.ts";
import type { MeshRecord, Pose, Solid } from "../recording.ts";

const ONE = new Vector3(1, 1, 1);
/** Faces that meet at a smaller angle are shaded smoothly [rad]. */
const CREASE = 0.7;

/** Writes the matrix of a pose into `out`. */
export function matrix([x, y, z, qx, qy, qz, qw]: Pose, out = new Matrix4()): Matrix4 {
  return out.compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw).normalize(), ONE);
}

/** Gives an object a pose, which nothing else changes. */
export function placeAt<O extends Object3D>(object: O, pose: Pose): O {
  object.matrixAutoUpdate = false;
  matrix(pose, object.matrix);
  object.matrixWorldNeedsUpdate = true;
  return object;
}

/** A material with a colour. */
type Coloured = Material & { color: Color; map?: Texture | null };

/** Gives a material a colour of the page, and its name, by which `paint` finds it. */
export function tint<M extends Coloured>(material: M, name: string): M {
  material.name = name;
  material.color.set(colour(name));
  return material;
}

type Drawn = Mesh<BufferGeometry, Coloured> & { dispose?: () => void };

/** Returns an object and all below it that are drawn. */
function drawnIn(object: Object3D): Drawn[] {
  const drawn: Drawn[] = [];
  object.traverse((part) => { if ("material" in part) drawn.push(part as Drawn); });
  return drawn;
}

/** Gives all materials of an object that have names of colours the colours of the theme. */
export function paint(object: Object3D): void {
  for (const { material } of drawnIn(object)) if (material.name) tint(material, material.name);
}

/** Frees the memory of an object on the graphics card. What is drawn again gets it back. */
export function release(object: Object3D): void {
  for (const part of drawnIn(object)) {
    part.dispose?.();
    part.geometry.dispose();
    part.material.map?.dispose();
    part.material.dispose();
  }
}

/** Removes all that a group draws, and frees its memory on the graphics card. */
export function disposeAll(group: Object3D): void {
  release(group);
  group.clear();
}

/** Scales the depth of a material by a factor: below 1 it is drawn nearer, above 1 farther. */
export function shiftDepth<M extends Material>(material: M, factor: number): M {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>
      gl_Position.z = (projectionMatrix * vec4(${factor.toFixed(3)} * mvPosition.xyz, 1.0)).z / ${factor.toFixed(3)};`);
  };
  material.customProgramCacheKey = () => `shifted ${factor}`;
  return material;
}

/** Returns the geometry of a mesh, which is made once and shared. */
const meshGeometry = once(({ vertices, triangles }: MeshRecord) =>
  toCreasedNormals(new BufferGeometry().setAttribute("position", new BufferAttribute(metres(vertices), 3)).setIndex(triangles), CREASE));

export function geometryOf(solid: Solid, meshes: MeshRecord[]): BufferGeometry {
  switch (solid.kind) {
    case "box": return new BoxGeometry(...solid.size);
    case "sphere": return new SphereGeometry(solid.radius, 28, 18);
    case "cylinder": return new CylinderGeometry(solid.radius, solid.radius, solid.length, 32).rotateX(Math.PI / 2);
    case "capsule": return new CapsuleGeometry(solid.radius, solid.length, 10, 28).rotateX(Math.PI / 2);
    case "mesh": return meshes[solid.mesh] ? meshGeometry(meshes[solid.mesh]!) : new BufferGeometry();
    default: return new BufferGeometry();
  }
}
