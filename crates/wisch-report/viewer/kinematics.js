// Where the links of the robot are: its tree, and variables that change over time.
import { Matrix4, Quaternion, Vector3 } from "three";

const PER_UNIT = 1e5; // positions come as whole 1e-5 rad or m

// A pose x, y, z [m] and quaternion x, y, z, w as a matrix.
export const pose = ([x, y, z, qx, qy, qz, qw]) =>
  new Matrix4().compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw), new Vector3(1, 1, 1));

// One track of the robot of the page.
export class Motion {
  constructor(data, track) {
    this.period = track.period;
    this.count = track.count;
    this.duration = track.period * (track.count - 1);
    this.still = track.start.map((q) => q / PER_UNIT);
    // One column of positions per variable that changes.
    this.columns = track.changes.map(([variable, steps]) => {
      const column = new Float64Array(track.count);
      let sum = track.start[variable];
      column[0] = sum / PER_UNIT;
      steps.forEach((step, k) => { column[k + 1] = (sum += step) / PER_UNIT; });
      return [variable, column];
    });
    this.worldFromRoot = pose(track.root);
    this.joints = data.joints.map((joint) => ({
      ...joint,
      parentFromJoint: pose(joint.pose),
      axis: new Vector3(...joint.axis),
    }));
    this.toolLink = data.tool.link;
    this.linkFromTool = pose(data.tool.pose);
  }

  // All variables at a time [s], linear between frames.
  variables(time) {
    const place = Math.min(Math.max(time / this.period, 0), this.count - 1) || 0;
    const k = Math.min(Math.floor(place), Math.max(this.count - 2, 0));
    const share = place - k;
    const q = this.still.slice();
    for (const [variable, column] of this.columns) {
      const next = column[Math.min(k + 1, this.count - 1)];
      q[variable] = column[k] + share * (next - column[k]);
    }
    return q;
  }

  // The pose of every link in the world: world_from_parent * parent_from_joint * motion(axis, position).
  links(time) {
    const q = this.variables(time);
    const turn = new Matrix4();
    const worldFromLink = [this.worldFromRoot.clone()];
    for (const { parent, parentFromJoint, axis, kind, offset, terms } of this.joints) {
      const position = terms.reduce((sum, [variable, factor]) => sum + factor * q[variable], offset);
      const worldFromChild = worldFromLink[parent].clone().multiply(parentFromJoint);
      if (kind === "revolute") worldFromChild.multiply(turn.makeRotationAxis(axis, position));
      if (kind === "prismatic") {
        worldFromChild.multiply(turn.makeTranslation(axis.x * position, axis.y * position, axis.z * position));
      }
      worldFromLink.push(worldFromChild);
    }
    return worldFromLink;
  }

  // Where the tool is, given the links.
  tool(worldFromLink) {
    return worldFromLink[this.toolLink].clone().multiply(this.linkFromTool);
  }
}

// Index of the last entry that begins at or before a time, -1 if none does.
export const lastBefore = (begins, time) => {
  let low = 0, high = begins.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (begins[middle] <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
};
