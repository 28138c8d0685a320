//! Each kind of fault is found where it is planted.

use std::mem::discriminant;
use wisch::follow::{
    FollowConfig, FollowError, Followed, JointPath, Motion, MotionFault, Phase, TimingConfig,
    Trajectory, Workcell, WorkcellConfig, audit, follow, time_path,
};
use wisch::represent::{Action, Task};
use wisch::robot::{RobotModel, SEGMENT_RESOLUTION, Srdf};
use wisch_testkit::{arm7, block, board, cell, planned};

struct Good {
    task: Task,
    cell: Workcell,
    followed: Followed,
}

fn good() -> Good {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let (plan, cell) = (planned(&task), cell(&task));
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    Good {
        task,
        cell,
        followed,
    }
}

fn faults(good: &Good) -> Vec<MotionFault> {
    let config = FollowConfig::default();
    let audit = audit(&good.followed, &good.cell, &good.task, &config).unwrap();
    assert_eq!(audit.is_sound(), audit.faults.is_empty());
    audit.faults
}

fn wipe(followed: &mut Followed) -> &mut Motion {
    let mut motions = followed.motions.iter_mut();
    motions.find(|motion| motion.phase.is_contact()).unwrap()
}

/// All faults are of one kind, and there are some.
fn assert_only(faults: &[MotionFault], kind: &MotionFault) {
    let is_kind = |fault: &MotionFault| discriminant(fault) == discriminant(kind);
    assert!(
        !faults.is_empty() && faults.iter().all(is_kind),
        "{faults:?}"
    );
}

const GAP: MotionFault = MotionFault::Gap {
    motion: 0,
    step: 0.0,
    gap: 0.0,
};
const OFF_LINE: MotionFault = MotionFault::OffLine {
    motion: 0,
    position: 0.0,
    rotation: 0.0,
};

#[test]
fn a_good_motion_has_no_faults() {
    assert_eq!(faults(&good()), []);
}

#[test]
fn a_motion_that_begins_late_or_elsewhere_is_a_gap() {
    let mut late = good();
    late.followed.motions.last_mut().unwrap().start += 0.1;
    assert_only(&faults(&late), &GAP);

    let mut missing = good();
    missing.followed.motions.remove(1);
    assert_only(&faults(&missing), &GAP);
}

#[test]
fn an_object_put_in_the_way_is_a_contact_whose_bodies_are_named() {
    // On the board, where only the tool wipes, and above it, where it is lifted.
    for height in [0.01, 0.12] {
        let mut good = good();
        good.task
            .scene
            .push(block("cup", [0.02; 3], [0.5, 0.0, 0.2 + height]));
        good.cell = cell(&good.task);
        let found = faults(&good);
        assert!(!found.is_empty());
        for fault in &found {
            let MotionFault::Contact { a, b, distance, .. } = fault else {
                panic!("{fault}");
            };
            assert!([a, b].iter().any(|name| *name == "cup"), "{fault}");
            assert!(*distance <= SEGMENT_RESOLUTION);
        }
    }
}

#[test]
fn a_motion_too_fast_for_its_joints_breaks_its_trajectory() {
    let mut good = good();
    let text = include_str!("../../../../robots/arm7.urdf");
    let slow = text.replace("velocity=\"2.175\"", "velocity=\"0.02\"");
    let model = RobotModel::from_urdf("slow", &slow, &mut |_| Err(String::new())).unwrap();
    let srdf = Some(arm7().srdf);
    let config = WorkcellConfig::default();
    good.cell = Workcell::new(model, srdf.as_ref(), &good.task, &config).unwrap();
    let found = faults(&good);
    let is_trajectory = |fault: &MotionFault| matches!(fault, MotionFault::Trajectory { .. });
    assert!(!found.is_empty() && found.iter().all(is_trajectory));
}

#[test]
fn a_tool_beside_short_of_or_turned_from_its_line_is_off_it() {
    let config = FollowConfig::default();
    let mut beside = good();
    for pose in &mut wipe(&mut beside.followed).tool_line {
        pose.surface_from_tool.position.y += 3.0 * config.line_tolerance;
    }
    assert_only(&faults(&beside), &OFF_LINE);

    let mut turned = good();
    for pose in &mut wipe(&mut turned.followed).tool_line {
        pose.surface_from_tool.heading += 3.0 * config.turn_tolerance;
    }
    assert_only(&faults(&turned), &OFF_LINE);

    let mut high = good();
    for pose in &mut wipe(&mut high.followed).tool_line {
        pose.height += 3.0 * config.line_tolerance;
    }
    assert_only(&faults(&high), &OFF_LINE);

    // It stops before the end, or begins after the begin.
    for reversed in [false, true] {
        let mut short = good();
        let line = &mut wipe(&mut short.followed).tool_line;
        if reversed {
            line.reverse();
        }
        let mut beyond = line[line.len() - 1];
        let before = line[line.len() - 2].surface_from_tool.position;
        let along = beyond.surface_from_tool.position - before;
        beyond.surface_from_tool.position += along.normalize() * 0.01;
        line.push(beyond);
        if reversed {
            line.reverse();
        }
        assert_only(&faults(&short), &OFF_LINE);
    }
}

