use super::demo::{Demo, Trouble};
use super::reduce::Dot;
use super::residual_map::Cells;
use super::*;
use crate::rasterize;
use crate::tests::{board, find_requests, keep, table, windshield};
use proptest::prelude::*;
use wisch::geometry::{Point2, Point3, Polygon, Vector2};
use wisch::interpret::{Belief, Diagnosis, Estimate, PathPiece, Touch};
use wisch::plan::predict;
use wisch::represent::{Action, GoalState, LogNormal, ParticleDistribution, Performance};

fn three_rounds() -> Demo {
    let troubles = [Trouble::Pushed, Trouble::Tilted(0.05), Trouble::Nothing];
    Demo::new(board(Action::Absorb), &troubles)
}

#[test]
fn three_rounds_are_shown() {
    let demo = three_rounds();
    let views = demo.views();
    let input = demo.input(&views);
    let pictures = pictures(&input);
    assert_eq!(pictures.len(), 1 + 3 * 5);
    for (stem, svg) in pictures {
        assert_eq!(find_requests(&svg), [""; 0], "{stem}");
        assert!(svg.len() < 150_000, "{stem}: {} bytes", svg.len());
        let png = rasterize(&svg, 1.5).expect("our own pictures can be drawn");
        keep(&format!("{stem}.svg"), &svg);
        keep(&format!("{stem}.png"), png);
    }
}

/// Makes a piece of a path at a time [s] and a height [m].
fn piece(time: f64, height: f64, touch: Touch) -> PathPiece {
    PathPiece {
        time: [time, time + 1e-3],
        position: Point3::new(0.1 * (time / 40.0).sin(), 0.05, height),
        heading: 0.0,
        normal_force: if touch == Touch::Free { 0.0 } else { -9.5 },
        tangential_force: 0.0,
        normalized_force: if touch == Touch::Free { 0.0 } else { 0.95 },
        height,
        slope: Vector2::zeros(),
        touch,
    }
}

fn dot(x: f64, y: f64, touch: Touch) -> Dot {
    Dot { x, y, touch }
}

/// Draws and rasterises the pictures of a changed demo; returns their joined text and each picture.
fn draw(
    name: &str,
    demo: &Demo,
    change: impl Fn(&mut RoundsInput, &mut Vec<RoundView>),
) -> (String, Vec<(String, String)>) {
    let mut views = demo.views();
    let none = [];
    let mut input = demo.input(&none);
    change(&mut input, &mut views);
    input.rounds = &views;
    let pictures = pictures(&input);
    for (stem, svg) in &pictures {
        assert!(svg.len() < 150_000, "{name}, {stem}: {} bytes", svg.len());
        assert!(!svg.contains("NaN"), "{name}, {stem}");
        let png = rasterize(svg, 1.0).expect("our own pictures can be drawn");
        keep(&format!("{name}-{stem}.png"), png);
    }
    let all = pictures.iter().map(|(_, svg)| svg.as_str());
    (all.collect(), pictures)
}

fn one_round(path: &[PathPiece]) -> Demo {
    let mut demo = Demo::new(board(Action::Absorb), &[Trouble::Nothing]);
    demo.rounds[0].interpretation.path = path.to_vec();
    demo
}

#[test]
fn a_peak_of_one_sample_in_minutes_is_kept() {
    let mut curve: Vec<Dot> = (0..120_000)
        .map(|i| dot(f64::from(i) * 0.005, 50.0, Touch::Confident))
        .collect();
    curve[77_777].y = 3.0;
    curve[5] = dot(curve[5].x, 90.0, Touch::FalsePositive);
    let kept = reduce::find_peaks(&curve);
    assert!(kept.len() < 2_600, "{}", kept.len());
    assert!(kept.contains(&curve[77_777]) && kept.contains(&curve[5]));
    assert!(kept.is_sorted_by(|a, b| a.x <= b.x), "in their order");
}

