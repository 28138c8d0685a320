//! Search for a ready posture: free of self-collision, away from limits, agile, with the tool over the surface.

use super::postures::{
    MAX_NEAR_VARIABLES, middle_posture, random_stream, range_of, variables_between,
};
use super::region::hand_extent;
use super::{SetupConfig, SetupError, SetupStage, WipingRegion};
use crate::frame::rotation_from_z;
use crate::geometry::{Point3, Pose, Vector3};
use crate::{
    Chain, CollisionModel, Group, IkConfig, IkOutcome, IkSolver, JointKind, LinkAxis, Margins,
    RobotModel, RotationGoal,
};
use nalgebra::{DMatrix, Translation3};
use rand::RngExt;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Clearance above which a larger one does not raise the score [m].
const AMPLE_CLEARANCE: f64 = 0.10;
/// Clearance above which a larger one does not raise the score, for links that at most three
/// variables move against each other [m]. Half of it is just above the clearance that the planner
/// keeps.
const AMPLE_NEAR: f64 = 0.012;
/// Number of random postures after which a search without a free posture ends.
const PROBE_SAMPLES: usize = 2000;
/// Number of shares of the joints' ranges from which the search starts.
const SPREADS: usize = 4;
/// Manipulability up to which a posture is singular: larger by orders of magnitude than its rounding errors [m³ or less].
pub const SINGULAR: f64 = 1e-7;
/// Share of the largest manipulability above which a larger one does not raise the score [1].
const AMPLE_MANIPULABILITY: f64 = 0.6;
/// Number of random postures that measure how far apart the links of a pair can be.
const AMPLE_SAMPLES: usize = 200;
/// Least clearance of a pair that is always close, as a share of its largest distance [1].
const LEAST_SHARE: f64 = 0.5;
/// Share of half a joint's range to the nearest limit above which a larger one does not raise the
/// score [1].
const AMPLE_RANGE: f64 = 0.35;
/// Largest share of the score that a place at the border of the region costs [1].
const BORDER_COST: f64 = 0.3;
/// Largest distance of the tip from its place in the region in a posture of an arm that cannot point its tool at the surface [m].
const MAX_OFF: f64 = 1.0;
/// Share of the score that joints half a turn from the middle of their limits cost, of which 0.9 is kept at most [1].
const TURN_COST: f64 = 1.5;
/// Largest angle of a tool that points at the surface \[rad\].
const MAX_TILT: f64 = 0.01;
/// Clearance from obstacles [m], which the planner keeps as well.
const OBSTACLE_CLEARANCE: f64 = 5e-3;
/// Least difference of a joint between two postures that both are returned [rad or m].
const DISTINCT: f64 = 0.8;
/// Clearance up to which pairs are measured [m].
const MAX_CLEARANCE: f64 = 1.0;
/// Steps per radian or metre to which joint positions are rounded: 0.0001 rad or m.
const STEPS: f64 = 1e4;

/// Tolerances and effort of the descents: a solution is rounded afterwards.
const DESCENT: IkConfig = IkConfig {
    position_tolerance: 1e-3,
    rotation_tolerance: 2e-3,
    max_iterations: 60,
    max_restarts: 0,
    posture_gain: 0.0,
    limit_gain: 0.5,
    max_step: 0.5,
};

/// Input of the search for a ready posture.
#[derive(Debug, Clone, Copy)]
pub struct ReadyRequest<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// The group whose joints move.
    pub group: &'a Group,
    /// Axis of the group's tip along which the tool is held.
    pub axis: LinkAxis,
    /// Posture of the robot (n) [rad or m]; joints outside the group keep it.
    pub held: &'a [f64],
    /// Collision model, with a tool and obstacles if there are any.
    pub collisions: &'a CollisionModel,
    /// Regions for the tip, the preferred one first; the first one with a posture is taken.
    pub regions: &'a [WipingRegion],
}

