//! How long each stage takes, and how that grows: tables in Markdown, and a plot.
//!
//! ```text
//! cargo run --release --package wisch-eval --example growth -- [SVG file, default growth.svg]
//! ```
//!
//! The stages are those of the first round of the shipped chopping-board by touch with `kde`, seed 1, medians of three; the strokes of
//! the effect model are pushes of 0.4 m over one square metre, tours those of points spread evenly, and paths those of seven
//! joints on smooth ways. One process on whatever else the machine does.

use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::error::Error;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;
use wisch::follow::{JointLimit, JointLimits, JointPath, TimingConfig, time_path};
use wisch::geometry::{PlanarPose, Point2, Polygon, Pose, Region, Vector2};
use wisch::plan::{CostMatrix, CoverageStrategy, Strategy, TourConfig, shortest_tour};
use wisch::represent::{
    Effect, EffectModel, ParticleDistribution, ParticleField, Surface, ToolMotion,
};
use wisch::run::{Session, Stage, ignore_events};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{WorkSurface, World};

type AnyError = Box<dyn Error + Send + Sync>;

/// A line of a plot: what it is of, and pairs of a size and a time [s].
type Line = (String, Vec<(f64, f64)>);

/// What grows, and how times grow with it.
struct Panel {
    size: &'static str,
    lines: Vec<Line>,
}

/// How many particles there are.
const PARTICLES: [usize; 3] = [20, 80, 320];
/// The same for the effect model alone.
const STROKES_OVER: [usize; 5] = [100, 1_000, 10_000, 100_000, 1_000_000];
/// How many members the belief has, of 80 particles each.
const MEMBERS: [usize; 3] = [16, 64, 256];
const NODES: [usize; 5] = [20, 50, 200, 500, 1000];
const WAYPOINTS: [usize; 4] = [100, 1_000, 10_000, 100_000];
const REPETITIONS: usize = 3;

fn main() -> Result<(), AnyError> {
    let path = std::env::args()
        .nth(1)
        .unwrap_or_else(|| "growth.svg".into());
    let nodes = || Panel {
        size: "nodes",
        lines: vec![line("tour", NODES, tour)],
    };
    let waypoints = || Panel {
        size: "waypoints",
        lines: vec![line("timing of a path", WAYPOINTS, timing)],
    };
    let panels = [
        shown(nodes()),
        shown(waypoints()),
        shown(of_members()?),
        shown(of_particles()?),
    ];
    std::fs::write(&path, plot(&panels))?;
    Ok(())
}

/// Prints the table of a panel as soon as it is there.
fn shown(panel: Panel) -> Panel {
    println!("{}", table(&panel));
    panel
}

fn line<const N: usize>(name: &str, sizes: [usize; N], time: impl Fn(usize) -> f64) -> Line {
    let points = sizes.map(|size| (size as f64, time(size)));
    (name.to_owned(), points.to_vec())
}

fn of_particles() -> Result<Panel, AnyError> {
    let mut lines = vec![line("effect of a stroke", STROKES_OVER, stroke)];
    for strategy in [
        Strategy::Coverage(CoverageStrategy::Grid),
        Strategy::Coverage(CoverageStrategy::Rrt),
        Strategy::Adaptive,
    ] {
        let mut times = Vec::new();
        for count in PARTICLES {
            let [planned, ..] = stages(count, None, strategy, Stage::Planned)?;
            times.push((count as f64, planned));
        }
        lines.push((format!("plan by {strategy}"), times));
    }
    let names = ["plan by kde", "follow", "check", "execute", "interpret"];
    let mut of_stage = names.map(|name| (name.to_owned(), Vec::new()));
    for count in PARTICLES {
        let kde = CoverageStrategy::Kde.into();
        let times = stages(count, None, kde, Stage::Interpreted)?;
        for ((_, line), time) in of_stage.iter_mut().zip(times) {
            line.push((count as f64, time));
        }
    }
    lines.extend(of_stage);
    Ok(Panel {
        size: "particles",
        lines,
    })
}

fn of_members() -> Result<Panel, AnyError> {
    let (mut planned, mut interpreted) = (Vec::new(), Vec::new());
    for members in MEMBERS {
        let times = stages(80, Some(members), Strategy::Adaptive, Stage::Planned)?;
        planned.push((members as f64, times[0]));
        let kde = CoverageStrategy::Kde.into();
        let times = stages(80, Some(members), kde, Stage::Interpreted)?;
        interpreted.push((members as f64, times[4]));
    }
    Ok(Panel {
        size: "members of the belief",
        lines: vec![
            ("plan by adaptive".to_owned(), planned),
            ("interpret".to_owned(), interpreted),
        ],
    })
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
        shape: Default::default(),
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

/// The shortest way through points and back [s].
fn tour(nodes: usize) -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let points: Vec<Point2> = (0..nodes)
        .map(|_| Point2::new(random.random(), random.random()))
        .collect();
    let costs = CostMatrix::euclidean(&points).expect("finite distances");
    median((0..REPETITIONS).map(|_| {
        let begin = Instant::now();
        black_box(shortest_tour(&costs, &TourConfig::default()));
        begin.elapsed().as_secs_f64()
    }))
}

