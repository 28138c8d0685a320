//! Following a plan: completely, with an audit, and equally on any number of threads; nodes out of
//! reach are reported.

#[path = "follow/audit.rs"]
mod audit_of_motions;
mod branches;
mod broom;
mod corners;
mod floor;
mod humanoid;
mod mount;
mod order;
mod speed;
mod target_surface;

use rayon::prelude::*;
use std::f64::consts::TAU;
use wisch::follow::{
    FollowConfig, FollowError, Followed, Obstruction, Phase, SearchScope, WorkcellConfig, audit,
    follow,
};
use wisch::geometry::{Point2, Polygon, Region};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, YawRule, plan, predict};
use wisch::represent::Action;
use wisch::robot::Margins;
use wisch_testkit::{Problem, SolvedProblem, arm7, block, board, cell, faults, planned, robots};

#[test]
fn an_arm_follows_every_stroke_of_a_board_as_planned() {
    for action in Action::WIPING {
        let task = board(action, [0.5, 0.0, 0.2]);
        let (plan, cell) = (planned(&task), cell(&task));
        let config = FollowConfig {
            free_order: false,
            ..FollowConfig::default()
        };
        let mut passed = Vec::new();
        let followed = follow(&task, &plan, &cell, None, &config, &mut |n| passed.push(n)).unwrap();

        assert_eq!(followed.abandoned, [], "{action}");
        assert!(followed.duration() > 0.0 && followed.contact_time() > 0.0);
        assert!(followed.contact_time() < followed.duration());
        let nodes = |strokes: &[wisch::plan::Stroke]| -> Vec<Vec<usize>> {
            strokes.iter().map(|stroke| stroke.nodes.clone()).collect()
        };
        assert_eq!(nodes(&followed.strokes), nodes(&plan.strokes), "{action}");
        // Wiping alone takes at least as long as the planned way at the greatest speed.
        assert!(followed.contact_time() >= plan.contact_distance() / config.contact_speed);
        let all: usize = plan.strokes.iter().map(|stroke| stroke.nodes.len()).sum();
        assert_eq!(passed.last(), Some(&all), "{action}");

        assert_eq!(
            faults(&task, &plan, &cell, &followed),
            [] as [String; 0],
            "{action}"
        );
        let audit = audit(&followed, &cell, &task, &config).unwrap();
        assert!(audit.is_sound() && audit.min_clearance > 0.0);
        assert!(audit.line.position <= config.line_tolerance);
        // In free motion, more deviation is allowed.
        for motion in &followed.motions {
            if motion.phase != Phase::FreeMotion {
                continue;
            }
            let model = cell.collisions();
            let nearest = motion.trajectory.samples(0.01).map(|sample| {
                let contact = |obstacles| {
                    let margins = Margins {
                        own: 0.0,
                        obstacles,
                    };
                    model.collision(&sample.q, margins).unwrap()
                };
                contact(0.95 * config.free_clearance)
            });
            let too_near = nearest.flatten().next();
            let too_near = too_near.map(|contact| model.describe(&contact));
            assert_eq!(too_near, None, "{action}");
        }
    }
}

#[test]
fn nodes_of_a_board_3_m_away_are_abandoned_with_reasons() {
    let task = board(Action::Absorb, [3.0, 0.0, 0.2]);
    let (plan, cell) = (planned(&task), cell(&task));
    let followed = followed(&task, &plan, &cell);
    let mut given_up: Vec<usize> = followed.abandoned.iter().map(|node| node.node).collect();
    given_up.sort_unstable();
    let mut nodes: Vec<usize> = (plan.strokes.iter())
        .flat_map(|stroke| stroke.nodes.clone())
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    assert_eq!(given_up, nodes);
    assert!(followed.strokes.is_empty() && followed.motions.is_empty());
    assert_eq!(followed.duration(), 0.0);
    for node in &followed.abandoned {
        assert!(!node.attempts.is_empty());
        for attempt in &node.attempts {
            // An arm stretched out is short of it by metres, or has come to a limit on the way.
            match &attempt.obstruction {
                Obstruction::OutOfReach { position_error, .. } => assert!(*position_error > 1.5),
                Obstruction::JointLimit { joint, .. } => assert!(joint.starts_with("joint_")),
                other => panic!("{other}"),
            }
        }
    }
}

