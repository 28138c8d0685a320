//! A broom that both hands hold.

use super::wiping::{Log, Wiping, as_believed};
use wisch::control::ControlConfig;
use wisch::follow::{FollowConfig, Phase, Workcell, follow};
use wisch::geometry::{Point3, Vector3};
use wisch::plan::{CoverageStrategy, plan};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{Dirt, Moment, Push};
use wisch_testkit::{first_stroke, humanoid, scenario};

/// Largest measured force of an arm that is led along [N]; a push is detected from 2 N on.
const FREE_FORCE: f64 = 1.5;

/// The first stroke of the broom.
fn sweeping() -> Wiping {
    let options = LoadOptions {
        strategy: Some(CoverageStrategy::Grid.into()),
        seed: Some(1),
        ..LoadOptions::default()
    };
    let LoadedTask {
        file, task, run, ..
    } = load_task(&scenario("broom-chippings"), &options).unwrap();
    let plan = first_stroke(plan(&task, &run.plan).unwrap());
    let humanoid = humanoid();
    let config = file.robot.as_ref().unwrap().workcell_config(&task);
    let cell = Workcell::new(humanoid.model, Some(&humanoid.srdf), &task, &config).unwrap();
    let (map, config) = (humanoid.map.as_ref(), FollowConfig::default());
    let followed = follow(&task, &plan, &cell, map, &config, &mut |_| ()).unwrap();
    Wiping {
        settings: as_believed(),
        dirt: Dirt::default(),
        config: ControlConfig::default(),
        seed: 0,
        task,
        cell,
        followed,
    }
}

/// How far the second hand's place on the stick moves along with the stick: greatest distance between where that
/// place is at the start, seen from the stick, and where the hand has it [m].
fn slip(log: &Log, wiping: &Wiping) -> f64 {
    let robot = wiping.cell.robot();
    let second = wiping.cell.second_arm().expect("two hands").chain().tip();
    let mut held: Option<(Point3, Point3)> = None;
    let mut most: f64 = 0.0;
    for row in log.rows.iter().step_by(20) {
        let kinematics = robot.forward_kinematics(&row.positions).unwrap();
        let world_from_hand = wiping.cell.world_from_root() * kinematics.world_from_link(second);
        let tool_from_hand = row.world_from_tool.inverse() * world_from_hand;
        let (in_hand, in_tool) = *held.get_or_insert_with(|| {
            let grip = wiping.task.tool.second_grip.as_ref().unwrap().point_in_tool;
            (tool_from_hand.inverse() * grip, grip)
        });
        most = most.max((tool_from_hand * in_hand - in_tool).norm());
    }
    most
}

#[test]
fn the_second_hand_stays_on_the_stick_also_when_somebody_pushes_it() {
    let mut wiping = sweeping();
    let start = wiping.midst();
    wiping.settings.pushes = vec![Push {
        round: 1,
        start: Moment::Seconds(start),
        duration: 0.6,
        force: Vector3::new(40.0, 0.0, 0.0),
        hand_speed: 0.3,
    }];
    let log = wiping.execute_until(start + 0.8);
    log.assert_finite();
    let led = log.furthest();
    assert!(led > 0.02, "the push leads the broom by {led} m");
    let slip = slip(&log, &wiping);
    assert!(slip < 3e-3, "the hand slips by {slip} m");
}

#[test]
fn in_the_air_the_second_arm_exerts_no_measured_force() {
    let wiping = sweeping();
    let log = wiping.execute();
    let free = log.rows.iter().filter(|row| row.phase == Phase::FreeMotion);
    let felt = free.map(|row| row.external.norm()).fold(0.0, f64::max);
    assert!(felt < FREE_FORCE, "{felt} N in the air");
}