/// The timing of a smooth path of seven joints [s].
fn timing(waypoints: usize) -> f64 {
    const JOINTS: usize = 7;
    let rows: Vec<Vec<f64>> = (0..waypoints)
        .map(|i| {
            let along = i as f64 * 0.02;
            (0..JOINTS)
                .map(|j| libm::sin(along * (1.0 + 0.1 * j as f64) + j as f64))
                .collect()
        })
        .collect();
    let path = JointPath::new(&rows).expect("a path");
    let joint = |j| JointLimit::arm(&format!("joint {j}"), -2.0, 2.0);
    let limits = JointLimits::new((0..JOINTS).map(joint).collect()).expect("limits");
    median((0..REPETITIONS).map(|_| {
        let begin = Instant::now();
        black_box(time_path(&path, &limits, &TimingConfig::default())).expect("a trajectory");
        begin.elapsed().as_secs_f64()
    }))
}

/// How long the stages up to one take in the first round [s]; 0 for those after. The belief has as many members as the
/// program's unless set.
fn stages(
    count: usize,
    members: Option<usize>,
    strategy: Strategy,
    last: Stage,
) -> Result<[f64; 5], AnyError> {
    let options = LoadOptions {
        settings: vec![
            ("particles.count".to_owned(), count.to_string()),
            ("perception.senses".to_owned(), "[\"touch\"]".to_owned()),
            ("execution.max_bodies".to_owned(), "500".to_owned()),
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
        let site = WorkSurface::from_task(&loaded.task);
        let mut world = World::new(&site, loaded.simulation.clone(), loaded.task.seed)?;
        let session = Session::new(&loaded.task, loaded.run.clone());
        let belief = match members {
            Some(members) => loaded.dirt_prior().belief(&loaded.task, members),
            None => loaded.belief(),
        };
        let session = session.with_belief(belief);
        let mut session = session.with_robot(robot.robot_setup());
        let reached = [
            Stage::Planned,
            Stage::Followed,
            Stage::Audited,
            Stage::Executed,
            Stage::Interpreted,
        ];
        for (stage, times) in reached.into_iter().zip(&mut times) {
            let begin = Instant::now();
            session.run_until(stage, &mut world, &mut ignore_events)?;
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

fn table(panel: &Panel) -> String {
    let mut text = format!(
        "| | times by number of {} | time grows as |\n|---|---|---|\n",
        panel.size
    );
    for (name, points) in &panel.lines {
        let times: Vec<String> = (points.iter())
            .map(|(size, time)| format!("{size}: {}", in_words(*time)))
            .collect();
        // Of the larger half, where what does not grow hides less.
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

/// Size of a panel [px], and its margins: left, top, right, bottom.
const PANEL: [f64; 2] = [620.0, 400.0];
const MARGINS: [f64; 4] = [70.0, 20.0, 150.0, 50.0];
const COLOURS: [&str; 9] = [
    "#4477aa", "#ee6677", "#228833", "#b8a030", "#3399bb", "#aa3377", "#555555", "#dd7700",
    "#004488",
];

/// Times over sizes, both in decades; two panels beside each other.
fn plot(panels: &[Panel]) -> String {
    let rows = panels.len().div_ceil(2) as f64;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        2.0 * PANEL[0],
        rows * PANEL[1]
    );
    for (i, panel) in panels.iter().enumerate() {
        let place = [(i % 2) as f64 * PANEL[0], (i / 2) as f64 * PANEL[1]];
        let _ = writeln!(
            svg,
            "<g transform=\"translate({} {})\">\n{}</g>",
            place[0],
            place[1],
            axes_and_lines(panel)
        );
    }
    svg + "</svg>\n"
}

fn axes_and_lines(panel: &Panel) -> String {
    let all = || panel.lines.iter().flat_map(|(_, points)| points);
    let decades = |of: fn(&(f64, f64)) -> f64| {
        let values = || all().map(of).filter(|value| *value > 0.0).map(libm::log10);
        [
            values().fold(f64::INFINITY, f64::min).floor(),
            values().fold(f64::NEG_INFINITY, f64::max).ceil(),
        ]
    };
    let (sizes, times) = (decades(|point| point.0), decades(|point| point.1));
    let [left, top, right, bottom] = MARGINS;
    let (width, height) = (PANEL[0] - left - right, PANEL[1] - top - bottom);
    let x = |decade: f64| left + (decade - sizes[0]) / (sizes[1] - sizes[0]) * width;
    let y = |decade: f64| top + (times[1] - decade) / (times[1] - times[0]) * height;
    let mut svg = String::new();
    for decade in sizes[0] as i32..=sizes[1] as i32 {
        let at = x(f64::from(decade));
        let _ = writeln!(
            svg,
            "<path d=\"M{at} {top}v{height}\" stroke=\"#ddd\"/><text x=\"{at}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
            top + height + 18.0,
            libm::pow(10.0, f64::from(decade))
        );
    }
    for decade in times[0] as i32..=times[1] as i32 {
        let at = y(f64::from(decade));
        let _ = writeln!(
            svg,
            "<path d=\"M{left} {at}h{width}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
            left - 6.0,
            at + 4.0,
            decade_in_words(decade)
        );
    }
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
        left + width / 2.0,
        PANEL[1] - 10.0,
        panel.size
    );
    // Names beside the ends of their lines, apart from each other.
    let mut ends: Vec<(f64, usize)> = (panel.lines.iter().enumerate())
        .map(|(i, (_, points))| (y(libm::log10(points[points.len() - 1].1)), i))
        .collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut below = f64::NEG_INFINITY;
    for (end, i) in ends {
        let (name, points) = &panel.lines[i];
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
            left + width + 8.0
        );
    }
    svg
}

/// A power of ten of a second.
fn decade_in_words(decade: i32) -> String {
    let (unit, of) = match decade {
        0.. => ("s", 0),
        -3.. => ("ms", -3),
        _ => ("µs", -6),
    };
    format!("{} {unit}", libm::pow(10.0, f64::from(decade - of)))
}
