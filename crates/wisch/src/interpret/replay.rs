//! The effect of a felt path: replayed many times through the one effect model, with chances (12).
//!
//! A particle responds to a contact if its threshold X ~ LogNormal(μ, σ) is at most f′. It draws X when
//! its contact begins, and again after every ℓ of travel in contact, so that the sampling rate of the log
//! does not matter. X ≤ f′ is the same as U ≤ P(X ≤ f′) with U even in (0, 1): U is what is drawn.

use super::{Belief, InterpretConfig, PathPiece, Touch};
use crate::geometry::{Edge, PlanarPose, Point2, Pose, Region, wrap_angle};
use crate::represent::{
    Effect, EffectModel, LogNormal, ParticleDistribution, ParticleField, Surface, ToolMotion,
};
use rand::Rng;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rayon::prelude::*;

/// Longest motion that is replayed at once [m]: thresholds are drawn between motions.
const MAX_LENGTH: f64 = 5e-3;
/// How far a path may be off the straight motion that stands for it [m].
const MAX_DEVIATION: f64 = 2.5e-4;
/// Change of f′ from which on a new motion begins [1]; beyond the noise of forces at 100 Hz, which would
/// otherwise choose the strongest of many.
const MAX_SHARE_CHANGE: f64 = 0.15;
/// Turn below which the heading counts as kept [rad]: half a degree, half a millimetre at a sponge's corner.
const HEADING_STEP: f64 = 0.0087;
/// Standing contact is one motion for as long as the tool stays within this [m].
const STANDING: f64 = 1e-4;
/// A particle that is touched again within this travel is still in the same contact [m]: it may have been
/// out of touch while the tool stood or turned a corner.
const SAME_CONTACT: f64 = MAX_LENGTH;
/// Pieces further apart than this are not one contact [s].
const MAX_GAP: f64 = 0.25;

/// A straight motion in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactMotion {
    motion: ToolMotion,
    /// Mean f′ [1].
    share: f64,
    /// Whether it goes on where the one before ended.
    continues: bool,
}

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
    pub(super) fn run(&self, believed: &Belief, motions: &[ContactMotion]) -> Belief {
        let members = believed.replays();
        let count = if members.len() == 1 {
            self.config.replays
        } else {
            members.len()
        };
        let replays = (0..count)
            .into_par_iter()
            .map(|replay| self.once(&members[replay % members.len()], motions, replay as u64))
            .collect();
        Belief::ensemble(replays)
    }

    fn once(
        &self,
        particles: &ParticleDistribution,
        motions: &[ContactMotion],
        replay: u64,
    ) -> ParticleDistribution {
        let mut chances = Chances::new(self.config.seed, replay, particles.len());
        let mut field = ParticleField::new(particles);
        let mut model = EffectModel::new(self.footprint, self.effect);
        for contact in motions {
            chances.advance(contact, &self.config.likelihood);
            model.apply_where(&mut field, self.surface, &contact.motion, |particle| {
                chances.responds(particle, self.config.redraw_length_m)
            });
        }
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
    /// P(X ≤ f′) of the motion at hand [1].
    probability: f64,
}

#[derive(Debug, Clone, Copy)]
struct Drawn {
    /// Travel at which the particle was last touched [m].
    touched: f64,
    /// Travel at which it drew [m].
    drew: f64,
    draws: u32,
    /// Even in (0, 1).
    level: f64,
}

impl Chances {
    fn new(seed: u64, replay: u64, particles: usize) -> Self {
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
        }
    }

    fn advance(&mut self, contact: &ContactMotion, likelihood: &LogNormal) {
        let begin = self.travelled[1]
            + if contact.continues {
                0.0
            } else {
                2.0 * SAME_CONTACT
            };
        self.travelled = [begin, begin + contact.motion.travel().1];
        self.probability = likelihood.probability(contact.share);
    }

    /// Whether a particle that the motion at hand touches responds to it.
    fn responds(&mut self, particle: usize, redraw_length: f64) -> bool {
        let [begin, end] = self.travelled;
        let drawn = &mut self.drawn[particle];
        let is_new_contact = begin - drawn.touched > SAME_CONTACT;
        if is_new_contact || begin - drawn.drew >= redraw_length {
            drawn.level = even(self.key, particle as u64, drawn.draws);
            drawn.draws += 1;
            drawn.drew = begin;
        }
        drawn.touched = end;
        drawn.level <= self.probability
    }
}

