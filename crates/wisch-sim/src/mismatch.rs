//! How a world differs from what a robot believes of it.

use crate::{GrainCount, Places, RealTool, Sensing, SimulationSettings, Waviness};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use wisch::geometry::{Vector2, Vector3};

/// Stream of the random numbers of mismatches, apart from those of tasks and worlds with the same seed.
const STREAM: u64 = 0x6d69_736d_6174_6368;
/// How far each quantity may be off in a random world, either way or at most, in the units of [`Mismatch`].
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
/// How far from the edge dirt along it lies at most [m].
const EDGE: [f64; 2] = [0.02, 0.08];

/// What is different in a world, laid over the settings of a task by [`SimulationSettings::with`].
///
/// ```
/// use wisch_sim::{Mismatch, Places};
/// let softer = Mismatch { places: Some(Places::Edge(0.03)), stiffness: 0.7, ..Mismatch::default() };
/// assert_ne!(softer, Mismatch::default());
/// assert_eq!(Mismatch::random(3), Mismatch::random(3));
/// assert_ne!(Mismatch::random(3), Mismatch::random(4));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mismatch {
    /// Where the dirt lies; `None` leaves it to the settings.
    pub places: Option<Places>,
    /// How much of it there is; `None` leaves it to the settings.
    pub count: Option<GrainCount>,
    /// What is added to the mean of ln f′ from which on a grain is taken along.
    pub mu_shift: f64,
    /// Standard deviation of ln f′; `None` leaves it to the settings.
    pub sigma: Option<f64>,
    /// Stiffness of the tool over the settings' [1].
    pub stiffness: f64,
    /// Length and width of its footprint over the settings' [1].
    pub footprint: f64,
    /// What is added to where the tool sits in the hand [m].
    pub grasp_offset: Vector2,
    /// What is added to how far it is turned there [rad].
    pub grasp_turn: f64,
    /// How joints and forces are measured; `None` leaves it to the settings.
    pub sensing: Option<Sensing>,
    /// What is added to the Coulomb friction of joints [Nm or N].
    pub joint_friction: f64,
    /// Waves in the surface; `None` leaves them to the settings.
    pub waviness: Option<Waviness>,
}

impl Default for Mismatch {
    /// None at all.
    fn default() -> Self {
        Self {
            places: None,
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
    /// A random one, everything at once: dirt anywhere, in heaps, in a band or along the edge; mean of ln f′ off by 0.5 at
    /// most and its spread 0.15 to 0.5; stiffness off by 30 %, footprint by 10 %, the grasp by 10 mm; joints and forces
    /// measured as by good sensors that have been used; waves of half a millimetre.
    pub fn random(seed: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(STREAM);
        let kind = random.random_range(0..4_u32);
        let mut between =
            |[low, high]: [f64; 2]| -> f64 { low + (high - low) * random.random::<f64>() };
        let (angle, radius) = (between([0.0, TAU]), between([0.0, GRASP]));
        Self {
            places: Some(match kind {
                0 => Places::Uniform,
                1 => Places::Clusters(None),
                2 => Places::Stripe {
                    center: None,
                    direction: None,
                    width: None,
                },
                _ => Places::Edge(between(EDGE)),
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
    /// The same world, but for a mismatch.
    #[must_use]
    pub fn with(&self, mismatch: &Mismatch) -> Self {
        let mut settings = self.clone();
        if let Some(places) = &mismatch.places {
            settings.dirt = places.clone();
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
