// The robot at given joint positions, solid or as a ghost, with its tool.
import { Group, Matrix4, Mesh, MeshLambertMaterial, NotEqualStencilFunc, ReplaceStencilOp, Vector3, type BufferGeometry, type Material } from "three";
import { makeBody } from "./body.ts";
import type { Finish } from "./shell.ts";
import { geometryOf, matrix } from "./solids.ts";
import { Tree } from "./tree.ts";
import type { Head, MeshRecord, Pose, Rgba, RobotRecord, Solid } from "../recording.ts";

export interface RobotMaterials {
  /** Of the body's casings, and of those of the working arm. */
  body: Material;
  arm: Material;
  /** Of housings, of rings, and of what connects hand and tool. */
  joint: Material;
  ring: Material;
  handle: Material;
  /** Of the shapes that collisions are checked with. */
  collision: Material;
  tool: Material;
  /** Returns the material of a shape with its own colour. */
  coloured(color: Rgba): Material;
}

/** Returns materials that draw everything as one. */
const allAs = (look: Material): RobotMaterials => ({ body: look, arm: look, joint: look, ring: look, handle: look, collision: look, tool: look, coloured: () => look });

/** Makes a translucent copy of a robot, the `i`-th one, which hides no other. It marks the pixels that it has coloured in the
 * stencil, and colours each only once: its parts do not show through each other. */
export function makeGhost(head: Head, meshes: MeshRecord[], shared: Robot, color: string, i: number, ...place: Parameters<Robot["show"]>): Group {
  const ghost = new Robot(head, meshes, allAs(new MeshLambertMaterial({
    color, transparent: true, opacity: 0.22, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2,
    stencilWrite: true, stencilRef: 1 + (i % 255), stencilFunc: NotEqualStencilFunc, stencilZPass: ReplaceStencilOp,
  })), shared);
  ghost.show(...place);
  ghost.order = 10 + i;
  return ghost.group;
}

interface Part { geometry: BufferGeometry; linkFromPart: Matrix4; look: Finish | Rgba }

/** Whether the body of a robot is made from its collision shapes, because it has no others. */
export const hasMadeBody = (robot: RobotRecord): boolean => !robot.links.some(({ visual }) => visual);

/** Returns the parts of all links. */
function makeParts(head: Head, meshes: MeshRecord[]): Part[][] {
  const { robot } = head;
  if (!robot) return [];
  if (hasMadeBody(robot)) return makeBody(head, meshes).map((body) => (Object.entries(body) as [Finish, BufferGeometry][]).map(([look, geometry]) => ({ geometry, linkFromPart: new Matrix4(), look })));
  return robot.links.map(({ shapes }) => shapes.map((shape) => ({ geometry: geometryOf(shape, meshes), linkFromPart: matrix(shape.pose), look: shape.color ?? "casing" })));
}

function makeMesh(geometry: BufferGeometry, material: Material, pose: Matrix4): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  mesh.matrix.copy(pose);
  return mesh;
}

export class Robot {
  readonly group = new Group();
  readonly tool: Mesh;
  private readonly tree: Tree | null;
  /** One group for each link. */
  readonly links: Group[] = [];
  private readonly collision: Mesh[] = [];
  private readonly linkFromTool: Matrix4;
  private readonly parts: Part[][];

  /** `shared`: the robot whose geometry a ghost shares. */
  constructor(private readonly head: Head, private readonly meshes: MeshRecord[], private readonly materials: RobotMaterials, shared?: Robot) {
    const { robot, tool } = head;
    this.tree = robot ? new Tree(robot.joints) : null;
    this.parts = shared?.parts ?? makeParts(head, meshes);
    this.parts.forEach((parts, i) => {
      const link = new Group();
      link.matrixAutoUpdate = false;
      const casing = robot!.links[i]!.arm ? materials.arm : materials.body;
      for (const { geometry, linkFromPart, look } of parts) {
        const mesh = makeMesh(geometry, typeof look !== "string" ? materials.coloured(look) : look === "casing" ? casing : materials[look], linkFromPart);
        mesh.castShadow = mesh.receiveShadow = !shared;
        link.add(mesh);
      }
      this.links.push(link);
      this.group.add(link);
    });
    this.linkFromTool = matrix(tool.solid.pose);
    this.tool = makeMesh(shared?.tool.geometry ?? geometryOf(tool.solid, meshes), materials.tool, this.linkFromTool);
    this.tool.castShadow = !shared;
    this.group.add(this.tool);
  }

  /** Moves robot and tool; hides what has no known pose. */
  show(root: Pose | null, q: ArrayLike<number>, toolPose: Pose | null): void {
    const placed = this.tree !== null && q.length > 0;
    for (const link of this.links) link.visible = placed;
    if (this.tree && placed) {
      this.tree.update(root ?? [0, 0, 0, 0, 0, 0, 1], q);
      this.links.forEach((link, i) => {
        link.matrix.copy(this.tree!.worldFromLink[i]!);
        link.matrixWorldNeedsUpdate = true;
      });
    }
    const { link } = this.head.tool;
    const worldFromLink = link !== null && placed ? this.tree!.worldFromLink[link] : undefined;
    this.tool.visible = worldFromLink !== undefined || toolPose !== null;
    if (worldFromLink) this.tool.matrix.multiplyMatrices(worldFromLink, this.linkFromTool);
    else if (toolPose) matrix(toolPose, this.tool.matrix).multiply(this.linkFromTool);
    this.tool.matrixWorldNeedsUpdate = true;
  }

  /** Shows the shapes that collisions are checked with; they are made when they are first shown. */
  set collisionShown(shown: boolean) {
    if (shown && !this.collision.length) this.head.robot?.links.forEach((record, i) => {
      for (const shape of collisionOf(record)) {
        const mesh = makeMesh(geometryOf(shape, this.meshes), this.materials.collision, matrix(shape.pose));
        this.collision.push(mesh);
        this.links[i]!.add(mesh);
      }
    });
    for (const mesh of this.collision) mesh.visible = shown;
  }

  /** Place in the order in which things are drawn: what is translucent comes after what lies behind it. */
  set order(order: number) {
    for (const mesh of [this.tool, ...this.links.flatMap(({ children }) => children)]) mesh.renderOrder = order;
  }

  /** Position of the tool in the world [m]. */
  get toolPlace(): Vector3 {
    return new Vector3().setFromMatrixPosition(this.tool.matrix);
  }

  /** Position of the first link with a shape in the world [m]. */
  get rootPlace(): Vector3 {
    return new Vector3().setFromMatrixPosition(this.links.find((link) => link.children.length)?.matrix ?? new Matrix4());
  }
}

/** Returns the shapes that collisions of a link are checked with. */
export const collisionOf = ({ visual, shapes, collision }: RobotRecord["links"][number]): Solid[] => (visual ? collision ?? [] : shapes);
