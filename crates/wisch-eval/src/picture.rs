//! Data of a picture of a wiped surface, small enough to be stored with the results.

use serde::{Deserialize, Serialize};
use wisch::geometry::Point2;
use wisch::plan::Plan;
use wisch::represent::{Fate, ParticleDistribution, Task};
use wisch_io::GoalRecord;

/// Resolution of stored positions: a tenth of a millimetre [1/m].
const PER_METRE: f64 = 1e4;

/// Particles before and after wiping, and strokes, in the surface frame \[m\].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// The goal.
    pub goal: GoalRecord,
    /// Radius of the collision sphere \[m\].
    pub collision_radius_m: f64,
    /// Path of the tool centre point for each stroke.
    pub strokes: Vec<Vec<[f64; 2]>>,
    /// Particles before wiping.
    pub before: Vec<[f64; 2]>,
    /// Particles that have not reached the goal.
    pub left: Vec<[f64; 2]>,
    /// Particles that have reached the goal.
    pub done: Vec<[f64; 2]>,
    /// Particles lost over an edge that is not a skim edge.
    pub lost: Vec<[f64; 2]>,
}

impl Picture {
    /// Collects the data of a plan and its effect. `wiped`: the plan; `before`, `after`: the particles before and after it.
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
                        .map(|pose| to_coordinates(pose.position))
                        .collect()
                })
                .collect(),
            before: before.remaining().map(to_coordinates).collect(),
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
            kind.push(to_coordinates(position));
        }
        picture
    }
}

fn to_coordinates(at: Point2) -> [f64; 2] {
    [at.x, at.y].map(|coordinate| (coordinate * PER_METRE).round() / PER_METRE)
}
