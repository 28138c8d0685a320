//! Given strokes: those that the tool cannot execute are refused with their place, and those of
//! planners are accepted.

use wisch::geometry::{PlanarPose, Point2, Polygon, Vector2};
use wisch::plan::{
    CoverageStrategy, Plan, PlanConfig, PlanError, Strategy, StrokeFault, check_strokes,
    describe_over_border, plan, plan_from_strokes, predict,
};
use wisch::represent::{Action, Ground, ParticleDistribution, Task, Treatment};
use wisch::run::{RunError, check_score};
use wisch_testkit::{block, board};

/// Half the extent of the board [m].
const HALF: [f64; 2] = [0.12, 0.09];

fn pose(x: f64, y: f64, heading: f64) -> PlanarPose {
    PlanarPose::new(Point2::new(x, y), heading)
}

/// A board at the origin of the world with nothing on it.
fn bare(action: Action) -> Task {
    let mut task = board(action, [0.0; 3]);
    task.collect_goal = Some(Point2::new(0.06, 0.0));
    task
}

fn given(task: &Task, strokes: &[Vec<PlanarPose>]) -> Result<Plan, StrokeFault> {
    match plan_from_strokes(task, strokes, 0.05) {
        Ok(plan) => Ok(plan),
        Err(PlanError::Stroke(fault)) => Err(fault),
        Err(other) => panic!("{other}"),
    }
}

fn with_hole(mut task: Task, center: [f64; 2], size: [f64; 2]) -> Task {
    let hole = Polygon::rectangle(Vector2::from(size));
    let hole = hole
        .outer()
        .iter()
        .map(|p| p + Vector2::from(center))
        .collect();
    let outer = task.surface.outline.outer().to_vec();
    task.surface.outline = Polygon::new(outer, vec![hole]);
    let on_it: Vec<Point2> = (task.particles.remaining())
        .filter(|place| task.surface.outline.contains(*place))
        .collect();
    task.particles = ParticleDistribution::new(&on_it).unwrap();
    task
}

#[test]
fn strokes_given_as_arrays_become_a_plan_of_ones_own() {
    let task = bare(Action::Absorb);
    let rows: Vec<Vec<PlanarPose>> = [-0.04, 0.04]
        .map(|y| vec![pose(-0.11, y, 0.0), pose(0.11, y, 0.0)])
        .to_vec();
    let plan = given(&task, &rows).unwrap();
    assert_eq!(plan.strategy, Strategy::Own);
    assert_eq!("own".parse(), Ok(Strategy::Own));
    assert!(!Strategy::ALL.contains(&Strategy::Own));
    let poses: Vec<Vec<PlanarPose>> = plan.strokes.iter().map(|s| s.poses.clone()).collect();
    assert_eq!(poses, rows);
    assert_eq!(plan.graph.edges, [(0, 1), (2, 3)]);
    // Two rows of a tool of 0.11 m cover all of 0.18 m but what lies less than half the tool's depth from the ends.
    assert_eq!(predict(&task, &plan, |_| ()).performance.ratio(), 1.0);
}

