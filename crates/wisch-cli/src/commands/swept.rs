//! The strokes of a command on a surface, and the dirt over which they pass.

use wisch::geometry::Point2;
use wisch::plan::{Plan, predict};
use wisch::represent::{GoalState, ParticleDistribution, ParticleError, Task};

/// The strokes of a command on a surface, and the dirt that lies there afterwards.
#[derive(Debug, Clone, Default)]
pub(super) struct SweptSurface {
    /// The plans of all rounds, each with its task.
    pub plans: Vec<(Task, Plan)>,
    /// Dirt that was collected, in the frame of the surface, estimated or else predicted [m].
    pub collected: Vec<Point2>,
}

/// Returns the places of particles that lie where a goal collects them; none for other goals.
pub(super) fn find_collected(particles: &ParticleDistribution, goal: GoalState) -> Vec<Point2> {
    let GoalState::Collected { center, radius } = goal else {
        return Vec::new();
    };
    let places = particles.remaining();
    places
        .filter(|place| (place - center).norm() <= radius)
        .collect()
}

impl SweptSurface {
    /// Returns the share of points on the surface over which the tool passes [1]; 0 without points.
    pub fn share_covered(&self, points: &[Point2]) -> Result<f64, ParticleError> {
        if points.is_empty() {
            return Ok(0.0);
        }
        let mut open = ParticleDistribution::new(points)?;
        for (task, plan) in &self.plans {
            let mut task = task.clone();
            task.particles = open;
            open = predict_absorbing(&task, plan).particles;
        }
        let left = open.remaining().count();
        Ok(1.0 - left as f64 / points.len() as f64)
    }
}

/// Returns the share of the particles that the tool passes over if they do not move [1].
pub(super) fn predict_covered_share(plan: &Plan, task: &Task) -> f64 {
    predict_absorbing(task, plan).performance.ratio()
}

fn predict_absorbing(task: &Task, plan: &Plan) -> wisch::plan::Prediction {
    let mut taken_up = plan.clone();
    taken_up.graph.goal = GoalState::Absorbed;
    predict(task, &taken_up, |_| ())
}
