//! The humanoid at the chopping board.

use wisch::follow::{FollowConfig, Phase, Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan};
use wisch::represent::{Action, Task};
use wisch_io::{LoadOptions, TaskFile, load_task};
use wisch_testkit::{faults, humanoid};

/// A scenario's file, and its task.
pub fn shipped(scenario: &str, action: Action) -> (TaskFile, Task) {
    let options = LoadOptions {
        action: Some(action),
        seed: Some(1),
        ..LoadOptions::default()
    };
    let loaded = load_task(&wisch_testkit::scenario(scenario), &options).unwrap();
    (loaded.file, loaded.task)
}

/// What the file's strategy plans.
pub fn planned(file: &TaskFile, task: &Task) -> Plan {
    let config = PlanConfig {
        strategy: CoverageStrategy::Kde,
        seed: 1,
        bandwidth: file.bandwidth_m(),
        lift_height: file.lift_height_m(),
    };
    plan(task, &config).unwrap()
}

#[test]
fn the_humanoid_wipes_the_whole_chopping_board_with_its_base_still() {
    let (file, task) = shipped("chopping-board", Action::Collect);
    let plan = planned(&file, &task);
    let humanoid = humanoid();
    let config = WorkcellConfig {
        world_from_robot: file.robot().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(humanoid.model, Some(&humanoid.srdf), &task, &config).unwrap();
    let map = humanoid.map.as_ref();
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, map, &config, &mut |_| ()).unwrap();

    assert_eq!(followed.abandoned, []);
    assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
    assert!(!followed.placements.is_empty());
    let base = cell.base().unwrap();
    let mut wipes = 0;
    for motion in &followed.motions {
        let samples: Vec<_> = motion.trajectory.samples(0.02).collect();
        let place = |i: usize| [base.x, base.y, base.yaw].map(|v| samples[i].q[v]);
        if motion.phase != Phase::Drive {
            assert!((0..samples.len()).all(|i| place(i) == place(0)));
        }
        wipes += usize::from(motion.phase.is_contact());
    }
    assert!(wipes > 0);
}
