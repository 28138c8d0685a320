//! The humanoid at the chopping board: its torso, its coupled joint and its base take part.

use super::wiping::{Wiping, as_believed, faults};
use wisch::control::ControlConfig;
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, plan};
use wisch::represent::Action;
use wisch::run::Ending;
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::Dirt;
use wisch_testkit::{first_stroke, humanoid, scenario};

/// Its first stroke.
fn wiping() -> Wiping {
    let options = LoadOptions {
        action: Some(Action::Absorb),
        strategy: Some(CoverageStrategy::Grid.into()),
        seed: Some(1),
        ..LoadOptions::default()
    };
    let LoadedTask {
        file, task, run, ..
    } = load_task(&scenario("chopping-board"), &options).unwrap();
    let plan = first_stroke(plan(&task, &run.plan).unwrap());
    let humanoid = humanoid();
    let config = WorkcellConfig {
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(humanoid.model, Some(&humanoid.srdf), &task, &config).unwrap();
    let map = humanoid.map.as_ref();
    let config = FollowConfig::default();
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

#[test]
fn the_humanoid_wipes_as_softly_as_an_arm_that_is_bolted_down() {
    let wiping = wiping();
    let log = wiping.execute_until(wiping.midst() + 2.0);
    log.assert_finite();
    assert_eq!(faults(&log), [] as [String; 0]);
    assert!(matches!(
        log.executed.ending,
        Ending::Complete | Ending::Stopped
    ));
    assert!(log.truth.contact_force.count() > 200);
}