#[test]
fn what_the_tool_cannot_do_is_refused_with_stroke_place_and_limit() {
    let row = |from: f64, to: f64, y: f64| vec![pose(from, y, 0.0), pose(to, y, 0.0)];
    let task = bare(Action::Absorb);
    let mut cup = task.clone();
    cup.scene
        .push(block("cup", [0.02, 0.02, 0.08], [0.05, 0.0, 0.04]));
    let fault = given(&cup, &[row(-0.1, -0.05, 0.0), row(-0.1, 0.1, 0.0)]).unwrap_err();
    let StrokeFault::Obstacle {
        stroke, object, x, ..
    } = &fault
    else {
        panic!("{fault}");
    };
    // The tool is 0.07 m deep: it meets the cup, which begins at 0.04 m, at 0.005 m, found at the next 5 mm.
    assert_eq!((*stroke, object.as_str()), (1, "cup"));
    assert!((0.0..=0.0151).contains(x), "{x}");
    // Past it, nearer than the collision sphere, which is wider than the tool.
    assert!(given(&cup, &[row(-0.1, 0.1, -0.0651)]).is_ok());
    // Inside the object, without crossing its sides.
    let mut crate_ = task.clone();
    crate_
        .scene
        .push(block("crate", [0.2, 0.17, 0.3], [0.0, 0.0, 0.15]));
    let inside = given(&crate_, &[vec![pose(0.0, 0.0, 0.0)]]).unwrap_err();
    assert!(matches!(inside, StrokeFault::Obstacle { .. }), "{inside}");

    let holed = with_hole(task.clone(), [0.0, 0.0], [0.04, 0.04]);
    let fault = given(&holed, &[row(-0.1, 0.1, 0.01)]).unwrap_err();
    let StrokeFault::Hole {
        stroke: 0,
        pose: 0,
        length,
        x,
        ..
    } = fault
    else {
        panic!("{fault}");
    };
    assert!((length - 0.04).abs() < 1e-9 && x.abs() < 1e-9);
    assert!(given(&holed, &[row(-0.1, 0.1, 0.021)]).is_ok());
    assert!(given(&holed, &[row(-0.1, -0.02, 0.01), row(0.02, 0.1, 0.01)]).is_ok());

    // A quarter of the tool's 0.07 m may be beyond the border.
    assert!(given(&task, &[row(-0.1, HALF[0] + 0.017, 0.0)]).is_ok());
    let fault = given(&task, &[row(-0.1, HALF[0] + 0.05, 0.0)]).unwrap_err();
    let StrokeFault::OffSurface {
        distance, limit, ..
    } = fault
    else {
        panic!("{fault}");
    };
    assert!((distance - 0.05).abs() < 1e-9 && (limit - 0.0175).abs() < 1e-9);
    let far = given(&task, &[vec![pose(3.0, 0.0, 0.0)]]).unwrap_err();
    assert!(matches!(far, StrokeFault::OffSurface { .. }), "{far}");

    let none = given(&task, &[row(-0.1, 0.1, 0.0), vec![]]).unwrap_err();
    assert_eq!(none, StrokeFault::Empty { stroke: 1 });
    let nan = given(&task, &[vec![pose(0.0, f64::NAN, 0.0)]]).unwrap_err();
    assert_eq!(nan, StrokeFault::NotFinite { stroke: 0, pose: 0 });
}

#[test]
fn a_way_through_a_notch_is_refused_and_one_over_a_skim_edge_is_reported() {
    let mut notched = bare(Action::Absorb);
    let corners = [
        [-0.12, -0.09],
        [0.12, -0.09],
        [0.12, 0.09],
        [0.05, 0.09],
        [0.05, 0.0],
        [-0.05, 0.0],
        [-0.05, 0.09],
        [-0.12, 0.09],
    ];
    notched.surface.outline = Polygon::new(corners.map(Point2::from).to_vec(), vec![]);
    let through = [vec![pose(-0.1, 0.05, 0.0), pose(0.1, 0.05, 0.0)]];
    let fault = given(&notched, &through).unwrap_err();
    assert!(
        matches!(fault, StrokeFault::OffSurface { distance, .. } if distance > 0.04),
        "{fault}"
    );

    // Edge 0, towards −y, is the skim edge.
    let over = |x: f64| vec![pose(x, 0.0, -1.57), pose(x, -HALF[1] - 0.06, -1.57)];
    let skim = bare(Action::Skim);
    let plan = given(&skim, &[over(-0.05), over(0.05)]).unwrap();
    let told = describe_over_border(&check_strokes(&skim, &plan.strokes).unwrap());
    assert_eq!(
        told,
        [
            "2 strokes, strokes[0] first, leave the surface by at most 0.060 m over a skim edge, as a skim does"
        ]
    );
    // Nothing else leaves it so far, and no skim leaves it over another edge.
    assert!(given(&bare(Action::Absorb), &[over(0.0)]).is_err());
    let aside = vec![pose(0.0, 0.0, 0.0), pose(HALF[0] + 0.06, 0.0, 0.0)];
    assert!(given(&skim, &[aside]).is_err());
}

