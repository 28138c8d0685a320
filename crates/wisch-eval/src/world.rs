//! Randomised worlds: task, mismatch between world and belief, and disturbances.

use crate::task_case::TaskCase;
use nalgebra::{Translation3, UnitQuaternion};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};
use wisch::geometry::{Pose, Vector2, Vector3};
use wisch::represent::{LogNormal, Task};
use wisch_sim::{Moment, Push, SimulationSettings, TrueDirt};

/// Stream of random numbers, independent of the task's.
const STREAM: u64 = 0x776f_726c_6400_0000;
/// Difference between μ of the true law and the believed one; its sign is random.
const LAW: f64 = 0.5;
/// A law that is much harder than believed.
const HARD: LogNormal = LogNormal {
    mu: -0.35,
    sigma: 0.4,
};
/// Relative differences between the true and the believed tool: stiffness and size [1].
const STIFFNESS: f64 = 0.3;
const FOOTPRINT: f64 = 0.1;
/// Offset of the tool in the hand [m]; its direction is random.
const GRASP: f64 = 0.01;
/// Maximum tilt of the true surface about its x and y [rad], and maximum offset along its normal [m].
const TILT: f64 = 3.0 * PI / 180.0;
const HEIGHT: f64 = 0.010;
/// Maximum number of pushes; and for a push, force [N], start as a share of the motion [1], duration [s], and speed of the
/// hand [m/s].
const PUSHES: u32 = 2;
const PUSH_FORCE: [f64; 2] = [10.0, 40.0];
const PUSH_START: [f64; 2] = [0.1, 0.9];
const PUSH_DURATION: [f64; 2] = [0.5, 2.5];
const HAND_SPEED: [f64; 2] = [0.05, 0.5];
/// Coulomb coefficient between tool and surface [1].
const FRICTION: [f64; 2] = [0.2, 0.9];
/// Maximum bias of the force sensor per axis, and standard deviation of its noise [N].
const BIAS: f64 = 1.0;
const NOISE: [f64; 2] = [0.0, 0.5];

/// The mismatch between a world and the robot's belief about it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MismatchKind {
    /// None: the grains are one draw of the belief and move as believed.
    AsBelieved,
    /// Grains are uniformly distributed, drawn independently of the belief.
    Uniform,
    /// Grains are in heaps.
    Clusters,
    /// Grains are in a band.
    Stripe,
    /// μ of the law is higher or lower by 0.5.
    Law,
    /// Grains are much harder to move: μ = -0.35, σ = 0.4.
    HardLaw,
    /// The tool is 30 % stiffer or softer.
    Stiffness,
    /// The tool is offset by 10 mm in the hand.
    Grasp,
    /// The tool's footprint is 10 % larger or smaller.
    Footprint,
}

impl MismatchKind {
    /// All kinds of mismatch, in the order of tables.
    pub const ALL: [Self; 9] = [
        Self::AsBelieved,
        Self::Uniform,
        Self::Clusters,
        Self::Stripe,
        Self::Law,
        Self::HardLaw,
        Self::Stiffness,
        Self::Grasp,
        Self::Footprint,
    ];

    /// Name of the mismatch in files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::AsBelieved => "as believed",
            Self::Uniform => "uniform, drawn apart",
            Self::Clusters => "clusters",
            Self::Stripe => "stripe",
            Self::Law => "law: mu ± 0.5",
            Self::HardLaw => "law: mu -0.35, sigma 0.4",
            Self::Stiffness => "stiffness ± 30 %",
            Self::Grasp => "grasp off by 10 mm",
            Self::Footprint => "footprint ± 10 %",
        }
    }

    fn apply(self, settings: &mut SimulationSettings, task: &Task, random: &mut ChaCha8Rng) {
        let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
        let angle = TAU * random.random::<f64>();
        settings.dirt = match self {
            Self::AsBelieved => TrueDirt::Listed(task.particles.clone()),
            Self::Clusters => TrueDirt::Clusters(None),
            Self::Stripe => TrueDirt::Stripe {
                center: None,
                direction: None,
                width: None,
            },
            _ => TrueDirt::Uniform,
        };
        match self {
            Self::AsBelieved | Self::Uniform | Self::Clusters | Self::Stripe => {}
            Self::Law => settings.likelihood.mu += sign * LAW,
            Self::HardLaw => settings.likelihood = HARD,
            Self::Stiffness => settings.tool.stiffness = 1.0 + sign * STIFFNESS,
            Self::Footprint => settings.tool.footprint = 1.0 + sign * FOOTPRINT,
            Self::Grasp => {
                settings.tool.grasp_offset =
                    GRASP * Vector2::new(libm::cos(angle), libm::sin(angle));
            }
        }
    }
}