#[test]
fn motions_of_another_robot_are_an_error() {
    let mut good = good();
    let [_, arm6, _] = wisch_testkit::robots();
    let config = WorkcellConfig::default();
    good.cell = Workcell::new(arm6.model, Some(&arm6.srdf), &good.task, &config).unwrap();
    let config = FollowConfig::default();
    let refused = audit(&good.followed, &good.cell, &good.task, &config);
    assert!(matches!(refused, Err(FollowError::Robot(_))), "{refused:?}");
}

/// The humanoid far from the board.
fn humanoid() -> (Task, Workcell) {
    let task = board(Action::Absorb, [3.0, 0.0, 0.8]);
    let urdf = include_str!("../../../../robots/humanoid.urdf");
    let model = RobotModel::from_urdf("humanoid", urdf, &mut |_| Err(String::new())).unwrap();
    let srdf = include_str!("../../../../robots/humanoid.srdf");
    let srdf = Srdf::parse("humanoid", srdf, &model).unwrap();
    let config = WorkcellConfig::default();
    let cell = Workcell::new(model, Some(&srdf), &task, &config).unwrap();
    (task, cell)
}

/// A motion of the humanoid in which some variables go to other positions.
fn moved(cell: &Workcell, phase: Phase, goals: &[(&str, f64)]) -> Followed {
    let mut goal = cell.ready().to_vec();
    for (name, position) in goals {
        let named = |joint: &wisch::follow::JointLimit| joint.name == *name;
        goal[cell.limits().joints().iter().position(named).unwrap()] = *position;
    }
    let path = JointPath::new(&[cell.ready(), &goal]).unwrap();
    let trajectory: Trajectory = time_path(&path, cell.limits(), &TimingConfig::default()).unwrap();
    Followed {
        motions: vec![Motion {
            phase,
            start: 0.0,
            trajectory,
            tool_line: Vec::new(),
        }],
        strokes: Vec::new(),
        placements: Vec::new(),
        rated: Vec::new(),
        abandoned: Vec::new(),
        tip_from_tool: *cell.tip_from_tool(),
    }
}

#[test]
fn a_base_that_moves_while_the_tool_is_down_is_a_fault() {
    let (task, cell) = humanoid();
    let config = FollowConfig::default();
    for base in ["base_x", "base_y", "base_yaw"] {
        let drives = moved(&cell, Phase::Drive, &[(base, 0.2)]);
        assert_eq!(audit(&drives, &cell, &task, &config).unwrap().faults, []);
        for phase in [Phase::Wipe(0), Phase::Lower, Phase::Lift, Phase::Lifted] {
            let wipes = moved(&cell, phase, &[(base, 0.2)]);
            let faults = audit(&wipes, &cell, &task, &config).unwrap().faults;
            assert_eq!(faults, [MotionFault::BaseMoves { motion: 0 }]);
        }
    }
}

#[test]
fn a_torso_beyond_its_coupled_limit_is_a_fault_of_the_joint_that_follows() {
    let (task, cell) = humanoid();
    // Each within its own range; their sum is beyond 135°.
    let bent = moved(
        &cell,
        Phase::FreeMotion,
        &[("torso_2", 0.9), ("torso_3", 1.7)],
    );
    let faults = audit(&bent, &cell, &task, &FollowConfig::default())
        .unwrap()
        .faults;
    let limits: Vec<&MotionFault> = (faults.iter())
        .filter(|fault| matches!(fault, MotionFault::Limit { .. }))
        .collect();
    assert!(!limits.is_empty());
    for fault in limits {
        let MotionFault::Limit { fault, time } = fault else {
            continue;
        };
        assert_eq!(fault.joint, "torso_4");
        assert!(*time > 0.0);
    }
    // No joint breaks its own limits.
    let is_trajectory = |fault: &MotionFault| matches!(fault, MotionFault::Trajectory { .. });
    assert!(!faults.iter().any(is_trajectory), "{faults:?}");
}

#[test]
fn a_node_left_out_and_a_stroke_elsewhere_are_found() {
    let Good {
        task,
        cell,
        followed,
    } = good();
    let plan = planned(&task);
    let found = |followed: &Followed| wisch_testkit::faults(&task, &plan, &cell, followed);
    assert_eq!(found(&followed), [] as [String; 0]);

    let mut lost = followed.clone();
    lost.strokes[0].nodes.pop();
    assert!(found(&lost).iter().any(|fault| fault.ends_with("are lost")));

    let mut elsewhere = followed;
    elsewhere.strokes[0].poses[0].position.x += 1e-3;
    assert_eq!(
        found(&elsewhere),
        ["stroke 0 is not the line that is wiped"]
    );
}
