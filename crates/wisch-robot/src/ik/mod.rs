//! Inverse kinematics: joint positions that put a tool at a pose, within all limits.
//!
//! A descent is the local method, equation (7) of the paper, q̇ = J†ẋ + (1 − J†J) z. J† has Levenberg–Marquardt damping
//! in proportion to the squared error (Sugihara 2011), which handles singularities and targets out of reach and
//! vanishes at the solution. A limit that a step would break becomes an equation of the step, so that the other joints
//! compensate. After a descent that ends in a local minimum, further ones start from random positions.

mod descent;
mod error;
mod limits;
mod posture;
mod step;

use super::{Chain, LinkId, MAX_CHAIN, RobotError, RobotModel};
use crate::geometry::{Point3, Pose};
use error::Target;
use limits::Limits;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::fmt;
use std::ops::{Deref, DerefMut};

/// Largest distance of a target from the base \[m\], beyond which squares lose precision.
pub const MAX_TARGET_DISTANCE: f64 = 1e6;

/// Tolerances and effort of the inverse kinematics.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IkConfig {
    /// Largest distance of the tool centre point from its target \[m\].
    pub position_tolerance: f64,
    /// Largest angle between the tool and its target \[rad\].
    pub rotation_tolerance: f64,
    /// Largest number of steps of one descent.
    pub max_iterations: usize,
    /// Largest number of descents from random positions.
    pub max_restarts: usize,
    /// Share of the distance to the posture that a step covers in the null space \[1\].
    pub posture_gain: f64,
    /// Share of the distance out of the outer tenths of a joint's range that a step covers in the null space \[1\].
    pub limit_gain: f64,
    /// Largest motion of a joint in one step [rad or m].
    pub max_step: f64,
}

impl Default for IkConfig {
    fn default() -> Self {
        Self {
            position_tolerance: 1e-6,
            rotation_tolerance: 1e-6,
            max_iterations: 100,
            max_restarts: 100,
            posture_gain: 0.1,
            limit_gain: 0.5,
            max_step: 0.5,
        }
    }
}

impl IkConfig {
    fn check(&self) -> Result<(), RobotError> {
        let positive = |value: f64| value > 0.0 && value < f64::INFINITY;
        let share = |value: f64| (0.0..=1.0).contains(&value);
        let (position, rotation) = (self.position_tolerance, self.rotation_tolerance);
        let (step, posture, limit) = (self.max_step, self.posture_gain, self.limit_gain);
        for (what, value, allowed, limit) in [
            (
                "position_tolerance",
                position,
                positive(position),
                "greater than 0 m",
            ),
            (
                "rotation_tolerance",
                rotation,
                positive(rotation),
                "greater than 0 rad",
            ),
            ("max_step", step, positive(step), "greater than 0 rad or m"),
            ("posture_gain", posture, share(posture), "from 0 to 1"),
            ("limit_gain", limit, share(limit), "from 0 to 1"),
        ] {
            if !allowed {
                return Err(RobotError::Value { what, value, limit });
            }
        }
        Ok(())
    }
}

/// Rotations of the target that the tool must match.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RotationGoal {
    /// All three rotations.
    Full,
    /// The tool's z axis must point as the target's does; the tool may rotate about it.
    AboutToolZFree,
}

/// Positions of a chain's variables [rad or m], stored inline.
#[derive(Clone, Copy)]
pub struct JointPositions {
    /// Values; zero from `count` on.
    values: [f64; MAX_CHAIN],
    count: usize,
}

impl JointPositions {
    fn zeros(count: usize) -> Self {
        Self {
            values: [0.0; MAX_CHAIN],
            count,
        }
    }

    /// Copies at most [`MAX_CHAIN`] values.
    fn copy_of(q: &[f64]) -> Self {
        let mut positions = Self::zeros(q.len().min(MAX_CHAIN));
        for (own, value) in positions.values.iter_mut().zip(q) {
            *own = *value;
        }
        positions
    }
}

impl FromIterator<f64> for JointPositions {
    /// Collects at most [`MAX_CHAIN`] values.
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut positions = Self::zeros(0);
        for value in values.into_iter().take(MAX_CHAIN) {
            positions.values[positions.count] = value;
            positions.count += 1;
        }
        positions
    }
}

