//! Whether a particle responds to a contact (12): the threshold that each has drawn.

use crate::interpret::contact::{ContactMotion, MAX_LENGTH};
use crate::random::keyed_uniform;
use rand::Rng;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// A particle that is touched again within this travel is still in the same contact [m]: it may have been
/// out of touch while the tool stood or turned a corner.
const SAME_CONTACT: f64 = MAX_LENGTH;

/// A level above every probability.
const SLIPPED: f64 = 2.0;
/// Tells apart the random numbers for slipping.
const SLIPS: u64 = 0x736c_6970;

/// The thresholds of all particles of one member, over all rounds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Activation {
    /// Of the member's random numbers.
    pub(super) key: u64,
    thresholds: Vec<Threshold>,
    travelled: TravelClock,
    /// Probability that a particle that draws slips past the tool instead [1].
    slip: f64,
    /// Whether each particle keeps its threshold for good.
    is_kept: bool,
}

/// Travel in contact before the motion at hand, and after it; an interruption adds a little [m].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct TravelClock([f64; 2]);

impl TravelClock {
    /// Goes on to a motion, and says between which travels it is.
    pub(super) fn advance(&mut self, contact: &ContactMotion) -> [f64; 2] {
        if !contact.continues {
            self.interrupt();
        }
        let begin = self.0[1];
        self.0 = [begin, begin + contact.motion.travel().1];
        self.0
    }

    /// What was touched before is touched anew from now on.
    fn interrupt(&mut self) {
        self.0 = [self.0[1] + 2.0 * SAME_CONTACT; 2];
    }
}

/// When a particle draws its threshold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DrawClock {
    /// Travel at which it was last touched [m].
    touched: f64,
    /// Travel at which it drew [m].
    drew: f64,
}

impl DrawClock {
    /// That of a particle that was never touched.
    pub(super) const NEVER: Self = Self {
        touched: f64::NEG_INFINITY,
        drew: 0.0,
    };

    /// Touches the particle between two travels [m], and says whether it draws as that begins.
    pub(super) fn touch(&mut self, [begin, end]: [f64; 2], redraw_length: f64) -> bool {
        let is_new_contact = begin - self.touched > SAME_CONTACT;
        let is_due = begin - self.drew >= redraw_length;
        self.touched = end;
        if is_new_contact {
            self.drew = begin;
        } else if is_due {
            // Draws are due every so often, whatever the length of the motions between which they fall.
            self.drew += redraw_length;
        }
        is_new_contact || is_due
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Threshold {
    clock: DrawClock,
    draws: u32,
    /// Which of its draws is kept, if one is.
    kept: u32,
    /// Uniform in (0, 1); [`SLIPPED`] responds to nothing.
    level: f64,
}

/// That of a particle that was never touched.
const NEVER: Threshold = Threshold {
    clock: DrawClock::NEVER,
    draws: 0,
    kept: 0,
    level: 1.0,
};

impl Activation {
    pub(super) fn new(seed: u64, member: u64, particles: usize, is_kept: bool) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(member);
        Self {
            key: random.next_u64(),
            thresholds: vec![NEVER; particles],
            travelled: TravelClock::default(),
            slip: 0.0,
            is_kept,
        }
    }

    /// Goes on to another log, in which so much slips: what the tool touched before, it touches anew.
    pub(super) fn begin_log(&mut self, slip: f64) {
        self.slip = slip;
        self.travelled.interrupt();
    }

    /// Forgets the thresholds of these particles, and has one for every particle of so many.
    pub(super) fn renew(&mut self, renewed: &[usize], particles: usize) {
        self.thresholds.resize(particles, NEVER);
        for &particle in renewed {
            let threshold = &mut self.thresholds[particle];
            *threshold = Threshold {
                kept: threshold.kept + 1,
                ..NEVER
            };
        }
    }

    /// Goes on to a motion.
    pub(super) fn advance(&mut self, contact: &ContactMotion) {
        self.travelled.advance(contact);
    }

    /// Whether a particle that the motion at hand touches, and that does so with a probability, responds.
    pub(super) fn responds(
        &mut self,
        particle: usize,
        probability: f64,
        redraw_length: f64,
    ) -> bool {
        let threshold = &mut self.thresholds[particle];
        if threshold.clock.touch(self.travelled.0, redraw_length) {
            let draw = if self.is_kept {
                threshold.kept
            } else {
                threshold.draws
            };
            threshold.level = keyed_uniform(self.key, particle as u64, draw);
            if keyed_uniform(self.key ^ SLIPS, particle as u64, threshold.draws) < self.slip {
                threshold.level = SLIPPED;
            }
            threshold.draws += 1;
        }
        threshold.level <= probability
    }
}
