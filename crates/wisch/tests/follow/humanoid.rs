//! The humanoid at the chopping board.

use crate::board::faults;
use crate::problems::robots;
use std::fs;
use std::path::{Path, PathBuf};
use wisch::follow::{FollowConfig, Phase, Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan};
use wisch::represent::{Action, Intent, KnowledgeBase, Task, TaskFile};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn knowledge() -> KnowledgeBase {
    let names = ["tools", "media", "surfaces", "interactions"].map(|name| format!("{name}.toml"));
    let texts = (names.iter()).map(|name| fs::read_to_string(root().join("knowledge").join(name)));
    let texts: Vec<String> = texts.map(Result::unwrap).collect();
    let files: Vec<(&str, &str)> = (names.iter().map(String::as_str))
        .zip(texts.iter().map(String::as_str))
        .collect();
    KnowledgeBase::from_toml(&files).unwrap()
}

/// A scenario's file, and its task.
pub fn shipped(scenario: &str, action: Action) -> (TaskFile, Task) {
    let name = format!("{scenario}.toml");
    let text = fs::read_to_string(root().join("scenarios").join(&name)).unwrap();
    let file = TaskFile::parse(&name, &text, &[]).unwrap();
    let Intent::Action { tool, medium, .. } = file.intent() else {
        panic!("it names no tool");
    };
    let read = |folder: &'static str| {
        move |path: &str| fs::read(root().join(folder).join(path)).map_err(|e| e.to_string())
    };
    let task = file.resolve(
        action,
        tool,
        medium,
        1,
        &knowledge(),
        &mut read("scenarios"),
        &mut read("knowledge"),
    );
    let task = task.unwrap();
    (file, task)
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
    let [.., humanoid] = robots().unwrap();
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
