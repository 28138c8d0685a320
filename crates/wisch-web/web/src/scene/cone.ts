// A circular cone onto which the chart of a surface is rolled: in the chart, a sector about the apex.
import { Vector3 } from "three";
import { once } from "../columns.ts";
import type { ConeShape } from "../recording.ts";

/** Directions of a cone in the chart and in space. */
interface Axes {
  along: readonly [number, number];
  /** Cosine of the half angle, and its sine with the sign of the radius. */
  cosine: number;
  sine: number;
  /** Distance of the chart's origin from the apex [m]. */
  slant: number;
  /** The direction in which the axis widens, the direction from it at the origin, and the direction across both. */
  axis: Vector3;
  radial: Vector3;
  across: Vector3;
}

const axesOf = once((cone: ConeShape): Axes => {
  const [x, y] = [Math.cos(cone.axis_rad), Math.sin(cone.axis_rad)];
  const [cosine, sine] = [Math.cos(cone.half_angle_rad), Math.sin(cone.half_angle_rad) * Math.sign(cone.radius_m)];
  return {
    along: [x, y], cosine, sine, slant: cone.radius_m / sine,
    axis: new Vector3(cosine * x, cosine * y, -sine), radial: new Vector3(sine * x, sine * y, cosine), across: new Vector3(-y, x, 0),
  };
});

/** Returns the angle about the axis from the chart's origin to a place [rad]. */
export function rollOnCone(cone: ConeShape, x: number, y: number): number {
  const { along, slant, sine } = axesOf(cone);
  return Math.atan2(along[0] * y - along[1] * x, slant + along[0] * x + along[1] * y) / sine;
}

/** Returns the point at a height over a place, in the frame of the surface [m]. */
export function liftOntoCone(cone: ConeShape, x: number, y: number, height: number): [number, number, number] {
  const { along, slant, sine, cosine, axis, radial, across } = axesOf(cone);
  const [v, u] = [along[0] * x + along[1] * y, along[0] * y - along[1] * x];
  // How much farther from the apex than the origin.
  const beyond = (v * (2 * slant + v) + u * u) / (Math.hypot(slant + v, u) + slant);
  const angle = Math.atan2(u, slant + v) / sine;
  const round = across.clone().multiplyScalar(Math.sin(angle)).addScaledVector(radial, -2 * Math.sin(angle / 2) ** 2);
  const out = round.clone().add(radial);
  return round.multiplyScalar(cone.radius_m)
    .addScaledVector(axis, cosine * beyond).addScaledVector(out, sine * beyond)
    .addScaledVector(out, cosine * height).addScaledVector(axis, -sine * height)
    .toArray();
}

/** Returns the normal under a point in the frame of the surface. */
export function normalOfCone(cone: ConeShape, point: Vector3): Vector3 {
  const { sine, cosine, axis, radial, across } = axesOf(cone);
  const [up, side] = [radial.dot(point) + cone.radius_m, across.dot(point)];
  const out = radial.clone().multiplyScalar(up).addScaledVector(across, side).multiplyScalar(Math.sign(cone.radius_m)).normalize();
  return out.multiplyScalar(cosine).addScaledVector(axis, -sine);
}

/** Returns a linear function of the place that is positive where the angle about the axis is larger than `roll` [rad]. */
export function pastRollOnCone(cone: ConeShape, roll: number): (x: number, y: number) => number {
  const { along, slant, sine } = axesOf(cone);
  const [s, c] = [Math.sin(roll * sine), Math.cos(roll * sine)];
  return (x, y) => Math.sign(sine) * (c * (along[0] * y - along[1] * x) - s * (slant + along[0] * x + along[1] * y));
}
