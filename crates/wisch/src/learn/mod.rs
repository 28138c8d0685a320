//! Learning of the laws by which tools move dirt, from rounds with observations before and after. A
//! law is the distribution (12) of the thresholds of particles: its parameters μ and σ, and ℓ, the
//! travel after which a threshold is drawn again; paper §4.2 (outlook).
//!
//! ```text
//! evidence: detections before and after, exposures  →  likelihood of the observations
//! grid:     over (μ, ln σ, ln ℓ) and kept thresholds  →  likelihood of one law
//! pooling:  laws of the same tool, of the same medium, and of all  →  posterior of each
//! ```
//!
//! A particle that was detected before and then exposed has stayed if each threshold that it drew
//! was higher than the f′ at its place. The probability is Π (1 − Φ((ln f′ − μ)/σ)) over its draws.
//! That holds for absorbing and for pushing, because a pushed particle leaves its place with its
//! first response. The camera adds errors: it misses grains and gives false alarms, and a neighbour
//! or another grain may lie where the particle lay.

mod error;
mod evidence;
mod grid;
mod pooling;
mod posterior;

pub use error::LearnError;
pub use evidence::ObservedRound;
pub use posterior::PosteriorSummary;

use crate::represent::{Interaction, LogNormal, LogNormalSpread, Redraw};
use evidence::RoundEvidence;
use grid::{LawPrior, LikelihoodGrid};

/// Least number of touched and observed particles for which a law is fitted.
pub const LEAST_PARTICLES: usize = 10;

/// Number of guesses of each particle's exposure, as its place and the grasp of the tool are uncertain.
pub const GUESSES: usize = 8;

/// Settings for learning the laws of tools and media.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LearnConfig {
    /// Standard deviation of the logarithm of a round's force scale, common to the whole round \[1\].
    pub force_share: f64,
    /// Seed of all random numbers.
    pub seed: u64,
}

impl Default for LearnConfig {
    /// The error of the force that an interpretation assumes by default.
    fn default() -> Self {
        Self {
            force_share: crate::interpret::Uncertainty::default().force_share,
            seed: 1,
        }
    }
}

/// The observed rounds of one pair of tool and medium, whose law is fitted.
#[derive(Debug, Clone, Copy)]
pub struct LawObservations<'a> {
    /// Entry of the knowledge base, which gives the prior.
    pub interaction: &'a Interaction,
    /// r_s of the tool, the prior mean of ℓ if the entry has none \[m\].
    pub collision_radius_m: f64,
    /// Rounds of any episodes.
    pub rounds: &'a [ObservedRound],
}

/// The posterior of the law of one pair of tool and medium.
#[derive(Debug, Clone, PartialEq)]
pub struct LearnedLaw {
    /// μ \[1\].
    pub mu: PosteriorSummary,
    /// ln σ \[1\].
    pub ln_sigma: PosteriorSummary,
    /// ln of ℓ in metres, for thresholds that are drawn again.
    pub ln_redraw_length: PosteriorSummary,
    /// Probability that a particle keeps its threshold \[1\].
    pub kept_share: f64,
    /// Number of rounds of the fit.
    pub rounds: usize,
    /// Number of touched and observed particles in them.
    pub particles: usize,
}

impl LearnedLaw {
    /// Returns the interaction with the posterior means and spreads, for the knowledge base.
    pub fn apply_to(&self, interaction: &Interaction) -> Interaction {
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

/// Fits the laws of several `lessons` together, and returns one law per lesson, in their order. A
/// lesson is the set of observed rounds of one pair of tool and medium.
///
/// The prior of a law is its entry in the knowledge base: the means of μ, ln σ and ln ℓ with their spreads. Laws are
/// partially pooled: the deviations of two laws from their entries, in these spreads, have correlation ρ/3, and ρ/3
/// more each for a common tool and a common medium. A law with many observations follows its own data, and a law with
/// few borrows from the others. ρ has a uniform prior on 0, 0.3, 0.6 and 0.9. ℓ is not pooled.
///
/// The force of each round is known up to [`LearnConfig::force_share`].
///
/// A single law is integrated on a grid that is refined where the posterior lies. Several laws are sampled (Gibbs),
/// each from its grid given the others. The result depends on lessons and seed only, not on the
/// number of threads.
///
/// # Errors
/// [`LearnError::Config`] or [`LearnError::OutOfRange`] for a value out of its range,
/// [`LearnError::Mismatch`] for exposures that do not match the detections, and
/// [`LearnError::TooFew`] for a law with fewer than [`LEAST_PARTICLES`] touched and observed
/// particles.
///
/// ```
/// use wisch::geometry::{Point2, Region};
/// use wisch::interpret::{Exposure, ParticleTouch};
/// use wisch::learn::{LearnConfig, LawObservations, ObservedRound, learn};
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
/// // Forty crumbs in a row, each touched once at f′ = 0.35; every second one stays.
/// let places: Vec<Point2> = (0..40).map(|i| Point2::new(0.02 * f64::from(i), 0.0)).collect();
/// let stayed: Vec<Point2> = places.iter().copied().step_by(2).collect();
/// let touch = Exposure::new(vec![ParticleTouch { travel: [0.0, 0.01], share: 0.35 }]);
/// let sensor = SensorModel::default();
/// let round = ObservedRound {
///     before: Observation { detections: places.clone(), hidden: Region::default() },
///     after: Observation { detections: stayed, hidden: Region::default() },
///     sight: Sight { sensor, detection: sensor.detection },
///     area_m2: 0.8,
///     exposures: vec![vec![touch]; 40],
///     earlier: vec![],
/// };
/// let observations = LawObservations { interaction: &interaction, collision_radius_m: 0.065, rounds: &[round] };
/// let learned = &learn(&[observations], &LearnConfig::default())?[0];
/// // Half of them respond, so ln f′ is μ.
/// assert!((learned.mu.mean - 0.35_f64.ln()).abs() < 0.05);
/// assert!(learned.mu.deviation < 0.15);
/// # Ok::<(), wisch::learn::LearnError>(())
/// ```
pub fn learn(
    lessons: &[LawObservations<'_>],
    config: &LearnConfig,
) -> Result<Vec<LearnedLaw>, LearnError> {
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
            grid: LikelihoodGrid::refine(&rounds, &prior, config.force_share),
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
        .map(|(fit, weights)| fit.summarise(weights))
        .collect())
}

/// Fit of a single law, before pooling.
struct Fit {
    prior: LawPrior,
    grid: LikelihoodGrid,
    rounds: usize,
    particles: usize,
}

impl Fit {
    /// Returns the posterior of the law, given the weights of the grid's nodes of (ln σ, μ).
    fn summarise(&self, weights: &[f64]) -> LearnedLaw {
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
