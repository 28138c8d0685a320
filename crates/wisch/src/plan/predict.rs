//! Prediction: the effect of a plan's strokes by the effect model; paper §3.4, Fig. 7.

use super::Plan;
use super::nominal_times::NominalTimes;
use super::score::DirtTerms;
use crate::geometry::PlanarPose;
use crate::represent::{ParticleDistribution, ParticleField, Performance, Task};

/// The predicted result of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// The particles after the plan.
    pub particles: ParticleDistribution,
    /// Performance with respect to the plan's goal.
    pub performance: Performance,
}

impl Prediction {
    /// The share of the dirt that the plan brings where it belongs, minus three times the share
    /// that it loses \[1\]; from 1 down to −3.
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
///
/// ```
/// # use wisch::prelude::*;
/// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// # let surface = Surface::new("tray", outline, Pose::translation(0.5, 0.0, 0.8));
/// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
/// # let crumbs = ParticleDistribution::new(&[Point2::new(-0.1, 0.05), Point2::new(0.12, 0.1)])?;
/// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
/// // A task with two crumbs on a tray.
/// let plan = wisch::plan::plan(&task, &PlanConfig::default())?;
/// let prediction = wisch::plan::predict(&task, &plan, |_| ());
/// assert_eq!(prediction.performance.achieved, 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn predict(task: &Task, plan: &Plan, mut watch: impl FnMut(&PredictionProgress)) -> Prediction {
    let mut field = ParticleField::new(&task.particles);
    let mut model = task.effect_model(&task.tool.footprint, plan.graph.goal.action().effect());
    let mut distance = 0.0;
    let times = NominalTimes::of(task);
    let before = times.before(plan);
    for (stroke, motions) in plan.strokes.iter().map(super::Stroke::motions).enumerate() {
        model.wait(&mut field, &task.surface, before[stroke]);
        for motion in motions {
            for (part, time) in times.parts(&motion) {
                model.apply(&mut field, &task.surface, &part);
                model.wait(&mut field, &task.surface, time);
            }
            distance += motion.travel().1;
            watch(&PredictionProgress {
                distance,
                surface_from_tool: motion.to,
                stroke,
                field: &field,
            });
        }
        model.lift_off(&mut field, &task.surface);
    }
    let particles = field.distribution();
    let performance = Performance::evaluate(&particles, &plan.graph.goal, &task.surface);
    Prediction {
        particles,
        performance,
    }
}