proptest! {
    #[test]
    fn extremes_of_every_contact_class_are_drawn(
        values in proptest::collection::vec((0.0..700.0_f64, 0.0..200.0_f64, 0..4usize), 1..400)
    ) {
        let touches = [Touch::Free, Touch::Weak, Touch::Confident, Touch::FalsePositive];
        let mut curve: Vec<Dot> = (values.into_iter())
            .map(|(x, y, touch)| dot(x, y, touches[touch]))
            .collect();
        curve.sort_by(|a, b| a.x.total_cmp(&b.x));
        let kept = reduce::find_peaks(&curve);
        prop_assert!(kept.iter().all(|dot| curve.contains(dot)));
        for touch in touches {
            let range = |dots: &[Dot]| {
                let of_touch = dots.iter().filter(|dot| dot.touch == touch);
                of_touch.fold((f64::MAX, f64::MIN), |(low, high), dot| (low.min(dot.y), high.max(dot.y)))
            };
            prop_assert_eq!(range(&kept), range(&curve));
        }
    }
}

#[test]
fn a_flickering_contact_class_stays_drawable() {
    let touches = [
        Touch::Free,
        Touch::Weak,
        Touch::Confident,
        Touch::FalsePositive,
    ];
    let path: Vec<PathPiece> = (0..180_000)
        .map(|i| {
            piece(
                f64::from(i) * 1e-3,
                1e-3 * f64::from(i % 7),
                touches[i as usize % 4],
            )
        })
        .collect();
    assert!(reduce::split_stretches(&path, 1e-5).len() <= 5_000);
    let (_, pictures) = draw("flicker", &one_round(&path), |_, _| ());
    assert_eq!(pictures.len(), 6);
}

#[test]
fn runs_are_contiguous_and_lose_no_point() {
    let curve = [
        dot(0.0, 1.0, Touch::Free),
        dot(1.0, 2.0, Touch::Free),
        dot(2.0, 3.0, Touch::Weak),
        dot(3.0, 4.0, Touch::Free),
    ];
    let runs = reduce::split_runs(&curve);
    let points: Vec<&[(f64, f64)]> = runs.iter().map(|run| run.points.as_slice()).collect();
    assert_eq!(
        points,
        [
            &[(0.0, 1.0), (1.0, 2.0)][..],
            &[(1.0, 2.0), (2.0, 3.0)],
            &[(2.0, 3.0), (3.0, 4.0)]
        ]
    );
}

#[test]
fn spans_are_merged_over_small_gaps_only() {
    let path: Vec<PathPiece> = [0.0, 0.002, 0.5, 0.501]
        .into_iter()
        .map(|time| piece(time, 0.0, Touch::FalsePositive))
        .collect();
    let spans = reduce::find_spans(&path, Touch::FalsePositive, 0.01);
    assert_eq!(spans, [[0.0, 0.003], [0.5, 0.502]]);
    assert_eq!(reduce::find_spans(&path, Touch::Weak, 0.01), [[0.0; 2]; 0]);
}

#[test]
fn a_short_push_is_visible_on_the_path() {
    let mut path: Vec<PathPiece> = (0..1_000)
        .map(|i| piece(f64::from(i) * 0.05, 0.0, Touch::Confident))
        .collect();
    path[500].touch = Touch::FalsePositive;
    let stretches = reduce::split_stretches(&path, 0.01);
    let pushed = |stretch: &&reduce::Stretch| stretch.touch == Touch::FalsePositive;
    assert_eq!(stretches.iter().filter(pushed).count(), 1);
    assert_eq!(
        stretches.last().map(|s| s.end),
        path.last().map(|p| p.position)
    );
}

#[test]
fn invalid_pieces_are_skipped() {
    let good = piece(1.0, 0.0, Touch::Weak);
    let mut nan = piece(2.0, 0.0, Touch::Weak);
    nan.normal_force = f64::NAN;
    let early = piece(0.5, 0.0, Touch::Weak);
    let mut backwards = piece(3.0, 0.0, Touch::Weak);
    backwards.time = [3.0, 2.0];
    assert_eq!(
        reduce::select_usable(&[good, nan, early, backwards]),
        [good]
    );
    draw("unusable", &one_round(&[nan, backwards]), |_, _| ());
}

