//! The target surface is an obstacle to everything but the pad in contact, whether or not the scene has an object that carries it.

use wisch::follow::{
    FollowConfig, FollowError, Followed, MotionFault, Phase, Workcell, WorkcellConfig, audit,
    follow,
};
use wisch::geometry::{Point2, Polygon, Pose, Vector3};
use wisch::represent::{Action, Task};
use wisch_testkit::{arm7, board, cell, planned};

/// The board with nothing under it.
fn bare(at: [f64; 3]) -> Task {
    let mut task = board(Action::Absorb, at);
    task.scene.clear();
    task
}

fn followed(task: &Task, cell: &Workcell) -> Followed {
    let config = FollowConfig::default();
    follow(task, &planned(task), cell, None, &config, &mut |_| ()).unwrap()
}

fn found(followed: &Followed, cell: &Workcell, task: &Task) -> Vec<MotionFault> {
    let config = FollowConfig::default();
    audit(followed, cell, task, &config).unwrap().faults
}

/// Bodies that the audit finds in the surface or behind it, each with its depth [m].
fn through(faults: &[MotionFault]) -> Vec<(&str, f64)> {
    let through = faults.iter().filter_map(|fault| match fault {
        MotionFault::ThroughSurface { body, depth, .. } => Some((body.as_str(), *depth)),
        _ => None,
    });
    through.collect()
}

#[test]
fn a_path_through_the_surface_and_a_hand_below_it_are_found_where_they_are_planted() {
    let low = bare([0.5, 0.0, 0.2]);
    let motion = followed(&low, &cell(&low));
    assert_eq!(found(&motion, &cell(&low), &low), []);

    // The same motion where the surface is in truth 0.1 m higher: the tool goes through it, and the hand over the tool is
    // as deep in it as the hand is nearer to the tool than that.
    let high = bare([0.5, 0.0, 0.3]);
    let faults = found(&motion, &cell(&high), &high);
    let through = through(&faults);
    assert!(
        through
            .iter()
            .any(|&(body, depth)| body == "sponge" && depth > 0.09)
    );
    assert!(
        through
            .iter()
            .any(|&(body, depth)| body != "sponge" && depth > 0.0)
    );

    // Only on its way to the first stroke, in free motion.
    let mut free = motion;
    free.motions.truncate(1);
    assert_eq!(free.motions[0].phase, Phase::FreeMotion);
    let faults = found(&free, &cell(&high), &high);
    assert!(!self::through(&faults).is_empty(), "{faults:?}");
}

#[test]
fn a_stroke_over_a_hole_is_found_where_it_is_planted() {
    let mut task = bare([0.5, 0.0, 0.2]);
    let motion = followed(&task, &cell(&task));
    let whole = task.surface.outline.outer().to_vec();
    let wiped = motion.strokes[0].poses[0].position;
    let hole = Polygon::rectangle([0.02, 0.02].into());
    let hole: Vec<Point2> = hole.outer().iter().map(|p| p + wiped.coords).collect();
    task.surface.outline = Polygon::new(whole, vec![hole]);
    let faults = found(&motion, &cell(&task), &task);
    let is_over_hole = |fault: &MotionFault| {
        matches!(fault, MotionFault::OverHole { place, .. }
        if (Point2::from(*place) - wiped).amax() < 0.01)
    };
    assert!(faults.iter().any(is_over_hole), "{faults:?}");
    assert!(faults.iter().all(is_over_hole), "{faults:?}");
}

#[test]
fn a_hand_that_reaches_through_the_surface_is_an_error_before_anything_moves() {
    for task in [
        bare([0.5, 0.0, 0.2]),
        board(Action::Absorb, [0.5, 0.0, 0.2]),
    ] {
        let robot = arm7();
        let held = cell(&task);
        // Held 0.1 m nearer to the wrist than the hand's end.
        let nearer = Pose::translation(0.0, 0.0, -0.1) * held.tip_from_tool();
        let config = WorkcellConfig {
            tip_from_tool: Some(nearer),
            ..WorkcellConfig::default()
        };
        let cell = Workcell::new(robot.model, Some(&robot.srdf), &task, &config).unwrap();
        let config = FollowConfig::default();
        let refused = follow(&task, &planned(&task), &cell, None, &config, &mut |_| ());
        let Err(FollowError::HandBelowSurface { depth, tip, .. }) = refused else {
            panic!("{refused:?}");
        };
        assert_eq!(tip, held.robot().links()[held.tip().index()].name);
        assert!((0.01..0.1).contains(&depth), "{depth}");
    }
}

/// Number of times at which a corner of the tool is behind the surface, in steps of 5 ms.
fn places_behind(followed: &Followed, cell: &Workcell, task: &Task) -> usize {
    let surface_from_world = task.surface.world_from_surface.inverse();
    let mut behind = 0;
    for motion in &followed.motions {
        let samples = motion.trajectory.samples(0.005);
        for sample in samples {
            let kinematics = cell.robot().forward_kinematics(&sample.q).unwrap();
            let tool = surface_from_world
                * cell.world_from_root()
                * kinematics.world_from_link(cell.tip())
                * cell.tip_from_tool();
            let mut corners = task.tool.mesh.vertices().iter().map(|corner| tool * corner);
            let is_behind = corners
                .any(|at| at.z < -2e-3 && task.surface.outline.contains(Point2::new(at.x, at.y)));
            behind += usize::from(is_behind);
        }
    }
    behind
}

#[test]
fn the_tool_goes_round_the_surface_and_not_through_it() {
    // Boards under the hand in its ready posture and before it, facing upwards and towards the robot.
    let mut wiped = 0;
    for (pitch, at) in [
        (0.0, [0.5, 0.1, 0.3]),
        (-0.5, [0.55, 0.0, 0.3]),
        (-0.7, [0.6, 0.0, 0.35]),
        (-1.2, [0.65, 0.1, 0.4]),
    ] {
        let mut task = bare(at);
        let turn = nalgebra::UnitQuaternion::from_axis_angle(&Vector3::y_axis(), pitch);
        let at = nalgebra::Translation3::from(Vector3::from(at));
        task.surface.world_from_surface = Pose::from_parts(at, turn);
        let cell = cell(&task);
        let config = FollowConfig::default();
        let motion = match follow(&task, &planned(&task), &cell, None, &config, &mut |_| ()) {
            Ok(motion) => motion,
            Err(FollowError::StartBlocked { .. }) => continue,
            Err(error) => panic!("{error}"),
        };
        assert_eq!(places_behind(&motion, &cell, &task), 0, "{pitch}");
        assert_eq!(found(&motion, &cell, &task), [], "{pitch}");
        wiped += usize::from(!motion.strokes.is_empty());
    }
    assert!(wiped >= 2, "{wiped}");
}
