//! What there is to see of a wiped surface, as data: small enough to be kept beside the figures.

use serde::{Deserialize, Serialize};
use wisch::geometry::Point2;
use wisch::plan::Plan;
use wisch::represent::{Fate, ParticleDistribution, Task};
use wisch_io::GoalRecord;

/// Places are kept to a tenth of a millimetre [1/m].
const PER_METRE: f64 = 1e4;

/// Particles before and after, and strokes, in the frame of the surface [m].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// What was to be reached.
    pub goal: GoalRecord,
    /// Radius of the collision sphere.
    pub collision_radius_m: f64,
    /// The way of the tool centre point, stroke by stroke.
    pub strokes: Vec<Vec<[f64; 2]>>,
    /// Where the particles lay.
    pub before: Vec<[f64; 2]>,
    /// Those that still lie where they should not.
    pub left: Vec<[f64; 2]>,
    /// Those that lie where they should.
    pub done: Vec<[f64; 2]>,
    /// Those that went over a wrong edge.
    pub lost: Vec<[f64; 2]>,
}

impl Picture {
    /// Of what a plan made of particles.
    pub(crate) fn new(
        task: &Task,
        wiped: &Plan,
        before: &ParticleDistribution,
        after: &ParticleDistribution,
    ) -> Self {
        let (goal, surface) = (wiped.graph.goal, &task.surface);
        let mut picture = Self {
            goal: goal.into(),
            collision_radius_m: wiped.collision_radius,
            strokes: (wiped.strokes.iter())
                .map(|stroke| {
                    stroke
                        .poses
                        .iter()
                        .map(|pose| place(pose.position))
                        .collect()
                })
                .collect(),
            before: before.remaining().map(place).collect(),
            left: Vec::new(),
            done: Vec::new(),
            lost: Vec::new(),
        };
        for (position, fate) in after.iter() {
            let kind = match fate {
                Fate::Absorbed => continue,
                _ if goal.is_met_by(position, fate, surface) => &mut picture.done,
                Fate::OffSurface { .. } => &mut picture.lost,
                Fate::OnSurface | Fate::Treated { .. } => &mut picture.left,
            };
            kind.push(place(position));
        }
        picture
    }
}

fn place(at: Point2) -> [f64; 2] {
    [at.x, at.y].map(|coordinate| (coordinate * PER_METRE).round() / PER_METRE)
}
