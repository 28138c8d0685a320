//! Acute corners of strokes.

use wisch::follow::{FollowConfig, audit, follow};
use wisch::plan::Strategy;
use wisch::represent::Action;
use wisch::run::{NoExecutor, Stage, ignore_events};
use wisch_io::{LoadOptions, load_task};
use wisch_testkit::{board, cell, planned, root};

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
    // Spread over this time, the largest acceleration takes a joint 4 mrad off a corner, and the tool more than the 1 mm
    // that it may deviate by.
    let config = FollowConfig {
        acceleration_ramp: 0.1,
        ..FollowConfig::default()
    };
    for action in [Action::Absorb, Action::Collect] {
        let task = board(action, [0.5, 0.0, 0.2]);
        let (plan, cell) = (planned(&task), cell(&task));
        let followed = follow(&task, &plan, &cell, None, &config, &mut |_| {}).unwrap();
        let audit = audit(&followed, &cell, &task, &config).unwrap();
        assert_eq!(audit.faults, [], "{action}");
    }
}
