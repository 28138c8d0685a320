//! The first ten seconds of wiping in the simulated world: arm of seven joints and humanoid, on a clean
//! board and with 80 breadcrumbs on it. Items are periods of 1 ms: 10 kitem/s are ten times real time.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use std::ops::ControlFlow;
use wisch::control::ControlConfig;
use wisch::follow::{FollowConfig, Followed, Workcell, WorkcellConfig, follow};
use wisch::geometry::Point2;
use wisch::plan::{CoverageStrategy, plan};
use wisch::represent::{Action, ParticleDistribution, Task};
use wisch::run::{Execution, MotionOrder};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{Dirt, SimulationSettings, execute};
use wisch_testkit::{ShippedRobot, arm7 as the_arm7, humanoid as the_humanoid, scenario};

fn main() {
    divan::main();
}

/// How long is wiped, from the first contact on [s].
const WIPED: f64 = 10.0;
const GRAINS: [usize; 2] = [0, 80];

struct Wiping {
    task: Task,
    cell: Workcell,
    followed: Followed,
    reality: SimulationSettings,
    dirt: Dirt,
    config: ControlConfig,
}

/// A shipped scenario with a given number of grains.
fn wiping(name: &str, grains: usize, robot: ShippedRobot) -> Wiping {
    let options = LoadOptions {
        action: Some(Action::Collect),
        strategy: Some(CoverageStrategy::Kde.into()),
        seed: Some(1),
        ..LoadOptions::default()
    };
    let loaded = load_task(&scenario(name), &options).unwrap();
    let reality = loaded.simulation;
    let LoadedTask {
        file, task, run, ..
    } = loaded;
    let plan = plan(&task, &run.plan).unwrap();
    let config = WorkcellConfig {
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(robot.model, Some(&robot.srdf), &task, &config).unwrap();
    let config = FollowConfig::default();
    let map = robot.map.as_ref();
    let mut followed = follow(&task, &plan, &cell, map, &config, &mut |_| ()).unwrap();
    let first = followed.motions.iter().position(|m| m.phase.is_contact());
    let end = followed.motions[first.unwrap()].start + WIPED;
    followed.motions.retain(|motion| motion.start < end);
    // The scenario's own dirt, over and over where it is too little.
    let own: Vec<Point2> = (task.particles.iter())
        .map(|(position, _)| position)
        .collect();
    let places: Vec<Point2> = own.into_iter().cycle().take(grains).collect();
    let dirt = Dirt::scatter(&ParticleDistribution::new(&places).unwrap(), &reality, 1);
    Wiping {
        task,
        cell,
        followed,
        reality,
        dirt,
        config: ControlConfig::default(),
    }
}

impl Wiping {
    fn execute(&self) -> Execution {
        let order = MotionOrder {
            round: 1,
            seed: 0,
            task: &self.task,
            cell: &self.cell,
            followed: &self.followed,
        };
        let executed = execute(
            &order,
            &self.reality,
            &self.dirt,
            &self.config,
            &mut |sample| {
                black_box(sample);
                ControlFlow::Continue(())
            },
        );
        executed.unwrap().0
    }

    fn bench(&self, bencher: Bencher) {
        let periods = (self.followed.duration() / self.config.period) as usize;
        bencher
            .counter(ItemsCount::new(periods))
            .bench_local(|| self.execute());
    }
}

#[divan::bench(args = GRAINS, sample_count = 5, sample_size = 1)]
fn arm7(bencher: Bencher, grains: usize) {
    wiping("arm-board", grains, the_arm7()).bench(bencher);
}

#[divan::bench(args = GRAINS, sample_count = 5, sample_size = 1)]
fn humanoid(bencher: Bencher, grains: usize) {
    wiping("chopping-board", grains, the_humanoid()).bench(bencher);
}
