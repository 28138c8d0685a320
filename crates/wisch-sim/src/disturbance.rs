//! Disturbances of a simulated execution: pushes and changes of the friction.

use std::fmt;
use wisch::follow::Followed;
use wisch::geometry::Vector3;

/// An instant of a round's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Moment {
    /// Time since the start of the motion \[s\].
    Seconds(f64),
    /// Time at which this share of the motion's duration has passed, in [0, 1].
    Share(f64),
    /// Middle of the time of this stroke, counted from 1.
    Stroke(usize),
}

impl Moment {
    /// Returns the time from the start of the motion \[s\]; `None` if the motion ends before it.
    pub fn time(self, followed: &Followed) -> Option<f64> {
        let duration = followed.duration();
        match self {
            Self::Seconds(time) => (time < duration).then_some(time),
            Self::Share(share) => (share < 1.0).then_some(share * duration),
            Self::Stroke(number) => {
                let motions = followed.motions.iter();
                let mut wipes =
                    motions.filter(|motion| motion.phase.stroke() == number.checked_sub(1));
                let first = wipes.next()?;
                let end = wipes.next_back().unwrap_or(first).end();
                Some(f64::midpoint(first.start, end))
            }
        }
    }
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Seconds(time) => write!(f, "{time:.1} s"),
            Self::Share(share) => write!(f, "{share} of the motion"),
            Self::Stroke(number) => write!(f, "stroke {number}"),
        }
    }
}

/// A push of the tool by a person's hand.
///
/// The hand exerts its full force on a tool at rest. The force falls linearly with the tool's speed and vanishes at the
/// speed of the hand, as muscles do, so that a compliant robot is guided away rather than thrown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// Number of the round, from 1.
    pub round: usize,
    /// Start of the push.
    pub start: Moment,
    /// Duration \[s\].
    pub duration: f64,
    /// The force on a tool at rest, in the axes of the world \[N\].
    pub force: Vector3,
    /// Speed of the hand [m/s].
    pub hand_speed: f64,
}

/// A change of the friction between tool and surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionChange {
    /// Number of the round, from 1.
    pub round: usize,
    /// Start of the change.
    pub start: Moment,
    /// Coulomb coefficient \[1\].
    pub friction: f64,
}