#[test]
fn a_robot_that_begins_inside_an_object_is_an_error_that_names_both() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    // The arm's shoulder is 0.333 m above its foot.
    task.scene
        .push(block("pillar", [0.1, 0.1, 0.1], [0.0, 0.0, 0.333]));
    let plan = planned(&task);
    let refused = follow(
        &task,
        &plan,
        &cell(&task),
        None,
        &FollowConfig::default(),
        &mut |_| (),
    );
    match refused {
        Err(FollowError::StartBlocked {
            a,
            b,
            distance,
            limit,
        }) => {
            let names = [a.as_str(), b.as_str()];
            assert!(names.contains(&"pillar"), "{names:?}");
            assert!(
                names.iter().any(|name| name.starts_with("link_")),
                "{names:?}"
            );
            assert!(distance < 0.0 && limit == FollowConfig::default().margin);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_configuration_without_sense_is_refused_by_the_name_of_its_field() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let (plan, cell) = (planned(&task), cell(&task));
    type Field = (&'static str, fn(&mut FollowConfig) -> &mut f64);
    let fields: [Field; 10] = [
        ("step", |config| &mut config.step),
        ("turn", |config| &mut config.turn),
        ("orientation_increment", |config| {
            &mut config.orientation_increment
        }),
        ("margin", |config| &mut config.margin),
        ("max_joint_step", |config| &mut config.max_joint_step),
        ("line_tolerance", |config| &mut config.line_tolerance),
        ("turn_tolerance", |config| &mut config.turn_tolerance),
        ("contact_speed", |config| &mut config.contact_speed),
        ("free_clearance", |config| &mut config.free_clearance),
        ("acceleration_ramp", |config| &mut config.acceleration_ramp),
    ];
    for (field, of) in fields {
        // A clearance or a ramp of 0 is allowed.
        let may_be_none = ["free_clearance", "acceleration_ramp"].contains(&field);
        let wrong = [f64::NAN, f64::INFINITY, -1.0, 0.0];
        for wrong in wrong.into_iter().filter(|w| !(may_be_none && *w == 0.0)) {
            let mut config = FollowConfig::default();
            *of(&mut config) = wrong;
            match follow(&task, &plan, &cell, None, &config, &mut |_| ()) {
                Err(FollowError::Config { name, value, .. }) => {
                    assert_eq!((name, value.to_bits()), (field, wrong.to_bits()));
                }
                other => panic!("{field} = {wrong}: {other:?}"),
            }
        }
    }
}

#[test]
fn an_unknown_group_is_named_with_the_nearest() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let robot = arm7();
    let config = WorkcellConfig {
        group: Some("arn".into()),
        ..WorkcellConfig::default()
    };
    let refused = wisch::follow::Workcell::new(robot.model, Some(&robot.srdf), &task, &config);
    let message = refused.map(|_| ()).unwrap_err().to_string();
    assert!(
        message.contains("arn") && message.ends_with("nearest: arm"),
        "{message}"
    );
}

#[test]
fn the_motion_is_the_same_on_one_thread_and_on_four() {
    let robots = robots();
    // One of an arm, and one of the humanoid, whose placements are rated in parallel.
    for seed in [2, 4] {
        let problem = Problem::random(seed).unwrap();
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let pool = pool.build().unwrap();
            pool.install(|| problem.followed(&robots[problem.robot]))
        };
        let (one, four) = (on(1).unwrap().motion, on(4).unwrap().motion);
        assert!(one.duration() > 0.0, "seed {seed} does not move");
        // Debug writes all digits that distinguish two numbers.
        assert!(format!("{one:?}") == format!("{four:?}"), "seed {seed}");
        let bits = |followed: &Followed| -> Vec<u64> {
            let times = (0..200).map(|i| followed.duration() * f64::from(i) / 199.0);
            times
                .flat_map(|time| followed.sample(time).unwrap().q)
                .map(f64::to_bits)
                .collect()
        };
        assert_eq!(bits(&one), bits(&four), "seed {seed}");
    }
}

/// A seed of the example with two nodes that only the global search reaches: the local one fails with
/// every rotation of the tool and every tried configuration.
const ONLY_GLOBALLY: u64 = 281;

#[test]
fn the_tool_turns_on_a_node_in_contact() {
    for action in Action::WIPING {
        let task = board(action, [0.5, 0.0, 0.2]);
        let config = PlanConfig {
            strategy: CoverageStrategy::Grid.into(),
            yaw: YawRule::AlongEdges,
            ..PlanConfig::default()
        };
        let (plan, cell) = (plan(&task, &config).unwrap(), cell(&task));
        let turns = |stroke: &wisch::plan::Stroke| stroke.nodes.windows(2).any(|n| n[0] == n[1]);
        assert!(plan.strokes.iter().any(turns), "{action}");
        let config = FollowConfig {
            free_yaw: false,
            ..FollowConfig::default()
        };
        let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
        assert_eq!(followed.abandoned, [], "{action}");
        assert!(followed.strokes.iter().any(turns), "{action}");
        assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
    }
}

