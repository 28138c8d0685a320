//! Each kind of planted fault is found.

use std::mem::discriminant;
use wisch::follow::{
    FollowConfig, FollowError, Followed, JointLimit, JointLimits, JointPath, Motion, MotionFault,
    Phase, RateKind, TimingConfig, Trajectory, TrajectoryFault, TrajectorySample, Workcell,
    WorkcellConfig, audit, follow, time_path,
};
use wisch::geometry::{PlanarPose, Point2, Vector3};
use wisch::represent::{Action, Task};
use wisch::robot::{RobotModel, SEGMENT_RESOLUTION, Srdf};
use wisch_testkit::{arm7, block, board, cell, first_stroke, planned};

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

    // It stops before the end, or begins after the start.
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
fn a_way_out_and_back_that_the_tool_leaves_out_is_found() {
    let mut good = good();
    let line = &mut wipe(&mut good.followed).tool_line;
    let corner = line[1];
    let mut aside = corner;
    aside.surface_from_tool.position.y += 0.02;
    line.splice(1..2, [corner, aside, corner]);
    let found = faults(&good);
    assert_only(&found, &OFF_LINE);
    let MotionFault::OffLine { position, .. } = found[0] else {
        unreachable!()
    };
    assert!((0.019..0.021).contains(&position), "{position}");
}

#[test]
fn a_stroke_that_returns_on_itself_is_no_fault() {
    let task = board(Action::Skim, [0.5, 0.0, 0.2]);
    let (mut plan, cell) = (first_stroke(planned(&task)), cell(&task));
    let stroke = &mut plan.strokes[0];
    let (node, pose) = (stroke.nodes[0], stroke.poses[0]);
    let at = |y: f64| PlanarPose {
        position: Point2::new(0.0, y),
        ..pose
    };
    stroke.poses = [0.02, 0.06, -0.05, 0.05, 0.0].map(at).to_vec();
    stroke.nodes = vec![node; stroke.poses.len()];
    let config = FollowConfig::default();
    let mut followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    assert_eq!(followed.strokes[0].poses.len(), 5);
    // The tool is nearer to the leg on which it returns than to that on which it goes out.
    let start = &mut wipe(&mut followed).tool_line[0];
    start.surface_from_tool.position.x += 0.3 * config.line_tolerance;
    let audit = audit(&followed, &cell, &task, &config).unwrap();
    assert_eq!(audit.faults, []);
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
    moved_within(cell, cell.limits(), phase, goals)
}

/// The same as [`moved`], timed with other limits.
fn moved_within(
    cell: &Workcell,
    limits: &JointLimits,
    phase: Phase,
    goals: &[(&str, f64)],
) -> Followed {
    let mut goal = cell.ready_posture().to_vec();
    for (name, position) in goals {
        let named = |joint: &JointLimit| joint.name == *name;
        goal[cell.limits().joints().iter().position(named).unwrap()] = *position;
    }
    let path = JointPath::new(&[cell.ready_posture(), &goal]).unwrap();
    let trajectory: Trajectory = time_path(&path, limits, &TimingConfig::default()).unwrap();
    Followed {
        motions: vec![Motion {
            phase,
            start: 0.0,
            trajectory,
            tool_line: Vec::new(),
        }],
        ..Followed::new(*cell.tip_from_tool())
    }
}

