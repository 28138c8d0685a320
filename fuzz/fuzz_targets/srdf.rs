//! SRDF files for a robot that is known, and the collisions of that robot with them.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;
use wisch::robot::{CollisionModel, RobotModel, Srdf};

static ROBOT: LazyLock<RobotModel> = LazyLock::new(|| {
    let text = include_str!("../../robots/arm6.urdf");
    RobotModel::from_urdf("arm6.urdf", text, &mut |_| Err(String::new())).expect("is shipped")
});

fuzz_target!(|text: &str| {
    let Ok(srdf) = Srdf::parse("fuzz.srdf", text, &ROBOT) else {
        return;
    };
    for state in &srdf.states {
        state.apply_to(&vec![0.0; ROBOT.dof()]);
    }
    for group in &srdf.groups {
        ROBOT
            .chain(group.base, group.tip)
            .expect("the tip hangs on the base");
    }
    CollisionModel::new(&ROBOT, Some(&srdf)).expect("of the same robot");
});
