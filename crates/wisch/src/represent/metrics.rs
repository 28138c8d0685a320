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
}

impl GoalState {
    /// The action that strives for this state.
    pub fn action(&self) -> Action {
        match self {
            Self::Absorbed => Action::Absorb,
            Self::Collected { .. } => Action::Collect,
            Self::Skimmed => Action::Skim,
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
    /// Particles pushed over an edge over which they should not go.
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
            } else if matches!(fate, Fate::OffSurface { .. }) {
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
