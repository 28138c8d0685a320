//! Settings and stages of the setup.

use super::SetupError;

/// Settings of the searches for pairs of links and for the ready posture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetupConfig {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of random postures in which pairs of links are checked.
    pub pair_samples: usize,
    /// Number of random postures from which the search for a ready posture starts.
    pub posture_samples: usize,
    /// Distance below which a pair counts as able to collide, so that it stays checked \[m\].
    pub never_margin: f64,
    /// Least clearance of the ready posture \[m\]; less for near links and for links that are always close.
    pub ready_clearance: f64,
}

impl Default for SetupConfig {
    /// 10 000 postures for pairs, as many as MoveIt's Setup Assistant takes by default, and 10 000 for the ready
    /// posture. A pair that comes within 1 mm stays checked; the ready posture keeps 20 mm.
    fn default() -> Self {
        Self {
            seed: 0,
            pair_samples: 10_000,
            posture_samples: 10_000,
            never_margin: 1e-3,
            ready_clearance: 0.02,
        }
    }
}

/// Largest number of random postures of a search.
const MAX_SAMPLES: usize = 10_000_000;

impl SetupConfig {
    /// Checks that all numbers are in their ranges.
    ///
    /// # Errors
    /// The first field outside its range.
    pub(super) fn check(&self) -> Result<(), SetupError> {
        let most = MAX_SAMPLES as f64;
        for (field, value, lower, upper) in [
            ("pair_samples", self.pair_samples as f64, 1.0, most),
            ("posture_samples", self.posture_samples as f64, 1.0, most),
            ("never_margin", self.never_margin, 0.0, 1.0),
            ("ready_clearance", self.ready_clearance, 0.0, 1.0),
        ] {
            if !(lower..=upper).contains(&value) {
                return Err(SetupError::Setting {
                    field,
                    value,
                    lower,
                    upper,
                });
            }
        }
        Ok(())
    }
}

/// A part of the setup that takes time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SetupStage {
    /// Random postures, in which all pairs are measured.
    Pairs,
    /// Descents to the least distance of pairs that never collided.
    NearestPostures,
    /// Search for a ready posture.
    Ready,
}
