//! The humanoid at the chopping board.

use std::f64::consts::TAU;
use wisch::follow::{FollowConfig, Followed, Phase, Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan};
use wisch::represent::{Action, Task};
use wisch::robot::CapabilityMap;
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

/// Returns the plan by the strategy of the file.
pub fn planned(file: &TaskFile, task: &Task) -> Plan {
    let config = PlanConfig {
        strategy: CoverageStrategy::Kde.into(),
        seed: 1,
        bandwidth: file.run.plan.bandwidth,
        lift_height: file.run.plan.lift_height,
        ..PlanConfig::default()
    };
    plan(task, &config).unwrap()
}

/// The humanoid in front of the chopping board, its task, and its capability map.
fn at_the_board() -> (Task, Plan, Workcell, Option<CapabilityMap>) {
    let (file, task) = shipped("chopping-board", Action::Collect);
    let plan = planned(&file, &task);
    let humanoid = humanoid();
    let config = WorkcellConfig {
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(humanoid.model, Some(&humanoid.srdf), &task, &config).unwrap();
    (task, plan, cell, humanoid.map)
}

#[test]
fn the_humanoid_wipes_the_whole_chopping_board_with_its_base_still() {
    let (task, plan, cell, map) = at_the_board();
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, map.as_ref(), &config, &mut |_| ()).unwrap();

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

#[test]
fn a_base_that_has_turned_round_begins_with_the_turns_that_it_counts() {
    let (task, plan, cell, map) = at_the_board();
    let base = cell.base().unwrap();
    let mut stands = cell.ready_posture().to_vec();
    stands[base.yaw] -= 2.0 * TAU - 0.01;
    let cell = cell.with_turns_of(&stands);
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, map.as_ref(), &config, &mut |_| ()).unwrap();

    assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
    let headings: Vec<f64> = (followed.motions.iter())
        .flat_map(|motion| motion.trajectory.samples(0.02))
        .map(|sample| sample.q[base.yaw])
        .collect();
    assert!((headings[0] - stands[base.yaw]).abs() < 0.05);
    // The base makes no needless turns.
    assert!(
        headings
            .windows(2)
            .all(|pair| (pair[1] - pair[0]).abs() < 0.1)
    );
}

/// The largest share of its velocity and of its acceleration limit that each joint of the robot uses in a motion,
/// those that follow others included, with the joint's name.
fn largest_shares(cell: &Workcell, followed: &Followed) -> Vec<(String, [f64; 2])> {
    let mut shares = Vec::new();
    for joint in cell.robot().joints() {
        let (Some(velocity), Some(acceleration)) =
            (joint.limits.velocity, joint.limits.acceleration)
        else {
            continue;
        };
        let mut most = [0.0_f64; 2];
        for motion in &followed.motions {
            for sample in motion.trajectory.samples(0.002) {
                most[0] = most[0].max(joint.drive.rate(&sample.qd).abs() / velocity);
                most[1] = most[1].max(joint.drive.rate(&sample.qdd).abs() / acceleration);
            }
        }
        shares.push((joint.name.clone(), most));
    }
    shares
}

#[test]
fn no_joint_exceeds_its_limits_and_neither_does_one_that_follows_others() {
    let loaded = load_task(
        &wisch_testkit::scenario("solar-panel-brush"),
        &LoadOptions::default(),
    )
    .unwrap();
    let (task, file) = (loaded.task, loaded.file);
    let plan = plan(&task, &loaded.run.plan).unwrap();
    let humanoid = humanoid();
    let config = WorkcellConfig {
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let cell = Workcell::new(humanoid.model, Some(&humanoid.srdf), &task, &config).unwrap();
    let map = humanoid.map.as_ref();
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, map, &config, &mut |_| ()).unwrap();

    let shares = largest_shares(&cell, &followed);
    assert!(shares.iter().any(|(joint, _)| joint == "torso_4"));
    for (joint, [velocity, acceleration]) in shares {
        assert!(
            velocity <= 1.0 + 1e-6 && acceleration <= 1.0 + 1e-6,
            "{joint}: {velocity:.3} of its velocity limit, {acceleration:.3} of its acceleration limit"
        );
    }
}
