//! The effect of a path: replayed many times through the one effect model, with random thresholds (12).
//!
//! A particle responds to a contact if its threshold X ~ LogNormal(μ, σ) is at most f′ at its place under
//! the tool. It draws X when its contact begins, and again after every ℓ of travel in contact, so that the
//! sampling rate of the log does not matter. X ≤ f′ is the same as U ≤ P(X ≤ f′) with U uniform in (0, 1): U is
//! what is drawn.

use super::activation::Activation;
use super::ensemble::{Belief, MemberState};
use super::parameter_sampling::{MemberParameters, scattered, slip};
use super::push_hypotheses::ContactEvidence;
use crate::geometry::Region;
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{ContactMotion, PressureDistribution, StiffnessBelief};
use crate::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, Surface};
use rayon::prelude::*;

/// Everything a replay needs but the particles.
#[derive(Debug)]
pub(in crate::interpret) struct Replay<'a> {
    pub(in crate::interpret) footprint: &'a Region,
    pub(in crate::interpret) effect: Effect,
    pub(in crate::interpret) surface: &'a Surface,
    pub(in crate::interpret) config: &'a InterpretConfig,
    pub(in crate::interpret) stiffness: StiffnessBelief,
}

impl Replay<'_> {
    /// The belief after these motions.
    ///
    /// Certainty becomes as many members as the settings say; members of an ensemble draw their parameters with the first
    /// log, and keep them.
    pub(in crate::interpret) fn run(
        &self,
        believed: &Belief,
        evidence: &ContactEvidence<'_>,
    ) -> Belief {
        let before = believed.replays();
        let (count, weights) = if believed.is_certain() {
            let count = self.config.replays;
            (count, vec![1.0 / count as f64; count])
        } else {
            (before.len(), believed.weights().to_vec())
        };
        let deviation = self.config.uncertainty.particle_m;
        let members = (0..count).into_par_iter().map(|member| {
            let dirt = &before[member % before.len()];
            let mut state = match believed.states.get(member) {
                Some(state) => state.clone(),
                None => self.first_state(dirt.len(), member as u64),
            };
            let compression = state.parameters.compression(self.config, self.stiffness);
            let motions = &evidence.motions(member as u64, compression);
            // Members of an ensemble already differ in where their particles lie, and places of the surface lie where they do.
            let is_scattered = believed.is_certain() && self.effect != Effect::Treat;
            let scattered = is_scattered.then(|| {
                scattered(
                    dirt,
                    self.surface,
                    deviation,
                    self.config.seed,
                    member as u64,
                )
            });
            let slip = match self.effect {
                Effect::Push => slip(self.config, member as u64),
                Effect::Absorb | Effect::Treat => 0.0,
            };
            state.activation.begin_log(slip);
            let after = self.once(scattered.as_ref().unwrap_or(dirt), motions, &mut state);
            (after, state)
        });
        Belief::continued(members.collect(), weights, self.stiffness)
    }

    fn first_state(&self, particles: usize, member: u64) -> MemberState {
        let parameters = MemberParameters::draw(self.config, member);
        let is_kept = parameters.is_kept;
        MemberState {
            activation: Activation::new(self.config.seed, member, particles, is_kept),
            parameters,
        }
    }

    fn once(
        &self,
        particles: &ParticleDistribution,
        motions: &[ContactMotion],
        state: &mut MemberState,
    ) -> ParticleDistribution {
        let MemberState {
            parameters,
            activation,
        } = state;
        let compression = parameters.compression(self.config, self.stiffness);
        let footprint = self.footprint.scaled(parameters.footprint_scale);
        let mut model = EffectModel::new(&footprint, self.effect);
        if self.effect == Effect::Push {
            let heap_depth = parameters.heap * self.config.redraw_length_m;
            model = model.with_heap(heap_depth, activation.key);
        }
        let mut field = ParticleField::new(particles);
        let bounds = footprint.bounds();
        let likelihood = &parameters.likelihood;
        for contact in motions {
            let contact = parameters.applied(contact);
            if !contact.continues {
                model.lift_off(&mut field, self.surface);
            }
            activation.advance(&contact);
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
                activation.responds(particle, probability, parameters.redraw_length)
            });
        }
        model.lift_off(&mut field, self.surface);
        field.distribution()
    }
}
