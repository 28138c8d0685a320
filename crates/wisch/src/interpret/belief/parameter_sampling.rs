//! The parameters of a member, sampled from what is not known exactly.

use crate::geometry::{PlanarPose, Point2};
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{ContactMotion, StiffnessBelief};
use crate::random::{keyed_uniform, normal, normal_pair};
use crate::represent::{Fate, LogNormal, ParticleDistribution, Surface, ToolMotion};
use rand::{Rng, RngExt};
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Streams of random numbers: apart from those of the activation, which are numbered from 0.
const STREAMS: u64 = 0x7661_7279_0000_0000;
/// Streams for where known particles lie.
const PLACES: u64 = 0x706c_6163_0000_0000;

/// Keys of what a member makes of the scale of the force, and of a log without contact.
const SCALES: u64 = 0x7363_616c_6573;

/// By how much more a law is off that is just wrong [1].
const OUTLIER: f64 = 3.0;
/// Share of the members in which nothing slips past the tool [1].
const UNSLIPPED: f64 = 0.875;

/// What a member takes for real, over all rounds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MemberParameters {
    grasp: PlanarPose,
    /// Size of the footprint over the believed one [1].
    pub(super) footprint_scale: f64,
    force_scale: f64,
    /// By how many standard deviations the logarithm of the tool's stiffness is off its mean [1].
    stiffness: f64,
    /// Depth of a heap of all particles over r_s [1].
    pub(super) heap: f64,
    /// The chance of an effect over the normalised force.
    pub(super) likelihood: LogNormal,
    /// After this travel in contact a threshold is drawn again [m].
    pub(super) redraw_length: f64,
    /// Whether thresholds are kept for good instead.
    pub(super) is_kept: bool,
}

impl MemberParameters {
    pub(super) fn draw(config: &InterpretConfig, member: u64) -> Self {
        let uncertainty = &config.uncertainty;
        let mut random = ChaCha8Rng::seed_from_u64(config.seed);
        random.set_stream(STREAMS ^ member);
        let offset = normal_pair(&mut random) * uncertainty.grasp_offset_m;
        let [turn, scale] = normal_pair(&mut random).into();
        let heap = uncertainty.heap_depth * random.random::<f64>();
        let [mu, sigma] = normal_pair(&mut random).into();
        let is_kept = random.random::<f64>() < uncertainty.kept_share;
        let length = normal(&mut random);
        let size = normal(&mut random);
        let is_outlier = random.random::<f64>() < uncertainty.law_outlier_share;
        let stiffness = normal(&mut random);
        let off = if is_outlier { OUTLIER } else { 1.0 };
        let LogNormal {
            mu: mean,
            sigma: spread,
        } = config.likelihood;
        Self {
            grasp: PlanarPose::new(Point2::from(offset), turn * uncertainty.grasp_turn),
            heap,
            footprint_scale: (1.0 + size * uncertainty.footprint_share).max(0.1),
            force_scale: (1.0 + scale * uncertainty.force_share).max(0.0),
            stiffness,
            likelihood: LogNormal {
                mu: mean + mu * uncertainty.law_mu * off,
                sigma: spread * libm::exp(sigma * uncertainty.law_sigma * off),
            },
            redraw_length: config.redraw_length_m * libm::exp(length * uncertainty.redraw_share),
            is_kept,
        }
    }

    /// How far the tool is compressed at nominal force [m], with what is believed of its stiffness by now.
    pub(super) fn compression(&self, config: &InterpretConfig, believed: StiffnessBelief) -> f64 {
        config.nominal_compression() / believed.scale(self.stiffness)
    }

    /// The motion that the tool makes if it sits so in the hand, with a force that is by this factor another.
    pub(super) fn applied(&self, contact: &ContactMotion, force_factor: f64) -> ContactMotion {
        let moved = |tool: &PlanarPose| {
            let position = tool.transform(self.grasp.position);
            PlanarPose::new(position, tool.heading + self.grasp.heading)
        };
        ContactMotion {
            motion: ToolMotion {
                from: moved(&contact.motion.from),
                to: moved(&contact.motion.to),
            },
            force: contact.force.scaled(self.force_scale * force_factor),
            ..*contact
        }
    }
}

/// The particles where they may lie as well, if each is known to this standard deviation along x and along y [m]; none
/// leaves the surface by that.
pub(super) fn scattered(
    particles: &ParticleDistribution,
    surface: &Surface,
    deviation: f64,
    seed: u64,
    member: u64,
) -> ParticleDistribution {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(PLACES ^ member);
    let places: Vec<(Point2, Fate)> = particles
        .iter()
        .map(|(position, fate)| {
            let there = position + normal_pair(&mut random) * deviation;
            let is_possible = fate == Fate::OnSurface && surface.outline.contains(there);
            (if is_possible { there } else { position }, fate)
        })
        .collect();
    // Finite positions stay finite.
    ParticleDistribution::with_fates(&places).unwrap_or_else(|_| particles.clone())
}

/// By which factor the f′ of a log is another in a member, if the tool pressed with this ratio of the declared force [1].
/// The log alone does not say which of two things is so: that the tool really pressed so much, or that the sensor or the
/// task has another scale and the force was the one meant.
pub(super) fn force_factor(config: &InterpretConfig, ratio: f64, member: u64) -> f64 {
    let is_rescaled =
        keyed_uniform(config.seed ^ SCALES, member, 0) < config.uncertainty.rescaled_share;
    if is_rescaled { 1.0 } else { ratio }
}

/// Share of what is pushed that slips past the tool in a log, per drawing [1]: how a heap leaks depends on the strokes, so a
/// member draws it for every log anew.
pub(super) fn slip(config: &InterpretConfig, member: u64) -> f64 {
    config.uncertainty.slip_share * slip_severity(config.seed, member)
}

/// How much slips in a member, over the most that may [1]: nothing in most of them. An additive sequence by the
/// golden ratio, begun anywhere, spreads the others evenly over the members, however many there are.
fn slip_severity(seed: u64, member: u64) -> f64 {
    const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(STREAMS - 1);
    let place = random.next_u64().wrapping_add(member.wrapping_mul(GOLDEN));
    // 53 bits in [0, 1).
    let place = (place >> 11) as f64 / (1_u64 << 53) as f64;
    ((place - UNSLIPPED) / (1.0 - UNSLIPPED)).max(0.0)
}
