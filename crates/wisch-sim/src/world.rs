//! The simulated world that lasts over the rounds of a session.

use crate::camera::{ObservationIndex, observe};
use crate::{Dirt, GroundTruth, SimulationError, SimulationSettings, WorkSurface, execute};
use wisch::control::ControlConfig;
use wisch::geometry::Pose;
use wisch::represent::{
    GoalState, Observation, ParticleDistribution, ParticleError, Performance, Surface, Task,
};
use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, SampleSink};

/// A simulated world with its own surface, dirt and pushes, which lasts over the rounds of a
/// session.
///
/// It executes every motion on the dirt that the previous motion left.
#[derive(Debug, Clone)]
pub struct World {
    settings: SimulationSettings,
    world_from_real: Pose,
    /// The dirt before the first round.
    dirt: Dirt,
    truth: Vec<GroundTruth>,
    /// Seed of the dirt and of the camera's detections.
    seed: u64,
    /// Number of observations since the last round.
    looks: u64,
}

impl World {
    /// Creates a world on `surface`, with dirt drawn from `settings` and `seed`. The world does not
    /// depend on a task.
    ///
    /// # Errors
    /// If the dirt that the settings describe does not fit on the surface.
    pub fn new(
        surface: &WorkSurface,
        settings: SimulationSettings,
        seed: u64,
    ) -> Result<Self, SimulationError> {
        Ok(Self {
            world_from_real: surface.world_from_surface * settings.believed_from_real,
            dirt: Dirt::draw(surface, &settings, seed)?,
            settings,
            seed,
            looks: 0,
            truth: Vec::new(),
        })
    }

    /// The dirt before the first round: ground truth, for evaluations and reports.
    pub const fn dirt(&self) -> &Dirt {
        &self.dirt
    }

    /// Returns the same world after earlier rounds, given their ground truth in order.
    #[must_use]
    pub fn with_history(self, truth: Vec<GroundTruth>) -> Self {
        Self { truth, ..self }
    }

    /// Ground truth of every round, in order. For evaluations and reports only: a real robot has none.
    pub fn truth(&self) -> &[GroundTruth] {
        &self.truth
    }
}

impl Executor for World {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let believed = order.task.surface.world_from_surface;
        let settings = SimulationSettings {
            believed_from_real: believed.inverse() * self.world_from_real,
            ..self.settings.clone()
        };
        let dirt = self.truth.last().map_or(&self.dirt, |truth| &truth.dirt);
        let (execution, truth) = execute(order, &settings, dirt, &ControlConfig::default(), sink)
            .map_err(ExecutorError::new)?;
        self.truth.push(truth);
        self.looks = 0;
        Ok(execution)
    }

    fn observe(&mut self, task: &Task) -> Result<Option<Observation>, ExecutorError> {
        // Too much dirt is not simulated at all. A camera in this world would wrongly report a clean surface.
        if self.dirt.grains().is_empty() {
            return Ok(None);
        }
        let index = ObservationIndex {
            seed: self.seed,
            rounds: self.truth.len() as u64,
            number: self.looks,
        };
        self.looks += 1;
        let (dirt, hidden): (_, &[_]) = match self.truth.last() {
            Some(truth) => (&truth.dirt, &truth.hidden),
            None => (&self.dirt, &[]),
        };
        let real = Surface {
            world_from_surface: self.world_from_real,
            shape: (self.settings.shape.as_ref())
                .unwrap_or(&task.surface.shape)
                .clone(),
            ..task.surface.clone()
        };
        let settings = &self.settings;
        Ok(observe(settings, task, &real, dirt, hidden, index))
    }
}

impl GroundTruth {
    /// The particles after the execution; `None` if no dirt was simulated.
    ///
    /// # Errors
    /// If a particle position is not finite, which would be a fault of the simulation.
    pub fn particles(&self) -> Result<Option<ParticleDistribution>, ParticleError> {
        let is_clean = self.dirt.grains().is_empty();
        (!is_clean).then(|| self.dirt.particles()).transpose()
    }

    /// The true performance after the execution \[1\]; `None` if no dirt was simulated.
    ///
    /// # Errors
    /// Those of [`Self::particles`].
    pub fn performance(
        &self,
        goal: &GoalState,
        surface: &Surface,
    ) -> Result<Option<f64>, ParticleError> {
        let particles = self.particles()?;
        Ok(particles.map(|particles| Performance::evaluate(&particles, goal, surface).ratio()))
    }
}
