//! How the simulated world really is, which neither the plan nor the interpretation is told.

use wisch::follow::Followed;
use wisch::geometry::{Pose, Vector3};
use wisch::represent::{GrainSize, KnowledgeBase, KnowledgeError, LogNormal, MediumKind, Task};
use wisch_io::{ExecutionRecord, FrictionChange, Push};

/// Drops of a liquid on a surface that they wet [m].
const DROPS: GrainSize = GrainSize {
    min_m: 0.002,
    max_m: 0.004,
};
/// Smaller grains are simulated as ones of this diameter [m]: a contact of two smaller bodies is not
/// resolved at 1 kHz.
const LEAST_GRAIN: f64 = 0.0008;

/// The world as it is: where the surface really is, how rough it is, who pushes, how bad the sensors
/// are, and how hard the dirt is to wipe.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationSettings {
    /// Where the surface really is, in the frame of the believed one.
    pub believed_from_real: Pose,
    /// Coulomb coefficient between tool and surface at the start [1].
    pub friction: f64,
    /// Changes of it, in any order.
    pub friction_changes: Vec<FrictionChange>,
    /// Who pushes, in any order.
    pub pushes: Vec<Push>,
    /// Standard deviation of the measured force, per axis [N].
    pub force_noise: f64,
    /// What is always added to the measured force, in the axes of the world [N].
    pub force_bias: Vector3,
    /// Distribution of the normalised pressure from which on a grain is taken along. Each grain has its
    /// own, for good.
    pub likelihood: LogNormal,
    /// Diameters of the grains.
    pub grain_size: GrainSize,
    /// The nature of the medium.
    pub kind: MediumKind,
    /// Up to how many particles are real bodies; a task with more is executed without dirt.
    pub max_bodies: usize,
}

impl SimulationSettings {
    /// The world of a task: what the file's table `[execution]` says of it, over what the knowledge base says of
    /// surface and medium.
    ///
    /// # Errors
    /// If surface or medium of the task are unknown.
    pub fn of(
        record: &ExecutionRecord,
        task: &Task,
        knowledge: &KnowledgeBase,
    ) -> Result<Self, KnowledgeError> {
        let medium = knowledge.medium(&task.medium)?;
        let likelihood = task.interaction.likelihood;
        let grain_size = medium.grain_size.unwrap_or(DROPS);
        Ok(Self {
            believed_from_real: record.believed_from_real,
            friction: match record.friction {
                Some(friction) => friction,
                None => knowledge.surface(&task.surface.name)?.friction,
            },
            friction_changes: record.friction_changes.clone(),
            pushes: record.pushes.clone(),
            force_noise: record.force_noise,
            force_bias: record.force_bias,
            likelihood: LogNormal {
                mu: record.mu.unwrap_or(likelihood.mu),
                sigma: record.sigma.unwrap_or(likelihood.sigma),
            },
            grain_size: GrainSize {
                min_m: grain_size.min_m.max(LEAST_GRAIN),
                max_m: grain_size.max_m.max(LEAST_GRAIN),
            },
            kind: if medium.grain_size.is_none() {
                MediumKind::Liquid
            } else {
                medium.kind
            },
            max_bodies: record.max_bodies,
        })
    }

    /// What disturbs a round's motion, and when.
    pub fn schedule(&self, round: usize, followed: &Followed) -> Schedule {
        let mut schedule = Schedule::default();
        for push in self.pushes.iter().filter(|push| push.round == round) {
            match push.start.time(followed) {
                Some(start) => schedule.pushes.push((start, *push)),
                None => schedule.missed.push(format!("a push at {}", push.start)),
            }
        }
        let changes = self.friction_changes.iter();
        for change in changes.filter(|change| change.round == round) {
            match change.start.time(followed) {
                Some(start) => schedule.friction_changes.push((start, change.friction)),
                None => {
                    let text = format!("a change of friction at {}", change.start);
                    schedule.missed.push(text);
                }
            }
        }
        (schedule.friction_changes).sort_by(|a, b| a.0.total_cmp(&b.0));
        schedule
    }
}

/// What disturbs one motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Schedule {
    /// Pushes, each with its start [s].
    pub pushes: Vec<(f64, Push)>,
    /// From when on [s] which coefficient of friction [1], by time.
    pub friction_changes: Vec<(f64, f64)>,
    /// In words, what never happens because the motion ends before.
    pub missed: Vec<String>,
}
