//! How long each stage takes, and how that grows with the dirt: a table in Markdown, and a plot.
//!
//! ```text
//! cargo run --release --package wisch-eval --example growth -- [SVG file, default growth.svg]
//! ```
//!
//! The stages are those of the first round of the shipped chopping-board by touch with `kde`, seed 1, medians of three; the strokes of
//! the effect model are pushes of 0.4 m over one square metre. One process on whatever else the machine does.

use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;
use wisch::geometry::{PlanarPose, Point2, Polygon, Pose, Region, Vector2};
use wisch::plan::{CoverageStrategy, Strategy};
use wisch::represent::{
    Effect, EffectModel, ParticleDistribution, ParticleField, Surface, ToolMotion,
};
use wisch::run::{Session, Stage, unobserved};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{SimulationSettings, Site, World};

type AnyError = Box<dyn Error + Send + Sync>;

/// A line of the plot: what it is of, and pairs of a size and a time [s].
type Line = (String, Vec<(f64, f64)>);

/// How many particles there are.
const PARTICLES: [usize; 4] = [20, 80, 320, 1280];
/// The same for the effect model alone.
const STROKES_OVER: [usize; 5] = [100, 1_000, 10_000, 100_000, 1_000_000];
const REPETITIONS: usize = 3;

fn main() -> Result<(), AnyError> {
    let path = std::env::args()
        .nth(1)
        .unwrap_or_else(|| "growth.svg".into());
    let mut lines = vec![(
        "effect of a stroke".to_owned(),
        STROKES_OVER
            .map(|count| (count as f64, stroke(count)))
            .to_vec(),
    )];
    for strategy in [
        Strategy::Coverage(CoverageStrategy::Grid),
        Strategy::Coverage(CoverageStrategy::Rrt),
        Strategy::Adaptive,
    ] {
        let mut times = Vec::new();
        for count in PARTICLES {
            let [planned, ..] = stages(count, strategy, Stage::Planned)?;
            times.push((count as f64, planned));
        }
        lines.push((format!("plan by {strategy}"), times));
    }
    let names = ["plan by kde", "follow", "check", "execute", "interpret"];
    let mut of_stage = names.map(|name| (name.to_owned(), Vec::new()));
    for count in PARTICLES {
        let times = stages(count, CoverageStrategy::Kde.into(), Stage::Interpreted)?;
        for ((_, line), time) in of_stage.iter_mut().zip(times) {
            line.push((count as f64, time));
        }
    }
    lines.extend(of_stage);
    print!("{}", table(&lines));
    std::fs::write(&path, plot(&lines))?;
    Ok(())
}

/// One push stroke [s].
fn stroke(count: usize) -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let places: Vec<Point2> = (0..count)
        .map(|_| Point2::new(random.random::<f64>() - 0.5, random.random::<f64>() - 0.5))
        .collect();
    let dirt = ParticleDistribution::new(&places).expect("finite places");
    let before = ParticleField::new(&dirt);
    let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
    let surface = Surface {
        name: "floor".into(),
        outline: Polygon::rectangle(Vector2::new(1.0, 1.0)),
        world_from_surface: Pose::identity(),
        skim_edges: Vec::new(),
    };
    let motion = ToolMotion {
        from: PlanarPose::new(Point2::new(-0.2, 0.0), 0.0),
        to: PlanarPose::new(Point2::new(0.2, 0.0), 0.0),
    };
    let mut model = EffectModel::new(&sponge, Effect::Push);
    median((0..31).map(|_| {
        let mut field = before.clone();
        let begin = Instant::now();
        model.apply(&mut field, &surface, &motion);
        begin.elapsed().as_secs_f64()
    }))
}

/// How long the stages up to one take in the first round [s]; 0 for those after.
fn stages(count: usize, strategy: Strategy, last: Stage) -> Result<[f64; 5], AnyError> {
    let options = LoadOptions {
        settings: vec![
            ("particles.count".to_owned(), count.to_string()),
            ("perception.senses".to_owned(), "[\"touch\"]".to_owned()),
            ("execution.max_bodies".to_owned(), "2000".to_owned()),
        ],
        strategy: Some(strategy),
        seed: Some(1),
        ..LoadOptions::default()
    };
    let scenario =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/chopping-board.toml");
    let loaded: LoadedTask = load_task(&scenario, &options)?;
    let robot = loaded.robot()?.ok_or("the scenario has no robot")?;
    let mut times: [Vec<f64>; 5] = Default::default();
    for _ in 0..REPETITIONS {
        let site = Site::of(&loaded.task);
        let mut world = World::new(&site, SimulationSettings::of(&loaded)?, loaded.task.seed)?;
        let session = Session::new(&loaded.task, loaded.run_config());
        let session = session.with_belief(loaded.belief());
        let mut session = session.with_robot(robot.performer());
        let reached = [
            Stage::Planned,
            Stage::Followed,
            Stage::Audited,
            Stage::Executed,
            Stage::Interpreted,
        ];
        for (stage, times) in reached.into_iter().zip(&mut times) {
            let begin = Instant::now();
            session.run_until(stage, &mut world, &mut unobserved)?;
            times.push(begin.elapsed().as_secs_f64());
            if stage == last {
                break;
            }
        }
    }
    Ok(times.map(|times| median(times.into_iter())))
}

