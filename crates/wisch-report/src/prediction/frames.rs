//! Frames of a predicted effect over time.

use wisch::geometry::{PlanarPose, Point2};
use wisch::plan::{Plan, PredictionProgress};
use wisch::represent::{Fate, GoalState, ParticleDistribution, Performance, Surface, Task};

/// Maximum number of frames of a prediction, including first and last.
pub const MAX_FRAMES: usize = 80;
/// Maximum number of particles in a frame; with more particles, every n-th is kept.
pub const MAX_DRAWN: usize = 5_000;

/// The state of the particles at one time of a prediction.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Distance travelled in contact so far \[m\].
    pub distance: f64,
    /// Pose of the tool in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Index of the stroke; `None` before the first.
    pub stroke: Option<usize>,
    /// Every n-th particle, see [`EffectFrames::thinning`]: position in the surface frame \[m\] and fate.
    pub particles: Vec<(Point2, Fate)>,
    /// Performance over all particles, including those that the frame leaves out.
    pub performance: Performance,
}

/// A recorder of a prediction that keeps at most `MAX_FRAMES` frames, evenly distributed over the motions.
///
/// ```ignore
/// let mut frames = EffectFrames::new(&task, &plan);
/// let prediction = predict(&task, &plan, |progress| frames.record(progress));
/// ```
#[derive(Debug, Clone)]
pub struct EffectFrames {
    surface: Surface,
    goal: GoalState,
    frames: Vec<Frame>,
    thinning: usize,
    motions: usize,
    seen: usize,
}

impl EffectFrames {
    /// Makes a recorder that holds the particles before the first stroke.
    pub fn new(task: &Task, plan: &Plan) -> Self {
        let heading = plan
            .tcp_path()
            .first()
            .map_or(0.0, |corner| corner.surface_from_tool.heading);
        let mut frames = Self {
            surface: task.surface.clone(),
            goal: plan.graph.goal,
            frames: Vec::new(),
            thinning: thinning(task.particles.len(), MAX_DRAWN),
            motions: plan.strokes.iter().map(|s| s.motions().count()).sum(),
            seen: 0,
        };
        frames.keep(
            0.0,
            PlanarPose::new(plan.tool_start, heading),
            None,
            &task.particles,
        );
        frames
    }

    /// Records the result of one motion.
    pub fn record(&mut self, progress: &PredictionProgress) {
        // Motion n of N is kept if n * MAX_FRAMES / N passes a whole number, so the last one is always kept.
        let gaps = MAX_FRAMES - 1;
        let due = |seen: usize| seen * gaps / self.motions.max(gaps);
        self.seen += 1;
        if self.motions <= gaps || due(self.seen) > due(self.seen - 1) {
            self.keep(
                progress.distance,
                progress.surface_from_tool,
                Some(progress.stroke),
                &progress.field.distribution(),
            );
        }
    }

    /// Returns the frames in order of time.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// Returns the thinning factor n: every n-th particle is kept; 1 keeps all.
    pub fn thinning(&self) -> usize {
        self.thinning
    }

    fn keep(
        &mut self,
        distance: f64,
        surface_from_tool: PlanarPose,
        stroke: Option<usize>,
        particles: &ParticleDistribution,
    ) {
        self.frames.push(Frame {
            distance,
            surface_from_tool,
            stroke,
            particles: particles.iter().step_by(self.thinning).collect(),
            performance: Performance::evaluate(particles, &self.goal, &self.surface),
        });
    }
}

/// Returns the smallest step that selects at most `most` out of `count`.
pub(crate) fn thinning(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
}
