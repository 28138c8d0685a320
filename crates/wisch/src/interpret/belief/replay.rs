//! Replays of a path through the effect model, with random thresholds (12).
//!
//! A particle responds to a contact if its threshold X ~ LogNormal(μ, σ) is at most f′ at its place under the tool. It
//! draws X when its contact begins and again after every ℓ of travel in contact, so the sampling rate of the log has no
//! influence. X ≤ f′ is equivalent to U ≤ P(X ≤ f′) with U uniform in (0, 1), and U is what is drawn.

use super::activation::Activation;
use super::ensemble::{Belief, MemberState};
use super::parameter_sampling::{MemberParameters, scatter, slip};
use super::push_hypotheses::ContactEvidence;
use crate::geometry::Region;
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{ContactMotion, PressureDistribution, StiffnessBelief, ToolOnBend};
use crate::represent::{
    DirtSlide, Effect, EffectModel, FilmFlow, GoalState, ParticleDistribution, ParticleField,
    Performance, Surface,
};
use rayon::prelude::*;

/// Longest time between two steps of a liquid film [s].
const FILM_STEP: f64 = 0.25;

/// Inputs of a replay except for the particles.
#[derive(Debug)]
pub(in crate::interpret) struct Replay<'a> {
    pub(in crate::interpret) footprint: &'a Region,
    pub(in crate::interpret) slide: Option<&'a DirtSlide>,
    pub(in crate::interpret) film: Option<&'a FilmFlow>,
    /// Times of the first and the last sample [s].
    pub(in crate::interpret) span: [f64; 2],
    pub(in crate::interpret) effect: Effect,
    pub(in crate::interpret) surface: &'a Surface,
    pub(in crate::interpret) config: &'a InterpretConfig,
    pub(in crate::interpret) stiffness: StiffnessBelief,
    /// Nominal force of the log over the declared one [1].
    pub(in crate::interpret) force_ratio: f64,
}

impl Replay<'_> {
    /// Returns the belief after the contact motions.
    ///
    /// A certain belief becomes an ensemble of as many members as the settings say. Members draw their parameters at
    /// the first log and keep them.
    pub(in crate::interpret) fn run(
        &self,
        believed: &Belief,
        evidence: &ContactEvidence<'_>,
    ) -> Belief {
        let before = believed.members();
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
            let motions = &evidence.motions(member as u64, compression, state.parameters.misread);
            // Members of an ensemble already differ in their places, and the places of a treated surface are exact.
            let is_scattered = believed.is_certain() && self.effect != Effect::Treat;
            let scattered = is_scattered.then(|| {
                scatter(
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
            let factor = state.parameters.force_factor(self.force_ratio);
            let after = self.replay_member(
                scattered.as_ref().unwrap_or(dirt),
                motions,
                factor,
                &mut state,
            );
            (after, state)
        });
        let remaining = |member: usize| before[member % before.len()].tally().remaining;
        Belief::continue_with(
            members.collect(),
            (0..count).map(remaining).collect(),
            weights,
            self.stiffness,
            believed.was_seen,
        )
    }

    /// Returns the absolute difference of the mean performance between members that rescale the force and members that
    /// take it as measured [1].
    pub(in crate::interpret) fn difference_by_scale(
        &self,
        belief: &Belief,
        goal: &GoalState,
    ) -> f64 {
        // Weight and weighted performance, for each kind of member.
        let mut sums = [[0.0; 2]; 2];
        let members = belief.members().iter().zip(belief.weights());
        for ((dirt, weight), state) in members.zip(&belief.states) {
            let factor = state.parameters.force_factor(self.force_ratio);
            let of_kind = &mut sums[usize::from(factor == self.force_ratio)];
            of_kind[0] += weight;
            of_kind[1] += weight * Performance::evaluate(dirt, goal, self.surface).ratio();
        }
        if sums.iter().any(|[weight, _]| *weight <= 0.0) {
            return 0.0;
        }
        let [rescaled, as_measured] = sums.map(|[weight, sum]| sum / weight);
        (rescaled - as_measured).abs()
    }

    fn first_state(&self, particles: usize, member: u64) -> MemberState {
        let parameters = MemberParameters::draw(self.config, member);
        let is_kept = parameters.is_kept;
        MemberState {
            activation: Activation::new(self.config.seed, member, particles, is_kept),
            parameters,
        }
    }

    fn replay_member(
        &self,
        particles: &ParticleDistribution,
        motions: &[ContactMotion],
        force_factor: f64,
        state: &mut MemberState,
    ) -> ParticleDistribution {
        let MemberState {
            parameters,
            activation,
        } = state;
        let compression = parameters.compression(self.config, self.stiffness);
        let footprint = self.footprint.scale(parameters.footprint_scale);
        let mut model = EffectModel::new(&footprint, self.effect)
            .with_slide(self.slide.cloned())
            .with_film(self.film.cloned());
        if self.effect == Effect::Push {
            let heap_depth = parameters.heap * self.config.redraw_length_m;
            model = model.with_heap(heap_depth, activation.key);
        }
        let mut field = ParticleField::new(particles);
        let bounds = footprint.bounds();
        let on_bend = ToolOnBend::new(self.surface, &footprint, compression, self.config);
        let likelihood = &parameters.likelihood;
        let [mut now, end] = self.span;
        for contact in motions {
            let contact = parameters.apply(contact, force_factor);
            // A film runs in steps, as it changes little during a motion of a centimetre.
            if self.film.is_some() && contact.end_time - now >= FILM_STEP {
                model.wait(&mut field, self.surface, contact.end_time - now);
                now = contact.end_time;
            }
            if !contact.continues {
                model.lift_off(&mut field, self.surface);
            }
            activation.advance(&contact);
            let on_bend = on_bend.as_ref();
            let pressure = PressureDistribution::of(&contact, bounds, compression, on_bend);
            model.set_pressure((pressure.as_ref()).and_then(PressureDistribution::of_part));
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
        model.wait(&mut field, self.surface, end - now);
        field.distribution()
    }
}
