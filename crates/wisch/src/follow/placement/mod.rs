//! Base poses for the arm's work, rated by how much of the rest of the path is in reach; paper §3.3.

pub(super) mod drive;

use crate::follow::path::tool_redundancy::{orientations, rank};
use crate::follow::{FollowConfig, Placement, RatedBasePose, ToolPose, Workcell};
use crate::geometry::{Bounds2, PlanarPose, Point2, Point3, Pose, Vector3, wrap_angle};
use crate::represent::{Task, Tool};
use crate::robot::{CapabilityMap, IkConfig, IkOutcome, RobotError, RotationGoal};
use nalgebra::UnitQuaternion;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Pitch of the candidate positions [m].
const PITCH: f64 = 0.1;
/// Number of headings at each position.
const HEADINGS: usize = 12;
/// Pitch [m] and number of headings without a capability map, where each pose is solved by inverse kinematics.
const SPARSE: (f64, usize) = (0.2, 8);
/// Largest number of poses of the path that are rated.
const MAX_POSES: usize = 80;
/// Largest number of poses that are rated without a capability map.
const SPARSE_POSES: usize = 16;
/// Base poses nearer than this, in position and heading, are not both tried [m, rad].
const MIN_SEPARATION: (f64, f64) = (0.15, 0.4);
/// Ratings that differ by less than this count as equal: then the nearer base pose is taken [1].
const SAME_RATING: f64 = 0.05;
/// Step of the tool's yaw in a rating [rad].
const TURN: f64 = PI / 4.0;
/// Ratings above this count as in reach, as in a capability map [1].
const IN_REACH: f64 = 0.5;
/// Distance around the path in which base poses are searched [m].
const AROUND: f64 = 1.6;

/// The rating of tool poses by their reachability.
pub(in crate::follow) struct Reachability<'a> {
    cell: &'a Workcell,
    task: &'a Task,
    map: Option<&'a CapabilityMap>,
    /// Rotations of the tool, nearest to the plan first.
    turns: Vec<Turn>,
    /// Pose of the group's base with the planar base at the origin.
    root_from_base: Pose,
}

/// A rotation of the tool about the surface normal against the plan.
struct Turn {
    rotation: UnitQuaternion<f64>,
    /// Weight of the rotation: 1 as planned, smaller away from it.
    weight: f64,
}

fn turns(tool: &Tool) -> Vec<Turn> {
    let symmetric = tool.is_half_turn_symmetric();
    (orientations(tool, TURN).iter())
        .filter(|orientation| orientation.tilt.abs() < TURN / 2.0)
        .map(|orientation| Turn {
            rotation: UnitQuaternion::from_axis_angle(&Vector3::z_axis(), orientation.rotation),
            weight: 1.0 / (1.0 + rank(orientation, symmetric)),
        })
        .collect()
}

impl<'a> Reachability<'a> {
    pub fn new(
        cell: &'a Workcell,
        task: &'a Task,
        map: Option<&'a CapabilityMap>,
    ) -> Result<Self, RobotError> {
        let origin = PlanarPose::new(Point2::origin(), 0.0);
        let q = cell.standing(cell.ready_posture(), &origin);
        let link = cell.ik().chain().base();
        let root_from_base = cell.robot().forward_kinematics(&q)?.world_from_link(link);
        Ok(Self {
            cell,
            task,
            map,
            turns: turns(&task.tool),
            root_from_base,
        })
    }

    /// Returns the reachability of a pose, 0 to 1, or `None` out of reach: the share of directions from which
    /// the position can be reached, smaller where the tool has to be turned from the plan.
    fn of(&self, world_from_tool: &Pose, world_from_base: &PlanarPose) -> Option<f64> {
        let stands = Pose::new(
            Vector3::new(world_from_base.position.x, world_from_base.position.y, 0.0),
            Vector3::z() * world_from_base.heading,
        );
        let base_from_tool = (stands * self.root_from_base).inverse() * world_from_tool;
        let mut poses = self
            .turns
            .iter()
            .map(|turn| (base_from_tool * turn.rotation, turn.weight));
        match self.map {
            Some(map) => poses.find_map(|(base_from_tool, worth)| {
                let base_from_tip = base_from_tool * self.cell.tip_from_tool().inverse();
                let place = Point3::from(base_from_tip.translation.vector);
                (map.reachability(&base_from_tip) > IN_REACH).then(|| worth * map.index(&place))
            }),
            None => {
                let config = IkConfig {
                    max_restarts: 2,
                    ..IkConfig::default()
                };
                poses.find_map(|(base_from_tool, worth)| {
                    let goal = RotationGoal::Full;
                    let found = (self.cell.ik()).solve(&base_from_tool, goal, &[], 0, &config);
                    matches!(found, Ok(IkOutcome::Solved(_))).then_some(worth)
                })
            }
        }
    }

    /// Returns for each pose of the tool on the surface its reachability from the best of some base poses, 0 to
    /// 1.
    pub fn best_of_each(&self, poses: &[PlanarPose], places: &[PlanarPose]) -> Vec<f64> {
        let ample = |&surface_from_tool: &PlanarPose| {
            let pose = ToolPose {
                surface_from_tool,
                height: 0.0,
                tilt: 0.0,
            };
            let world_from_tool = Workcell::world_from_tool(self.task, &pose);
            let ratings = places
                .iter()
                .filter_map(|place| self.of(&world_from_tool, place));
            ratings.fold(0.0, f64::max)
        };
        poses.par_iter().map(ample).collect()
    }

