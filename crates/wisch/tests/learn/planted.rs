//! Worlds with a planted law: a sponge wipes a board with a force that varies, and a camera
//! observes it before and after.

use super::super::interpret::log::{PRESS, STEEP, Script, task};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{Point2, Region, Vector2};
use wisch::interpret::{Exposure, InterpretConfig, Interpreter, TouchSample};
use wisch::learn::{GUESSES, ObservedRound};
use wisch::random::normal_pair;
use wisch::represent::{
    Effect, Interaction, LogNormal, LogNormalSpread, Observation, SensorModel, Sight, Task,
};

/// Force of the tool by place, for each log [N]: in two of them between 20 and 100 % of the press
/// force; in the others so small that most grains need several draws to respond, except for one
/// column, which shows the height of the board.
const PRESSES: [fn(Point2) -> f64; 4] = [
    |p| PRESS * (0.6 + 2.0 * p.x),
    |p| PRESS * (0.6 - 2.0 * p.x),
    |p| PRESS * if p.x > 0.1 { 0.95 } else { 0.34 },
    |p| PRESS * if p.x < -0.1 { 0.95 } else { 0.28 },
];

/// Strokes over the board, by log: along it, the sponge's 7 cm over each place; strokes of 2 cm at
/// all places; and back and forth at each place, 3 cm seven times or 5 cm five times.
fn strokes(log: usize) -> Vec<[Point2; 2]> {
    let line = |from: [f64; 2], to: [f64; 2]| [Point2::from(from), Point2::from(to)];
    let (side, times) = match log {
        0 => {
            let rows = [-0.085, 0.085, 0.0];
            return rows.map(|y| line([-0.2, y], [0.2, y])).to_vec();
        }
        1 => (0.02, 1),
        2 => (0.03, 7),
        _ => (0.05, 5),
    };
    let at_place = |place: i32| {
        let [x, y] = [
            0.1 * f64::from(place % 4) - 0.15,
            0.12 * f64::from(place / 4) - 0.06,
        ];
        let [from, to] = [[x - side / 2.0, y], [x + side / 2.0, y]];
        (0..times).map(move |time| {
            if time % 2 == 0 {
                line(from, to)
            } else {
                line(to, from)
            }
        })
    };
    (0..8).flat_map(at_place).collect()
}

/// The law of a world.
#[derive(Debug, Clone, Copy)]
pub struct Planted {
    pub mu: f64,
    pub sigma: f64,
    /// ℓ [m]; `None` where thresholds are kept for good.
    pub redraw: Option<f64>,
}

impl Planted {
    /// Whether a particle with this exposure stays.
    fn stays(&self, exposure: &Exposure, force_scale: f64, random: &mut ChaCha8Rng) -> bool {
        let law = LogNormal {
            mu: self.mu,
            sigma: self.sigma,
        };
        let draws = match self.redraw {
            Some(length) => exposure.draws(length),
            None => vec![exposure.max_share()],
        };
        let mut stays = true;
        for share in draws {
            stays &= random.random::<f64>() >= law.probability(share * force_scale);
        }
        stays
    }
}

/// Worlds that differ in their dirt, in the real force of the tool and in the detections of the
/// camera.
pub struct World {
    planted: Planted,
    effect: Effect,
    particles: usize,
    task: Task,
    logs: Vec<Vec<TouchSample>>,
    pub sight: Sight,
    /// Standard deviation of the logarithm of the ratio of real to measured force in a round [1].
    pub force_share: f64,
}

impl World {
    pub fn new(planted: Planted, effect: Effect, particles: usize) -> Self {
        let task = task(0, STEEP);
        let logs = PRESSES.iter().enumerate().map(|(log, press)| {
            let script = Script {
                strokes: strokes(log),
                press: *press,
                rate: 100.0,
                ..Script::default()
            };
            script.samples(&task)
        });
        let logs = logs.collect();
        Self {
            planted,
            effect,
            particles,
            task,
            logs,
            sight: sight(),
            force_share: 0.08,
        }
    }

    pub fn with(&self, planted: Planted) -> Self {
        Self {
            planted,
            task: self.task.clone(),
            logs: self.logs.clone(),
            ..*self
        }
    }

    fn interpreter(&self, seed: u64, log: usize) -> Interpreter {
        let config = InterpretConfig {
            seed,
            ..InterpretConfig::from_task(&self.task)
        };
        let mut interpreter = Interpreter::new(&self.task, &config).unwrap();
        for sample in &self.logs[log] {
            interpreter.push(sample).unwrap();
        }
        interpreter
    }

    /// A round of wiping, observed before and after.
    pub fn round(&self, seed: u64) -> ObservedRound {
        self.run(seed, 1).remove(0)
    }

