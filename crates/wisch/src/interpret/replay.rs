//! The effect of a felt path: replayed many times through the one effect model, with chances (12).
//!
//! A particle responds to a contact if its threshold X ~ LogNormal(μ, σ) is at most f′ at its place under
//! the tool. It draws X when its contact begins, and again after every ℓ of travel in contact, so that the
//! sampling rate of the log does not matter. X ≤ f′ is the same as U ≤ P(X ≤ f′) with U even in (0, 1): U is
//! what is drawn.

use super::chances::Chances;
use super::doubt::Witness;
use super::heap::Heap;
use super::motions::ContactMotion;
use super::uneven::Uneven;
use super::variation::Variation;
use super::{Belief, InterpretConfig};
use crate::geometry::Region;
use crate::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, Surface};
use rayon::prelude::*;

/// Everything a replay needs but the particles.
#[derive(Debug)]
pub(super) struct Replay<'a> {
    pub(super) footprint: &'a Region,
    pub(super) effect: Effect,
    pub(super) surface: &'a Surface,
    pub(super) config: &'a InterpretConfig,
}

impl Replay<'_> {
    /// The belief after these motions.
    pub(super) fn run(&self, believed: &Belief, witness: &Witness<'_>) -> Belief {
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
                let mut variation = Variation::draw(&self.config.uncertainty, seed, replay as u64);
                let motions = &witness.account(replay as u64);
                let member = &members[replay % members.len()];
                if is_certain {
                    // Members of an ensemble already differ in where their particles lie.
                    let scattered = variation.scattered(member, self.surface);
                    self.once(&scattered, motions, &variation, replay as u64)
                } else {
                    self.once(member, motions, &variation, replay as u64)
                }
            })
            .collect();
        Belief::ensemble(replays)
    }

    fn once(
        &self,
        particles: &ParticleDistribution,
        motions: &[ContactMotion],
        variation: &Variation,
        replay: u64,
    ) -> ParticleDistribution {
        let (slip, heap) = match self.effect {
            Effect::Push => (variation.slip, variation.heap * self.config.redraw_length_m),
            Effect::Absorb => (0.0, 0.0),
        };
        let mut chances = Chances::new(self.config.seed, replay, particles.len(), slip);
        let mut heap = Heap::new(heap, chances.key);
        let mut field = ParticleField::new(particles);
        let mut model = EffectModel::new(self.footprint, self.effect);
        let bounds = self.footprint.bounds();
        for contact in motions {
            let contact = variation.applied(contact);
            if !contact.continues {
                heap.rest(&mut field, self.surface);
            }
            let uneven = Uneven::of(&contact, bounds, self.config.nominal_compression());
            let most = (uneven.as_ref()).map_or(contact.felt.share(), Uneven::most);
            if !chances.advance(&contact, self.config.likelihood.probability(most)) {
                continue;
            }
            let likelihood = &self.config.likelihood;
            let redraw_length = self.config.redraw_length_m;
            let motion = &contact.motion;
            heap.begin(motion);
            model.apply_where(&mut field, self.surface, motion, |particle, position| {
                let probability = uneven.as_ref().map_or(chances.probability, |uneven| {
                    likelihood.probability(uneven.share(position))
                });
                let responds = chances.responds(particle, probability, redraw_length);
                if responds {
                    heap.take(particle);
                }
                responds
            });
            heap.pass(&mut field, self.surface);
        }
        heap.rest(&mut field, self.surface);
        field.distribution()
    }
}