    /// Rates base poses around the path: by the number of consecutive poses in reach, and by their
    /// reachability.
    pub fn rate_base_poses(&self, ahead: &[ToolPose], config: &FollowConfig) -> Vec<Candidate> {
        let poses = self.sample_poses(ahead);
        let Some(places) = self.places(&poses) else {
            return Vec::new();
        };
        places
            .into_par_iter()
            .map(|world_from_base| {
                let q = self
                    .cell
                    .standing(self.cell.ready_posture(), &world_from_base);
                let contact = self.cell.collisions().collision(&q, config.margin);
                if !matches!(contact, Ok(None)) {
                    return Candidate {
                        world_from_base,
                        in_reach: None,
                        share: 0.0,
                        rating: 0.0,
                    };
                }
                let reached = poses
                    .iter()
                    .map_while(|pose| self.of(pose, &world_from_base));
                let (in_reach, sum) =
                    reached.fold((0, 0.0), |(n, sum), ample| (n + 1, sum + ample));
                Candidate {
                    world_from_base,
                    in_reach: Some(in_reach),
                    share: in_reach as f64 / poses.len() as f64,
                    rating: sum / in_reach.max(1) as f64,
                }
            })
            .collect()
    }

    fn sample_poses(&self, ahead: &[ToolPose]) -> Vec<Pose> {
        let most = if self.map.is_some() {
            MAX_POSES
        } else {
            SPARSE_POSES
        };
        let stride = ahead.len().div_ceil(most).max(1);
        let last = ahead.len().saturating_sub(1);
        (ahead.iter().enumerate())
            .filter(|(i, _)| i % stride == 0 || *i == last)
            .map(|(_, pose)| Workcell::world_from_tool(self.task, pose))
            .collect()
    }

    fn places(&self, world_from_tools: &[Pose]) -> Option<Vec<PlanarPose>> {
        let (pitch, headings) = if self.map.is_some() {
            (PITCH, HEADINGS)
        } else {
            SPARSE
        };
        let flat = |pose: &Pose| {
            let at: Point3 = pose.translation.vector.into();
            Point2::new(at.x, at.y)
        };
        let bounds = Bounds2::from_points(world_from_tools.iter().map(flat))?;
        let (low, high) = (bounds.min, bounds.max);
        let count = |length: f64| ((length + 2.0 * AROUND) / pitch).round().max(1.0) as usize;
        let (nx, ny) = (count(high.x - low.x), count(high.y - low.y));
        let center = nalgebra::center(&low, &high);
        let at = |i: usize, n: usize, middle: f64| middle + pitch * (i as f64 - n as f64 / 2.0);
        let poses = (0..=nx).flat_map(move |i| {
            (0..=ny).flat_map(move |j| {
                (0..headings).map(move |k| {
                    let position = Point2::new(at(i, nx, center.x), at(j, ny, center.y));
                    PlanarPose::new(position, wrap_angle(TAU * k as f64 / headings as f64))
                })
            })
        });
        Some(poses.collect())
    }
}

/// A rated base pose.
#[derive(Debug, Clone, Copy)]
pub(in crate::follow) struct Candidate {
    pub world_from_base: PlanarPose,
    /// Number of poses in reach, from the first on; `None` where the robot cannot stand.
    pub in_reach: Option<usize>,
    /// The same number as a share of all poses [1].
    pub share: f64,
    /// Reachability of the first poses, 0 to 1.
    pub rating: f64,
}

impl From<&Candidate> for RatedBasePose {
    fn from(candidate: &Candidate) -> Self {
        Self {
            world_from_base: candidate.world_from_base,
            rating: candidate.in_reach.map(|_| candidate.share),
        }
    }
}

impl From<&Candidate> for Placement {
    fn from(candidate: &Candidate) -> Self {
        Self {
            world_from_base: candidate.world_from_base,
            rating: candidate.rating,
        }
    }
}

/// Returns the base poses to try, best first and apart from each other. The best follow most of the path before
/// the base has to move; of equal ones those with high reachability come first, then the nearest.
pub(in crate::follow) fn best(
    candidates: &[Candidate],
    from: &PlanarPose,
    count: usize,
) -> Vec<Candidate> {
    let mut usable: Vec<(usize, i64, f64, &Candidate)> = candidates
        .iter()
        .filter_map(|candidate| {
            let in_reach = candidate.in_reach.filter(|&count| count > 0)?;
            let away = (candidate.world_from_base.position - from.position).norm();
            let level = (candidate.rating / SAME_RATING).round() as i64;
            Some((in_reach, level, away, candidate))
        })
        .collect();
    usable.sort_by(|a, b| (b.0, b.1).cmp(&(a.0, a.1)).then(a.2.total_cmp(&b.2)));
    let mut chosen: Vec<Candidate> = Vec::new();
    for (.., candidate) in usable {
        if chosen.len() == count {
            break;
        }
        let at = &candidate.world_from_base;
        let is_apart = |other: &Candidate| {
            let other = &other.world_from_base;
            (other.position - at.position).norm() > MIN_SEPARATION.0
                || wrap_angle(other.heading - at.heading).abs() > MIN_SEPARATION.1
        };
        if chosen.iter().all(is_apart) {
            chosen.push(*candidate);
        }
    }
    chosen
}
