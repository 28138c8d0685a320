// An arm of seven joints with the kinematics of a Franka Emika Panda, and positions that hold a tool down at a place.

const HALF = Math.SQRT1_2;
const turn = (axis, quarters) => {
  const q = [0, 0, 0, Math.cos((quarters * Math.PI) / 4)];
  q[axis] = Math.sin((quarters * Math.PI) / 4);
  return q;
};
const X = (quarters) => turn(0, quarters);
const FRAMES = [
  [0, 0, 0.333, 0, 0, 0, 1], [0, 0, 0, ...X(-1)], [0, -0.316, 0, ...X(1)], [0.0825, 0, 0, ...X(1)],
  [-0.0825, 0.384, 0, ...X(-1)], [0, 0, 0, ...X(1)], [0.088, 0, 0, ...X(1)],
];
/** Pose of the tool's face in the frame of the last link. */
const LINK_FROM_TOOL = [0, 0, 0.16, 1, 0, 0, 0];
export const REST_POSE = [0, 0.1, 0, -2.2, 0, 2.3, 0.785];

const multiply = (a, b) => {
  const out = new Array(12);
  for (let i = 0; i < 3; i++) for (let j = 0; j < 4; j++) {
    out[4 * i + j] = a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] + (j === 3 ? a[4 * i + 3] : 0);
  }
  return out;
};
const matrix = ([x, y, z, a, b, c, w]) => [
  1 - 2 * (b * b + c * c), 2 * (a * b - c * w), 2 * (a * c + b * w), x,
  2 * (a * b + c * w), 1 - 2 * (a * a + c * c), 2 * (b * c - a * w), y,
  2 * (a * c - b * w), 2 * (b * c + a * w), 1 - 2 * (a * a + b * b), z,
];
const aboutZ = (angle) => [Math.cos(angle), -Math.sin(angle), 0, 0, Math.sin(angle), Math.cos(angle), 0, 0, 0, 0, 1, 0];

function forward(q) {
  const frames = [];
  let at = matrix([0, 0, 0, 0, 0, 0, 1]);
  FRAMES.forEach((frame, i) => {
    at = multiply(multiply(at, matrix(frame)), aboutZ(q[i]));
    frames.push(at);
  });
  return { frames, tool: multiply(at, matrix(LINK_FROM_TOOL)) };
}

/** Solves A x = b for a small matrix. */
function solve(A, b) {
  const n = b.length;
  const M = A.map((row, i) => [...row, b[i]]);
  for (let c = 0; c < n; c++) {
    const best = M.slice(c).reduce((top, row, i) => (Math.abs(row[c]) > Math.abs(M[top][c]) ? c + i : top), c);
    [M[c], M[best]] = [M[best], M[c]];
    for (let r = 0; r < n; r++) if (r !== c) {
      const f = M[r][c] / M[c][c];
      for (let k = c; k <= n; k++) M[r][k] -= f * M[c][k];
    }
  }
  return M.map((row, i) => row[n] / row[i]);
}

/** Positions near `start` with the tool's face at a place [m] in the robot's root frame, facing down (damped least squares). */
export function reach([x, y, z], start = REST_POSE) {
  const q = start.slice();
  for (let round = 0; round < 40; round++) {
    const { frames, tool } = forward(q);
    // Its normal points up, its first axis ahead.
    const column = (j) => [tool[j], tool[4 + j], tool[8 + j]];
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const off = [cross(column(0), [1, 0, 0]), cross(column(2), [0, 0, 1])];
    const error = [x - tool[3], y - tool[7], z - tool[11], ...[0, 1, 2].map((k) => 0.5 * (off[0][k] + off[1][k]))];
    if (Math.hypot(...error) < 1e-5) break;
    const J = frames.map((f) => {
      const axis = [f[2], f[6], f[10]];
      return [...cross(axis, [tool[3] - f[3], tool[7] - f[7], tool[11] - f[11]]), ...axis];
    });
    const A = error.map((_, i) => error.map((_, j) => J.reduce((sum, c) => sum + c[i] * c[j], 0) + (i === j ? 1e-5 : 0)));
    const y6 = solve(A, error);
    J.forEach((c, i) => { q[i] += c.reduce((sum, v, k) => sum + v * y6[k], 0); });
  }
  return q;
}

const capsule = (radius, length, pose) => ({ kind: "capsule", radius, length, pose });
const SHAPES = [
  [capsule(0.075, 0.08, [-0.03, 0, 0.06, 0, HALF, 0, HALF])],
  [capsule(0.07, 0.16, [0, 0, -0.115, 0, 0, 0, 1])],
  [capsule(0.07, 0.12, [0, -0.06, 0, HALF, 0, 0, HALF])],
  [capsule(0.065, 0.14, [0, 0, -0.145, 0, 0, 0, 1]), capsule(0.06, 0.06, [0.05, 0, 0, HALF, 0, 0, HALF])],
  [capsule(0.062, 0.1, [-0.05, 0.06, 0, HALF, 0, 0, HALF])],
  [capsule(0.058, 0.12, [0, 0, -0.26, 0, 0, 0, 1]), capsule(0.045, 0.16, [0, 0.07, -0.11, HALF, 0, 0, HALF])],
  [capsule(0.055, 0.08, [0.05, 0, 0, HALF, 0, 0, HALF])],
  [capsule(0.05, 0.05, [0, 0, 0.06, 0, 0, 0, 1]), { kind: "mesh", mesh: 0, pose: [0, 0, 0.115, 0, 0, 0, 1] }],
];

/** A tapered flange as a mesh. */
export const FLANGE = (() => {
  const vertices = [];
  const triangles = [];
  const n = 24;
  for (let i = 0; i < n; i++) for (const [radius, z] of [[470, -180], [300, 280]]) {
    vertices.push(Math.round(radius * Math.cos((2 * Math.PI * i) / n)), Math.round(radius * Math.sin((2 * Math.PI * i) / n)), z);
  }
  vertices.push(0, 0, -180, 0, 0, 280);
  for (let i = 0; i < n; i++) {
    const [a, b, c, d] = [2 * i, 2 * ((i + 1) % n), 2 * i + 1, 2 * ((i + 1) % n) + 1];
    triangles.push(a, b, d, a, d, c, 2 * n, b, a, 2 * n + 1, c, d);
  }
  return { vertices, triangles };
})();

export const ROBOT = {
  name: "arm7",
  variables: FRAMES.map((_, i) => `joint_${i + 1}`),
  joints: FRAMES.map((pose, i) => ({ parent: i, pose, axis: [0, 0, 1], kind: "revolute", offset: 0, terms: [[i, 1]] })),
  links: SHAPES.map((shapes, i) => ({ name: `link_${i}`, arm: i > 0, shapes })),
};

/** A sponge as a mesh in the frame of the tool, whose origin lies on its wiping face. */
export const SPONGE = {
  vertices: Array.from({ length: 8 }, (_, k) => [k & 1 ? 250 : -250, k & 2 ? 450 : -450, k & 4 ? 300 : 0]).flat(),
  triangles: [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5],
};

export const TOOL = { link: 7, solid: { kind: "mesh", mesh: 1, pose: LINK_FROM_TOOL } };
