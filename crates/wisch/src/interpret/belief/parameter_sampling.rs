//! Parameters of a member, sampled from the uncertainty of the settings.

use crate::geometry::{PlanarPose, Point2};
use crate::interpret::config::InterpretConfig;
use crate::interpret::contact::{ContactMotion, StiffnessBelief};
use crate::random::{keyed_uniform, normal, normal_pair};
use crate::represent::{Fate, LogNormal, ParticleDistribution, Surface, ToolMotion};
use rand::{Rng, RngExt};
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Random streams of the parameters; those of the activation are numbered from 0.
const STREAMS: u64 = 0x7661_7279_0000_0000;
/// Random streams of the places of known particles.
const PLACES: u64 = 0x706c_6163_0000_0000;

/// Key of the draw that decides how a member explains the scale of the force.
const SCALES: u64 = 0x7363_616c_6573;
/// Key of the draw that selects the members in which doubtful logs count as misread.
const MISREAD: u64 = 0x6d69_7372_6561_6421;

/// Factor by which the parameters of an outlier deviate more [1].
const OUTLIER: f64 = 3.0;
/// Share of the members in which nothing slips past the tool [1].
const UNSLIPPED: f64 = 0.875;

/// Parameters of a member, constant over all rounds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MemberParameters {
    grasp: PlanarPose,
    /// Size of the footprint over the modelled one [1].
    pub(super) footprint_scale: f64,
    force_scale: f64,
    /// Deviation of the logarithm of the tool's stiffness from its mean, in standard deviations [1].
    stiffness: f64,
    /// Depth of a heap of all particles, over r_s [1].
    pub(super) heap: f64,
    /// Probability of an effect as a function of f′.
    pub(super) likelihood: LogNormal,
    /// Travel in contact after which a threshold is drawn again [m].
    pub(super) redraw_length: f64,
    /// Whether each particle keeps its threshold instead of drawing a new one.
    pub(super) is_kept: bool,
    /// Draw from 0 to 1 that decides whether logs are misread in this member [1]: a sensor that is dead in one log is dead
    /// in all.
    pub(super) misread: f64,
    /// Whether the member explains a press force other than the declared one by the scale of the force.
    is_rescaled: bool,
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
            misread: keyed_uniform(config.seed ^ MISREAD, member, 0),
            is_rescaled: keyed_uniform(config.seed ^ SCALES, member, 0)
                < uncertainty.rescaled_share,
        }
    }

    /// Compression of the tool at nominal force [m], given the current belief about its stiffness.
    pub(super) fn compression(&self, config: &InterpretConfig, believed: StiffnessBelief) -> f64 {
        config.nominal_compression() / believed.scale(self.stiffness)
    }

    /// Returns the factor on f′ if the tool pressed with `ratio` times the declared force [1].
    ///
    /// The log does not distinguish two causes. In the first, the tool really pressed with this force.
    /// In the second, the sensor or the task has another scale, and the tool pressed with the declared
    /// force. Each member assumes one of them, in all logs.
    pub(super) fn force_factor(&self, ratio: f64) -> f64 {
        if self.is_rescaled { 1.0 } else { ratio }
    }

    /// Returns the motion of the tool as the member grasps it, with the force scaled by `force_factor`.
    pub(super) fn apply(&self, contact: &ContactMotion, force_factor: f64) -> ContactMotion {
        let moved = |tool: &PlanarPose| {
            let position = tool.transform(self.grasp.position);
            PlanarPose::new(position, tool.heading + self.grasp.heading)
        };
        ContactMotion {
            motion: ToolMotion {
                from: moved(&contact.motion.from),
                to: moved(&contact.motion.to),
            },
            force: contact.force.scale(self.force_scale * force_factor),
            ..*contact
        }
    }
}

/// Shifts each particle by a normal error of `deviation` along x and along y [m]. A particle stays in place if it would
/// leave the surface.
pub(super) fn scatter(
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
    // The shifted places are finite, as they lie on the surface.
    ParticleDistribution::with_fates(&places).unwrap_or_else(|_| particles.clone())
}

/// Returns the share of pushed dirt that slips past the tool in a log, per draw of a threshold [1]. A heap leaks
/// differently with each plan, so a member draws it for every log.
pub(super) fn slip(config: &InterpretConfig, member: u64) -> f64 {
    config.uncertainty.slip_share * slip_severity(config.seed, member)
}

/// Returns the share of slip in a member over the largest one [1]; 0 in most members. An additive sequence by the
/// golden ratio with a random start spreads the remaining members evenly, for any number of them.
fn slip_severity(seed: u64, member: u64) -> f64 {
    const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(STREAMS - 1);
    let place = random.next_u64().wrapping_add(member.wrapping_mul(GOLDEN));
    // The upper 53 bits as a number in [0, 1).
    let place = (place >> 11) as f64 / (1_u64 << 53) as f64;
    ((place - UNSLIPPED) / (1.0 - UNSLIPPED)).max(0.0)
}
