//! What wiping teaches of the laws by which tools move dirt: μ, σ and ℓ of (12), from rounds that were looked at before
//! and after; paper §4.2 (outlook).
//!
//! ```text
//! evidence: detections before and after, exposures  →  how likely what was seen is, if so many stayed
//! grid:     over (μ, ln σ, ln ℓ), and thresholds that are kept for good  →  likelihood of one law
//! pooling:  laws of the same tool, of the same medium, and of all  →  posterior of each
//! ```
//!
//! A particle that was seen before and then exposed has stayed if each threshold that it drew was higher than the f′
//! that it felt: with probability Π (1 − Φ((ln f′ − μ)/σ)) over its draws. That holds for absorbing and for pushing, as
//! a pushed particle leaves its place with its first response. What is seen of that is blurred: grains are missed,
//! nothing is taken for a grain, and a neighbour or something that came there may lie where the particle lay.

mod error;
mod evidence;
mod grid;
mod pooling;
mod posterior;

pub use error::LearnError;
pub use evidence::SeenRound;
pub use posterior::PosteriorSummary;

use crate::represent::{Interaction, LogNormal, LogNormalSpread, Redraw};
use evidence::RoundEvidence;
use grid::{LawPrior, LikelihoodGrid};

/// Fewest particles that were touched and looked for from which a law is fitted.
pub const LEAST_PARTICLES: usize = 10;

/// Guesses of what each particle felt, as where it lay and how the tool sat in the hand are not known exactly.
pub const GUESSES: usize = 8;

/// Settings of the learning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LearnConfig {
    /// What f′ of a round may be off by, the same for all of it, as a standard deviation of its logarithm [1].
    pub force_share: f64,
    /// Of everything random.
    pub seed: u64,
}

impl Default for LearnConfig {
    /// As an interpretation has it.
    fn default() -> Self {
        Self {
            force_share: crate::interpret::Uncertainty::default().force_share,
            seed: 1,
        }
    }
}

/// Everything that was seen of one law.
#[derive(Debug, Clone, Copy)]
pub struct Lesson<'a> {
    /// What was known of it before, as the knowledge base has it.
    pub interaction: &'a Interaction,
    /// r_s of the tool, which ℓ is where nothing better is known [m].
    pub collision_radius_m: f64,
    /// The rounds, of whatever episodes.
    pub rounds: &'a [SeenRound],
}

/// A law as the rounds have it.
#[derive(Debug, Clone, PartialEq)]
pub struct LearnedLaw {
    /// μ [1].
    pub mu: PosteriorSummary,
    /// ln σ [1].
    pub ln_sigma: PosteriorSummary,
    /// ln of ℓ in metres, if thresholds are drawn again.
    pub ln_redraw_length: PosteriorSummary,
    /// Probability that a particle keeps its threshold for good [1].
    pub kept_share: f64,
    /// Rounds that it was fitted to.
    pub rounds: usize,
    /// Particles in them that were touched and looked for.
    pub particles: usize,
}

impl LearnedLaw {
    /// As the knowledge base keeps it: the middle of what is believed, and its spread.
    pub fn applied_to(&self, interaction: &Interaction) -> Interaction {
        Interaction {
            likelihood: LogNormal {
                mu: self.mu.mean,
                sigma: libm::exp(self.ln_sigma.mean),
            },
            likelihood_spread: LogNormalSpread {
                mu: self.mu.deviation,
                ln_sigma: self.ln_sigma.deviation,
            },
            redraw: Redraw {
                length_m: Some(libm::exp(self.ln_redraw_length.mean)),
                ln_length_spread: self.ln_redraw_length.deviation,
                kept_share: self.kept_share,
            },
            ..interaction.clone()
        }
    }
}

