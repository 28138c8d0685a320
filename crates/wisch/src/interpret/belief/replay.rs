//! The effect of a path: replayed many times through the one effect model, with random thresholds (12).
//!
//! A particle responds to a contact if its threshold X ~ LogNormal(μ, σ) is at most f′ at its place under
//! the tool. It draws X when its contact begins, and again after every ℓ of travel in contact, so that the
//! sampling rate of the log does not matter. X ≤ f′ is the same as U ≤ P(X ≤ f′) with U uniform in (0, 1): U is
//! what is drawn.

use super::activation::Activation;
use super::ensemble::Belief;
use super::parameter_sampling::ParameterSample;
use super::push_hypotheses::ContactEvidence;
use crate::geometry::Region;
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{ContactMotion, PressureDistribution};
use crate::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, Surface};
use rayon::prelude::*;

/// Everything a replay needs but the particles.
#[derive(Debug)]
pub(in crate::interpret) struct Replay<'a> {
    pub(in crate::interpret) footprint: &'a Region,
    pub(in crate::interpret) effect: Effect,
    pub(in crate::interpret) surface: &'a Surface,
    pub(in crate::interpret) config: &'a InterpretConfig,
}

impl Replay<'_> {
    /// The belief after these motions.
    pub(in crate::interpret) fn run(
        &self,
        believed: &Belief,
        evidence: &ContactEvidence<'_>,
    ) -> Belief {
        let members = believed.replays();
        let is_certain = members.len() == 1;
        let count = if is_certain {
            self.config.replays
        } else {
            members.len()
        };
        let replays = (0..count)
            .into_par_iter()
            .map(|replay| {
                let seed = self.config.seed;
                let mut parameters =
                    ParameterSample::draw(&self.config.uncertainty, seed, replay as u64);
                let motions = &evidence.motions(replay as u64);
                let member = &members[replay % members.len()];
                if is_certain {
                    // Members of an ensemble already differ in where their particles lie.
                    let scattered = parameters.scattered(member, self.surface);
                    self.once(&scattered, motions, &parameters, replay as u64)
                } else {
                    self.once(member, motions, &parameters, replay as u64)
                }
            })
            .collect();
        Belief::ensemble(replays)
    }

    fn once(
        &self,
        particles: &ParticleDistribution,
        motions: &[ContactMotion],
        parameters: &ParameterSample,
        replay: u64,
    ) -> ParticleDistribution {
        let mut model = EffectModel::new(self.footprint, self.effect);
        let slip = match self.effect {
            Effect::Push => parameters.slip,
            Effect::Absorb => 0.0,
        };
        let mut activation = Activation::new(self.config.seed, replay, particles.len(), slip);
        if self.effect == Effect::Push {
            let heap_depth = parameters.heap * self.config.redraw_length_m;
            model = model.with_heap(heap_depth, activation.key);
        }
        let mut field = ParticleField::new(particles);
        let bounds = self.footprint.bounds();
        let likelihood = &self.config.likelihood;
        for contact in motions {
            let contact = parameters.applied(contact);
            if !contact.continues {
                model.lift_off(&mut field, self.surface);
            }
            activation.advance(&contact);
            let compression = self.config.nominal_compression();
            let pressure = PressureDistribution::of(&contact, bounds, compression);
            let most =
                (pressure.as_ref()).map_or(contact.force.value(), PressureDistribution::most);
            let largest = likelihood.probability(most);
            if largest <= 0.0 {
                continue;
            }
            let motion = &contact.motion;
            model.apply_where(&mut field, self.surface, motion, |particle, position| {
                let probability = (pressure.as_ref()).map_or(largest, |pressure| {
                    likelihood.probability(pressure.share(position))
                });
                activation.responds(particle, probability, self.config.redraw_length_m)
            });
        }
        model.lift_off(&mut field, self.surface);
        field.distribution()
    }
}
