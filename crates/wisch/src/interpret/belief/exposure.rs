//! Exposure of places to the tool during a log: f′ at a place, and the travel in contact over which
//! the tool touched it.

use super::activation::{DrawClock, TravelClock};
use super::parameter_sampling::{MemberParameters, scatter};
use super::push_hypotheses::ContactEvidence;
use super::replay::Replay;
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{PressureDistribution, ToolOnBend};
use crate::interpret::uncertainty::Uncertainty;
use crate::represent::{EffectModel, ParticleDistribution, ParticleField};

/// One touch of a particle that stays in place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParticleTouch {
    /// Travel of the tool in contact at the beginning and at the end of the touch \[m\].
    pub travel: [f64; 2],
    /// Largest f′ (9), the normalised force, at the particle during the touch \[1\].
    pub share: f64,
}

/// The touches of one particle during a log, on condition that it stays in place.
///
/// ```
/// use wisch::interpret::{Exposure, ParticleTouch};
/// let touch = |begin: f64, share| ParticleTouch { travel: [begin, begin + 0.01], share };
/// // 3 cm under the tool, then 1 m away from it, then under it again.
/// let exposure = Exposure::new(vec![touch(0.0, 0.4), touch(0.01, 0.6), touch(0.02, 0.5), touch(1.03, 0.9)]);
/// assert_eq!(exposure.draws(0.02), [0.6, 0.5, 0.9]);
/// assert_eq!(exposure.draws(0.5), [0.6, 0.9]);
/// assert_eq!(exposure.max_share(), 0.9);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Exposure {
    touches: Vec<ParticleTouch>,
}

impl Exposure {
    /// Returns an exposure; `touches` are sorted by travel.
    pub fn new(touches: Vec<ParticleTouch>) -> Self {
        Self { touches }
    }

    /// Whether the tool touched the particle at all.
    pub fn is_touched(&self) -> bool {
        !self.touches.is_empty()
    }

    /// Returns the largest f′ met by each threshold that the particle draws, if it draws again after every
    /// `redraw_length` ℓ of travel \[m\]. The particle has stayed if each of its thresholds was higher.
    pub fn draws(&self, redraw_length: f64) -> Vec<f64> {
        let mut clock = DrawClock::NEVER;
        let mut draws: Vec<f64> = Vec::new();
        for touch in &self.touches {
            let is_new = clock.touch(touch.travel, redraw_length);
            match draws.last_mut() {
                Some(most) if !is_new => *most = most.max(touch.share),
                _ => draws.push(touch.share),
            }
        }
        draws
    }

    /// Largest f′ of all touches \[1\]: a particle that keeps one threshold has stayed if that threshold is higher.
    pub fn max_share(&self) -> f64 {
        self.touches
            .iter()
            .map(|touch| touch.share)
            .fold(0.0, f64::max)
    }
}

impl Replay<'_> {
    /// Returns the exposure of each particle, with one entry per guess. Each guess draws the particle's place, the
    /// grasp of the tool and the hypothesis about each push. `deviation`: standard deviation of a place along x and
    /// along y [m].
    pub(in crate::interpret) fn exposures(
        &self,
        particles: &ParticleDistribution,
        evidence: &ContactEvidence<'_>,
        deviation: f64,
        guesses: usize,
    ) -> Vec<Vec<Exposure>> {
        // The error of the force scale is left out: it is the same for the whole log.
        let config = InterpretConfig {
            uncertainty: Uncertainty {
                force_share: 0.0,
                ..self.config.uncertainty
            },
            ..self.config.clone()
        };
        let mut exposures = vec![vec![Exposure::default(); guesses]; particles.len()];
        (0..guesses).for_each(|guess| {
            let parameters = MemberParameters::draw(&config, guess as u64);
            let there = scatter(
                particles,
                self.surface,
                deviation,
                config.seed,
                guess as u64,
            );
            let mut field = ParticleField::new(&there);
            let compression = parameters.compression(&config, self.stiffness);
            let footprint = self.footprint.scale(parameters.footprint_scale);
            let mut model = EffectModel::new(&footprint, self.effect);
            let bounds = footprint.bounds();
            let on_bend = ToolOnBend::new(self.surface, &footprint, compression, &config);
            let mut clock = TravelClock::default();
            for contact in evidence
                .motions(guess as u64, compression, parameters.misread)
                .iter()
            {
                let contact = parameters.apply(contact, self.force_ratio);
                let travel = clock.advance(&contact);
                let on_bend = on_bend.as_ref();
                let pressure = PressureDistribution::of(&contact, bounds, compression, on_bend);
                model.set_pressure((pressure.as_ref()).and_then(PressureDistribution::of_part));
                let mean = contact.force.value();
                let most = (pressure.as_ref()).map_or(mean, PressureDistribution::most);
                if most <= 0.0 {
                    continue;
                }
                let motion = &contact.motion;
                model.apply_where(&mut field, self.surface, motion, |particle, position| {
                    let share = (pressure.as_ref()).map_or(mean, |p| p.share(position));
                    exposures[particle][guess]
                        .touches
                        .push(ParticleTouch { travel, share });
                    false
                });
            }
        });
        exposures
    }
}
