//! Both hands on a broom.

use super::humanoid::{planned, shipped};
use std::sync::mpsc::channel;
use std::time::Duration;
use wisch::follow::{
    AllowedContact, FollowConfig, FollowError, Followed, GRIP_TOLERANCE, LEAN_TOLERANCE,
    MotionFault, Phase, Workcell, WorkcellConfig, audit, follow,
};
use wisch::geometry::{Point3, Vector3};
use wisch::represent::{Action, Task};
use wisch_io::TaskFile;
use wisch_testkit::{board, cell, faults, humanoid};

/// Distance by which the humanoid's hand extends beyond the origin of its link: a capsule of 0.12 m
/// about 0.2 m [m].
const HAND: f64 = 0.32;

fn sweeping(file: &TaskFile, task: &Task, second: Option<&str>) -> Result<Workcell, FollowError> {
    let humanoid = humanoid();
    let config = WorkcellConfig {
        second_group: second.map(Into::into),
        world_from_robot: file.robot.as_ref().and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    Workcell::new(humanoid.model, Some(&humanoid.srdf), task, &config)
}

/// The first stroke of the scenario, swept with both hands.
fn swept() -> (TaskFile, Task, Workcell, Followed) {
    let (file, task) = shipped("broom-chippings", Action::Collect);
    let record = file.robot.as_ref().unwrap();
    let cell = sweeping(&file, &task, record.second_group.as_deref()).unwrap();
    let mut plan = planned(&file, &task);
    plan.strokes.truncate(1);
    let humanoid = humanoid();
    let config = FollowConfig::default();
    let followed = follow(
        &task,
        &plan,
        &cell,
        humanoid.map.as_ref(),
        &config,
        &mut |_| (),
    );
    let followed = followed.unwrap();
    assert_eq!(followed.abandoned, []);
    assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
    (file, task, cell, followed)
}

#[test]
fn both_hands_stay_on_the_stick_over_the_whole_motion() {
    let (file, mut task, cell, followed) = swept();
    let grip = task.tool.second_grip.unwrap();
    let left = cell.robot().link("left_tcp").unwrap();
    let mut moved = 0.0_f64;
    let mut before: Option<Point3> = None;
    let count = (followed.duration() / 0.01) as usize;
    for i in 0..=count {
        let q = followed.sample(i as f64 * 0.01).unwrap().q;
        let kinematics = cell.robot().forward_kinematics(&q).unwrap();
        let world_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        let world_from_left = kinematics.world_from_link(left);
        let hand = world_from_left * Point3::new(0.0, 0.0, HAND);
        let off = (world_from_tool * grip.point_in_tool - hand).norm();
        assert!(off <= GRIP_TOLERANCE, "{off} m off after {i} samples");
        let bar = world_from_tool * grip.axis_in_tool.into_inner();
        let lean = bar
            .dot(&(world_from_left * Vector3::y()))
            .abs()
            .min(1.0)
            .acos();
        assert!(lean <= grip.max_lean + LEAN_TOLERANCE, "{lean} rad");
        moved += before.map_or(0.0, |before| (hand - before).norm());
        before = Some(hand);
    }
    assert!(moved > 0.5, "the hand has only moved {moved} m");

    // With another or a stiffer grip on the stick, this motion has faults.
    let config = FollowConfig::default();
    let second = Some("left_arm");
    let is_off_grip = |fault: &MotionFault| matches!(fault, MotionFault::OffGrip { .. });
    let mut higher = grip;
    higher.point_in_tool.z += 1.5 * GRIP_TOLERANCE;
    let mut stiff = grip;
    stiff.max_lean = 0.0;
    for wrong in [higher, stiff] {
        task.tool.second_grip = Some(wrong);
        let cell = sweeping(&file, &task, second).unwrap();
        let faults = audit(&followed, &cell, &task, &config).unwrap().faults;
        assert!(
            !faults.is_empty() && faults.iter().all(is_off_grip),
            "{faults:?}"
        );
    }
}

#[test]
fn bristles_that_nothing_presses_hang_below_the_tool_centre_point() {
    let (_, task, cell, followed) = swept();
    let depth = task.interaction.compression_depth_m;
    let over_sheet = |q: &[f64]| {
        let kinematics = cell.robot().forward_kinematics(q).unwrap();
        let world_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        let sheet = task.surface.world_from_surface.translation.z;
        world_from_tool.translation.z - sheet
    };
    // Half as high as the bristles are compressed when they sweep.
    let times = (0..).map(|i| f64::from(i) * 1e-3);
    let lifting = times
        .filter(|time| {
            let motion = (followed.motions.iter().rev()).find(|motion| motion.start <= *time);
            motion.is_some_and(|motion| motion.phase == Phase::Lift)
        })
        .map(|time| followed.sample(time).unwrap().q)
        .find(|q| over_sheet(q) > 0.5 * depth)
        .unwrap();
    let touching = |touch| {
        let model = cell.all_collisions(touch);
        model.collision(&lifting, 1e-3).unwrap()
    };
    assert_eq!(touching(AllowedContact::Surface), None);
    assert!(touching(AllowedContact::None).is_some());
}

#[test]
fn a_second_hand_that_cannot_hold_the_tool_is_reported() {
    let (file, mut task) = shipped("broom-chippings", Action::Collect);
    let refused = |task: &Task, second| match sweeping(&file, task, Some(second)) {
        Ok(_) => panic!("{second} holds it"),
        Err(error) => error.to_string(),
    };
    assert_eq!(
        refused(&task, "left_arn"),
        "unknown group \"left_arn\"; nearest: left_arm; known: left_arm, right_arm"
    );
    assert_eq!(
        refused(&task, "right_arm"),
        "\"right_tcp\" moves with the arm that leads the tool, so it cannot be the second hand; choose a group of another arm"
    );
    let grip = task.tool.second_grip.as_mut().unwrap();
    grip.point_in_tool.z = 2.8;
    let message = refused(&task, "left_arm");
    assert!(
        message.starts_with(
            "\"left_tcp\" cannot hold the tool in the ready posture: the second hand is off"
        ),
        "{message}"
    );
    task.tool.second_grip = None;
    assert_eq!(
        refused(&task, "left_arm"),
        "tool \"broom\" has no second_grip that the group \"left_arm\" could hold"
    );
}

#[test]
fn one_hand_leaves_the_other_where_it_is() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    assert!(cell(&task).second_arm().is_none());
    let (file, task) = shipped("broom-chippings", Action::Collect);
    let cell = sweeping(&file, &task, None).unwrap();
    assert_eq!(cell.arm_variables(), cell.ik().chain().variables());
}

/// Upper limit of the duration of a search.
const PATIENCE: Duration = Duration::from_secs(600);

#[test]
fn the_search_for_a_free_motion_of_two_hands_ends() {
    // Between the strokes, the projection of the second hand onto the stick moves new nodes of the
    // search tree away from their target; a search without a check of progress never ends.
    let (sender, ended) = channel();
    std::thread::spawn(move || {
        let (file, task) = shipped("broom-chippings", Action::Collect);
        let record = file.robot.as_ref().unwrap();
        let cell = sweeping(&file, &task, record.second_group.as_deref()).unwrap();
        let plan = planned(&file, &task);
        let humanoid = humanoid();
        let config = FollowConfig::default();
        let map = humanoid.map.as_ref();
        let followed = follow(&task, &plan, &cell, map, &config, &mut |_| ()).unwrap();
        let _ = sender.send(faults(&task, &plan, &cell, &followed));
    });
    let faults = ended.recv_timeout(PATIENCE).expect("it ends");
    assert_eq!(faults, [] as [String; 0]);
}