/// A ready posture with its properties.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadyPosture {
    /// Posture of the robot (n) [rad or m].
    pub q: Vec<f64>,
    /// Least distance of links and tools that the group moves against each other, without obstacles \[m\]; at most 1 m.
    pub clearance: f64,
    /// Least distance of a pair, as a share of the distance that is ample for it: 0.1 m, or for a pair that is always
    /// closer the largest distance in random postures \[1\].
    pub clearance_share: f64,
    /// Yoshikawa's manipulability of the group, see [`manipulability`].
    pub manipulability: f64,
    /// Distance to the nearest limit, as a share of half the joint's range: 0 at a limit, 1 in the middle \[1\].
    pub limit_share: f64,
    /// Angle between the axis of the tip and the direction into the surface \[rad\].
    pub tilt: f64,
    /// Position of the end of the tip's shapes in the root frame \[m\].
    pub tip: Point3,
    /// Where the tip is, in words.
    pub place: String,
    /// Number of random postures from which the search started.
    pub samples: usize,
    /// Number of postures found that are free of collision.
    pub free: usize,
}

/// Result of the search from one random posture.
enum Candidate {
    /// The tool cannot be put into the region from there.
    OutOfReach,
    /// The posture collides; the pair in words.
    Colliding(String),
    Free(Box<ReadyPosture>),
}

/// A group in the search.
struct Search<'a> {
    request: &'a ReadyRequest<'a>,
    solver: IkSolver,
    /// The group's pairs.
    collisions: CollisionModel,
    base_from_root: Pose,
    /// The end of the tip's shapes, where a tool begins.
    tip_from_end: Pose,
    /// Distance of each pair above which a larger one does not raise the score [m].
    ample: Vec<f64>,
    /// Joints outside their limits in the held posture.
    held_faults: Vec<String>,
    config: &'a SetupConfig,
}

/// Searches for a ready posture. From each random posture, inverse kinematics moves the end of the tip to a random
/// place of the region, with its z axis against the surface. Of the postures that are free of collision, the one with
/// the largest product of clearance, distance to limits and manipulability is returned; each factor saturates where
/// more does not help. Positions are rounded to 0.0001 rad or m.
///
/// An arm that cannot point the tool at the surface gets the posture with the least tilt.
///
/// # Errors
/// If a setting is out of range, the group or posture does not fit the robot, or every posture collides.
///
/// # Panics
/// If a link of the group belongs to another, larger robot.
pub fn find_ready(
    request: &ReadyRequest<'_>,
    config: &SetupConfig,
    progress: impl Fn(SetupStage, usize, usize) + Sync,
) -> Result<ReadyPosture, SetupError> {
    Ok(find_ready_postures(request, config, 1, progress)?.swap_remove(0))
}

/// Searches for several ready postures, as [`find_ready`] does, the best one first.
///
/// `count`: largest number of postures, at least 1. Each of them differs from every better one by 0.8 rad or m or more in
/// some joint.
///
/// # Errors
/// If a setting is out of range, the group or posture does not fit the robot, or every posture collides.
///
/// # Panics
/// If a link of the group belongs to another, larger robot.
pub fn find_ready_postures(
    request: &ReadyRequest<'_>,
    config: &SetupConfig,
    count: usize,
    progress: impl Fn(SetupStage, usize, usize) + Sync,
) -> Result<Vec<ReadyPosture>, SetupError> {
    config.check()?;
    let (robot, group) = (request.robot, request.group);
    let reach = hand_extent(robot, group.tip, request.axis, request.held)?;
    let tip_from_end = request.axis.frame() * Pose::translation(0.0, 0.0, reach);
    let solver = IkSolver::new(robot, group.base, group.tip, tip_from_end)?;
    let kinematics = robot.forward_kinematics(request.held)?;
    let collisions = request
        .collisions
        .with_variables(solver.chain().variables());
    let search = Search {
        held_faults: (robot.limit_faults(request.held)?.into_iter())
            .map(|fault| fault.joint)
            .collect(),
        ample: measure_ample(request, solver.chain(), &collisions, config.seed),
        collisions,
        base_from_root: kinematics.world_from_link(group.base).inverse(),
        request,
        solver,
        tip_from_end,
        config,
    };
    let mut reached = 0;
    let mut contacts: BTreeMap<String, usize> = BTreeMap::new();
    for only_straight in [true, false] {
        for region in request.regions {
            let candidates = search.search(region, only_straight, &progress);
            let mut free = Vec::new();
            for candidate in candidates {
                reached += usize::from(!matches!(candidate, Candidate::OutOfReach));
                match candidate {
                    Candidate::OutOfReach => {}
                    Candidate::Colliding(contact) => *contacts.entry(contact).or_default() += 1,
                    Candidate::Free(posture) => free.push(*posture),
                }
            }
            let chosen = choose(robot, search.solver.chain(), region, free, count.max(1));
            if !chosen.is_empty() {
                return Ok(chosen);
            }
        }
    }
    let most = contacts.into_iter().max_by_key(|(_, count)| *count);
    Err(SetupError::NoReadyPosture {
        group: group.name.clone(),
        samples: config.posture_samples,
        reached,
        contact: most.map(|(contact, _)| contact),
    })
}

