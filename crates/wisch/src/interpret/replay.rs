//! The effect of a felt path: replayed many times through the one effect model, with chances (12).
//!
//! A particle responds to a contact if its threshold X ~ LogNormal(μ, σ) is at most f′ at its place under
//! the tool. It draws X when its contact begins, and again after every ℓ of travel in contact, so that the
//! sampling rate of the log does not matter. X ≤ f′ is the same as U ≤ P(X ≤ f′) with U even in (0, 1): U is
//! what is drawn.

use super::doubt::Witness;
use super::heap::Heap;
use super::motions::{ContactMotion, MAX_LENGTH};
use super::uneven::Uneven;
use super::variation::Variation;
use super::{Belief, InterpretConfig};
use crate::geometry::Region;
use crate::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, Surface};
use rand::Rng;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rayon::prelude::*;

/// A particle that is touched again within this travel is still in the same contact [m]: it may have been
/// out of touch while the tool stood or turned a corner.
const SAME_CONTACT: f64 = MAX_LENGTH;

/// A level above every probability.
const SLIPPED: f64 = 2.0;
/// Makes numbers of their own for slipping.
const SLIPS: u64 = 0x736c_6970;

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

/// What each particle has drawn.
#[derive(Debug)]
struct Chances {
    key: u64,
    drawn: Vec<Drawn>,
    /// Travel in contact before the motion at hand, and after it; an interruption adds a little [m].
    travelled: [f64; 2],
    /// P(X ≤ f′) of the motion at hand where the tool presses most [1].
    probability: f64,
    /// Probability that a particle that draws slips past the tool instead [1].
    slip: f64,
}

#[derive(Debug, Clone, Copy)]
struct Drawn {
    /// Travel at which the particle was last touched [m].
    touched: f64,
    /// Travel at which it drew [m].
    drew: f64,
    draws: u32,
    /// Even in (0, 1); [`SLIPPED`] responds to nothing.
    level: f64,
}

impl Chances {
    fn new(seed: u64, replay: u64, particles: usize, slip: f64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(replay);
        let never = Drawn {
            touched: f64::NEG_INFINITY,
            drew: 0.0,
            draws: 0,
            level: 1.0,
        };
        Self {
            key: random.next_u64(),
            drawn: vec![never; particles],
            travelled: [0.0; 2],
            probability: 0.0,
            slip,
        }
    }

    /// Goes on to a motion, and says whether any particle can respond to it.
    fn advance(&mut self, contact: &ContactMotion, probability: f64) -> bool {
        let begin = self.travelled[1]
            + if contact.continues {
                0.0
            } else {
                2.0 * SAME_CONTACT
            };
        self.travelled = [begin, begin + contact.motion.travel().1];
        self.probability = probability;
        self.probability > 0.0
    }

    /// Whether a particle that the motion at hand touches, and that does so with a probability, responds.
    fn responds(&mut self, particle: usize, probability: f64, redraw_length: f64) -> bool {
        let [begin, end] = self.travelled;
        let drawn = &mut self.drawn[particle];
        let is_new_contact = begin - drawn.touched > SAME_CONTACT;
        let is_due = begin - drawn.drew >= redraw_length;
        if is_new_contact || is_due {
            drawn.level = even(self.key, particle as u64, drawn.draws);
            if even(self.key ^ SLIPS, particle as u64, drawn.draws) < self.slip {
                drawn.level = SLIPPED;
            }
            drawn.draws += 1;
            // Draws are due every so often, whatever the length of the motions between which they fall.
            drawn.drew = if is_new_contact {
                begin
            } else {
                drawn.drew + redraw_length
            };
        }
        drawn.touched = end;
        drawn.level <= probability
    }
}

/// A number even in (0, 1) for a key, a particle and a draw, whatever was drawn before.
pub(super) fn even(key: u64, particle: u64, draw: u32) -> f64 {
    let mixed = mix(mix(key ^ mix(particle)).wrapping_add(u64::from(draw)));
    // 53 bits, the middle of each step.
    ((mixed >> 11) as f64 + 0.5) * (1.0 / (1_u64 << 53) as f64)
}

/// The finaliser of SplitMix64 (Steele, Lea and Flood, 2014) after its increment.
fn mix(value: u64) -> u64 {
    let z = value.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