/// A number even in (0, 1) for a key, a particle and a draw, whatever was drawn before.
fn even(key: u64, particle: u64, draw: u32) -> f64 {
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

/// The straight motions in contact of a path, in the frame of the real surface.
pub(super) fn contact_motions(path: &[PathPiece], real_from_believed: &Pose) -> Vec<ContactMotion> {
    let mut builder = Builder::default();
    for piece in path {
        match piece.touch {
            Touch::Weak | Touch::Confident if piece.normalized_force > 0.0 => {
                builder.take(piece, real_from_believed);
            }
            _ => builder.interrupt(),
        }
    }
    builder.interrupt();
    builder.motions
}

/// Joins pieces to motions.
#[derive(Debug, Default)]
struct Builder {
    motions: Vec<ContactMotion>,
    open: Option<Open>,
}

/// A motion that still grows.
#[derive(Debug)]
struct Open {
    from: PlanarPose,
    to: PlanarPose,
    last_time: f64,
    /// Places passed on the way, the last one included.
    passed: Vec<Point2>,
    pieces: u32,
    share: f64,
    continues: bool,
}

impl Builder {
    fn take(&mut self, piece: &PathPiece, real_from_believed: &Pose) {
        let position = (real_from_believed * piece.position).xy();
        if let Some(open) = &self.open
            && piece.time[0] - open.last_time > MAX_GAP
        {
            self.interrupt();
        }
        let Some(open) = &mut self.open else {
            let at = PlanarPose::new(position, piece.heading);
            self.open = Some(Open::at(at, piece, false));
            return;
        };
        let heading = kept_heading(open.to.heading, piece.heading);
        let to = PlanarPose::new(position, heading);
        if open.goes_on_to(&to, piece.normalized_force) {
            open.grow(to, piece);
        } else {
            let mut next = Open::at(open.to, piece, true);
            next.grow_to(to);
            self.interrupt();
            self.open = Some(next);
        }
    }

    fn interrupt(&mut self) {
        if let Some(open) = self.open.take() {
            self.close(&open);
        }
    }

    /// Keeps a motion, in parts if it is long: a slow log has pieces longer than a motion should be.
    fn close(&mut self, open: &Open) {
        let way = open.to.position - open.from.position;
        let turn = open.to.heading - open.from.heading;
        let parts = (way.norm() / MAX_LENGTH).ceil().max(1.0) as u32;
        let at = |part: u32| {
            let share = f64::from(part) / f64::from(parts);
            PlanarPose::new(
                open.from.position + way * share,
                open.from.heading + turn * share,
            )
        };
        self.motions.extend((0..parts).map(|part| ContactMotion {
            motion: ToolMotion {
                from: at(part),
                to: at(part + 1),
            },
            share: open.share,
            continues: open.continues || part > 0,
        }));
    }
}

/// A heading near the measured one: the one before, as long as it differs too little to matter, and
/// otherwise the measured one, turned on without a jump.
fn kept_heading(before: f64, measured: f64) -> f64 {
    let turn = wrap_angle(measured - before);
    if turn.abs() < HEADING_STEP {
        before
    } else {
        before + turn
    }
}

impl Open {
    fn at(from: PlanarPose, piece: &PathPiece, continues: bool) -> Self {
        Self {
            from,
            to: from,
            last_time: piece.time[1],
            passed: Vec::new(),
            pieces: 1,
            share: piece.normalized_force,
            continues,
        }
    }

    fn goes_on_to(&self, to: &PlanarPose, share: f64) -> bool {
        let chord = Edge {
            start: self.from.position,
            end: to.position,
        };
        (share - self.share).abs() <= MAX_SHARE_CHANGE
            && to.heading == self.to.heading
            && self.from.heading == self.to.heading
            && (to.position - self.from.position).norm() <= MAX_LENGTH
            && (self.passed.iter()).all(|place| chord.distance(*place) <= MAX_DEVIATION)
    }

    fn grow(&mut self, to: PlanarPose, piece: &PathPiece) {
        self.pieces += 1;
        self.share += (piece.normalized_force - self.share) / f64::from(self.pieces);
        self.last_time = piece.time[1];
        self.grow_to(to);
    }

    fn grow_to(&mut self, to: PlanarPose) {
        let last = self.passed.last().copied().unwrap_or(self.from.position);
        if (to.position - last).norm() > STANDING {
            self.passed.push(to.position);
        }
        self.to = to;
    }
}