#[test]
fn a_base_that_moves_while_the_tool_is_down_is_a_fault() {
    let (task, cell) = humanoid();
    // The base drives faster than a tool may wipe.
    let config = FollowConfig {
        contact_speed: 1.0,
        approach_speed: 1.0,
        ..FollowConfig::default()
    };
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

/// The limits of the variables alone, velocities and accelerations scaled: a joint that follows others is not timed.
fn of_variables(cell: &Workcell, velocity: f64, acceleration: f64) -> JointLimits {
    let scaled = |limit: &JointLimit| JointLimit {
        velocity: velocity * limit.velocity,
        acceleration: acceleration * limit.acceleration,
        ..limit.clone()
    };
    JointLimits::new(cell.limits().joints().iter().map(scaled).collect()).unwrap()
}

#[test]
fn a_torso_beyond_its_coupled_limit_is_a_fault_of_the_joint_that_follows() {
    let (task, cell) = humanoid();
    // Each within its own range; their sum is beyond 135°.
    let bent = moved_within(
        &cell,
        &of_variables(&cell, 0.4, 0.4),
        Phase::FreeMotion,
        &[("torso_2", 0.5), ("torso_3", 1.9)],
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
fn a_joint_that_follows_others_too_fast_is_a_fault_though_none_of_these_is() {
    let (task, cell) = humanoid();
    let config = FollowConfig::default();
    // Up: the sum of both stays in its range.
    let goals = [("torso_2", -1.2), ("torso_3", 1.3)];
    let timed = moved(&cell, Phase::FreeMotion, &goals);
    let kept = audit(&timed, &cell, &task, &config).unwrap().faults;
    let is_trajectory = |fault: &&MotionFault| matches!(fault, MotionFault::Trajectory { .. });
    assert_eq!(kept.iter().find(is_trajectory), None);
    for (velocity, acceleration, broken) in [
        (1.0, 0.4, RateKind::Velocity),
        (0.4, 1.0, RateKind::Acceleration),
    ] {
        let limits = of_variables(&cell, velocity, acceleration);
        let fast = moved_within(&cell, &limits, Phase::FreeMotion, &goals);
        let faults = audit(&fast, &cell, &task, &config).unwrap().faults;
        let rates: Vec<RateKind> = (faults.iter())
            .filter_map(|fault| match fault {
                MotionFault::Trajectory {
                    joint,
                    fault:
                        TrajectoryFault::TooFast {
                            rate, value, limit, ..
                        },
                    ..
                } => {
                    assert_eq!(joint.as_deref(), Some("torso_4"), "{fault}");
                    assert!(value.abs() > *limit);
                    assert!(fault.to_string().ends_with("is \"torso_4\")"), "{fault}");
                    Some(*rate)
                }
                _ => None,
            })
            .collect();
        assert!(rates.contains(&broken), "{faults:?}");
        let of_velocity = [RateKind::Velocity, RateKind::PositionStep];
        let is_of_velocity = |rate: &RateKind| of_velocity.contains(rate);
        assert!(
            rates
                .iter()
                .all(|rate| is_of_velocity(rate) == is_of_velocity(&broken))
        );
    }
}

/// A shipped URDF with another effort limit of one joint.
fn with_effort(urdf: &str, joint: &str, effort: f64) -> String {
    let (before, from_joint) = urdf
        .split_once(&format!("<joint name=\"{joint}\""))
        .unwrap();
    let (element, after) = from_joint.split_once("</joint>").unwrap();
    let (limit, rest) = element.split_once("effort=\"").unwrap();
    let (_, rest) = rest.split_once('"').unwrap();
    format!("{before}<joint name=\"{joint}\"{limit}effort=\"{effort}\"{rest}</joint>{after}")
}

#[test]
fn the_force_of_the_surface_counts_as_effort() {
    let Good {
        mut task,
        cell,
        followed,
    } = good();
    let force = 200.0;
    task.interaction.press_force_n = force;
    let faults = audit(&followed, &cell, &task, &FollowConfig::default())
        .unwrap()
        .faults;
    let loaded = faults.iter().find_map(|fault| match fault {
        MotionFault::Effort {
            time,
            joint,
            effort,
            press: Some(press),
            ..
        } => Some((*time, joint, *effort, *press)),
        _ => None,
    });
    let (time, joint, effort, press) = loaded.expect("a joint that is too weak");
    assert_eq!(press, force);
    let robot = cell.robot();
    let variable = (0..robot.dof()).find(|&i| robot.variable(i).name == *joint);
    let variable = variable.unwrap();
    let motion = followed.motion_at(time).unwrap();
    let TrajectorySample { q, qd, qdd, .. } = motion.trajectory.sample(time - motion.start);
    // By how much the tool rises over the surface when the joint moves, by central differences.
    let height = |change: f64| {
        let mut q = q.clone();
        q[variable] += change;
        let tip = robot
            .forward_kinematics(&q)
            .unwrap()
            .world_from_link(cell.tip());
        let world_from_tool = cell.world_from_root() * tip * cell.tip_from_tool();
        let normal = task.surface.world_from_surface * Vector3::z();
        world_from_tool.translation.vector.dot(&normal)
    };
    let rise = (height(1e-6) - height(-1e-6)) / 2e-6;
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let dynamics = robot.dynamics().unwrap();
    let own = dynamics.inverse_dynamics(&q, &qd, &qdd, gravity).unwrap()[variable];
    let expected = own - force * rise;
    assert!(
        (effort - expected).abs() < 0.02 * expected.abs(),
        "{joint} at {time} s: {effort}, expected {expected} of which {own} moves the robot"
    );
}

#[test]
fn a_joint_that_follows_others_and_is_too_weak_for_the_robots_weight_is_a_fault() {
    let (task, cell) = humanoid();
    let motion = moved(&cell, Phase::FreeMotion, &[("torso_2", -0.9)]);
    let config = FollowConfig::default();
    let is_effort = |fault: &&MotionFault| matches!(fault, MotionFault::Effort { .. });
    let faults = audit(&motion, &cell, &task, &config).unwrap().faults;
    assert_eq!(faults.iter().find(is_effort), None);

    let urdf = include_str!("../../../../robots/humanoid.urdf");
    let weak = with_effort(urdf, "torso_4", 2.0);
    let model = RobotModel::from_urdf("weak", &weak, &mut |_| Err(String::new())).unwrap();
    let srdf = Srdf::parse(
        "humanoid",
        include_str!("../../../../robots/humanoid.srdf"),
        &model,
    );
    let cell = Workcell::new(model, srdf.ok().as_ref(), &task, &WorkcellConfig::default()).unwrap();
    let faults = audit(&motion, &cell, &task, &config).unwrap().faults;
    let weak: Vec<&MotionFault> = faults.iter().filter(is_effort).collect();
    assert!(!weak.is_empty());
    for fault in weak {
        let MotionFault::Effort {
            joint,
            effort,
            limit,
            unit,
            ..
        } = fault
        else {
            continue;
        };
        assert_eq!((joint.as_str(), *limit, *unit), ("torso_4", 2.0, "Nm"));
        assert!(effort.abs() > 2.0);
    }
}

#[test]
fn a_weak_joint_is_moved_as_slowly_as_its_effort_allows() {
    let fast = good();
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let dynamics = fast.cell.robot().dynamics().unwrap();
    // What the second joint needs at most to carry the arm, and to carry and move it [Nm].
    let mut most = [0.0_f64; 2];
    for motion in &fast.followed.motions {
        for sample in motion.trajectory.samples(0.002) {
            let carrying = dynamics.gravity(&sample.q, gravity).unwrap()[1];
            let TrajectorySample { q, qd, qdd, .. } = &sample;
            let moving = dynamics.inverse_dynamics(q, qd, qdd, gravity).unwrap()[1];
            most = [most[0].max(carrying.abs()), most[1].max(moving.abs())];
        }
    }
    let limit = most[0] / 0.98 + 0.3 * (most[1] - most[0]);
    assert!(limit < most[1], "{most:?}");

    let joint = &fast.cell.robot().variable(1).name;
    let urdf = with_effort(include_str!("../../../../robots/arm7.urdf"), joint, limit);
    let model = RobotModel::from_urdf("weak", &urdf, &mut |_| Err(String::new())).unwrap();
    let srdf = Some(arm7().srdf);
    let config = WorkcellConfig::default();
    let cell = Workcell::new(model, srdf.as_ref(), &fast.task, &config).unwrap();
    let plan = planned(&fast.task);
    let config = FollowConfig::default();
    let refused = audit(&fast.followed, &cell, &fast.task, &config)
        .unwrap()
        .faults;
    assert!(
        refused
            .iter()
            .all(|fault| matches!(fault, MotionFault::Effort { .. }))
    );
    assert!(!refused.is_empty());

    let slow = follow(&fast.task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    assert_eq!(audit(&slow, &cell, &fast.task, &config).unwrap().faults, []);
    assert!(slow.duration() > fast.followed.duration());
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
    assert_eq!(found(&elsewhere), ["stroke 0 is not the executed line"]);
}