#[test]
fn what_is_planned_is_accepted_and_presses_the_tool_over_no_hole() {
    let cup = block("cup", [0.02, 0.02, 0.08], [-0.07, 0.04, 0.04]);
    for action in Action::WIPING {
        for has_hole in [false, true] {
            let mut task = bare(action);
            task.scene.push(cup.clone());
            if has_hole {
                task = with_hole(task, [0.0, -0.02], [0.03, 0.05]);
            }
            let coverage = CoverageStrategy::ALL.map(Strategy::from);
            for strategy in coverage.into_iter().chain([Strategy::Adaptive]) {
                let mut config = PlanConfig {
                    strategy,
                    seed: 1,
                    ..PlanConfig::default()
                };
                config.search.evaluations = 2000;
                let plan = plan(&task, &config).unwrap();
                assert!(!plan.strokes.is_empty());
                check_strokes(&task, &plan.strokes)
                    .unwrap_or_else(|fault| panic!("{action} by {strategy}: {fault}"));
            }
        }
    }
}

#[test]
fn a_surface_is_polished_round_its_holes() {
    let mut task = board(Action::Polish, [0.0; 3]);
    task.surface.outline = Polygon::rectangle(Vector2::new(0.6, 0.4));
    task.scene.clear();
    task.treatment = Some(Treatment::Polish {
        passes: 2,
        max_passes: 3,
        preston: None,
    });
    let places: Vec<Point2> = (0..60 * 40)
        .map(|i| {
            Point2::new(
                f64::from(i % 60) * 0.01 - 0.295,
                f64::from(i / 60) * 0.01 - 0.195,
            )
        })
        .collect();
    task.particles = ParticleDistribution::new(&places).unwrap();
    let task = with_hole(task, [0.1, 0.05], [0.15, 0.12]);
    let config = PlanConfig {
        strategy: Strategy::Lanes,
        ..PlanConfig::default()
    };
    let plan = plan(&task, &config).unwrap();
    check_strokes(&task, &plan.strokes).unwrap();
    for stroke in &plan.strokes {
        for leg in stroke.poses.windows(2) {
            let parts = task.surface.split_move(leg[0].position, leg[1].position);
            assert!(
                !parts
                    .iter()
                    .any(|part| matches!(part.ground, Ground::Hole(_)))
            );
        }
    }
    // What lies beside the hole where the middle of a lane would be over it is left.
    let performance = predict(&task, &plan, |_| ()).performance.ratio();
    assert!(performance > 0.9, "{performance}");
}

#[test]
fn a_plan_that_loses_most_of_the_dirt_is_refused_with_its_score() {
    let task = bare(Action::Collect);
    // Over the edge towards +x, over which nothing is to go.
    let out = |y: f64| vec![pose(-0.12, y, 0.0), pose(HALF[0] + 0.017, y, 0.0)];
    let plan = given(&task, &[out(-0.05), out(0.05)]).unwrap();
    let prediction = predict(&task, &plan, |_| ());
    let (initial, lost) = (prediction.performance.initial, prediction.performance.lost);
    assert!(2 * lost > initial, "{lost} of {initial}");
    let share = |count: usize| count as f64 / initial as f64;
    let score = share(prediction.performance.achieved) - 3.0 * share(lost);
    assert!((prediction.score() - score).abs() < 1e-12);
    let refused = check_score(&prediction, Action::Collect, -1.0).unwrap_err();
    assert!(
        matches!(refused, RunError::LosesDirt { least: -1.0, .. }),
        "{refused}"
    );
    assert!(
        refused
            .to_string()
            .contains(&format!("a score of {score:.2}")),
        "{refused}"
    );
    assert_eq!(check_score(&prediction, Action::Collect, -3.0), Ok(()));
}
