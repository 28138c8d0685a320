//! The chain that a map is made of: where it may be, and how it gets near a pose.

use super::MapError;
use crate::geometry::{Point3, Pose, Vector3};
use crate::robot::{Chain, Drive, JointKind, LinkId, MAX_CHAIN, Range, RobotModel};
use nalgebra::{SMatrix, SVector};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

pub(super) type Positions = [f64; MAX_CHAIN];

pub(super) struct Arm {
    pub chain: Chain,
    tip_from_tool: Pose,
    ranges: Vec<Range>,
    coupled: Vec<(Drive, Range)>,
    /// Farthest that the tool can be from the base [m].
    pub reach: f64,
}

const POSITION_TOLERANCE: f64 = 1e-3;
const ROTATION_TOLERANCE: f64 = 5e-3;
/// A radian of the tool's axis counts as this many metres.
const ROTATION_LENGTH: f64 = 0.2;
const STEPS: usize = 15;

impl Arm {
    pub(super) fn new(
        robot: &RobotModel,
        base: LinkId,
        tip: LinkId,
        tip_from_tool: Pose,
    ) -> Result<Self, MapError> {
        let chain = robot.chain(base, tip)?;
        let mut ranges = Vec::new();
        for &variable in chain.variables() {
            let joint = robot.variable(variable);
            let pi = std::f64::consts::PI;
            ranges.push(match joint.limits.position {
                Some(range) => range,
                None if joint.kind == JointKind::Revolute => Range {
                    lower: -pi,
                    upper: pi,
                },
                None => {
                    let joint = joint.name.clone();
                    return Err(MapError::Unlimited { joint });
                }
            });
        }
        let coupled = robot
            .joints()
            .iter()
            .enumerate()
            .filter(|(i, j)| {
                !robot.variables().iter().any(|v| v.index() == *i)
                    && j.drive
                        .terms
                        .iter()
                        .any(|(v, _)| chain.variables().contains(v))
            })
            .filter_map(|(_, j)| Some((j.drive.clone(), j.limits.position?)))
            .collect();
        let mut reach = tip_from_tool.translation.vector.norm();
        let mut at = tip;
        while at != base {
            let Some(id) = robot.links()[at.index()].parent else {
                break;
            };
            let joint = &robot.joints()[id.index()];
            reach += joint.parent_from_joint.translation.vector.norm();
            if joint.kind == JointKind::Prismatic {
                let range = joint.limits.position.ok_or_else(|| MapError::Unlimited {
                    joint: joint.name.clone(),
                })?;
                reach += range.lower.abs().max(range.upper.abs());
            }
            at = joint.parent;
        }
        Ok(Self {
            chain,
            tip_from_tool,
            ranges,
            coupled,
            reach,
        })
    }

    pub(super) fn sample(&self, random: &mut ChaCha8Rng) -> Positions {
        let mut q = [0.0; MAX_CHAIN];
        for (q, range) in q.iter_mut().zip(&self.ranges) {
            *q = range.lower + random.random::<f64>() * (range.upper - range.lower);
        }
        q
    }

    pub(super) fn base_from_tool(&self, q: &Positions) -> Option<Pose> {
        let kinematics = self.chain.forward_kinematics(&q[..self.chain.dof()]).ok()?;
        Some(kinematics.base_from_tip() * self.tip_from_tool)
    }

    /// Whether joints that follow several others are within their limits.
    pub(super) fn within(&self, all: &[f64]) -> bool {
        self.coupled.iter().all(|(drive, range)| {
            let position = drive.position(all);
            range.lower <= position && position <= range.upper
        })
    }