/// The disturbance that acts during the rounds of a world.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Disturbance {
    /// No disturbance.
    None,
    /// The surface is tilted and shifted; friction, bias and noise differ from the belief.
    Place,
    /// As `Place`, and a person pushes once or twice in the first round.
    Push,
}

impl Disturbance {
    /// All kinds of disturbance, in the order of tables.
    pub const ALL: [Self; 3] = [Self::None, Self::Place, Self::Push];

    /// Name of the disturbance in files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::None => "undisturbed",
            Self::Place => "surface elsewhere",
            Self::Push => "pushed",
        }
    }

    fn apply(self, settings: &mut SimulationSettings, random: &mut ChaCha8Rng) {
        if self == Self::None {
            return;
        }
        let mut between =
            |[low, high]: [f64; 2]| -> f64 { low + (high - low) * random.random::<f64>() };
        let tilt = Vector3::new(between([-TILT, TILT]), between([-TILT, TILT]), 0.0);
        settings.believed_from_real = Pose::from_parts(
            Translation3::new(0.0, 0.0, between([-HEIGHT, HEIGHT])),
            UnitQuaternion::from_scaled_axis(tilt),
        );
        settings.friction = between(FRICTION);
        settings.force_bias = Vector3::from_fn(|_, _| between([-BIAS, BIAS]));
        settings.force_noise = between(NOISE);
        if self == Self::Place {
            return;
        }
        let count = 1 + between([0.0, f64::from(PUSHES)]) as u32;
        let push = |_| {
            // A uniform direction: z uniform in [-1, 1], azimuth uniform in [0, 2π) (Archimedes' hat-box theorem).
            let (up, angle) = (between([-1.0, 1.0]), between([0.0, TAU]));
            let across = (1.0 - up * up).sqrt();
            let direction = Vector3::new(across * libm::cos(angle), across * libm::sin(angle), up);
            Push {
                round: 1,
                start: Moment::Share(between(PUSH_START)),
                duration: between(PUSH_DURATION),
                force: between(PUSH_FORCE) * direction,
                hand_speed: between(HAND_SPEED),
            }
        };
        settings.pushes = (0..count).map(push).collect();
    }
}

/// The senses that the robot uses in a world.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Senses {
    /// Tool poses and forces, as in the paper.
    Touch,
    /// Touch, and a camera that observes the dirt before the first round and after each round.
    TouchAndSight,
}

/// A world of an evaluation, which its seed determines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct WorldCase {
    /// Seed of world and task.
    pub seed: u64,
    /// The task.
    pub task: TaskCase,
    /// Mismatch between world and belief.
    pub mismatch: MismatchKind,
    /// Disturbance.
    pub disturbance: Disturbance,
}

impl WorldCase {
    /// Returns the world of a seed. 243 consecutive seeds cover each combination of task, mismatch and disturbance once.
    pub fn from_seed(seed: u64) -> Self {
        let digit = |place: u64, base: usize| (seed / place) as usize % base;
        let tasks: Vec<TaskCase> = TaskCase::cases_by_surface().collect();
        // Each seed advances by one mismatch and each block by one task, so that a few consecutive seeds are mixed, too.
        let (mismatch, block) = (digit(1, 9), digit(9, 9));
        Self {
            seed,
            task: tasks[(mismatch + block) % tasks.len()],
            mismatch: MismatchKind::ALL[mismatch],
            disturbance: Disturbance::ALL[(digit(81, 3) + mismatch + digit(9, 9)) % 3],
        }
    }

    /// Returns the world's settings, based on the scenario's settings without disturbances.
    pub fn settings(&self, calm: &SimulationSettings, task: &Task) -> SimulationSettings {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(STREAM);
        let mut settings = calm.clone();
        self.mismatch.apply(&mut settings, task, &mut random);
        self.disturbance.apply(&mut settings, &mut random);
        settings
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn seeds_in_a_row_have_each_combination_once() {
        let of = |seed| {
            let case = WorldCase::from_seed(seed);
            (case.task, case.mismatch, case.disturbance)
        };
        for first in [1, 1000, 10_000] {
            let all: HashSet<_> = (first..first + 243).map(of).collect();
            assert_eq!(all.len(), 243);
            // Nine consecutive seeds have all mismatches and all tasks.
            let few: Vec<_> = (first..first + 9).map(of).collect();
            let mismatches: HashSet<_> = few.iter().map(|case| case.1).collect();
            assert_eq!(mismatches.len(), 9);
        }
    }
}
