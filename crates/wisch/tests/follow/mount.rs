//! Mounts of tools: as declared, from the SRDF, or square on the flange; and the collisions that
//! they permit.

use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};
use wisch::follow::{
    FollowConfig, FollowError, Followed, MotionFault, MountSource, Phase, PlanningGroup, Workcell,
    WorkcellConfig, audit, follow,
};
use wisch::geometry::Pose;
use wisch::represent::{Action, Grip, Mount, Task};
use wisch::robot::{LinkAxis, RobotModel, Srdf};
use wisch_testkit::{block, board, cell, humanoid, planned, root};

/// Returns the angle between the tool's normal and the axis of the link that holds it [rad].
fn lean(cell: &Workcell) -> f64 {
    let out = cell.tip_from_tool().rotation * Vector3::z();
    out.angle(&-Vector3::z())
}

fn text(file: &str) -> String {
    std::fs::read_to_string(root().join("robots").join(file)).expect("it is shipped")
}

/// Returns the cell of a robot that is given by its texts.
fn cell_of(urdf: &str, srdf: &str, task: &Task) -> Workcell {
    let robot = RobotModel::from_urdf("robot.urdf", urdf, &mut |_| Err(String::new())).unwrap();
    let srdf = Srdf::parse("robot.srdf", srdf, &robot).unwrap();
    Workcell::new(robot, Some(&srdf), task, &WorkcellConfig::default()).unwrap()
}

#[test]
fn a_tool_is_square_on_a_flange_unless_task_or_robot_declares_otherwise() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let held = cell(&task);
    assert!(lean(&held) < 1e-9);
    assert_eq!(held.mount().source, MountSource::Assumed);
    assert!(
        held.mount().to_string().ends_with("(assumed)"),
        "{}",
        held.mount()
    );
    let thickness = task.tool.mesh.bounds().1.z;
    let out = held.tip_from_tool().translation.z;

    let hand = humanoid();
    let config = WorkcellConfig::default();
    let leaning = Workcell::new(hand.model, Some(&hand.srdf), &task, &config).unwrap();
    assert_eq!(leaning.mount().source, MountSource::Srdf);
    assert!((lean(&leaning) - 0.8).abs() < 1e-9);

    let (yaw, distance) = (0.5, Some(0.1));
    task.tool.mount = Some(Mount::Flange {
        yaw,
        distance,
        holder_radius: None,
        axis: None,
    });
    let turned = cell(&task);
    assert_eq!(turned.mount().source, MountSource::Declared);
    assert!((turned.tip_from_tool().translation.z - 0.1 - thickness).abs() < 1e-9);
    let between = held.tip_from_tool().rotation.inverse() * turned.tip_from_tool().rotation;
    assert!((between.angle() - yaw).abs() < 1e-9);

    task.tool.mount = Some(Mount::Hand { lean: 0.4 });
    assert!((lean(&cell(&task)) - 0.4).abs() < 1e-9);

    let upside = UnitQuaternion::from_euler_angles(PI, 0.0, 0.0);
    let tool_from_hand = Pose::from_parts([0.0, 0.0, thickness].into(), upside);
    task.tool.mount = Some(Mount::Grip(Grip { tool_from_hand }));
    let gripped = cell(&task).tip_from_tool().inverse() * held.tip_from_tool();
    assert!(gripped.translation.vector.norm() + gripped.rotation.angle() < 1e-9);
    assert!(out >= thickness);
}

#[test]
fn a_hand_points_along_the_axis_that_task_or_robot_declares() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    for axis in LinkAxis::ALL {
        let holder = format!("<tool_holder link=\"tcp\" axis=\"{axis}\"/></robot>");
        let srdf = text("arm7.srdf").replace("</robot>", &holder);
        let cell = cell_of(&text("arm7.urdf"), &srdf, &task);
        assert_eq!(
            (cell.mount().axis, cell.mount().source),
            (axis, MountSource::Srdf)
        );
        let out = cell.tip_from_tool().rotation * -Vector3::z();
        let expected = axis.frame().rotation * Vector3::z();
        assert!((out - expected).norm() < 1e-9, "{axis}");
        let along = cell.tip_from_tool().translation.vector.dot(&expected);
        assert!(
            along >= task.tool.mesh.bounds().1.z - 1e-9,
            "{axis}: {along}"
        );
    }
    task.tool.mount = Some(Mount::Flange {
        yaw: 0.0,
        distance: Some(0.1),
        holder_radius: None,
        axis: Some(LinkAxis::NegativeY),
    });
    let declared = cell(&task);
    let out = declared.tip_from_tool().translation.vector;
    let height = task.tool.mesh.bounds().1.z;
    assert!(
        (out - Vector3::new(0.0, -0.1 - height, 0.0)).norm() < 1e-9,
        "{out}"
    );
}

