//! Activation of particles (12): the threshold that each particle has drawn, and its response to a contact.

use crate::interpret::contact::{ContactMotion, MAX_LENGTH};
use crate::random::keyed_uniform;
use rand::Rng;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Travel within which a particle that is touched again is still in the same contact [m]: contact
/// may be interrupted while the tool stands or turns a corner.
const SAME_CONTACT: f64 = MAX_LENGTH;

/// Level of a particle that slips past the tool; above every probability, so that it does not respond.
const SLIPPED: f64 = 2.0;
/// Probability of a response below which a touch cannot have moved a particle [1].
const NEGLIGIBLE: f64 = 0.01;
/// Key that separates the random numbers of slipping from those of the thresholds.
const SLIPS: u64 = 0x736c_6970;

/// The thresholds of all particles of one member, over all rounds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Activation {
    /// Key of the member's random numbers.
    pub(super) key: u64,
    thresholds: Vec<Threshold>,
    travelled: TravelClock,
    /// Probability that a particle slips past the tool instead of drawing a threshold [1].
    slip: f64,
    /// Whether each particle keeps its threshold permanently.
    is_kept: bool,
}

/// Travel in contact before and after the current motion [m]; each interruption adds a little.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct TravelClock([f64; 2]);

impl TravelClock {
    /// Advances to the next motion, and returns the travel before and after it [m].
    pub(super) fn advance(&mut self, contact: &ContactMotion) -> [f64; 2] {
        if !contact.continues {
            self.interrupt();
        }
        let begin = self.0[1];
        self.0 = [begin, begin + contact.motion.travel().1];
        self.0
    }

    /// Ends the contact, so that every particle touched later is in a new contact.
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
    /// Clock of a particle that was never touched.
    pub(super) const NEVER: Self = Self {
        touched: f64::NEG_INFINITY,
        drew: 0.0,
    };

    /// Records a touch between two travels [m], and returns whether the particle draws a threshold at its beginning.
    pub(super) fn touch(&mut self, [begin, end]: [f64; 2], redraw_length: f64) -> bool {
        let is_new_contact = begin - self.touched > SAME_CONTACT;
        let is_due = begin - self.drew >= redraw_length;
        self.touched = end;
        if is_new_contact {
            self.drew = begin;
        } else if is_due {
            // Draws are due at fixed travels, independent of how the travel is split into motions.
            self.drew += redraw_length;
        }
        is_new_contact || is_due
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Threshold {
    clock: DrawClock,
    draws: u32,
    /// Number of times that the particle was renewed; it selects the threshold of a particle that keeps it.
    kept: u32,
    /// Level, uniform in (0, 1); a particle at [`SLIPPED`] never responds.
    level: f64,
    /// Largest probability of a response that it has met [1].
    most: f64,
}

/// Threshold of a particle that was never touched.
const NEVER: Threshold = Threshold {
    clock: DrawClock::NEVER,
    draws: 0,
    kept: 0,
    level: 1.0,
    most: 0.0,
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

    /// Whether a particle was ever touched with a force to which it may respond.
    pub(super) fn is_touched(&self, particle: usize) -> bool {
        self.thresholds
            .get(particle)
            .is_none_or(|threshold| threshold.most >= NEGLIGIBLE)
    }

    /// Begins another log in which the share `slip` of the particles slips past the tool [1]; every touch is a new
    /// contact.
    pub(super) fn begin_log(&mut self, slip: f64) {
        self.slip = slip;
        self.travelled.interrupt();
    }

    /// Resizes the list to `particles` thresholds, and forgets those of the particles in `renewed`.
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

    /// Advances to the next motion.
    pub(super) fn advance(&mut self, contact: &ContactMotion) {
        self.travelled.advance(contact);
    }

    /// Whether a particle touched by the current motion responds, given the probability of its activation [1].
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
        threshold.most = threshold.most.max(probability);
        threshold.level <= probability
    }
}
