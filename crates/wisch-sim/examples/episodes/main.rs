//! Random disturbance episodes: the humanoid wipes the chopping board while the board is not where it is
//! believed, somebody pushes, and the sensors err. What must never happen is counted: errors, panics,
//! numbers that are none, a controller that presses harder than allowed, and goals claimed that are not met.
//!
//! ```text
//! cargo run --release --package wisch-sim --example episodes -- [--seeds N] [--first-seed N] [--only N,N,...] [--scenario NAME] [--each]
//! ```
//!
//! Exits with 1 if any of it happened.

mod draw;
mod summary;

use draw::disturbed;
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use summary::{Episode, Fate, Pass, Summary};
use wisch::interpret::EventKind;
use wisch::represent::ParticleError;
use wisch::run::{PlannedRound, Round, RunEvent, Session, TelemetrySample};
use wisch_io::{Moment, load_task};
use wisch_sim::{GroundTruth, SimulationSettings, Site, World};
use wisch_testkit::{AnyError, Robot, by_density, humanoid, run_config, scenario};

/// What every episode has in common.
struct Stage {
    name: String,
    robot: Robot,
}

fn main() -> Result<ExitCode, AnyError> {
    let (mut seeds, mut first, mut name, mut tells_each) =
        (200, 1, "chopping-board".to_owned(), false);
    let mut only: Vec<u64> = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--seeds" => seeds = arguments.next().unwrap_or_default().parse()?,
            "--first-seed" => first = arguments.next().unwrap_or_default().parse()?,
            "--only" => {
                let list = arguments.next().unwrap_or_default();
                only = (list.split(',').map(str::parse)).collect::<Result<_, _>>()?;
            }
            "--scenario" => name = arguments.next().unwrap_or_default(),
            "--each" => tells_each = true,
            other => return Err(format!("{other:?} is no option").into()),
        }
    }
    let target = load_task(&scenario(&name), &by_density(first))?
        .file
        .target_performance();
    let stage = Stage {
        name,
        robot: humanoid(),
    };
    if only.is_empty() {
        only.extend(first..first + seeds);
    }
    let episodes: Vec<Episode> = only
        .into_par_iter()
        .map(|seed| {
            let episode = stage.episode(seed);
            if tells_each {
                println!("{episode}");
            }
            episode
        })
        .collect();
    let summary = Summary::of(&episodes, target);
    print!("{summary}");
    Ok(ExitCode::from(u8::from(!summary.is_clean())))
}

impl Stage {
    /// One episode; whatever happens in it stays in it.
    fn episode(&self, seed: u64) -> Episode {
        let mut bad_samples = 0;
        let mut reality = None;
        let fate = catch_unwind(AssertUnwindSafe(|| {
            self.perform(seed, &mut reality, &mut bad_samples)
        }));
        let fate = match fate {
            Ok(Ok(rounds)) => Fate::Ended(rounds),
            Ok(Err(error)) => Fate::Failed(error.to_string()),
            Err(panic) => Fate::Panicked(
                (panic.downcast_ref::<String>().cloned())
                    .or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()))
                    .unwrap_or_default(),
            ),
        };
        Episode {
            seed,
            disturbances: reality.as_ref().map_or_else(String::new, in_words),
            pushes: reality.map_or_else(Vec::new, |reality| {
                let pushes = reality.pushes.iter();
                pushes
                    .filter_map(|push| match push.start {
                        Moment::Seconds(start) => Some([start, start + push.duration]),
                        Moment::Share(_) | Moment::Stroke(_) => None,
                    })
                    .collect()
            }),
            bad_samples,
            fate,
        }
    }

    fn perform(
        &self,
        seed: u64,
        disturbances: &mut Option<SimulationSettings>,
        bad_samples: &mut usize,
    ) -> Result<Vec<Pass>, AnyError> {
        let loaded = load_task(&scenario(&self.name), &by_density(seed))?;
        let task = &loaded.task;
        let reality = disturbed(&SimulationSettings::of(&loaded)?, seed);
        *disturbances = Some(reality.clone());
        let mut world = World::new(&Site::of(task), reality, task.seed)?;
        let performer = self.robot.performer();
        let session = Session::new(task, run_config(&loaded)).with_belief(loaded.belief());
        let mut session = session.with_robot(performer);
        session.run(&mut world, &mut |event| {
            if let RunEvent::Sample(sample) = event {
                *bad_samples += usize::from(!is_finite(sample));
            }
            ControlFlow::Continue(())
        })?;
        let rounds = session.rounds().iter().zip(world.truth());
        Ok(rounds
            .map(|(round, truth)| pass(round, truth))
            .collect::<Result<_, _>>()?)
    }
}

/// Whether all that is measured are numbers.
fn is_finite(sample: &TelemetrySample<'_>) -> bool {
    let poses = [sample.world_from_commanded, sample.world_from_tool];
    let wrenches = [sample.controller, sample.external];
    [sample.positions, sample.velocities, sample.efforts]
        .concat()
        .iter()
        .all(|value| value.is_finite())
        && (poses.iter()).all(|pose| pose.to_homogeneous().iter().all(|value| value.is_finite()))
        && (wrenches.iter())
            .flat_map(|wrench| wrench.force.iter().chain(wrench.moment.iter()))
            .all(|value| value.is_finite())
}

/// What counts of a round.
fn pass(round: &Round, world: &GroundTruth) -> Result<Pass, ParticleError> {
    let PlannedRound { plan, task, .. } = &round.motion;
    let estimate = &round.interpretation.performance;
    let collisions = (round.interpretation.events.iter())
        .filter(|event| event.kind == EventKind::Collision)
        .map(|event| [event.start, event.end]);
    Ok(Pass {
        estimated: estimate.mean,
        interval: [estimate.low, estimate.high],
        truth: world.performance(&plan.graph.goal, &task.surface)?,
        collisions: collisions.collect(),
        verdict: round.verdict,
        ending: round.execution.ending.clone(),
        duration: round.execution.duration,
        controller_force: world.max_controller_force,
        force_limit: round.motion.task.interaction.press_force_n,
        contact_force: world.contact_force.mean(),
    })
}

fn in_words(reality: &SimulationSettings) -> String {
    let (x, y, _) = reality.believed_from_real.rotation.euler_angles();
    let pushes: Vec<String> = (reality.pushes.iter())
        .map(|push| {
            let [x, y, z]: [f64; 3] = push.force.into();
            let (start, duration) = (push.start, push.duration);
            format!("{start} for {duration:.1} s ({x:.0} {y:.0} {z:.0}) N")
        })
        .collect();
    format!(
        "tilt {:+.1} {:+.1}° height {:+.1} mm friction {:.2} pushes [{}]",
        x.to_degrees(),
        y.to_degrees(),
        1e3 * reality.believed_from_real.translation.z,
        reality.friction,
        pushes.join(", ")
    )
}
