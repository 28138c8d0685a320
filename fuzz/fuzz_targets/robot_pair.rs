//! A URDF and an SRDF, apart by a line: what `wisch robot check` says of them, and a work cell with that robot.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;
use wisch::follow::{Workcell, WorkcellConfig};
use wisch::geometry::Pose;
use wisch::represent::{Action, Task};
use wisch::robot::{IkConfig, RobotModel, RotationGoal, Severity, Srdf, check};
use wisch_testkit::board;

/// The line between the two.
const APART: &str = "<!-- SRDF -->";

/// More links than this take too long [1].
const MOST_LINKS: usize = 60;

static TASK: LazyLock<Task> = LazyLock::new(|| board(Action::Absorb, [0.45, 0.0, 0.3]));

fuzz_target!(|text: &str| {
    let (urdf, srdf) = text.split_once(APART).unwrap_or((text, ""));
    let mut no_meshes = |_: &str| Err("no meshes".to_owned());
    let Ok(findings) = check("fuzz.urdf", urdf, &mut no_meshes) else {
        return;
    };
    let made = RobotModel::from_urdf("fuzz.urdf", urdf, &mut no_meshes);
    let is_sound = findings
        .iter()
        .all(|finding| finding.severity != Severity::Error);
    let Ok(robot) = made else {
        assert!(!is_sound, "refused, though nothing was found");
        return;
    };
    let findings = Srdf::check("fuzz.srdf", srdf, &robot);
    let srdf = Srdf::parse("fuzz.srdf", srdf, &robot).ok();
    let is_refused = findings
        .iter()
        .any(|finding| finding.severity == Severity::Error);
    assert_eq!(
        srdf.is_none(),
        is_refused,
        "check and reader differ: {findings:?}"
    );
    if robot.links().len() > MOST_LINKS {
        return;
    }
    let Ok(cell) = Workcell::new(robot, srdf.as_ref(), &TASK, &WorkcellConfig::default()) else {
        return;
    };
    assert_eq!(cell.ready_posture().len(), cell.robot().dof());
    let _ = cell
        .collisions()
        .clearance(cell.ready_posture(), 0.1)
        .expect("a posture of this robot");
    let target = Pose::translation(0.45, 0.0, 0.3);
    let reached = cell
        .ik()
        .solve(&target, RotationGoal::Full, &[], 1, &IkConfig::default());
    let _ = reached.expect("a target that can be asked for");
});