#[test]
fn joints_move_less_where_the_yaw_is_theirs_to_choose() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let corner = |i: usize| {
        let angle = TAU * i as f64 / 32.0;
        Point2::new(0.03 * libm::cos(angle), 0.03 * libm::sin(angle))
    };
    let disc = Polygon::new((0..32).map(corner).collect(), Vec::new());
    task.tool.footprint = Region::new(vec![disc]);
    assert!(task.tool.is_round());
    let (plan, cell) = (planned(&task), cell(&task));
    let moved = |free_yaw| {
        let config = FollowConfig {
            free_yaw,
            ..FollowConfig::default()
        };
        let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
        assert_eq!(followed.abandoned, []);
        assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
        let wiped = Plan {
            strokes: followed.strokes.clone(),
            ..plan.clone()
        };
        let [in_contact, _] = followed.joint_movement(cell.arm_variables());
        (
            in_contact,
            predict(&task, &wiped, |_| ()).performance.achieved,
        )
    };
    let ((turning, achieved_as_planned), (free, achieved)) = (moved(false), moved(true));
    assert!(free < 0.6 * turning, "{free} rad of {turning}");
    assert!(achieved >= achieved_as_planned);
    // A sponge that pushes is not round: its yaw is the plan's.
    let pushing = board(Action::Collect, [0.5, 0.0, 0.2]);
    assert!(!pushing.tool.is_round());
    let plan = planned(&pushing);
    let strokes = [true, false].map(|free_yaw| {
        let config = FollowConfig {
            free_yaw,
            ..FollowConfig::default()
        };
        follow(&pushing, &plan, &cell, None, &config, &mut |_| ())
            .unwrap()
            .strokes
    });
    assert_eq!(strokes[0], strokes[1]);
}

#[test]
fn the_global_method_reaches_nodes_that_the_local_one_abandons() {
    let robots = robots();
    let mut problem = Problem::random(ONLY_GLOBALLY).unwrap();
    problem.plan.yaw = YawRule::Blended;
    let with = |search| {
        let config = FollowConfig {
            search,
            ..FollowConfig::default()
        };
        let tried = problem.follow_with(&robots[problem.robot], &config);
        let tried = tried.unwrap();
        assert_eq!(tried.faults, [] as [String; 0]);
        tried.motion
    };
    let local = with(SearchScope::Local);
    assert_eq!(local.abandoned.len(), 4);
    assert!(local.abandoned.iter().all(|node| !node.attempts.is_empty()));
    assert_eq!(with(SearchScope::Global).abandoned.len(), 2);
}

/// Seeds of the example that once gave motions with faults, with the cause.
const ONCE_WRONG: [u64; 4] = [
    // While it wiped, the tool was kept off the arm's own links without its rim only.
    0, 82, 136, // An edge of the tool lost more to the rim than the margin kept.
    154,
];

/// Least number of the 24 problems below that are followed completely, and completely or in part:
/// one less than at present.
const LEAST_WHOLE: usize = 13;
const LEAST_FOLLOWED: usize = 19;

#[test]
fn random_problems_are_solved_without_faults() {
    let robots = robots();
    let seeds: Vec<u64> = (100..120).chain(ONCE_WRONG).collect();
    let outcomes: Vec<(u64, &str, SolvedProblem)> = (seeds.into_par_iter())
        .map(|seed| {
            let problem = Problem::random(seed).unwrap();
            let name = robots[problem.robot].name;
            (seed, name, problem.outcome(&robots))
        })
        .collect();
    let square: Vec<(u64, &str, SolvedProblem)> = (100..120_u64)
        .into_par_iter()
        .map(|seed| {
            let mut problem = Problem::random(seed).unwrap();
            problem.task.tool.mount = None;
            (seed, "square", problem.outcome(&robots))
        })
        .collect();
    let is_faulty = |outcome: &SolvedProblem| matches!(outcome, SolvedProblem::Faulty(_));
    let all = outcomes.iter().chain(&square);
    let wrong: Vec<_> = all.filter(|(.., o)| is_faulty(o)).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
    // If all problems were refused, there would be no faults either.
    let is =
        |wanted: &[SolvedProblem]| outcomes.iter().filter(|(.., o)| wanted.contains(o)).count();
    let whole = is(&[SolvedProblem::Whole]);
    let followed = is(&[SolvedProblem::Whole, SolvedProblem::Partly]);
    assert!(
        whole >= LEAST_WHOLE && followed >= LEAST_FOLLOWED,
        "{whole} whole, {followed} followed: {outcomes:?}"
    );
}

fn followed(
    task: &wisch::represent::Task,
    plan: &wisch::plan::Plan,
    cell: &wisch::follow::Workcell,
) -> Followed {
    follow(
        task,
        plan,
        cell,
        None,
        &FollowConfig::default(),
        &mut |_| (),
    )
    .unwrap()
}
