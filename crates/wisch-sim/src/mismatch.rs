//! Differences between a simulated world and what a robot believes about it.

use crate::{GrainCount, RealTool, Sensing, SimulationSettings, TrueDirt, Waviness};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use wisch::geometry::{Vector2, Vector3};

/// Stream of the random numbers of mismatches, separate from those of tasks and worlds with the same seed.
const STREAM: u64 = 0x6d69_736d_6174_6368;
/// Range of each quantity in a random world, as ± or as largest value, in the units of [`Mismatch`].
const MU: f64 = 0.5;
const SIGMA: [f64; 2] = [0.15, 0.5];
const STIFFNESS: [f64; 2] = [0.7, 1.3];
const FOOTPRINT: [f64; 2] = [0.9, 1.1];
const GRASP: f64 = 0.010;
const GRASP_TURN: f64 = 0.05;
const ENCODER_NOISE: f64 = 5e-5;
const BACKLASH: f64 = 5e-4;
const FORCE_DELAY: f64 = 0.010;
const FORCE_DRIFT: f64 = 0.005;
const JOINT_FRICTION: f64 = 0.3;
const WAVINESS: f64 = 5e-4;
const WAVE_LENGTH: [f64; 2] = [0.15, 0.6];
/// Range for the width of the strip of dirt along the outline [m].
const EDGE_WIDTH: [f64; 2] = [0.02, 0.08];

/// Differences between a world and the settings of a task, applied by [`SimulationSettings::with_mismatch`].
///
/// ```
/// use wisch_sim::{Mismatch, TrueDirt};
/// let softer = Mismatch { dirt: Some(TrueDirt::Edge(0.03)), stiffness: 0.7, ..Mismatch::default() };
/// assert_ne!(softer, Mismatch::default());
/// assert_eq!(Mismatch::draw(3), Mismatch::draw(3));
/// assert_ne!(Mismatch::draw(3), Mismatch::draw(4));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mismatch {
    /// Spatial distribution of the dirt; `None` keeps that of the settings.
    pub dirt: Option<TrueDirt>,
    /// Number of grains; `None` keeps that of the settings.
    pub count: Option<GrainCount>,
    /// Offset of the mean of ln f′, the threshold above which the tool takes a grain along \[1\].
    pub mu_shift: f64,
    /// Standard deviation of ln f′ \[1\]; `None` keeps that of the settings.
    pub sigma: Option<f64>,
    /// Stiffness of the tool, as a multiple of that in the settings \[1\].
    pub stiffness: f64,
    /// Length and width of the footprint, as a multiple of those in the settings \[1\].
    pub footprint: f64,
    /// Additional offset of the tool in the hand \[m\].
    pub grasp_offset: Vector2,
    /// Additional rotation of the tool in the hand \[rad\].
    pub grasp_turn: f64,
    /// Errors of joint and force sensors; `None` keeps those of the settings.
    pub sensing: Option<Sensing>,
    /// Additional Coulomb friction of joints [Nm or N].
    pub joint_friction: f64,
    /// Waves in the surface; `None` keeps those of the settings.
    pub waviness: Option<Waviness>,
}

impl Default for Mismatch {
    /// No mismatch.
    fn default() -> Self {
        Self {
            dirt: None,
            count: None,
            mu_shift: 0.0,
            sigma: None,
            stiffness: 1.0,
            footprint: 1.0,
            grasp_offset: Vector2::zeros(),
            grasp_turn: 0.0,
            sensing: None,
            joint_friction: 0.0,
            waviness: None,
        }
    }
}

impl Mismatch {
    /// Draws a random mismatch in all quantities at once.
    ///
    /// The dirt lies uniformly, in heaps, in a band or along the edge. The mean of ln f′ is off by up to 0.5, its
    /// standard deviation is 0.15 to 0.5. Stiffness is off by up to 30 %, the footprint by 10 %, the grasp by 10 mm.
    /// Sensors have the errors of good sensors that have been used, and the surface has waves of up to half a
    /// millimetre.
    pub fn draw(seed: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(STREAM);
        let kind = random.random_range(0..4_u32);
        let mut between =
            |[low, high]: [f64; 2]| -> f64 { low + (high - low) * random.random::<f64>() };
        let (angle, radius) = (between([0.0, TAU]), between([0.0, GRASP]));
        Self {
            dirt: Some(match kind {
                0 => TrueDirt::Uniform,
                1 => TrueDirt::Clusters(None),
                2 => TrueDirt::Stripe {
                    center: None,
                    direction: None,
                    width: None,
                },
                _ => TrueDirt::Edge(between(EDGE_WIDTH)),
            }),
            count: None,
            mu_shift: between([-MU, MU]),
            sigma: Some(between(SIGMA)),
            stiffness: between(STIFFNESS),
            footprint: between(FOOTPRINT),
            grasp_offset: Vector2::new(libm::cos(angle), libm::sin(angle)) * radius,
            grasp_turn: between([-GRASP_TURN, GRASP_TURN]),
            sensing: Some(Sensing {
                encoder_noise: between([0.0, ENCODER_NOISE]),
                backlash: between([0.0, BACKLASH]),
                force_delay: between([0.0, FORCE_DELAY]),
                force_drift: Vector3::from_fn(|_, _| between([-FORCE_DRIFT, FORCE_DRIFT])),
            }),
            joint_friction: between([0.0, JOINT_FRICTION]),
            waviness: Some(Waviness {
                height: between([0.0, WAVINESS]),
                length: between(WAVE_LENGTH),
            }),
        }
    }
}

impl SimulationSettings {
    /// Returns these settings with a mismatch applied.
    #[must_use]
    pub fn with_mismatch(&self, mismatch: &Mismatch) -> Self {
        let mut settings = self.clone();
        if let Some(dirt) = &mismatch.dirt {
            settings.dirt = dirt.clone();
        }
        settings.count = mismatch.count.unwrap_or(self.count);
        settings.likelihood.mu += mismatch.mu_shift;
        settings.likelihood.sigma = mismatch.sigma.unwrap_or(self.likelihood.sigma);
        settings.tool = RealTool {
            stiffness: self.tool.stiffness * mismatch.stiffness,
            footprint: self.tool.footprint * mismatch.footprint,
            grasp_offset: self.tool.grasp_offset + mismatch.grasp_offset,
            grasp_turn: self.tool.grasp_turn + mismatch.grasp_turn,
        };
        settings.sensing = mismatch.sensing.unwrap_or(self.sensing);
        settings.joint_friction += mismatch.joint_friction;
        settings.waviness = mismatch.waviness.unwrap_or(self.waviness);
        settings
    }
}