#[test]
fn short_logs_are_drawn() {
    let (html, _) = draw("empty", &one_round(&[]), |_, _| ());
    assert!(html.contains("The log is empty."));
    draw(
        "one-sample",
        &one_round(&[piece(4.0, 0.0, Touch::Confident)]),
        |_, _| (),
    );
    let mut instant = piece(4.0, 0.0, Touch::Confident);
    instant.time = [4.0, 4.0];
    draw("one-instant", &one_round(&[instant]), |_, _| ());
}

#[test]
fn a_round_without_contact_says_so() {
    let path: Vec<PathPiece> = (0..500)
        .map(|i| piece(f64::from(i) * 0.01, 0.05, Touch::Free))
        .collect();
    let mut demo = one_round(&path);
    let found = &mut demo.rounds[0].interpretation;
    found.plane = None;
    found.diagnosis = Diagnosis::NoContact;
    found.events = Vec::new();
    let (html, pictures) = draw("no-contact", &demo, |_, _| ());
    assert!(html.contains("height above the believed surface"));
    let path = &pictures
        .iter()
        .find(|(stem, _)| stem == "round-1-path")
        .expect("a path")
        .1;
    assert!(!path.contains("class=\"fitted-plane\""));
}

/// Marks of ground truth in figures.
const TRUTHS: [&str; 2] = ["true: ", "class=\"bar-true"];

#[test]
fn without_ground_truth_none_is_shown() {
    let demo = three_rounds();
    let (html, _) = draw("no-truth", &demo, |_, views| {
        for view in views {
            view.truth = None;
            view.pushes = &[];
        }
    });
    for truth in TRUTHS {
        assert!(!html.contains(truth), "{truth}");
    }
    let (html, _) = draw("truth", &demo, |_, _| ());
    for truth in TRUTHS {
        assert!(html.contains(truth), "{truth}");
    }
}

#[test]
fn names_are_escaped() {
    let mut demo = Demo::new(board(Action::Absorb), &[Trouble::Nothing]);
    demo.task.name = "<script>alert(1)</script> & \"co\"".to_owned();
    demo.task.medium = "<b>crumbs</b>".to_owned();
    let (html, pictures) = draw("names", &demo, |_, _| ());
    assert!(!html.contains("<script") && !html.contains("<b>"));
    assert!(pictures[0].1.contains("&lt;script&gt;"));
}

#[test]
fn a_run_without_rounds_has_pictures() {
    let demo = three_rounds();
    let (_, pictures) = draw("none", &demo, |_, views| views.clear());
    assert_eq!(pictures, []);
}

#[test]
fn of_many_rounds_the_first_and_the_last_have_pictures() {
    let demo = Demo::new(board(Action::Absorb), &[Trouble::Nothing]);
    let (_, pictures) = draw("many", &demo, |_, views| {
        let first = views[0];
        views.extend((2..=40).map(|number| RoundView { number, ..first }));
    });
    assert_eq!(pictures.len(), 1 + 5 * MAX_PICTURED);
    let stems: Vec<&str> = pictures.iter().map(|(stem, _)| stem.as_str()).collect();
    assert!(stems.contains(&"round-1-force") && stems.contains(&"round-40-force"));
    assert!(!stems.contains(&"round-2-force"));
}

