//! Task performance: the share of the particles that meet the goal of the action; (4), (5), (6).

use super::{Action, Fate, ParticleDistribution, Surface};
use crate::geometry::Point2;

/// Goal of a task, against which the particles are measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GoalState {
    /// Every particle deleted (4).
    Absorbed,
    /// Every particle within `radius` of `center` (5).
    Collected {
        /// n_goal in the surface frame \[m\].
        center: Point2,
        /// r_s \[m\].
        radius: f64,
    },
    /// Every particle off the surface, over permitted edges only (6).
    Skimmed,
    /// Every place passed this many times.
    Polished {
        /// Passes over each place; measured passes are rounded.
        passes: u32,
    },
    /// Every place coated to this thickness, within [`THICKNESS_TOLERANCE`].
    Dispensed {
        /// Target thickness \[m\].
        thickness: f64,
        /// Thickness that one pass leaves \[m\].
        per_pass: f64,
    },
}

/// Tolerance of a coat as a share of the target thickness \[1\].
pub const THICKNESS_TOLERANCE: f64 = 0.2;
/// Share of a pass above which it counts as a whole pass [1].
const COUNTED_PASS: f64 = 0.5;

impl GoalState {
    /// The wiping action that reaches this goal.
    pub fn action(&self) -> Action {
        match self {
            Self::Absorbed => Action::Absorb,
            Self::Collected { .. } => Action::Collect,
            Self::Skimmed => Action::Skim,
            Self::Polished { .. } => Action::Polish,
            Self::Dispensed { .. } => Action::Dispense,
        }
    }

    /// Its name in files: the predicate of PDDL goals, such as "absorbed".
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Absorbed => "absorbed",
            Self::Collected { .. } => "collected",
            Self::Skimmed => "skimmed",
            Self::Polished { .. } => "polished",
            Self::Dispensed { .. } => "dispensed",
        }
    }

    /// Returns the number of whole passes that a place with `passes` passes still needs; 0 if it is done.
    pub fn missing_passes(&self, passes: f64) -> u32 {
        let wanted = match *self {
            Self::Polished { passes } => f64::from(passes),
            Self::Dispensed {
                thickness,
                per_pass,
            } => thickness / per_pass,
            Self::Absorbed | Self::Collected { .. } | Self::Skimmed => 0.0,
        };
        (wanted - passes).round().max(0.0) as u32
    }

    /// Whether a particle can never meet the goal: it went over a wrong edge, or its coat is too
    /// thick. Dirt that fell by its own weight is not lost, because no tool moved it.
    pub fn is_lost(&self, fate: Fate) -> bool {
        match (self, fate) {
            (_, Fate::OffSurface { .. }) => fate != Fate::FALLEN,
            (
                Self::Dispensed {
                    thickness,
                    per_pass,
                },
                Fate::Treated { passes },
            ) => passes * per_pass > *thickness,
            _ => false,
        }
    }

    /// Whether a particle meets the goal; `position` in the surface frame \[m\].
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
                Self::Dispensed {
                    thickness,
                    per_pass,
                },
                Fate::Treated { passes },
            ) => (passes * per_pass - thickness).abs() <= THICKNESS_TOLERANCE * thickness,
            _ => false,
        }
    }
}

/// Counts of particles that meet or miss a goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Performance {
    /// Number of particles in all.
    pub initial: usize,
    /// Number of particles that meet the goal.
    pub achieved: usize,
    /// Number of particles pushed over a wrong edge, or of places with too thick a coat.
    pub lost: usize,
}

impl Performance {
    /// Counts the particles against the goal.
    ///
    /// ```
    /// use wisch::prelude::*;
    /// use wisch::represent::{Fate, GoalState, Performance};
    /// let surface = Surface::new("tray", Polygon::rectangle(Vector2::new(0.4, 0.3)), Pose::identity());
    /// let fates = [(Point2::new(0.1, 0.0), Fate::Absorbed), (Point2::new(-0.1, 0.0), Fate::OnSurface)];
    /// let particles = ParticleDistribution::with_fates(&fates)?;
    /// let performance = Performance::evaluate(&particles, &GoalState::Absorbed, &surface);
    /// assert_eq!(performance.ratio(), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluate(particles: &ParticleDistribution, goal: &GoalState, surface: &Surface) -> Self {
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

    /// Achieved share in [0, 1]; 1 if there are no particles.
    pub fn ratio(&self) -> f64 {
        if self.initial == 0 {
            1.0
        } else {
            self.achieved as f64 / self.initial as f64
        }
    }
}
