//! Acute corners of strokes.

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
