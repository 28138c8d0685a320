//! Rounds for the tests: a sponge with a synthetic, slightly noisy log, and crumbs that match it.

use super::input::{RoundView, RoundsInput};
use std::f64::consts::TAU;
use wisch::geometry::{Point3, Pose, Vector2, Vector3};
use wisch::interpret::{
    Belief, ContactResidual, Diagnosis, Event, EventKind, FittedPlane, InterpretConfig,
    Interpretation, PathPiece, PerformanceDistribution, Touch, TouchSample, interpret,
};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, TcpWaypoint, plan, predict};
use wisch::represent::{Fate, GoalState, LogNormal, ParticleDistribution, Performance, Task};

/// Speed of the tool [m/s], and duration of a piece of the path [s].
const SPEED: f64 = 0.12;
const PERIOD: f64 = 0.004;
/// Height above which the tool is lifted [m].
const LIFTED: f64 = 0.5e-3;
const REPLAYS: u64 = 24;
/// Maximum distance of the tool centre at which it affects a particle [m].
const REACH: f64 = 0.045;

/// The disturbance of a round.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Trouble {
    Nothing,
    /// The surface is tilted by this about its y axis [rad].
    Tilted(f64),
    /// The tool is pushed twice.
    Pushed,
}

pub(crate) struct Played {
    pub(crate) plan: Plan,
    pub(crate) believed: ParticleDistribution,
    pub(crate) predicted: f64,
    pub(crate) interpretation: Interpretation,
    pub(crate) truth: ParticleDistribution,
    pub(crate) share: f64,
    pub(crate) pushes: Vec<[f64; 2]>,
}

pub(crate) struct Demo {
    pub(crate) task: Task,
    pub(crate) goal: GoalState,
    pub(crate) rounds: Vec<Played>,
}

impl Demo {
    pub(crate) fn new(task: Task, troubles: &[Trouble]) -> Self {
        let mut demo = Self {
            goal: GoalState::Absorbed,
            rounds: Vec::new(),
            task,
        };
        // Flatter than that of real sponges, so that the probability curve is visible.
        demo.task.interaction.likelihood = LogNormal {
            mu: -0.6,
            sigma: 0.45,
        };
        let initial = demo.task.particles.clone();
        let (mut believed, mut truth) = (initial.clone(), initial.clone());
        for (number, &trouble) in troubles.iter().enumerate() {
            demo.task.particles = believed.clone();
            let round = demo.play(number as u64, trouble, &truth);
            believed = round.interpretation.belief.members()[0].clone();
            truth = round.truth.clone();
            demo.rounds.push(round);
        }
        demo.task.particles = initial;
        demo
    }

    fn play(&self, number: u64, trouble: Trouble, truth: &ParticleDistribution) -> Played {
        let config = PlanConfig {
            strategy: CoverageStrategy::Kde.into(),
            seed: 1,
            ..PlanConfig::default()
        };
        let plan = plan(&self.task, &config).expect("a plan");
        let predicted = predict(&self.task, &plan, |_| ()).performance.ratio();
        let way = build_commanded_path(&plan.tcp_path());
        let last = way.last().map_or(0.0, |(time, _)| *time);
        let pushes = match trouble {
            Trouble::Pushed => vec![[0.30, 0.36], [0.62, 0.65]],
            Trouble::Nothing | Trouble::Tilted(_) => Vec::new(),
        };
        let pushes: Vec<[f64; 2]> = (pushes.into_iter())
            .map(|push: [f64; 2]| push.map(|share| share * last))
            .collect();
        let path: Vec<PathPiece> = (way.iter().enumerate())
            .map(|(i, place)| {
                build_piece(
                    &self.task,
                    trouble,
                    &pushes,
                    number * 1_000_000 + i as u64,
                    place,
                )
            })
            .collect();
        let draw =
            |from: &ParticleDistribution, seed| wipe_particles(&self.task, &path, from, seed);
        let replays: Vec<ParticleDistribution> = (0..REPLAYS)
            .map(|replay| draw(&self.task.particles, 100 * number + replay))
            .collect();
        let truth = draw(truth, 7_000 + number);
        let belief = Belief::from_members(replays).expect("replays of one length");
        let performance = belief.performance(&self.goal, &self.task.surface, 0.0);
        Played {
            believed: self.task.particles.clone(),
            predicted,
            interpretation: build_interpretation(trouble, &path, belief, performance),
            share: Performance::evaluate(&truth, &self.goal, &self.task.surface).ratio(),
            truth,
            pushes,
            plan,
        }
    }