impl Deref for JointPositions {
    type Target = [f64];
    fn deref(&self) -> &[f64] {
        &self.values[..self.count]
    }
}

impl DerefMut for JointPositions {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.values[..self.count]
    }
}

impl PartialEq for JointPositions {
    fn eq(&self, other: &Self) -> bool {
        self[..] == other[..]
    }
}

impl fmt::Debug for JointPositions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self[..].fmt(f)
    }
}

/// Result of the inverse kinematics for a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IkOutcome {
    /// Positions at which the tool is at its target within the tolerances, and every joint, including followers, is
    /// within its limits.
    Solved(JointPositions),
    /// No descent reached the target.
    Stuck {
        /// The positions within the limits with the least error of all descents.
        best: JointPositions,
        /// Distance of the tool centre point from its target at `best` \[m\].
        position_error: f64,
        /// Angle between the tool and its target at `best` \[rad\], of the rotations that count.
        rotation_error: f64,
    },
}

/// Inverse kinematics of a chain of joints that carries a tool. Constant once built.
///
/// ```
/// # let text = include_str!("../../../../robots/arm7.urdf");
/// # let robot = wisch_robot::RobotModel::from_urdf("arm7.urdf", text, &mut |_| Err(String::new()))?;
/// use wisch_robot::geometry::Pose;
/// use wisch_robot::{IkConfig, IkOutcome, IkSolver, RotationGoal};
/// let (base, flange) = (robot.root(), robot.link("tcp")?);
/// let flange_from_tool = Pose::translation(0.0, 0.0, 0.1);
/// let solver = IkSolver::new(&robot, base, flange, flange_from_tool)?;
/// // 0.5 m ahead, 0.3 m up, pointing down.
/// let down = nalgebra::UnitQuaternion::from_euler_angles(std::f64::consts::PI, 0.0, 0.0);
/// let base_from_tool = Pose::from_parts([0.5, 0.0, 0.3].into(), down);
/// let config = IkConfig::default();
/// let outcome = solver.solve(&base_from_tool, RotationGoal::Full, &[], 1, &config)?;
/// let IkOutcome::Solved(q) = outcome else { panic!("{outcome:?}") };
/// let base_from_flange = solver.chain().forward_kinematics(&q)?.base_from_tip();
/// let apart = base_from_tool.inv_mul(&(base_from_flange * flange_from_tool));
/// assert!(apart.translation.vector.norm() < 1e-6 && apart.rotation.angle() < 1e-6);
/// assert!(robot.limit_faults(&q)?.is_empty());
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
#[derive(Debug, Clone)]
pub struct IkSolver {
    chain: Chain,
    tip_from_tool: Pose,
    tool_in_tip: Point3,
    limits: Limits,
    posture: JointPositions,
}

impl IkSolver {
    /// Returns a solver for the chain from `base` out to `tip`, with a tool fixed to the tip. The limits are those of
    /// every joint that only the chain's variables move. The posture is the middle of the limits, and 0 for a joint
    /// without limits.
    ///
    /// # Errors
    /// If there is no such chain ([`RobotModel::chain`]), or the pose is not finite.
    ///
    /// # Panics
    /// If a link belongs to another, larger robot.
    pub fn new(
        robot: &RobotModel,
        base: LinkId,
        tip: LinkId,
        tip_from_tool: Pose,
    ) -> Result<Self, RobotError> {
        let chain = robot.chain(base, tip)?;
        check_pose("tip_from_tool", &tip_from_tool)?;
        let limits = Limits::new(robot, &chain);
        let posture = limits.middle();
        Ok(Self {
            chain,
            tip_from_tool,
            tool_in_tip: tip_from_tool.translation.vector.into(),
            limits,
            posture,
        })
    }

    /// Returns the solver with another posture: positions of the chain's n variables [rad or m] that attract the
    /// solution in the null space. Positions outside the limits are projected inside.
    ///
    /// # Errors
    /// If `q` does not have n finite values.
    pub fn with_posture(mut self, q: &[f64]) -> Result<Self, RobotError> {
        self.posture = self.inside(q)?;
        Ok(self)
    }

