// The robot at given joint positions, solid or as a ghost, with its tool.
import { Group, Matrix4, Mesh, MeshLambertMaterial, TorusGeometry, Vector3 } from "three";
import type { BufferGeometry, Material, Object3D } from "three";
import { geometryOf, matrix } from "./solids.ts";
import type { Head, JointRecord, MeshRecord, Pose, Rgba, Solid } from "../recording.ts";

/** Forward kinematics: world_from_link = world_from_parent * parent_from_joint * motion(axis, position), from root to tips. */
export class Tree {
  readonly worldFromLink: Matrix4[];
  private readonly joints: (JointRecord & { parentFromJoint: Matrix4; direction: Vector3 })[];
  private readonly motion = new Matrix4();

  constructor(joints: JointRecord[]) {
    this.joints = joints.map((joint) => ({ ...joint, parentFromJoint: matrix(joint.pose), direction: new Vector3(...joint.axis) }));
    this.worldFromLink = Array.from({ length: joints.length + 1 }, () => new Matrix4());
  }

  /** Computes the poses of all links. */
  update(root: Pose, q: ArrayLike<number>): void {
    matrix(root, this.worldFromLink[0]);
    this.joints.forEach(({ parent, parentFromJoint, direction, kind, offset, terms }, i) => {
      let position = offset;
      for (const [variable, factor] of terms) position += factor * (q[variable] || 0);
      const worldFromChild = this.worldFromLink[i + 1]!.multiplyMatrices(this.worldFromLink[parent]!, parentFromJoint);
      if (kind === "revolute") worldFromChild.multiply(this.motion.makeRotationAxis(direction, position));
      else if (kind === "prismatic") worldFromChild.multiply(this.motion.makeTranslation(direction.x * position, direction.y * position, direction.z * position));
    });
  }
}

/** Materials of the robot; consecutive links have different shades. */
export interface RobotMaterials {
  body: [Material, Material];
  arm: [Material, Material];
  hand: Material;
  /** Of the rings where capsules begin to be round. */
  ring: Material;
  /** Of collision shapes beside visual ones. */
  collision: Material;
  tool: Material;
  /** Returns the material of a shape with its own colour. */
  coloured(color: Rgba): Material;
}

export const ghostMaterial = (): MeshLambertMaterial => new MeshLambertMaterial({ transparent: true, opacity: 0.22, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });

interface Part { geometry: BufferGeometry; pose: Pose; color: Rgba | undefined }

/** Share of a capsule's radius that is the thickness of its rings [1]. */
const RING_SHARE = 0.05;

/** Adds rings to a capsule, which make bare collision shapes look like the parts of an arm. */
function addRings(link: Group, shape: Solid, material: Material): void {
  if (shape.kind !== "capsule" || shape.length < shape.radius) return;
  for (const end of [-1, 1]) {
    const geometry = new TorusGeometry(shape.radius, RING_SHARE * shape.radius, 8, 40).translate(0, 0, (end * shape.length) / 2);
    const ring = new Mesh(geometry, material);
    ring.matrixAutoUpdate = false;
    matrix(shape.pose, ring.matrix);
    link.add(ring);
  }
}

export class Robot {
  readonly group = new Group();
  private readonly tree: Tree | null;
  private readonly links: Group[] = [];
  private readonly collision: Mesh[] = [];
  readonly tool: Mesh;
  private readonly linkFromTool: Matrix4;
  private readonly parts: Part[][];
  private readonly toolGeometry: BufferGeometry;

  constructor(private readonly head: Head, meshes: MeshRecord[], materials: RobotMaterials, shared?: Robot) {
    const { robot, tool } = head;
    this.tree = robot ? new Tree(robot.joints) : null;
    this.parts = shared?.parts ?? (robot?.links ?? []).map(({ shapes }) =>
      shapes.map((shape) => ({ geometry: geometryOf(shape, meshes), pose: shape.pose, color: shape.color })));
    this.parts.forEach((parts, i) => {
      const link = new Group();
      link.matrixAutoUpdate = false;
      const shade = i % 2;
      const { arm, visual } = robot!.links[i]!;
      // The collision geometry of the last link encloses the tool, so it is translucent.
      const material = i === tool.link && !visual ? materials.hand : arm ? materials.arm[shade]! : materials.body[shade]!;
      for (const { geometry, pose, color } of parts) {
        const mesh = new Mesh(geometry, color ? materials.coloured(color) : material);
        mesh.matrixAutoUpdate = false;
        matrix(pose, mesh.matrix);
        mesh.castShadow = mesh.receiveShadow = !shared;
        link.add(mesh);
      }
      if (!visual && material !== materials.hand) for (const shape of robot!.links[i]!.shapes) addRings(link, shape, materials.ring);
      if (!shared) this.addCollision(link, robot!.links[i]!.collision ?? [], meshes, materials.collision);
      this.links.push(link);
      this.group.add(link);
    });
    this.toolGeometry = shared?.toolGeometry ?? geometryOf(tool.solid, meshes);
    this.tool = new Mesh(this.toolGeometry, materials.tool);
    this.tool.matrixAutoUpdate = false;
    this.tool.castShadow = !shared;
    this.linkFromTool = matrix(tool.solid.pose);
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

  /** Shows the shapes that collisions are checked with, where the recording has them beside visual ones. */
  set collisionShown(shown: boolean) {
    for (const mesh of this.collision) mesh.visible = shown;
  }

  private addCollision(link: Group, shapes: readonly Solid[], meshes: MeshRecord[], material: Material): void {
    for (const shape of shapes) {
      const mesh = new Mesh(geometryOf(shape, meshes), material);
      mesh.matrixAutoUpdate = mesh.visible = false;
      matrix(shape.pose, mesh.matrix);
      this.collision.push(mesh);
      link.add(mesh);
    }
  }

  /** The links that can hide something: not the translucent shape round the tool. */
  get limbs(): Object3D[] {
    return this.links.filter((_, i) => i !== this.head.tool.link || this.head.robot!.links[i]!.visual);
  }

  /** Draws the robot over what lies behind it, as it must be while it is translucent. */
  set last(last: boolean) {
    for (const link of this.links) for (const mesh of link.children) mesh.renderOrder = last ? 9 : 0;
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
