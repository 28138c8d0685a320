//! Gravity in predictions: dirt that slides back after a stroke, and a film that makes the order of strokes matter.

use std::f64::consts::FRAC_PI_2;
use wisch::geometry::{PlanarPose, Point2, Polygon, Pose, Vector2, Vector3};
use wisch::plan::{Plan, PlanConfig, Planner, has_predicted_gain, plan_from_strokes, predict};
use wisch::represent::{
    Action, DirtFriction, DirtMobility, Fate, Liquid, LiquidFilm, ParticleDistribution, Surface,
    SurfaceShape, Task, Tool, ToolPace,
};

fn task(action: Action, surface: Surface, dirt: &[Point2]) -> Task {
    let sponge = Tool::pad("sponge", Vector3::new(0.06, 0.06, 0.05)).unwrap();
    let dirt = ParticleDistribution::new(dirt).unwrap();
    Task::new(action, surface, sponge, "dirt", dirt)
}

fn plan_of(task: &Task, strokes: &[Vec<PlanarPose>]) -> Plan {
    plan_from_strokes(task, strokes, 0.05).unwrap()
}

/// A panel of 0.36 x 0.5 m whose y points up its slope, with 0.1 mm of a liquid on it.
fn panel(slope: f64) -> Task {
    let outline = Polygon::rectangle(Vector2::new(0.36, 0.5));
    let pose = Pose::new(Vector3::z(), Vector3::x() * slope);
    let (columns, rows) = (20, 28);
    let lattice = (0..columns * rows).map(|i| {
        let share = |i: usize, count: usize| (i as f64 + 0.5) / count as f64 - 0.5;
        Point2::new(
            0.36 * share(i % columns, columns),
            0.5 * share(i / columns, rows),
        )
    });
    let dirt: Vec<Point2> = lattice.collect();
    let mut surface = Surface::new("panel", outline, pose);
    surface.skim_edges = vec![0, 1, 2, 3];
    let mut task = task(Action::Skim, surface, &dirt);
    task.mobility = DirtMobility::Runs(LiquidFilm {
        liquid: Liquid {
            viscosity: 2e-3,
            ..Liquid::WATER
        },
        particle_volume: 0.36 * 0.5 * 1e-4 / dirt.len() as f64,
        pace: ToolPace::default(),
    });
    task
}

/// Lanes across the panel and over its border, from the top down or from the bottom up.
fn lanes(is_down: bool) -> Vec<Vec<PlanarPose>> {
    let height = |lane: usize| 0.22 - 0.055 * lane as f64;
    let lane = |lane: usize| {
        let lane = if is_down { lane } else { 8 - lane };
        [-0.15, 0.2]
            .map(|x| PlanarPose::new(Point2::new(x, height(lane)), 0.0))
            .to_vec()
    };
    (0..9).map(lane).collect()
}

#[test]
fn a_running_film_scores_lanes_from_the_top_down_higher_than_from_the_bottom_up() {
    let scores = |task: &Task| {
        [true, false].map(|is_down| {
            let plan = plan_of(task, &lanes(is_down));
            let prediction = predict(task, &plan, |_| ());
            assert_eq!(prediction.particles.tally().initial, task.particles.len());
            let config = PlanConfig::default();
            let score = Planner::new(task, &config).score(&plan).unwrap();
            [prediction.score(), score.total]
        })
    };
    let [down, up] = scores(&panel(0.49));
    for (down, up) in down.into_iter().zip(up) {
        assert!(down > up + 0.05, "{down} {up}");
    }
    // On a level panel, and of a liquid of which nothing is known, the order does not matter.
    let mut unknown = panel(0.49);
    unknown.mobility = DirtMobility::Unknown;
    for task in [panel(0.0), unknown] {
        let [down, up] = scores(&task);
        for (down, up) in down.into_iter().zip(up) {
            assert!((down - up).abs() < 1e-9, "{down} {up}");
        }
    }
}

#[test]
fn what_runs_off_by_itself_is_no_gain_of_a_stroke() {
    let mut task = panel(0.49);
    // The panel is dry above the middle.
    let low: Vec<Point2> = task.particles.remaining().filter(|p| p.y < 0.0).collect();
    task.particles = ParticleDistribution::new(&low).unwrap();
    let beside = [0.1, 0.12].map(|x| PlanarPose::new(Point2::new(x, 0.2), 0.0));
    let beside = plan_of(&task, &[beside.to_vec()]);
    let left = |plan: &Plan| predict(&task, plan, |_| ()).particles.tally().remaining;
    assert!(left(&beside) < low.len(), "some of it runs off meanwhile");
    assert!(!has_predicted_gain(&task, &beside));
    let through = [-0.15, 0.2].map(|x| PlanarPose::new(Point2::new(x, -0.1), 0.0));
    assert!(has_predicted_gain(
        &task,
        &plan_of(&task, &[through.to_vec()])
    ));
}

#[test]
fn dirt_that_is_pushed_up_the_side_of_a_gutter_slides_back_when_the_tool_lifts_off() {
    let outline = Polygon::rectangle(Vector2::new(0.66, 0.3));
    let mut gutter = Surface::new("gutter", outline, Pose::identity());
    gutter.shape = SurfaceShape::Cylinder {
        radius: -0.5,
        axis: FRAC_PI_2,
    };
    let dirt = [-0.02, 0.0, 0.02].map(|y| Point2::new(0.05, y));
    let mut task = task(Action::Collect, gutter, &dirt);
    task.collect_goal = Some(Point2::new(0.2, 0.0));
    task.interaction.compression_depth_m = 0.01;
    let up = [0.0, 0.27].map(|x| PlanarPose::new(Point2::new(x, 0.0), 0.0));
    let plan = plan_of(&task, &[up.to_vec()]);
    // The front of the pad is at 0.3 m, where the gutter leans by 0.6 rad: tan(0.6) = 0.68.
    let places = |task: &Task| {
        let after = predict(task, &plan, |_| ()).particles;
        after
            .iter()
            .map(|(place, fate)| {
                assert_eq!(fate, Fate::OnSurface);
                place.x
            })
            .collect::<Vec<f64>>()
    };
    assert!(places(&task).iter().all(|x| (x - 0.3).abs() < 0.01));
    task.mobility = DirtMobility::Slides(DirtFriction {
        at_rest: 0.5,
        sliding: 0.4,
    });
    let end = 0.5 * 0.4_f64.atan();
    assert!(places(&task).iter().all(|x| (x - end).abs() < 1e-9));
    task.mobility = DirtMobility::Slides(DirtFriction::constant(0.8));
    assert!(places(&task).iter().all(|x| (x - 0.3).abs() < 0.01));
}
