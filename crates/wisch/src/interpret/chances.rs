//! Whether a particle responds to a contact (12): what each has drawn, whatever was drawn before.

use super::motions::{ContactMotion, MAX_LENGTH};
use rand::Rng;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// A particle that is touched again within this travel is still in the same contact [m]: it may have been
/// out of touch while the tool stood or turned a corner.
const SAME_CONTACT: f64 = MAX_LENGTH;

/// A level above every probability.
const SLIPPED: f64 = 2.0;
/// Makes numbers of their own for slipping.
const SLIPS: u64 = 0x736c_6970;

/// What each particle has drawn.
#[derive(Debug)]
pub(super) struct Chances {
    pub(super) key: u64,
    drawn: Vec<Drawn>,
    /// Travel in contact before the motion at hand, and after it; an interruption adds a little [m].
    travelled: [f64; 2],
    /// P(X ≤ f′) of the motion at hand where the tool presses most [1].
    pub(super) probability: f64,
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
    pub(super) fn new(seed: u64, replay: u64, particles: usize, slip: f64) -> Self {
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
    pub(super) fn advance(&mut self, contact: &ContactMotion, probability: f64) -> bool {
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
    pub(super) fn responds(
        &mut self,
        particle: usize,
        probability: f64,
        redraw_length: f64,
    ) -> bool {
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
