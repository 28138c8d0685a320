//! Pairs of bodies that are excluded from collision checks.

use super::super::{JointKind, LinkId, RobotModel};
use super::{BodyId, CollisionModel, with_scratch};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::f64::consts::PI;

/// Why a pair of bodies is excluded from collision checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AllowedReason {
    /// One body holds the other, and no link between them has shapes.
    Neighbours,
    /// The bodies overlap in at least 95 % of the postures within the limits.
    AlwaysColliding,
    /// The SRDF disables the pair.
    Disabled,
    /// [`CollisionModel::allow`] was called for the pair.
    Asked,
}

/// Number of postures in which pairs are checked for permanent overlap.
const POSTURES: usize = 1000;
/// Largest number of these postures in which a permanently overlapping pair may be apart: 5 %, as in MoveIt's setup
/// assistant.
const MAX_APART: usize = POSTURES / 20;
/// Largest number of postures that are drawn to get enough within the limits of followers.
const MAX_DRAWS: usize = 20 * POSTURES;
/// Range of a sliding joint without limits [m].
const UNLIMITED_SLIDE: f64 = 1.0;

/// Returns, for each link, itself if it has shapes, and the nearest links with shapes above and below it.
pub(super) fn neighbours(robot: &RobotModel) -> Vec<Vec<BodyId>> {
    let has_shapes = |link: usize| !robot.links()[link].collision.is_empty();
    let mut near = vec![Vec::new(); robot.links().len()];
    for link in 0..near.len() {
        if has_shapes(link) {
            near[link].push(BodyId(link));
        }
        for joint in robot.joints_above(LinkId(link)) {
            let holder = joint.parent.index();
            if has_shapes(link) {
                near[holder].push(BodyId(link));
            }
            if has_shapes(holder) {
                near[link].push(BodyId(holder));
                break;
            }
        }
    }
    near
}

impl CollisionModel {
    /// Allows two bodies to touch; the first reason is kept.
    pub(super) fn permit(&mut self, a: BodyId, b: BodyId, reason: AllowedReason) {
        if a != b {
            self.allowed.entry([a.min(b), a.max(b)]).or_insert(reason);
        }
    }

    pub(super) fn allow_neighbours(&mut self) {
        for link in 0..self.mounts.len() {
            let has_shapes = !self.bodies[link].solids.is_empty();
            for neighbour in self.neighbours[link].clone() {
                if has_shapes {
                    self.permit(BodyId(link), neighbour, AllowedReason::Neighbours);
                }
            }
        }
    }

    /// Allows pairs to touch that overlap in nearly all postures within the limits.
    pub(super) fn allow_always_colliding(&mut self, robot: &RobotModel) {
        let mut random = ChaCha8Rng::seed_from_u64(0);
        // Each pair with the number of postures in which it was apart.
        let mut candidates: Vec<([BodyId; 2], usize)> =
            self.pairs.iter().map(|&pair| (pair, 0)).collect();
        let mut postures = 0;
        for _ in 0..MAX_DRAWS {
            if postures == POSTURES || candidates.is_empty() {
                break;
            }
            let q = draw_posture(robot, &mut random);
            if robot
                .limit_faults(&q)
                .map_or(true, |faults| !faults.is_empty())
            {
                continue;
            }
            postures += 1;
            with_scratch(|scratch| {
                self.place(&q, scratch);
                for (pair, apart) in &mut candidates {
                    *apart += usize::from(self.distance(*pair, scratch, f64::MIN_POSITIVE) > 0.0);
                }
            });
            candidates.retain(|&(_, apart)| apart <= MAX_APART);
        }
        for ([a, b], apart) in candidates {
            if postures > 0 && apart * POSTURES <= postures * MAX_APART {
                self.permit(a, b, AllowedReason::AlwaysColliding);
            }
        }
        self.list_pairs();
    }
}

/// Draws a posture within the limits of the variables; unlimited ones within π or 1 m of 0.
pub(crate) fn draw_posture(robot: &RobotModel, random: &mut ChaCha8Rng) -> Vec<f64> {
    let position = |i: usize| {
        let joint = robot.variable(i);
        let (lower, upper) = match (joint.limits.position, joint.kind) {
            (Some(range), _) => (range.lower, range.upper),
            (None, JointKind::Revolute) => (-PI, PI),
            (None, _) => (-UNLIMITED_SLIDE, UNLIMITED_SLIDE),
        };
        lower + random.random::<f64>() * (upper - lower)
    };
    (0..robot.dof()).map(position).collect()
}
