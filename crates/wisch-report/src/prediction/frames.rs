//! The effect over time, kept while a prediction runs.

use wisch::geometry::{PlanarPose, Point2};
use wisch::plan::{Plan, PredictionProgress};
use wisch::represent::{Fate, GoalState, ParticleDistribution, Performance, Surface, Task};

/// Most frames kept of one prediction, the beginning and the end included.
pub const MAX_FRAMES: usize = 80;
/// Most particles kept in a frame; of more, every n-th is kept.
pub const MAX_DRAWN: usize = 5_000;

/// One moment of a prediction.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Distance travelled in contact so far [m].
    pub distance: f64,
    /// Pose of the tool in the surface frame.
    pub surface_from_tool: PlanarPose,
    /// Index of the stroke; `None` before the first.
    pub stroke: Option<usize>,
    /// Every n-th particle, see [`EffectFrames::thinning`]: its place in the surface frame [m] and its fate.
    pub particles: Vec<(Point2, Fate)>,
    /// Of all particles, the thinned-out ones too.
    pub performance: Performance,
}

/// Watches a prediction and keeps at most `MAX_FRAMES` moments of it, evenly over the motions.
///
/// ```ignore
/// let mut frames = EffectFrames::new(&task, &plan);
/// let prediction = predict(&task, &plan, |progress| frames.watch(progress));
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
    /// Begins with the particles as they lie before the first stroke.
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

    /// Takes note of one motion's outcome.
    pub fn watch(&mut self, progress: &PredictionProgress) {
        // The n-th motion is kept where the share of motions seen passes a whole number of frames,
        // so that the last is always kept.
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

    /// The kept moments, in order of time.
    pub fn all(&self) -> &[Frame] {
        &self.frames
    }

    /// Every how many-th particle is kept; 1 keeps all.
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
            performance: Performance::of(particles, &self.goal, &self.surface),
        });
    }
}

/// The smallest step that takes at most `most` out of `count`.
pub(crate) fn thinning(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
}