#[test]
fn a_holder_between_flange_and_tool_keeps_clear_of_obstacles() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    task.tool.mount = Some(Mount::Flange {
        yaw: 0.0,
        distance: Some(0.3),
        holder_radius: None,
        axis: None,
    });
    let free = cell(&task);
    let holder = free
        .mount()
        .holder
        .expect("the tool is far from the flange");
    assert!(holder.is_assumed && holder.ends[1] - holder.ends[0] > 0.15);
    let text = free.mount().to_string();
    assert!(
        text.contains("holder 0.") && text.contains("(assumed)"),
        "{text}"
    );
    let plan = planned(&task);
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &free, None, &config, &mut |_| ()).unwrap();
    assert_eq!(followed.abandoned, []);
    assert!(audit(&followed, &free, &task, &config).unwrap().is_sound());

    // A block half way along the holder, where the robot waits and in the middle of the motion.
    let middle_at = |q: &[f64]| {
        let kinematics = free.robot().forward_kinematics(q).unwrap();
        let half = Pose::translation(0.0, 0.0, f64::midpoint(holder.ends[0], holder.ends[1]));
        let tip = free.world_from_root() * kinematics.world_from_link(free.tip());
        (tip * half).translation.vector
    };
    let name = format!("holder of {}", task.tool.name);
    let during = followed.sample(followed.duration() / 2.0).unwrap().q;
    let mut planted = task.clone();
    let at = middle_at(&during);
    (planted.scene).push(block("bar", [0.01, 0.01, 0.01], [at.x, at.y, at.z]));
    let found = audit(&followed, &cell(&planted), &planted, &config).unwrap();
    let names_both = |a: &str, b: &str| [a, b].contains(&"bar") && [a, b].contains(&name.as_str());
    assert!(
        (found.faults.iter())
            .any(|fault| matches!(fault, MotionFault::Contact { a, b, .. } if names_both(a, b))),
        "{:?}",
        found.faults
    );

    let at = middle_at(free.ready_posture());
    (task.scene).push(block("bar", [0.01, 0.01, 0.01], [at.x, at.y, at.z]));
    let refused = follow(&task, &plan, &cell(&task), None, &config, &mut |_| ());
    assert!(
        matches!(&refused, Err(FollowError::StartBlocked { a, b, .. }) if names_both(a, b)),
        "{refused:?}"
    );
}

#[test]
fn a_gripper_on_the_tip_holds_the_tool_at_its_end() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let gripper = r#"
  <link name="palm"><collision><origin xyz="0 0 0.03"/><geometry><box size="0.1 0.1 0.06"/></geometry></collision></link>
  <link name="knuckle"/>
  <link name="finger"><collision><origin xyz="0 0 0.02"/><geometry><box size="0.02 0.02 0.04"/></geometry></collision></link>
  <joint name="on_tcp" type="fixed"><parent link="tcp"/><child link="palm"/></joint>
  <joint name="bend" type="revolute"><parent link="palm"/><child link="knuckle"/><origin xyz="0 0 0.06"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="5"/></joint>
  <joint name="on_knuckle" type="fixed"><parent link="knuckle"/><child link="finger"/></joint>
</robot>"#;
    let urdf = text("arm7.urdf").replace("</robot>", gripper);
    let bare = cell(&task);
    let with = cell_of(&urdf, &text("arm7.srdf"), &task);
    let out = |cell: &Workcell| cell.tip_from_tool().translation.z;
    let before = out(&bare) - task.tool.mesh.bounds().1.z;
    assert!((out(&with) - out(&bare) - (0.1 - before)).abs() < 1e-9);
    // Without a group, the arm wipes and not its gripper.
    let robot = with.robot();
    let group = PlanningGroup::choose(robot, None, None).unwrap();
    assert_eq!(robot.links()[group.tip.index()].name, "tcp");
    // The fingers touch the tool that they hold.
    let ready = with.ready_posture().to_vec();
    let touched = with.collisions().collision(&ready, 1e-3).unwrap();
    assert!(touched.is_none(), "{touched:?}");
}

#[test]
fn a_group_above_a_lift_wipes_while_the_lift_stays_at_its_ready_position() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.3]);
    let lift = r#"<link name="rail"/>
  <joint name="lift" type="prismatic"><parent link="rail"/><child link="link_0"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="0.4" velocity="0.1" effort="1000"/></joint>
