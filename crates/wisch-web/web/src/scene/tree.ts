// Forward kinematics of a recording's robot.
import { Matrix4, Vector3 } from "three";
import { matrix } from "./solids.ts";
import type { JointRecord, Pose } from "../recording.ts";

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