/// Returns Yoshikawa's manipulability √det(J Jᵀ) of a chain's tip (1985, eq. 12) at positions `q` of its n variables
/// [rad or m], with lengths in metres. For fewer than six variables it is √det(Jᵀ J).
///
/// # Errors
/// If `q` does not have n finite values.
pub fn manipulability(chain: &Chain, q: &[f64]) -> Result<f64, SetupError> {
    let kinematics = chain.forward_kinematics(q)?;
    let jacobian = kinematics.jacobian(Point3::origin());
    let columns = jacobian.view();
    let jacobian = DMatrix::from_fn(6, columns.ncols(), |i, j| columns[(i, j)]);
    let square = if jacobian.ncols() < 6 {
        jacobian.transpose() * &jacobian
    } else {
        &jacobian * jacobian.transpose()
    };
    Ok(square.determinant().max(0.0).sqrt())
}

/// Returns the distance of each pair above which a larger one does not raise the score [m].
fn measure_ample(
    request: &ReadyRequest<'_>,
    chain: &Chain,
    collisions: &CollisionModel,
    seed: u64,
) -> Vec<f64> {
    let mut random = random_stream(seed.wrapping_add(3), 0);
    let mut ample = vec![f64::MIN_POSITIVE; collisions.own_distances(request.held, 0.0).len()];
    for _ in 0..AMPLE_SAMPLES {
        let mut q = request.held.to_vec();
        for &variable in chain.variables() {
            let (lower, upper) = range_of(request.robot, variable);
            q[variable] = lower + random.random::<f64>() * (upper - lower);
        }
        let distances = collisions.own_distances(&q, AMPLE_CLEARANCE);
        for (most, distance) in ample.iter_mut().zip(distances) {
            *most = most.max(distance);
        }
    }
    for (pair, ample) in ample.iter_mut().enumerate() {
        let links = collisions.own_links(pair);
        let between = links.map(|links| variables_between(request.robot, links).len());
        if between.is_some_and(|count| count <= MAX_NEAR_VARIABLES) {
            *ample = ample.min(AMPLE_NEAR);
        }
    }
    ample
}