    /// Rounds of one run: what stays in the first is wiped again in the second.
    pub fn run(&self, seed: u64, rounds: usize) -> Vec<ObservedRound> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let [length, width] = super::super::interpret::log::BOARD;
        let anywhere = |random: &mut ChaCha8Rng| {
            let [x, y] = [random.random::<f64>() - 0.5, random.random::<f64>() - 0.5];
            Point2::new(x * length, y * width)
        };
        let mut dirt: Vec<Point2> = (0..self.particles).map(|_| anywhere(&mut random)).collect();
        // If thresholds are kept, each particle has one.
        let mut kept: Vec<f64> = dirt.iter().map(|_| random.random()).collect();
        let mut before = self.seen(&dirt, anywhere, &mut random);
        let mut felt: Vec<Interpreter> = Vec::new();
        let mut found = Vec::new();
        for round in 0..rounds {
            let log = (seed as usize + round) % self.logs.len();
            let scale = libm::exp(self.force_share * normal_pair(&mut random).x);
            // The true pose of the tool in the hand is a guess of another seed.
            let really = self.interpreter(seed ^ 0x5eed, log);
            let exposures = really.exposures(&dirt, self.effect, 0.0, 1).unwrap();
            let mut moved = Vec::new();
            let law = LogNormal {
                mu: self.planted.mu,
                sigma: self.planted.sigma,
            };
            let stays: Vec<bool> = (exposures.iter().zip(&kept))
                .map(|(exposure, kept)| match self.planted.redraw {
                    None => *kept >= law.probability(exposure[0].max_share() * scale),
                    Some(_) => self.planted.stays(&exposure[0], scale, &mut random),
                })
                .collect();
            for (place, stays) in dirt.iter().zip(&stays) {
                if self.effect == Effect::Push && !stays {
                    moved.push(Point2::new(0.19 + 0.005 * random.random::<f64>(), place.y));
                }
            }
            let mut flags = stays.iter();
            dirt.retain(|_| *flags.next().unwrap());
            let mut flags = stays.iter();
            kept.retain(|_| *flags.next().unwrap());
            let there: Vec<Point2> = dirt.iter().copied().chain(moved).collect();
            let after = self.seen(&there, anywhere, &mut random);
            let sigma = self.sight.sensor.position_error_m;
            let exposed = |interpreter: &Interpreter| {
                let places = &before.detections;
                interpreter
                    .exposures(places, self.effect, sigma, GUESSES)
                    .unwrap()
            };
            let interpreter = self.interpreter(seed, log);
            let exposures = exposed(&interpreter);
            let mut earlier = Vec::new();
            for felt in &felt {
                let most = exposed(felt).into_iter().map(|guesses| {
                    let most = guesses.iter().map(Exposure::max_share);
                    most.collect::<Vec<f64>>()
                });
                let most: Vec<Vec<f64>> = most.collect();
                if earlier.is_empty() {
                    earlier = most;
                } else {
                    for (known, most) in earlier.iter_mut().zip(most) {
                        for (known, most) in known.iter_mut().zip(most) {
                            *known = known.max(most);
                        }
                    }
                }
            }
            felt.push(interpreter);
            found.push(ObservedRound {
                before: std::mem::replace(&mut before, after.clone()),
                after,
                sight: self.sight,
                area_m2: length * width,
                exposures,
                earlier,
            });
        }
        found
    }

    fn seen(
        &self,
        dirt: &[Point2],
        anywhere: impl Fn(&mut ChaCha8Rng) -> Point2,
        random: &mut ChaCha8Rng,
    ) -> Observation {
        let Sight { sensor, detection } = self.sight;
        let mut detections = Vec::new();
        for place in dirt {
            let error: Vector2 = normal_pair(random) * sensor.position_error_m;
            if random.random::<f64>() < detection {
                detections.push(place + error);
            }
        }
        // Exponential gaps: a Poisson-distributed number of false alarms.
        let [length, width] = super::super::interpret::log::BOARD;
        let mut left = sensor.false_alarms_per_m2 * length * width;
        loop {
            left += libm::log(1.0 - random.random::<f64>());
            if left < 0.0 {
                break;
            }
            detections.push(anywhere(random));
        }
        Observation {
            detections,
            hidden: Region::default(),
        }
    }
}

/// Returns the detection of the dirt by a camera.
pub fn sight() -> Sight {
    let sensor = SensorModel::default();
    Sight {
        sensor,
        detection: sensor.detection,
    }
}

/// Returns the interaction of a pair before learning.
pub fn interaction_of(tool: &str, medium: &str) -> Interaction {
    Interaction {
        tool: tool.into(),
        medium: medium.into(),
        likelihood: STEEP,
        likelihood_spread: LogNormalSpread::default(),
        ..wisch_testkit::interaction()
    }
}