    /// Returns the solver with a margin to the limits of revolute joints \[rad\], at most a tenth of their range. A
    /// compliant arm deviates from its command, and an end stop there would push it.
    ///
    /// # Errors
    /// If the margin is negative or not finite.
    pub fn with_limit_margin(mut self, margin: f64) -> Result<Self, RobotError> {
        if !(margin.is_finite() && margin >= 0.0) {
            return Err(RobotError::Value {
                what: "limit_margin",
                value: margin,
                limit: "0 rad or more",
            });
        }
        self.limits.narrow(margin);
        let posture = self.posture;
        self.posture = self.inside(&posture)?;
        Ok(self)
    }

    /// The chain that the solver moves.
    pub const fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Posture that attracts the solution [rad or m].
    pub const fn posture(&self) -> &JointPositions {
        &self.posture
    }

    /// Descends once from `start`, the chain's n positions [rad or m]; a start outside the limits is first projected
    /// inside. Each step includes self-motion towards the posture and out of the outer parts of the limits, at most as
    /// long as the error [m and rad]. A start that reaches the target is therefore returned unchanged.
    ///
    /// # Errors
    /// If `start` does not have n values, a value is not finite, the target is farther than [`MAX_TARGET_DISTANCE`], or
    /// a value of `config` is out of range.
    pub fn solve_from(
        &self,
        base_from_tool: &Pose,
        goal: RotationGoal,
        start: &[f64],
        config: &IkConfig,
    ) -> Result<IkOutcome, RobotError> {
        let target = check_target(base_from_tool, goal, config)?;
        let start = self.inside(start)?;
        Ok(self.descend(&target, start, config)?.outcome(config))
    }

    /// Descends from `starts`, or from the posture if there are none, then from at most [`IkConfig::max_restarts`]
    /// random positions, until the target is reached. Sliding joints are drawn within 1 m of the first start, as a base
    /// may have a wide range. The result depends on the arguments and the seed only.
    ///
    /// # Errors
    /// As [`solve_from`](Self::solve_from).
    pub fn solve(
        &self,
        base_from_tool: &Pose,
        goal: RotationGoal,
        starts: &[&[f64]],
        seed: u64,
        config: &IkConfig,
    ) -> Result<IkOutcome, RobotError> {
        let target = check_target(base_from_tool, goal, config)?;
        let posture: &[&[f64]] = &[&self.posture];
        let starts = if starts.is_empty() { posture } else { starts };
        let reference = self.inside(starts[0])?;
        let mut best = self.descend(&target, reference, config)?;
        for start in &starts[1..] {
            let start = self.inside(start)?;
            if !best.has_reached(config) {
                best = best.or_better(self.descend(&target, start, config)?, config);
            }
        }
        if best.has_reached(config) {
            return Ok(best.outcome(config));
        }
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        for _ in 0..config.max_restarts {
            let start = self.limits.random(&reference, &mut random);
            best = best.or_better(self.descend(&target, start, config)?, config);
            if best.has_reached(config) {
                break;
            }
        }
        Ok(best.outcome(config))
    }

    /// Draws the chain's n positions [rad or m] within the limits, as the random starts of [`solve`](Self::solve):
    /// sliding joints within 1 m of `near`. The result depends on the arguments only.
    ///
    /// # Errors
    /// If `near` does not have n finite values.
    pub fn random_start(&self, near: &[f64], seed: u64) -> Result<JointPositions, RobotError> {
        let near = self.inside(near)?;
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        Ok(self.limits.random(&near, &mut random))
    }

    /// Projects positions into the limits.
    fn inside(&self, q: &[f64]) -> Result<JointPositions, RobotError> {
        self.chain.check_positions(q)?;
        let mut q = JointPositions::copy_of(q);
        self.limits.project(&mut q);
        Ok(q)
    }
}

fn check_pose(what: &'static str, pose: &Pose) -> Result<(), RobotError> {
    let translation = pose.translation.vector;
    for value in translation.iter().chain(pose.rotation.coords.iter()) {
        if !value.is_finite() || value.abs() > MAX_TARGET_DISTANCE {
            let limit = "finite, and no more than 1e6 m";
            let value = *value;
            return Err(RobotError::Value { what, value, limit });
        }
    }
    Ok(())
}

fn check_target(
    base_from_tool: &Pose,
    goal: RotationGoal,
    config: &IkConfig,
) -> Result<Target, RobotError> {
    config.check()?;
    check_pose("base_from_tool", base_from_tool)?;
    Ok(Target {
        base_from_tool: *base_from_tool,
        goal,
    })
}
