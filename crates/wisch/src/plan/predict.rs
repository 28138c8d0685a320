//! Prediction: the effect of a plan's strokes by the effect model; paper §3.4, Fig. 7.

use super::Plan;
use super::score::DirtTerms;
use crate::geometry::PlanarPose;
use crate::represent::{EffectModel, ParticleDistribution, ParticleField, Performance, Task};

/// The predicted result of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// The particles after the plan.
    pub particles: ParticleDistribution,
    /// Performance with respect to the plan's goal.
    pub performance: Performance,
}

impl Prediction {
    /// The share of the dirt that the plan brings where it belongs, less three times the share that it loses
    /// \[1\]; from 1 down to −3.
    pub fn score(&self) -> f64 {
        DirtTerms::from(&self.performance).total() / self.performance.initial.max(1) as f64
    }
}

/// The state after one motion of a prediction.
#[derive(Debug, Clone, Copy)]
pub struct PredictionProgress<'a> {
    /// Distance travelled in contact so far \[m\].
    pub distance: f64,
    /// Pose of the tool in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Index of the stroke.
    pub stroke: usize,
    /// The particles at this moment.
    pub field: &'a ParticleField,
}

/// Simulates the strokes of a plan with the effect model. `watch` is called after every motion; pass `|_| ()`
/// to ignore it.
pub fn predict(task: &Task, plan: &Plan, mut watch: impl FnMut(&PredictionProgress)) -> Prediction {
    let mut field = ParticleField::new(&task.particles);
    let mut model = EffectModel::new(&task.tool.footprint, plan.graph.goal.action().effect());
    let mut distance = 0.0;
    for (stroke, motions) in plan.strokes.iter().map(super::Stroke::motions).enumerate() {
        for motion in motions {
            model.apply(&mut field, &task.surface, &motion);
            distance += motion.travel().1;
            watch(&PredictionProgress {
                distance,
                surface_from_tool: motion.to,
                stroke,
                field: &field,
            });
        }
    }
    let particles = field.distribution();
    let performance = Performance::evaluate(&particles, &plan.graph.goal, &task.surface);
    Prediction {
        particles,
        performance,
    }
}