fn median(times: impl Iterator<Item = f64>) -> f64 {
    let mut times: Vec<f64> = times.collect();
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(0.0)
}

fn table(lines: &[Line]) -> String {
    let mut text =
        String::from("| stage | times by number of particles | time grows as |\n|---|---|---|\n");
    for (name, points) in lines {
        let times: Vec<String> = (points.iter())
            .map(|(size, time)| format!("{size}: {}", in_words(*time)))
            .collect();
        let (first, last) = (points[points.len() / 2 - 1], points[points.len() - 1]);
        let exponent = libm::log(last.1 / first.1) / libm::log(last.0 / first.0);
        let _ = writeln!(text, "| {name} | {} | n^{exponent:.1} |", times.join(", "));
    }
    text
}

fn in_words(seconds: f64) -> String {
    match seconds {
        s if s < 1e-3 => format!("{:.2} µs", 1e6 * s),
        s if s < 1.0 => format!("{:.1} ms", 1e3 * s),
        s => format!("{s:.2} s"),
    }
}

/// Size of the plot [px], and its margins: left, top, right, bottom.
const PLOT: [f64; 2] = [760.0, 460.0];
const MARGINS: [f64; 4] = [70.0, 20.0, 160.0, 50.0];
const COLOURS: [&str; 9] = [
    "#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#555555", "#dd7700",
    "#004488",
];

/// Times over sizes, both in decades.
fn plot(lines: &[Line]) -> String {
    let all = || lines.iter().flat_map(|(_, points)| points);
    let decades = |of: fn(&(f64, f64)) -> f64| {
        let values = || all().map(of).filter(|value| *value > 0.0).map(libm::log10);
        [
            values().fold(f64::INFINITY, f64::min).floor(),
            values().fold(f64::NEG_INFINITY, f64::max).ceil(),
        ]
    };
    let (sizes, times) = (decades(|point| point.0), decades(|point| point.1));
    let [left, top, right, bottom] = MARGINS;
    let x =
        |decade: f64| left + (decade - sizes[0]) / (sizes[1] - sizes[0]) * (PLOT[0] - left - right);
    let y = |decade: f64| {
        PLOT[1] - bottom - (decade - times[0]) / (times[1] - times[0]) * (PLOT[1] - top - bottom)
    };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        PLOT[0], PLOT[1]
    );
    for decade in sizes[0] as i32..=sizes[1] as i32 {
        let at = x(f64::from(decade));
        let _ = writeln!(
            svg,
            "<path d=\"M{at} {top}V{}\" stroke=\"#ddd\"/><text x=\"{at}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
            PLOT[1] - bottom,
            PLOT[1] - bottom + 18.0,
            libm::pow(10.0, f64::from(decade))
        );
    }
    for decade in times[0] as i32..=times[1] as i32 {
        let at = y(f64::from(decade));
        let _ = writeln!(
            svg,
            "<path d=\"M{left} {at}H{}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
            PLOT[0] - right,
            left - 6.0,
            at + 4.0,
            in_words(libm::pow(10.0, f64::from(decade)))
                .replace(".00", "")
                .replace(".0", "")
        );
    }
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">particles</text>",
        (left + PLOT[0] - right) / 2.0,
        PLOT[1] - 10.0
    );
    // Names beside the ends of their lines, apart from each other.
    let mut ends: Vec<(f64, usize)> = (lines.iter().enumerate())
        .map(|(i, (_, points))| (y(libm::log10(points[points.len() - 1].1)), i))
        .collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut below = f64::NEG_INFINITY;
    for (end, i) in ends {
        let (name, points) = &lines[i];
        let colour = COLOURS[i % COLOURS.len()];
        let places: Vec<String> = (points.iter())
            .map(|(size, time)| {
                format!("{:.1},{:.1}", x(libm::log10(*size)), y(libm::log10(*time)))
            })
            .collect();
        below = (end + 4.0).max(below + 15.0);
        let _ = writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/><text x=\"{}\" y=\"{below:.1}\" fill=\"{colour}\">{name}</text>",
            places.join(" "),
            PLOT[0] - right + 8.0
        );
    }
    svg + "</svg>\n"
}