impl Search<'_> {
    /// Searches from all random postures, or from the first [`PROBE_SAMPLES`] if none of these ends in a free posture.
    ///
    /// `only_straight`: whether the tool must point at the surface.
    fn search(
        &self,
        region: &WipingRegion,
        only_straight: bool,
        progress: &(impl Fn(SetupStage, usize, usize) + Sync),
    ) -> Vec<Candidate> {
        let total = self.config.posture_samples;
        let done = AtomicUsize::new(0);
        let of_sample = |sample: usize| {
            let candidate = self.try_sample(region, only_straight, sample);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(SetupStage::Ready, done, total);
            // A posture that cannot be evaluated, because a number is not finite, does not count.
            candidate.unwrap_or(Candidate::OutOfReach)
        };
        let probed = total.min(PROBE_SAMPLES);
        let mut found: Vec<Candidate> = (0..probed).into_par_iter().map(of_sample).collect();
        // If none of many postures is free, the search ends to save time.
        if found
            .iter()
            .any(|candidate| matches!(candidate, Candidate::Free(_)))
        {
            found.par_extend((probed..total).into_par_iter().map(of_sample));
        }
        found
    }

    fn try_sample(
        &self,
        region: &WipingRegion,
        only_straight: bool,
        sample: usize,
    ) -> Result<Candidate, SetupError> {
        let robot = self.request.robot;
        let chain = self.solver.chain();
        let mut random = random_stream(self.config.seed.wrapping_add(2), sample);
        let mut share = || random.random::<f64>();
        // Starts near the middle of the limits end in postures that are less twisted.
        let spread = ((sample % SPREADS) + 1) as f64 / SPREADS as f64;
        let start: Vec<f64> = (chain.variables().iter())
            .map(|&variable| {
                let (lower, upper) = range_of(robot, variable);
                f64::midpoint(lower, upper) + spread * (share() - 0.5) * (upper - lower)
            })
            .collect();
        let size = region.high - region.low;
        let place = region.low + size.map(|side| side * share());
        let into_surface =
            Pose::from_parts(Translation3::from(place), rotation_from_z(&-Vector3::z()));
        let root_from_tool = region.root_from_region * into_surface;
        let goal = self.base_from_root * root_from_tool;
        let outcome =
            (self.solver).solve_from(&goal, RotationGoal::AboutToolZFree, &start, &DESCENT)?;
        let positions = match outcome {
            IkOutcome::Solved(positions) => positions,
            IkOutcome::Stuck {
                best,
                position_error,
                ..
            } if !only_straight && position_error <= MAX_OFF => best,
            IkOutcome::Stuck { .. } => return Ok(Candidate::OutOfReach),
        };
        let mut q = self.request.held.to_vec();
        for (&variable, &position) in chain.variables().iter().zip(positions.iter()) {
            let rounded = unwind(robot, variable, round(position));
            let limits = robot.variable(variable).limits.position;
            let is_inside = limits.is_none_or(|l| (l.lower..=l.upper).contains(&rounded));
            q[variable] = if is_inside { rounded } else { position };
        }
        // Joints that follow others may be outside their limits before the search.
        let mut faults = robot.limit_faults(&q)?.into_iter();
        if faults.any(|fault| !self.held_faults.contains(&fault.joint)) {
            return Ok(Candidate::OutOfReach);
        }
        self.evaluate(region, q)
    }

    fn evaluate(&self, region: &WipingRegion, q: Vec<f64>) -> Result<Candidate, SetupError> {
        let (robot, group) = (self.request.robot, self.request.group);
        let obstacles = Margins {
            own: 0.0,
            obstacles: OBSTACLE_CLEARANCE,
        };
        if let Some(contact) = self.collisions.collision(&q, obstacles)? {
            let [a, b] = [contact.a, contact.b].map(|body| self.collisions.name(body));
            return Ok(Candidate::Colliding(format!("{a:?} with {b:?}")));
        }
        let distances = self.collisions.own_distances(&q, MAX_CLEARANCE);
        let mut clearance_share: f64 = 1.0;
        for (pair, (&distance, &ample)) in distances.iter().zip(&self.ample).enumerate() {
            let least = self.config.ready_clearance.min(LEAST_SHARE * ample);
            if distance < least {
                let [a, b] = self.collisions.own_pair(pair);
                return Ok(Candidate::Colliding(format!("{a:?} with {b:?}")));
            }
            clearance_share = clearance_share.min(distance / ample);
        }
        let clearance = distances.into_iter().fold(MAX_CLEARANCE, f64::min);
        let chain = self.solver.chain();
        let own: Vec<f64> = chain.variables().iter().map(|&v| q[v]).collect();
        let root_from_tip =
            robot.forward_kinematics(&q)?.world_from_link(group.tip) * self.tip_from_end;
        let into_surface = region.root_from_region.rotation * -Vector3::z();
        Ok(Candidate::Free(Box::new(ReadyPosture {
            clearance,
            clearance_share,
            manipulability: manipulability(chain, &own)?,
            limit_share: limit_share(robot, chain.variables(), &q),
            tilt: (root_from_tip.rotation * Vector3::z()).angle(&into_surface),
            tip: root_from_tip.translation.vector.into(),
            place: region.place.clone(),
            samples: self.config.posture_samples,
            free: 0,
            q,
        })))
    }
}