    /// Interprets the logs of the rounds with the library.
    pub(crate) fn interpret_logs(mut self) -> Self {
        let config = InterpretConfig::from_task(&self.task);
        for round in &mut self.rounds {
            let log = sample_pieces(&self.task, &round.interpretation.path);
            let before = Belief::from_particles(round.believed.clone());
            round.interpretation = interpret(&log, &self.task, &before, &self.goal, &config)
                .expect("the log can be interpreted");
        }
        self
    }

    pub(crate) fn views(&self) -> Vec<RoundView<'_>> {
        (self.rounds.iter().enumerate())
            .map(|(i, round)| RoundView {
                number: i + 1,
                plan: Some(&round.plan),
                believed: &round.believed,
                predicted: round.predicted,
                interpretation: &round.interpretation,
                truth: Some((&round.truth, round.share)),
                pushes: &round.pushes,
            })
            .collect()
    }

    pub(crate) fn input<'a>(&'a self, views: &'a [RoundView<'a>]) -> RoundsInput<'a> {
        RoundsInput {
            task: &self.task,
            goal: &self.goal,
            target: 0.95,
            rounds: views,
        }
    }
}

/// Returns a log that corresponds to pieces of a path.
fn sample_pieces(task: &Task, path: &[PathPiece]) -> Vec<TouchSample> {
    let world_from_surface = task.surface.world_from_surface;
    let sample = |piece: &PathPiece| {
        let p = piece.position;
        // The force on the tool is opposite to the force on the surface.
        let force = Vector3::new(piece.tangential_force, 0.0, -piece.normal_force);
        TouchSample {
            time: piece.time[0],
            world_from_tool: world_from_surface * Pose::translation(p.x, p.y, p.z),
            force: world_from_surface * force,
        }
    };
    path.iter().map(sample).collect()
}