/// Fits the laws of these lessons together, each with its own result, in their order.
///
/// What is known of a law before is its entry in the knowledge base: the mean of μ and of ln σ with their spreads, ℓ with
/// its own. Partial pooling: by how many of these spreads two laws are off the entries is correlated, by ρ/3 for any two,
/// by as much more if they share their tool, and their medium. So a law that is seen often decides for itself, and
/// one that is seen rarely borrows from the others. ρ is learned too: 0, 0.3, 0.6 and 0.9 are as likely before. ℓ is
/// each law's own.
///
/// How hard the tool pressed is known for each round only up to [`LearnConfig::force_share`].
///
/// A single law is integrated on a grid that is refined where the posterior lies; several are sampled (Gibbs), each from
/// its grid given the others. Same lessons and seed, same result, on any number of threads.
///
/// # Errors
/// Settings that make no sense; rounds whose exposures are not those of their detections; a law of which fewer than
/// [`LEAST_PARTICLES`] particles were touched and looked for.
///
/// ```
/// use wisch::geometry::{Point2, Region};
/// use wisch::interpret::{Exposure, Touched};
/// use wisch::learn::{LearnConfig, Lesson, SeenRound, learn};
/// use wisch::represent::*;
/// # let interaction = Interaction {
/// #     tool: "sponge".into(),
/// #     medium: "breadcrumbs".into(),
/// #     surface: SurfaceScope::Any,
/// #     actions: Action::ALL.into_iter().collect(),
/// #     press_force_n: 10.0,
/// #     stiffness_n_per_m: 500.0,
/// #     damping_ratio: 0.7,
/// #     nullspace_posture_weight: 0.1,
/// #     compression_depth_m: 0.005,
/// #     gap_m: 0.0,
/// #     likelihood: LogNormal { mu: -1.05, sigma: 0.25 },
/// #     likelihood_spread: LogNormalSpread::default(),
/// #     redraw: Redraw::default(),
/// # };
/// // Forty crumbs in a row, each touched once at f′ = 0.35, of which every second one stays.
/// let places: Vec<Point2> = (0..40).map(|i| Point2::new(0.02 * f64::from(i), 0.0)).collect();
/// let stayed: Vec<Point2> = places.iter().copied().step_by(2).collect();
/// let touch = Exposure::new(vec![Touched { travel: [0.0, 0.01], share: 0.35 }]);
/// let sensor = SensorModel::default();
/// let round = SeenRound {
///     before: Observation { detections: places.clone(), hidden: Region::default() },
///     after: Observation { detections: stayed, hidden: Region::default() },
///     sight: Sight { sensor, detection: sensor.detection },
///     area_m2: 0.8,
///     exposures: vec![vec![touch]; 40],
///     earlier: vec![],
/// };
/// let lesson = Lesson { interaction: &interaction, collision_radius_m: 0.065, rounds: &[round] };
/// let learned = &learn(&[lesson], &LearnConfig::default())?[0];
/// // Half of them respond at ln f′ = μ.
/// assert!((learned.mu.mean - 0.35_f64.ln()).abs() < 0.05);
/// assert!(learned.mu.deviation < 0.15);
/// # Ok::<(), wisch::learn::LearnError>(())
/// ```
pub fn learn(lessons: &[Lesson<'_>], config: &LearnConfig) -> Result<Vec<LearnedLaw>, LearnError> {
    if !(0.0..=1.0).contains(&config.force_share) {
        return Err(LearnError::Config {
            name: "force_share",
            value: config.force_share,
            expected: "0 to 1",
        });
    }
    let mut fits = Vec::with_capacity(lessons.len());
    for lesson in lessons {
        let law = || {
            let Interaction {
                tool,
                medium,
                surface,
                ..
            } = lesson.interaction;
            format!("{tool} on {medium} on {surface}")
        };
        let rounds = (lesson.rounds.iter().enumerate())
            .map(|(index, round)| RoundEvidence::of(round, index, &law))
            .collect::<Result<Vec<_>, _>>()?;
        let particles = rounds.iter().map(RoundEvidence::observed).sum();
        if particles < LEAST_PARTICLES {
            return Err(LearnError::TooFew {
                law: law(),
                particles,
                rounds: rounds.len(),
            });
        }
        let prior = LawPrior::of(lesson.interaction, lesson.collision_radius_m);
        fits.push(Fit {
            grid: LikelihoodGrid::refined(&rounds, &prior, config.force_share),
            prior,
            rounds: rounds.len(),
            particles,
        });
    }
    let names: Vec<[&str; 2]> = (lessons.iter())
        .map(|lesson| {
            let interaction = lesson.interaction;
            [interaction.tool.as_str(), interaction.medium.as_str()]
        })
        .collect();
    let weights = pooling::posteriors(&fits, &names, config.seed);
    Ok((fits.iter().zip(&weights))
        .map(|(fit, weights)| fit.learned(weights))
        .collect())
}

/// One law's part of a fit.
struct Fit {
    prior: LawPrior,
    grid: LikelihoodGrid,
    rounds: usize,
    particles: usize,
}

impl Fit {
    /// What follows from the posterior weights of the grid's nodes of μ and ln σ.
    fn learned(&self, weights: &[f64]) -> LearnedLaw {
        let grid = &self.grid;
        let (mu, ln_sigma) = grid.marginals(weights);
        let (ln_length, kept_share) = grid.redraw(weights, &self.prior);
        LearnedLaw {
            mu: PosteriorSummary::of(&grid.mu, &mu),
            ln_sigma: PosteriorSummary::of(&grid.ln_sigma, &ln_sigma),
            ln_redraw_length: PosteriorSummary::of(&grid.ln_length, &ln_length),
            kept_share,
            rounds: self.rounds,
            particles: self.particles,
        }
    }
}
