//! The humanoid at the chopping board: its torso, its coupled joint and its base take part.

use crate::problems::robots;
use crate::wiping::{Wiping, as_believed, faults};
use std::fs;
use std::path::{Path, PathBuf};
use wisch::control::ControlConfig;
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, follow};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan};
use wisch::represent::{Action, Intent, KnowledgeBase, TaskFile};
use wisch::run::Ending;
use wisch_sim::Dirt;

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

/// Its first stroke.
fn wiping() -> Wiping {
    let text = fs::read_to_string(root().join("scenarios/chopping-board.toml")).unwrap();
    let file = TaskFile::parse("chopping-board.toml", &text, &[]).unwrap();
    let Intent::Action { tool, medium, .. } = file.intent() else {
        panic!("it names no tool");
    };
    let read = |folder: &'static str| {
        move |path: &str| fs::read(root().join(folder).join(path)).map_err(|e| e.to_string())
    };
    let (mut assets, mut meshes) = (read("scenarios"), read("knowledge"));
    let knowledge = knowledge();
    let task = file
        .resolve(
            Action::Absorb,
            tool,
            medium,
            1,
            &knowledge,
            &mut assets,
            &mut meshes,
        )
        .unwrap();
    let config = PlanConfig {
        strategy: CoverageStrategy::Grid,
        seed: 1,
        bandwidth: file.bandwidth_m(),
        lift_height: file.lift_height_m(),
    };
    let plan = plan(&task, &config).unwrap();
    let plan = Plan {
        strokes: plan.strokes.into_iter().take(1).collect(),
        ..plan
    };
    let [.., humanoid] = robots().unwrap();
    let config = WorkcellConfig {
        world_from_robot: file.robot().and_then(|robot| robot.world_from_robot),
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
