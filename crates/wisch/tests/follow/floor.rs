//! A floor before an arm without shapes: only its joints limit what it reaches.

use wisch::follow::{FollowConfig, Followed, Phase, ToolPose, Workcell, WorkcellConfig, follow};
use wisch::geometry::PlanarPose;
use wisch::plan::{Plan, plan, predict};
use wisch::represent::Task;
use wisch::robot::{IkConfig, IkOutcome, RobotModel, RotationGoal};
use wisch_io::{LoadOptions, load_task};
use wisch_testkit::{faults, root};

struct Floor {
    task: Task,
    plan: Plan,
    cell: Workcell,
    followed: Followed,
}

/// The shipped arm without its shapes.
fn bare_arm() -> RobotModel {
    let mut urdf = include_str!("../../../../robots/arm7.urdf").to_owned();
    while let Some((before, rest)) = urdf.split_once("<collision>") {
        let (_, after) = rest.split_once("</collision>").unwrap();
        urdf = format!("{before}{after}");
    }
    RobotModel::from_urdf("bare", &urdf, &mut |_| Err(String::new())).unwrap()
}

fn floor(settings: &[(&str, &str)]) -> Floor {
    let settings = settings.iter();
    let options = LoadOptions {
        settings: settings
            .map(|(key, value)| ((*key).into(), (*value).into()))
            .collect(),
        ..LoadOptions::default()
    };
    let file = root().join("crates/wisch/tests/data/floor.toml");
    let loaded = load_task(&file, &options).unwrap();
    let plan = plan(&loaded.task, &loaded.run.plan).unwrap();
    let robot = loaded.file.robot.as_ref();
    let config = WorkcellConfig {
        world_from_robot: robot.and_then(|robot| robot.world_from_robot),
        ..WorkcellConfig::default()
    };
    let task = loaded.task;
    let cell = Workcell::new(bare_arm(), None, &task, &config).unwrap();
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
    Floor {
        task,
        plan,
        cell,
        followed,
    }
}

/// Whether inverse kinematics alone finds a posture with the tool on a node, in any of 36
/// orientations.
fn is_reached(floor: &Floor, node: usize) -> bool {
    let position = floor.plan.graph.position(node);
    let config = IkConfig {
        max_restarts: 20,
        ..IkConfig::default()
    };
    (0..36).any(|i| {
        let pose = ToolPose {
            surface_from_tool: PlanarPose::new(position, f64::from(10 * i).to_radians()),
            height: 0.0,
            tilt: 0.0,
        };
        let root_from_world = floor.cell.world_from_root().inverse();
        let target = root_from_world * Workcell::world_from_tool(&floor.task, &pose);
        let ik = floor.cell.ik();
        let outcome = ik
            .solve(&target, RotationGoal::Full, &[], 1, &config)
            .unwrap();
        matches!(outcome, IkOutcome::Solved(_))
    })
}

#[test]
fn a_node_that_inverse_kinematics_reaches_is_not_abandoned() {
    let floor = floor(&[]);
    let Floor {
        task,
        plan,
        cell,
        followed,
    } = &floor;
    assert_eq!(faults(task, plan, cell, followed), [] as [String; 0]);
    // The corners of the floor are out of reach.
    assert!(!followed.abandoned.is_empty() && followed.abandoned.len() <= 4);
    let reached = followed
        .abandoned
        .iter()
        .filter(|lost| is_reached(&floor, lost.node));
    let reached: Vec<usize> = reached.map(|lost| lost.node).collect();
    assert_eq!(reached, [] as [usize; 0]);
}

#[test]
fn what_nodes_out_of_reach_leave_of_a_tour_is_joined_anew() {
    let floor = floor(&[
        ("surface.size_m", "[1.8, 1.2]"),
        ("surface.position_m", "[0.0, 0.6, 0.0]"),
        ("scene.0.box_m", "[1.8, 1.2, 0.02]"),
        ("scene.0.position_m", "[0.0, 0.6, -0.01]"),
    ]);
    let Floor {
        task,
        plan,
        cell,
        followed,
    } = &floor;
    assert_eq!(faults(task, plan, cell, followed), [] as [String; 0]);
    assert!(followed.abandoned.len() > 100);
    let strokes = &followed.strokes;
    let single = strokes
        .iter()
        .filter(|stroke| stroke.nodes.len() == 1)
        .count();
    let free = followed
        .motions
        .iter()
        .filter(|motion| motion.phase == Phase::FreeMotion);
    assert!(strokes.len() <= 4, "{} strokes", strokes.len());
    assert_eq!(single, 0, "strokes of a single node");
    // To each and back.
    assert!(free.count() <= 2 * strokes.len());
}

/// A floor whose far corners are out of reach, with an action that needs its nodes in order.
fn rooted(action: &str, more: &[(&str, &str)]) -> Floor {
    let far = [
        ("action", action),
        ("surface.size_m", "[1.4, 1.0]"),
        ("surface.position_m", "[0.0, 0.5, 0.0]"),
        ("scene.0.box_m", "[1.4, 1.0, 0.02]"),
        ("scene.0.position_m", "[0.0, 0.5, -0.01]"),
    ];
    floor(&[&far, more].concat())
}

#[test]
fn what_nodes_out_of_reach_leave_of_trees_is_joined_anew() {
    // If the strokes were only cut at nodes out of reach, 91 nodes would be abandoned each time, 1
    // crumb would reach the goal, and free motion would take 55 s and 59 s.
    for (action, more, achieved) in [
        ("\"collect\"", ("collect.goal_m", "[0.0, 0.0]"), 20),
        ("\"skim\"", ("surface.skim_edges", "[\"y_min\"]"), 50),
    ] {
        let floor = rooted(action, &[more, ("plan.heading", "\"blended\"")]);
        let Floor {
            task,
            plan,
            cell,
            followed,
        } = &floor;
        assert_eq!(faults(task, plan, cell, followed), [] as [String; 0]);
        assert!((1..=85).contains(&followed.abandoned.len()));
        let wiped = Plan {
            strokes: followed.strokes.clone(),
            ..plan.clone()
        };
        let performance = predict(task, &wiped, |_| ()).performance;
        assert!(
            performance.achieved >= achieved,
            "{action}: {performance:?}"
        );
        let free: f64 = (followed.motions.iter())
            .filter(|motion| motion.phase == Phase::FreeMotion)
            .map(|motion| motion.trajectory.duration())
            .sum();
        assert!(free < 40.0, "{action}: {free} s");
    }
}