#[test]
fn cells_hold_mean_and_standard_deviation() {
    let mut task = board(Action::Absorb);
    task.surface.outline = Polygon::rectangle(Vector2::new(0.4, 0.2));
    let lying = |points: &[Point2]| ParticleDistribution::new(points).expect("finite");
    let (low, high) = (Point2::new(-0.199, -0.099), Point2::new(0.199, 0.099));
    let replays = [
        lying(&[low, low, low, high, high, high, high, high]),
        lying(&[low, high, high, high, high, high, high, high]),
    ];
    let cells = Cells::new(&replays, &GoalState::Absorbed, &task.surface);
    // Each of 8 particles has 0.01 m² for itself, a square of 0.1 m: 4 × 2 cells.
    assert_eq!((cells.side, cells.columns, cells.mean.len()), (0.1, 4, 8));
    // 3 and 1 particles: mean 2, deviation 1. 5 and 7 particles: mean 6, deviation 1.
    assert_eq!((cells.mean[0], cells.deviation[0]), (2.0, 1.0));
    assert_eq!((cells.mean[7], cells.deviation[7]), (6.0, 1.0));
    assert_eq!(cells.mean.iter().sum::<f64>(), 8.0);
    // No particle outside the goal remains.
    let goal = GoalState::Collected {
        center: low,
        radius: 0.05,
    };
    let cells = Cells::new(&replays, &goal, &task.surface);
    assert_eq!((cells.mean[0], cells.mean[7]), (0.0, 6.0));
    let nothing = Cells::new(&[], &goal, &task.surface).mean;
    assert!(nothing.iter().all(|&mean| mean == 0.0));
}

#[test]
fn the_typical_replay_is_nearest_to_the_mean() {
    let demo = three_rounds();
    let views = demo.views();
    let input = demo.input(&views);
    let share = |particles: &ParticleDistribution| {
        Performance::evaluate(particles, input.goal, &input.task.surface).ratio()
    };
    let mean = views[0].interpretation.performance.mean;
    let off = (share(views[0].typical_replay(&input)) - mean).abs();
    assert!(
        views[0]
            .members()
            .iter()
            .all(|r| (share(r) - mean).abs() >= off)
    );
}

#[test]
fn logs_that_the_library_interpreted_are_shown() {
    let demo = three_rounds().interpret_logs();
    let (_, pictures) = draw("interpreted", &demo, |_, _| ());
    let path = |stem: &str| pictures.iter().find(|(name, _)| name == stem);
    let pushed = path("round-1-path").map(|(_, svg)| svg.contains("class=\"touch-false\" d="));
    assert_eq!(pushed, Some(true));
}

#[test]
fn a_wide_and_a_crowded_surface_are_shown() {
    let glass = Demo::new(windshield(Action::Absorb), &[Trouble::Pushed]);
    draw("windshield", &glass, |_, _| ());
    let crowded = Demo::new(table(Action::Absorb), &[Trouble::Tilted(-0.03)]);
    draw("table", &crowded, |_, _| ());
    let mut narrow = board(Action::Absorb);
    narrow.surface.outline = Polygon::rectangle(Vector2::new(0.2, 0.6));
    draw("narrow", &Demo::new(narrow, &[Trouble::Nothing]), |_, _| ());
}

#[test]
fn any_likelihood_can_be_drawn() {
    let mut demo = Demo::new(board(Action::Absorb), &[Trouble::Nothing]);
    for (mu, sigma) in [
        (-1.05, 0.25),
        (0.0, 1e-3),
        (-9.0, 4.0),
        (4.0, 0.1),
        (-20.0, 0.01),
    ] {
        demo.task.interaction.likelihood = LogNormal { mu, sigma };
        draw(&format!("likelihood-{mu}-{sigma}"), &demo, |_, _| ());
    }
}

#[test]
fn a_collect_and_a_skim_are_shown() {
    for action in [Action::Collect, Action::Skim] {
        let mut demo = Demo::new(board(action), &[Trouble::Nothing]);
        let round = &mut demo.rounds[0];
        let prediction = predict(&demo.task, &round.plan, |_| ());
        let (after, share) = (prediction.particles, prediction.performance.ratio());
        demo.goal = round.plan.graph.goal;
        (round.truth, round.share) = (after.clone(), share);
        round.interpretation.belief = Belief::from_particles(after);
        round.interpretation.performance = Estimate {
            mean: share,
            low: share,
            high: share,
        };
        let (html, _) = draw(&format!("{action}"), &demo, |_, _| ());
        let done = match action {
            Action::Collect => "in the goal area",
            _ => "over the skim edge",
        };
        assert!(html.contains(done), "{action}");
    }
}