/// Returns a pseudo-random number between −1 and 1 (SplitMix64).
fn draw_noise(seed: u64) -> f64 {
    let mut z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// Returns times and commanded positions of the tool, one per piece.
fn build_commanded_path(corners: &[TcpWaypoint]) -> Vec<(f64, Point3)> {
    let place = |w: &TcpWaypoint| {
        let p = w.surface_from_tool.position;
        Point3::new(p.x, p.y, w.height)
    };
    let mut way = Vec::new();
    for leg in corners.windows(2) {
        let (from, to) = (place(&leg[0]), place(&leg[1]));
        let steps = ((to - from).norm() / (SPEED * PERIOD)).ceil().max(1.0) as usize;
        for step in 0..steps {
            let share = step as f64 / steps as f64;
            way.push((way.len() as f64 * PERIOD, from + (to - from) * share));
        }
    }
    way
}

fn build_piece(
    task: &Task,
    trouble: Trouble,
    pushes: &[[f64; 2]],
    seed: u64,
    &(time, wanted): &(f64, Point3),
) -> PathPiece {
    let press = task.interaction.press_force_n;
    let tilt = match trouble {
        Trouble::Tilted(angle) => angle,
        Trouble::Nothing | Trouble::Pushed => 0.0,
    };
    let ground = -tilt.tan() * wanted.x;
    let push = pushes
        .iter()
        .find(|[from, to]| (*from..=*to).contains(&time));
    let swing = |[from, to]: &[f64; 2]| (TAU / 2.0 * (time - from) / (to - from)).sin();
    let (height, force, touch) = if let Some(push) = push {
        let height = wanted.z + 0.004 + 0.018 * swing(push);
        (
            height,
            -(0.5 + 0.6 * swing(push)) * press,
            Touch::FalsePositive,
        )
    } else if wanted.z > LIFTED {
        (wanted.z - ground, 0.0, Touch::Free)
    } else {
        // Where the surface falls away, the tool presses less, and then not at all.
        let missing = (ground / -0.010).clamp(0.0, 1.3);
        let force = press * (0.96 - missing) * (1.0 - 0.12 * (3.0 * time).sin().powi(4));
        let touch = match force / press {
            share if share >= 0.9 => Touch::Confident,
            share if share > 0.05 => Touch::Weak,
            _ => Touch::Free,
        };
        // A tool that is pressed with less force is less compressed.
        let relief = 1.0 - (force / press).clamp(0.0, 1.0);
        let mut gap = relief * task.interaction.compression_depth_m;
        if touch == Touch::Free {
            gap += 0.002;
        }
        (gap, -force.max(0.0), touch)
    };
    let force = force + 0.02 * press * draw_noise(2 * seed);
    let height = height + 1.5e-4 * draw_noise(2 * seed + 1);
    PathPiece {
        time: [time, time + PERIOD],
        position: Point3::new(wanted.x, wanted.y, ground + height),
        heading: 0.0,
        normal_force: force,
        tangential_force: 0.3 * force.abs(),
        normalized_force: (-force / press).clamp(0.0, 1.0),
        height,
        slope: Vector2::zeros(),
        touch,
    }
}

/// Wipes each particle with the probability of the strongest contact near it.
fn wipe_particles(
    task: &Task,
    path: &[PathPiece],
    particles: &ParticleDistribution,
    seed: u64,
) -> ParticleDistribution {
    let contact = |piece: &&PathPiece| matches!(piece.touch, Touch::Weak | Touch::Confident);
    let wiped = particles.iter().enumerate().map(|(i, (p, fate))| {
        let near = |piece: &&PathPiece| (piece.position.xy() - p).norm() < REACH;
        let hardest = (path.iter().filter(contact).filter(near))
            .map(|piece| piece.normalized_force)
            .fold(0.0, f64::max);
        let chance = task.interaction.likelihood.probability(hardest);
        let threshold = 0.5 * (1.0 + draw_noise(seed * 10_000 + i as u64));
        let is_absorbed = fate == Fate::Absorbed || threshold < chance;
        (
            p,
            if is_absorbed {
                Fate::Absorbed
            } else {
                Fate::OnSurface
            },
        )
    });
    ParticleDistribution::with_fates(&wiped.collect::<Vec<_>>()).expect("our own list")
}

fn build_interpretation(
    trouble: Trouble,
    path: &[PathPiece],
    belief: Belief,
    distribution: PerformanceDistribution,
) -> Interpretation {
    let performance = distribution.estimate();
    let tilt = match trouble {
        Trouble::Tilted(angle) => angle,
        Trouble::Nothing | Trouble::Pushed => 0.002,
    };
    let confident = (path.iter().filter(|p| p.touch == Touch::Confident)).count();
    let time = |wanted: &dyn Fn(Touch) -> bool| path.iter().filter(|p| wanted(p.touch)).count();
    let contact = time(&|touch| matches!(touch, Touch::Weak | Touch::Confident));
    let near = path
        .iter()
        .filter(|p| p.touch != Touch::Free || p.height < 0.01)
        .count();
    Interpretation {
        path: path.to_vec(),
        plane: Some(FittedPlane {
            point: Point3::new(0.0, 0.0, 2e-4),
            normal: Vector3::new(tilt.sin(), 0.0, tilt.cos()),
            tilt,
            offset: 2e-4,
            directions: 2,
            inliers: confident * 95 / 100,
            confident,
            rms: 3e-4,
        }),
        registration: None,
        // A bump of 0.4 mm, and a hollow of 0.2 mm.
        residuals: [([0.01, 0.01], 4e-4), ([0.03, 0.01], -2e-4)]
            .map(|(place, height)| ContactResidual {
                place: place.into(),
                height,
                contacts: 5,
            })
            .to_vec(),
        doubts: vec![],
        diagnosis: if tilt > 0.01 {
            Diagnosis::Relocalize {
                world_from_surface: Pose::identity(),
            }
        } else {
            Diagnosis::Localized
        },
        events: list_events(path),
        force_bias: Some(0.12),
        pressed_force: Some(10.0),
        tool_stiffness: None,
        contact_share: Some(contact as f64 / near.max(1) as f64),
        belief,
        distribution,
        by_touch: performance,
        observation: None,
        performance,
    }
}

/// Returns intervals of contact, pushes, and contact losses between contacts without a lift.
fn list_events(path: &[PathPiece]) -> Vec<Event> {
    let kind = |piece: &PathPiece| match piece.touch {
        Touch::Weak | Touch::Confident => Some(EventKind::Contact),
        Touch::FalsePositive => Some(EventKind::Push),
        Touch::Free if piece.height < 0.0085 => Some(EventKind::ContactLoss),
        Touch::Free => None,
    };
    let runs = path.chunk_by(|a, b| kind(a) == kind(b));
    let event = |run: &[PathPiece]| {
        let mean = run.iter().map(|p| p.normal_force).sum::<f64>() / run.len() as f64;
        kind(&run[0]).map(|kind| Event {
            kind,
            start: run[0].time[0],
            end: run[run.len() - 1].time[1],
            samples: 4 * run.len(),
            mean_normal_force: mean,
            peak_force: run.iter().map(|p| p.normal_force.abs()).fold(0.0, f64::max),
            peak_height: run.iter().map(|p| p.height).fold(0.0, f64::max),
        })
    };
    let lasts = |event: &Event| match event.kind {
        // Approach and lift are not contact losses.
        EventKind::ContactLoss => event.end - event.start > 0.12,
        _ => event.end - event.start > 0.03,
    };
    runs.filter_map(event).filter(lasts).collect()
}
