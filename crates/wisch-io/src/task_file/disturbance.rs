//! What disturbs an execution, as a task file tells it.

use wisch::geometry::Vector3;

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