</robot>"#;
    let urdf = text("arm7.urdf").replace("</robot>", lift);
    let lifted = r#"<group name="column"><joint name="lift"/></group>
  <group_state name="ready" group="column"><joint name="lift" value="0.1"/></group_state>
</robot>"#;
    let srdf = text("arm7.srdf").replace("</robot>", lifted);
    let cell = cell_of(&urdf, &srdf, &task);
    assert_eq!(cell.held_joints(), ["lift"]);
    let plan = planned(&task);
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    assert_eq!(followed.abandoned, []);
    let variable = (0..cell.robot().dof())
        .find(|&i| cell.robot().variable(i).name == "lift")
        .expect("it has a lift");
    for motion in &followed.motions {
        assert!(
            motion
                .trajectory
                .samples(0.1)
                .all(|at| at.q[variable] == 0.1)
        );
    }
}

#[test]
fn joints_that_no_ready_state_sets_are_at_home() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let homely = text("arm7.srdf").replace("name=\"ready\"", "name=\"home\"");
    let at_home = cell_of(&text("arm7.urdf"), &homely, &task);
    assert_eq!(at_home.ready_posture(), cell(&task).ready_posture());
}

/// Returns the arm whose last joint turns without limits and is ready nearly a turn off, and a motion of it.
fn turning(task: &Task) -> (Workcell, Followed) {
    let urdf = text("arm7.urdf");
    let (head, last) = urdf
        .split_once("<joint name=\"joint_7\" type=\"revolute\">")
        .unwrap();
    let urdf = format!("{head}<joint name=\"joint_7\" type=\"continuous\">{last}");
    let srdf = text("arm7.srdf");
    let at = srdf.find("<joint name=\"joint_7\" value=\"").unwrap();
    let (before, after) = srdf.split_at(at);
    let end = after.find("/>").unwrap();
    let srdf = format!(
        "{before}<joint name=\"joint_7\" value=\"6\"{}",
        &after[end..]
    );
    let cell = cell_of(&urdf, &srdf, task);
    let config = FollowConfig::default();
    let followed = follow(task, &planned(task), &cell, None, &config, &mut |_| ()).unwrap();
    (cell, followed)
}

#[test]
fn free_motion_to_a_stroke_takes_the_nearest_turn_of_a_joint() {
    for action in [Action::Absorb, Action::Skim] {
        let task = board(action, [0.5, 0.0, 0.2]);
        let (cell, followed) = turning(&task);
        assert_eq!(followed.abandoned, []);
        let joint = |i: &usize| cell.robot().variable(*i).name == "joint_7";
        let variable = (0..cell.robot().dof()).find(joint).expect("it has it");
        let motions = &followed.motions;
        for pair in motions.windows(2) {
            if pair[0].phase != Phase::FreeMotion || pair[1].phase != Phase::Lower {
                continue;
            }
            let end = |time: f64| pair[0].trajectory.sample(time).q[variable];
            let turned = end(pair[0].trajectory.duration()) - end(0.0);
            assert!(turned.abs() <= PI + 1e-9, "{action}: {turned} rad");
            assert!((turned / TAU).round() == 0.0, "{action}: {turned} rad");
        }
    }
}

#[test]
fn a_limit_of_speed_between_strokes_is_kept() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let cell = cell(&task);
    let fastest = |free_speed: f64| {
        let config = FollowConfig {
            free_speed,
            ..FollowConfig::default()
        };
        let followed = follow(&task, &planned(&task), &cell, None, &config, &mut |_| ()).unwrap();
        let mut fastest: f64 = 0.0;
        for motion in &followed.motions {
            let tool: Vec<Vector3<f64>> = (motion.trajectory.samples(0.01))
                .map(|at| {
                    let kinematics = cell.robot().forward_kinematics(&at.q).unwrap();
                    let tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
                    tool.translation.vector
                })
                .collect();
            if !matches!(motion.phase, Phase::Wipe(_)) {
                let speeds = tool
                    .windows(2)
                    .map(|pair| (pair[1] - pair[0]).norm() / 0.01);
                fastest = speeds.fold(fastest, f64::max);
            }
        }
        fastest
    };
    let free = fastest(f64::INFINITY);
    assert!(free > 0.25, "{free} m/s");
    for limit in [0.25, 0.1] {
        let kept = fastest(limit);
        assert!(kept <= 1.01 * limit, "{kept} m/s, not {limit} m/s");
    }
}
