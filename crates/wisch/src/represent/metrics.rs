//! Task performance: which share of the particles is where the action wants them; (4), (5), (6).

use super::{Action, Fate, ParticleDistribution, Surface};
use crate::geometry::Point2;

/// What the particles are measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GoalState {
    /// Every particle deleted (4).
    Absorbed,
    /// Every particle within `radius` of `center` (5).
    Collected {
        /// n_goal in the surface frame [m].
        center: Point2,
        /// r_s [m].
        radius: f64,
    },
    /// Every particle off the surface, over an edge where that is allowed (6).
    Skimmed,
    /// Every place passed so often.
    Polished {
        /// Passes, counted whole: the nearest number to what was slid.
        passes: u32,
    },
    /// Every place so thick, within [`THICKNESS_TOLERANCE`].
    Emitted {
        /// Wanted [m].
        thickness: f64,
        /// What one pass leaves [m].
        per_pass: f64,
    },
}

/// By how much of the wanted thickness a coat may be off [1].
pub const THICKNESS_TOLERANCE: f64 = 0.2;
/// What is slid of a pass from which on it counts as one [1].
const COUNTED_PASS: f64 = 0.5;

impl GoalState {
    /// The action that strives for this state.
    pub fn action(&self) -> Action {
        match self {
            Self::Absorbed => Action::Absorb,
            Self::Collected { .. } => Action::Collect,
            Self::Skimmed => Action::Skim,
            Self::Polished { .. } => Action::Polish,
            Self::Emitted { .. } => Action::Emit,
        }
    }

    /// How many whole passes a place that has so many still needs: 0 where it is done.
    pub fn missing_passes(&self, passes: f64) -> u32 {
        let wanted = match *self {
            Self::Polished { passes } => f64::from(passes),
            Self::Emitted {
                thickness,
                per_pass,
            } => thickness / per_pass,
            Self::Absorbed | Self::Collected { .. } | Self::Skimmed => 0.0,
        };
        (wanted - passes).round().max(0.0) as u32
    }

    /// Whether nothing brings a particle back that does not meet the goal: it is over a wrong edge, or under too thick a coat.
    pub fn is_lost(&self, fate: Fate) -> bool {
        match (self, fate) {
            (_, Fate::OffSurface { .. }) => true,
            (
                Self::Emitted {
                    thickness,
                    per_pass,
                },
                Fate::Treated { passes },
            ) => passes * per_pass > *thickness,
            _ => false,
        }
    }

    /// Whether one particle is where the goal wants it.
    pub fn is_met_by(&self, position: Point2, fate: Fate, surface: &Surface) -> bool {
        match (self, fate) {
            (Self::Absorbed, Fate::Absorbed) => true,
            (Self::Collected { center, radius }, Fate::OnSurface) => {
                (position - center).norm() <= *radius
            }
            (Self::Skimmed, Fate::OffSurface { edge }) => surface.is_skim_edge(usize::from(edge)),
            (Self::Polished { passes: wanted }, Fate::Treated { passes }) => {
                passes + COUNTED_PASS >= f64::from(*wanted)
            }
            (
                Self::Emitted {
                    thickness,
                    per_pass,
                },
                Fate::Treated { passes },
            ) => (passes * per_pass - thickness).abs() <= THICKNESS_TOLERANCE * thickness,
            _ => false,
        }
    }
}

/// How well a distribution meets a goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Performance {
    /// Particles there were at the beginning.
    pub initial: usize,
    /// Particles where the goal wants them.
    pub achieved: usize,
    /// Particles pushed over an edge over which they should not go, and places under too thick a coat.
    pub lost: usize,
}

impl Performance {
    /// Counts the particles against the goal.
    pub fn of(particles: &ParticleDistribution, goal: &GoalState, surface: &Surface) -> Self {
        let mut performance = Self {
            initial: particles.len(),
            ..Self::default()
        };
        for (position, fate) in particles.iter() {
            if goal.is_met_by(position, fate, surface) {
                performance.achieved += 1;
            } else if goal.is_lost(fate) {
                performance.lost += 1;
            }
        }
        performance
    }

    /// Achieved share in [0, 1]; 1 where there was nothing to do.
    pub fn ratio(&self) -> f64 {
        if self.initial == 0 {
            1.0
        } else {
            self.achieved as f64 / self.initial as f64
        }
    }
}
