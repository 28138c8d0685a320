//! The ground truth reaches neither the plan nor the interpretation.

use crate::execute::{Wiping, as_believed};
use std::ops::ControlFlow;
use wisch::geometry::Point2;
use wisch::represent::{Action, ParticleDistribution};
use wisch::run::{
    Execution, Executor, ExecutorError, MotionOrder, RecordedRound, RecordedSample, Recording,
};
use wisch::run::{RunConfig, SampleSink, Session};
use wisch_sim::{Dirt, SimulationSettings, TrueDirt, WorkSurface, World};
use wisch_testkit::{arm7, board};

/// A world, and the samples of the first round that its sink received.
struct Heard {
    world: World,
    rounds: Vec<RecordedRound>,
}

impl Executor for Heard {
    fn execute(
        &mut self,
        order: &MotionOrder<'_>,
        sink: &mut SampleSink<'_>,
    ) -> Result<Execution, ExecutorError> {
        let mut samples = Vec::new();
        let execution = self.world.execute(order, &mut |sample| {
            samples.push(RecordedSample::from(sample));
            sink(sample)
        })?;
        self.rounds.push(RecordedRound {
            samples,
            execution: execution.clone(),
            observation: None,
        });
        Ok(execution)
    }
}

#[test]
fn the_world_does_not_read_the_belief_about_the_dirt() {
    let mut wiping = Wiping::of_one_stroke(Action::Skim);
    wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
    let first = wiping.execute();
    wiping.task.particles = ParticleDistribution::new(&[Point2::new(0.01, 0.02)]).unwrap();
    let second = wiping.execute();
    assert_eq!(first.bytes(), second.bytes());
    assert_eq!(first.truth, second.truth);
}

#[test]
fn other_dirt_changes_no_plan_no_motion_and_no_interpretation_of_the_same_log() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let robot = arm7();
    let world = |dirt: TrueDirt| {
        let settings = SimulationSettings {
            dirt,
            ..as_believed()
        };
        World::new(&WorkSurface::from_task(&task), settings, 1).unwrap()
    };
    let rounds = |executor: &mut dyn Executor| {
        let config = RunConfig {
            max_rounds: 1,
            ..RunConfig::default()
        };
        let mut session = Session::new(&task, config).with_robot(robot.robot_setup());
        let ended = session.run(executor, &mut |_| ControlFlow::Continue(()));
        ended.unwrap();
        session.into_rounds()
    };
    let mut even = Heard {
        world: world(TrueDirt::Uniform),
        rounds: Vec::new(),
    };
    let mut edge = world(TrueDirt::Edge(0.01));
    assert_ne!(even.world.dirt(), edge.dirt());
    let [of_even, of_edge] = [rounds(&mut even), rounds(&mut edge)];
    assert_eq!(of_even[0].motion.plan, of_edge[0].motion.plan);
    let motions = [&of_even, &of_edge].map(|rounds| format!("{:?}", rounds[0].motion.followed));
    assert_eq!(motions[0], motions[1]);
    assert_ne!(even.world.truth()[0].dirt, edge.truth()[0].dirt);

    // The log of one world, interpreted in a session with the other.
    let mut recording = Recording::new(None, even.rounds, world(TrueDirt::Edge(0.01)));
    let again = rounds(&mut recording);
    let understood = [&again, &of_even].map(|rounds| format!("{:?}", rounds[0].interpretation));
    assert_eq!(understood[0], understood[1]);
    assert_eq!(again[0].verdict, of_even[0].verdict);
}