    pub(super) fn approach(
        &self,
        point: &Point3,
        axis: &Vector3,
        start: &Positions,
    ) -> Option<Positions> {
        let n = self.chain.dof();
        let mut q = *start;
        let tool = Point3::from(self.tip_from_tool.translation.vector);
        let (mut e, mut j) = self.error(point, axis, &q, &tool)?;
        let mut damping = 1e-4;
        let done = |e: &SVector<f64, 5>| {
            e.fixed_rows::<3>(0).norm() < POSITION_TOLERANCE
                && e.fixed_rows::<2>(3).norm() < ROTATION_TOLERANCE * ROTATION_LENGTH
        };
        for _ in 0..STEPS {
            if done(&e) {
                return Some(q);
            }
            let mut frozen = [false; MAX_CHAIN];
            let gradient = j.transpose() * e;
            for i in 0..n {
                frozen[i] = gradient[i] > 0.0 && q[i] >= self.ranges[i].upper
                    || gradient[i] < 0.0 && q[i] <= self.ranges[i].lower;
            }
            let mut trial = q;
            for _ in 0..3 {
                let mut a = SMatrix::<f64, 5, 5>::identity() * damping;
                for i in 0..n {
                    if !frozen[i] {
                        a.ger(1.0, &j.column(i), &j.column(i), 1.0);
                    }
                }
                let y = a.cholesky()?.solve(&e);
                let mut hit = false;
                trial = q;
                for i in 0..n {
                    if frozen[i] {
                        continue;
                    }
                    let step = j.column(i).dot(&y).clamp(-0.5, 0.5);
                    trial[i] += step;
                    let Range { lower, upper } = self.ranges[i];
                    if trial[i] > upper || trial[i] < lower {
                        trial[i] = trial[i].clamp(lower, upper);
                        hit = true;
                    }
                }
                if !hit {
                    break;
                }
                for (i, frozen) in frozen.iter_mut().enumerate().take(n) {
                    let Range { lower, upper } = self.ranges[i];
                    let is_held = trial[i] == upper || trial[i] == lower;
                    if !*frozen && is_held && (trial[i] - q[i]).abs() < 1e-9 {
                        *frozen = true;
                        hit = false;
                    }
                }
                if hit {
                    break;
                }
            }
            let (e1, j1) = self.error(point, axis, &trial, &tool)?;
            let (before, after) = (e.norm(), e1.norm());
            if after < before {
                q = trial;
                (e, j) = (e1, j1);
                damping = (damping / 4.0).max(1e-9);
                if after > 0.98 * before {
                    return None;
                }
            } else {
                damping *= 10.0;
                if damping > 1.0 {
                    return None;
                }
            }
        }
        done(&e).then_some(q)
    }

    #[allow(clippy::type_complexity)]
    fn error(
        &self,
        point: &Point3,
        axis: &Vector3,
        q: &Positions,
        tool: &Point3,
    ) -> Option<(SVector<f64, 5>, SMatrix<f64, 5, MAX_CHAIN>)> {
        let n = self.chain.dof();
        let kinematics = self.chain.forward_kinematics(&q[..n]).ok()?;
        let pose = kinematics.base_from_tip() * self.tip_from_tool;
        let jacobian = kinematics.jacobian(*tool);
        let jacobian = jacobian.view();
        let rotation = pose.rotation.to_rotation_matrix();
        let (x, y, z) = (
            rotation.matrix().column(0).into_owned(),
            rotation.matrix().column(1).into_owned(),
            rotation.matrix().column(2).into_owned(),
        );
        let cross = z.cross(axis);
        let sine = cross.norm();
        let angle = sine.atan2(z.dot(axis));
        let turn = if sine > 1e-12 {
            cross * (angle / sine)
        } else {
            x * angle
        };
        let p = point.coords - pose.translation.vector;
        let l = ROTATION_LENGTH;
        let e = SVector::<f64, 5>::new(p.x, p.y, p.z, l * x.dot(&turn), l * y.dot(&turn));
        let mut j = SMatrix::<f64, 5, MAX_CHAIN>::zeros();
        for i in 0..n {
            let c = jacobian.column(i);
            let w = Vector3::new(c[3], c[4], c[5]);
            j[(0, i)] = c[0];
            j[(1, i)] = c[1];
            j[(2, i)] = c[2];
            j[(3, i)] = l * x.dot(&w);
            j[(4, i)] = l * y.dot(&w);
        }
        Some((e, j))
    }
}
