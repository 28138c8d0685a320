//! What a simulated execution takes for real, and neither the plan nor the interpretation is told.

use super::{GrainSize, LogNormal, MediumKind};
use crate::geometry::{Pose, Vector3};

/// A hand that pushes the tool.
///
/// It pushes with its full force against a tool at rest, and the less the faster the tool already gives
/// way, none at the speed of the hand: as muscles do, and so that a robot that yields is led away rather
/// than thrown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// In which round of the task, from 1.
    pub round: usize,
    /// When it begins [s].
    pub start: f64,
    /// How long it lasts [s].
    pub duration: f64,
    /// The force on a tool at rest, in the axes of the world [N].
    pub force: Vector3,
    /// Speed of the hand [m/s].
    pub hand_speed: f64,
}

/// The friction between tool and surface from some time on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionChange {
    /// In which round of the task, from 1.
    pub round: usize,
    /// From when on [s].
    pub time: f64,
    /// Coulomb coefficient [1].
    pub friction: f64,
}

/// The world as it is: where the surface really is, how rough it is, who pushes, how bad the sensors
/// are, and how hard the dirt is to wipe.
#[derive(Debug, Clone, PartialEq)]
pub struct Reality {
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
