//! Executes a scenario undisturbed, pushed, and with the surface displaced, interprets the samples, and
//! prints it beside the truth.
//!
//! ```text
//! cargo run --release --package wisch-sim --example interpret -- [scenario, default chopping-board] [action, default the scenario's] [seed, default 1]
//! ```

use std::ops::ControlFlow;
use std::time::Instant;
use wisch::control::ControlConfig;
use wisch::follow::{FollowConfig, Followed, Workcell, WorkcellConfig, follow};
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{
    Belief, EventKind, InterpretConfig, Interpretation, TouchSample, interpret,
};
use wisch::plan::{CoverageStrategy, plan};
use wisch::represent::{Action, GoalState, Task};
use wisch::run::MotionOrder;
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{Dirt, Moment, Push, SimulationSettings, WorkSurface, execute};
use wisch_testkit::{AnyError, humanoid, scenario};

/// Force [N] and duration [s] of the pushes.
const PUSH: [f64; 2] = [15.0, 0.8];

struct Trial<'a> {
    task: &'a Task,
    cell: &'a Workcell,
    followed: &'a Followed,
    goal: &'a GoalState,
    seed: u64,
}

impl Trial<'_> {
    /// Executes, interprets, and prints both.
    fn run(&self, name: &str, reality: &SimulationSettings) -> Result<(), AnyError> {
        let dirt = Dirt::draw(&WorkSurface::from_task(self.task), reality, self.seed)?;
        let mut samples: Vec<TouchSample> = Vec::new();
        let order = MotionOrder {
            round: 1,
            seed: 0,
            task: self.task,
            cell: self.cell,
            followed: self.followed,
        };
        let (executed, truth) = execute(
            &order,
            reality,
            &dirt,
            &ControlConfig::default(),
            &mut |sample| {
                samples.push(TouchSample {
                    time: sample.time,
                    world_from_tool: sample.world_from_tool,
                    force: sample.external.force,
                });
                ControlFlow::Continue(())
            },
        )?;
        let truth = truth.performance(self.goal, &self.task.surface)?;
        let truth = truth.ok_or("no dirt was simulated")?;
        let begin = Instant::now();
        let believed = Belief::from_particles(self.task.particles.clone());
        let config = InterpretConfig::from_task(self.task);
        let interpretation = interpret(&samples, self.task, &believed, self.goal, &config)?;
        let milliseconds = begin.elapsed().as_secs_f64() * 1e3;
        println!(
            "{name:12} true {:5.1} %, believed {:5.1} % ({:.1} to {:.1}), {:.1} s of log in {milliseconds:.0} ms, contact {}, bias {}",
            100.0 * truth,
            100.0 * interpretation.performance.mean,
            100.0 * interpretation.performance.low,
            100.0 * interpretation.performance.high,
            executed.duration,
            known(interpretation.contact_share, |share| format!(
                "{:.1} %",
                100.0 * share
            )),
            known(interpretation.force_bias, |bias| format!("{bias:+.2} N")),
        );
        print_plane(&interpretation);
        print_events(&interpretation, &reality.pushes);
        Ok(())
    }

    /// The middle of the longest stroke [s].
    fn amid(&self) -> f64 {
        let contact = (self.followed.motions.iter()).filter(|m| m.phase.is_contact());
        let longest =
            contact.max_by(|a, b| (a.trajectory.duration()).total_cmp(&b.trajectory.duration()));
        longest.map_or(0.0, |motion| {
            motion.start + 0.5 * motion.trajectory.duration()
        })
    }
}

fn print_plane(interpretation: &Interpretation) {
    if let Some(plane) = &interpretation.plane {
        println!(
            "    plane tilted {:.2} deg, off {:+.2} mm, {} of {} contacts on it, {:.2} mm apart",
            plane.tilt.to_degrees(),
            1e3 * plane.offset,
            plane.inliers,
            plane.confident,
            1e3 * plane.rms
        );
    }
}

fn print_events(interpretation: &Interpretation, pushes: &[Push]) {
    for push in pushes {
        println!("    pushed at {} for {:.3} s", push.start, push.duration);
    }
    for event in interpretation
        .events
        .iter()
        .filter(|event| event.kind != EventKind::Contact)
    {
        println!(
            "    {:?} {:.3} to {:.3} s, {:.1} N, at most {:.1} N and {:.1} mm",
            event.kind,
            event.start,
            event.end,
            event.mean_normal_force,
            event.peak_force,
            1e3 * event.peak_height
        );
    }
}

fn main() -> Result<(), AnyError> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments
        .next()
        .unwrap_or_else(|| "chopping-board".to_owned());
    let asked = arguments.next();
    let seed: u64 = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let robot = humanoid();
    let named = |asked: String| {
        let mut actions = Action::WIPING.into_iter();
        actions
            .find(|action| action.as_str() == asked)
            .ok_or("no such action")
    };
    let options = LoadOptions {
        action: asked.map(named).transpose()?,
        strategy: Some(CoverageStrategy::Kde.into()),
        seed: Some(seed),
        ..LoadOptions::default()
    };
    let loaded = load_task(&scenario(&name), &options)?;
    let real = loaded.simulation.clone();
    let LoadedTask {
        file, task, run, ..
    } = loaded;
    let plan = plan(&task, &run.plan)?;
    let cell_config = WorkcellConfig {
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(robot.model.clone(), Some(&robot.srdf), &task, &cell_config)?;
    let config = FollowConfig::default();
    let map = robot.map.as_ref();
    let followed = follow(&task, &plan, &cell, map, &config, &mut |_| ())?;
    let trial = Trial {
        task: &task,
        cell: &cell,
        followed: &followed,
        goal: &plan.graph.goal,
        seed,
    };

    let calm = SimulationSettings {
        pushes: vec![],
        ..real.clone()
    };
    trial.run("undisturbed", &calm)?;
    let world_from_surface = &task.surface.world_from_surface;
    let [size, duration] = PUSH;
    for (name, direction) in [
        ("pushed up", Vector3::z()),
        ("pushed aside", Vector3::y()),
        ("pushed along", Vector3::x()),
        ("pushed down", -Vector3::z()),
    ] {
        let push = Push {
            round: 1,
            start: Moment::Seconds(trial.amid()),
            duration,
            force: world_from_surface * direction * size,
            hand_speed: 0.5,
        };
        trial.run(
            name,
            &SimulationSettings {
                pushes: vec![push],
                ..calm.clone()
            },
        )?;
    }
    let elsewhere = [
        (
            "tilted 2 deg",
            Pose::rotation(Vector3::new(0.0, 2.0_f64.to_radians(), 0.0)),
        ),
        ("5 mm higher", Pose::translation(0.0, 0.0, 0.005)),
        ("5 mm lower", Pose::translation(0.0, 0.0, -0.005)),
    ];
    for (name, believed_from_real) in elsewhere {
        trial.run(
            name,
            &SimulationSettings {
                believed_from_real,
                ..calm.clone()
            },
        )?;
    }
    Ok(())
}

/// A number in words; "unknown" if the log does not show it.
fn known(number: Option<f64>, in_words: impl Fn(f64) -> String) -> String {
    number.map_or_else(|| "unknown".to_owned(), in_words)
}
