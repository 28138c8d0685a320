//! Acute corners of strokes.

use std::fs;
use std::path::Path;
use wisch::plan::Strategy;
use wisch::run::{NoExecutor, Stage, ignore_events};
use wisch_io::{LoadOptions, load_task};
use wisch_testkit::root;

#[test]
fn the_tool_reaches_the_tip_of_an_acute_corner_as_the_audit_demands() {
    // Strokes to the dirt of a small surface turn by more than 140°. A rounded corner is then near both of its sides, and
    // far from its tip.
    for seed in [1, 2] {
        let part = ["(absorbed water table)", "sponge"].map(str::to_owned);
        let keys = ["goal", "tool.in_hand"].map(str::to_owned);
        let options = LoadOptions {
            settings: keys.into_iter().zip(part).collect(),
            strategy: Some("kde".parse::<Strategy>().unwrap()),
            seed: Some(seed),
            ..LoadOptions::default()
        };
        let loaded = load_task(&root().join("scenarios/kitchen.toml"), &options).unwrap();
        let robot = loaded.robot().unwrap().expect("the task has a robot");
        let mut session = loaded.session().with_robot(robot.robot_setup());
        (session.run_until(Stage::Audited, &mut NoExecutor, &mut ignore_events)).unwrap();
        let (_, audit) = session.first_motion().expect("a motion");
        assert_eq!(audit.faults, [], "seed {seed}");
    }
}

#[test]
fn corners_are_passed_slower_where_no_smaller_blend_keeps_the_tool_on_its_line() {
    // Accelerations are spread over 0.04 s, which takes the tool 1.3 mm off a corner of these strokes.
    let task = r#"
        schema = 1
        name = "corners"
        seed = 52
        action = "absorb"
        strategy = "kde"
        tool = { name = "sponge" }
        medium = { name = "water" }
        surface = { name = "board", size_m = [0.24, 0.24], position_m = [-0.2, 0, 0.77], carried_by = "block", friction = 0.35 }
        particles = { source = "uniform", count = 40 }
        robot = { name = "humanoid", position_m = [0, -1.1, 0], rpy_rad = [0, 0, 1.5707963267948966] }
        scene = [{ name = "block", box_m = [0.24, 0.24, 0.04], position_m = [-0.2, 0, 0.75] }]
    "#;
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("corners.toml");
    fs::write(&path, task).unwrap();
    let loaded = load_task(&path, &LoadOptions::default()).unwrap();
    let robot = loaded.robot().unwrap().expect("the task has a robot");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    (session.run_until(Stage::Audited, &mut NoExecutor, &mut ignore_events)).unwrap();
    let (_, audit) = session.first_motion().expect("a motion");
    assert_eq!(audit.faults, []);
}