/// Returns the distinct postures with the best scores; among those that point at the surface if there are any.
fn choose(
    robot: &RobotModel,
    chain: &Chain,
    region: &WipingRegion,
    free: Vec<ReadyPosture>,
    count: usize,
) -> Vec<ReadyPosture> {
    let found = free.len();
    let is_straight = |posture: &ReadyPosture| posture.tilt <= MAX_TILT;
    let any_straight = free.iter().any(is_straight);
    let most = (free.iter().map(|posture| posture.manipulability)).fold(0.0, f64::max);
    // For an arm that is singular everywhere, manipulability does not distinguish postures.
    let ability = |posture: &ReadyPosture| {
        if most > SINGULAR {
            (posture.manipulability / (AMPLE_MANIPULABILITY * most)).min(1.0)
        } else {
            1.0
        }
    };
    let score = |posture: &ReadyPosture| {
        let straight = if any_straight {
            1.0
        } else {
            posture.tilt.cos().max(0.0)
        };
        posture.clearance_share
            * (posture.limit_share / AMPLE_RANGE).min(1.0)
            * ability(posture)
            * (1.0 - BORDER_COST * distance_from_middle(region, &posture.tip))
            * (1.0 - (TURN_COST * turn_from_middle(robot, chain.variables(), &posture.q)).min(0.9))
            * straight
    };
    let candidates = free.into_iter().filter(|p| !any_straight || is_straight(p));
    let scored = candidates.map(|posture| (score(&posture), posture));
    let mut scored: Vec<_> = scored.filter(|(score, _)| score.is_finite()).collect();
    // The sort is stable, so of equal scores the first one found stays first.
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut chosen: Vec<ReadyPosture> = Vec::new();
    for (_, posture) in scored {
        let differs = |other: &ReadyPosture| {
            (posture.q.iter().zip(&other.q)).any(|(a, b)| (a - b).abs() >= DISTINCT)
        };
        if chosen.len() < count && chosen.iter().all(differs) {
            chosen.push(ReadyPosture {
                free: found,
                ..posture
            });
        }
    }
    chosen
}

/// Distance of a point from the middle of a region, as a share of that of its corners, at most 1.
fn distance_from_middle(region: &WipingRegion, tip: &Point3) -> f64 {
    let in_region = region.root_from_region.inverse_transform_point(tip);
    let half = (region.high - region.low) / 2.0;
    let middle = (region.high + region.low) / 2.0;
    let from_middle =
        (in_region.coords - middle).component_div(&half.add_scalar(f64::MIN_POSITIVE));
    (from_middle.norm() / 3.0_f64.sqrt()).min(1.0)
}

/// Root mean square of the turns of the revolute joints from the middle of their limits, in half turns, at most 1.
fn turn_from_middle(robot: &RobotModel, variables: &[usize], q: &[f64]) -> f64 {
    let middle = middle_posture(robot);
    let revolute = |&&v: &&usize| robot.variable(v).kind == JointKind::Revolute;
    let turns = variables.iter().filter(revolute);
    let squares: Vec<f64> = turns.map(|&v| ((q[v] - middle[v]) / PI).powi(2)).collect();
    let mean = squares.iter().sum::<f64>() / squares.len().max(1) as f64;
    mean.sqrt().min(1.0)
}

/// Least distance of the variables to their limits, as a share of half their range [1]; 1 without limits.
fn limit_share(robot: &RobotModel, variables: &[usize], q: &[f64]) -> f64 {
    let shares = variables.iter().filter_map(|&variable| {
        let range = robot.variable(variable).limits.position?;
        let half = (range.upper - range.lower) / 2.0;
        let nearest = (q[variable] - range.lower).min(range.upper - q[variable]);
        (half > 0.0).then(|| nearest / half)
    });
    shares.fold(1.0, f64::min)
}

/// Returns a position without the digits beyond a step.
fn round(position: f64) -> f64 {
    (position * STEPS).round() / STEPS
}

/// Returns a position of a rotating joint without whole turns, where the limits permit it.
fn unwind(robot: &RobotModel, variable: usize, position: f64) -> f64 {
    let joint = robot.variable(variable);
    let nearest = position - TAU * (position / TAU).round();
    let nearest = round(nearest);
    let is_allowed = joint
        .limits
        .position
        .is_none_or(|l| (l.lower..=l.upper).contains(&nearest));
    if joint.kind == JointKind::Revolute && is_allowed {
        nearest
    } else {
        position
    }
}
