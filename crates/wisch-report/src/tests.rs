use super::*;
use crate::draw::{Contours, PictureError};
use crate::prediction::frames::{MAX_DRAWN, MAX_FRAMES};
use resvg::{tiny_skia, usvg};
use std::path::PathBuf;
use wisch::geometry::{Mesh, Point2, Pose, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, FreeSpace, Plan, PlanConfig, Prediction, plan, predict};
use wisch::represent::Task;
use wisch::represent::{
    Action, Interaction, ParticleDistribution, SceneObject, ScenePart, Surface, Tool,
};
use wisch_testkit::{sponge, surface};

/// Environment variable with a folder in which these tests keep their pictures for inspection.
const KEEP: &str = "WISCH_KEEP_REPORTS";

struct Run {
    task: Task,
    plan: Plan,
    prediction: Prediction,
    frames: EffectFrames,
}

impl Run {
    fn of(task: Task, strategy: CoverageStrategy) -> Self {
        let config = PlanConfig {
            strategy: strategy.into(),
            seed: 1,
            ..PlanConfig::default()
        };
        let plan = plan(&task, &config).expect("the scenes of these tests can be planned");
        let mut frames = EffectFrames::new(&task, &plan);
        let prediction = predict(&task, &plan, |progress| frames.record(progress));
        Self {
            task,
            plan,
            prediction,
            frames,
        }
    }

    fn input(&self) -> ReportInput<'_> {
        ReportInput {
            title: &self.task.name,
            task: &self.task,
            plan: &self.plan,
            prediction: &self.prediction,
            frames: &self.frames,
            bandwidth: None,
            motion: None,
            rounds: None,
        }
    }
}

/// Returns the shipped interaction of a sponge with breadcrumbs.
fn interaction() -> Interaction {
    let knowledge = wisch_io::KnowledgeSource::BuiltIn
        .base()
        .expect("the shipped knowledge");
    let known = knowledge.interaction("sponge", "breadcrumbs", "table");
    known.expect("the sponge on the table").clone()
}

fn task(action: Action, size: Vector2, scene: Vec<SceneObject>, count: usize) -> Task {
    let mut task = Task {
        name: format!("{action} on a surface of {} × {} m", size.x, size.y),
        action,
        surface: Surface {
            name: "surface".into(),
            ..surface(size.into())
        },
        scene,
        tool: Tool {
            mesh: Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).expect("a box"),
            ..sponge()
        },
        medium: "breadcrumbs".into(),
        interaction: interaction(),
        particles: ParticleDistribution::default(),
        collect_goal: Some(Point2::new(0.3 * size.x, -0.3 * size.y)),
        treatment: None,
        mobility: Default::default(),
        tool_start: Point2::new(0.0, -0.5 * size.y - 0.11),
        seed: 1,
    };
    let meshes: Vec<_> = task.obstacles_in_surface().collect();
    let space = FreeSpace::new(&task.surface, &meshes, 0.065).expect("boxes make a scene");
    // A low-discrepancy sequence (Roberts' R2) makes the positions deterministic.
    let places: Vec<Point2> = (1..)
        .map(|i| {
            let i = f64::from(i);
            Point2::new(
                ((i * 0.754_877_666).fract() - 0.5) * size.x,
                ((i * 0.569_840_291).fract() - 0.5) * size.y,
            )
        })
        .filter(|&p| count > 1_000 || !space.is_occupied(p))
        .take(count)
        .collect();
    task.particles = ParticleDistribution::new(&places).expect("finite places");
    task
}

fn object(name: &str, mesh: Mesh, at: [f64; 3], turn: f64) -> SceneObject {
    SceneObject {
        name: name.into(),
        part: ScenePart::Obstacle,
        mesh,
        world_from_object: Pose::new(
            Vector3::new(at[0], at[1], at[2]),
            Vector3::new(0.0, 0.0, turn),
        ),
    }
}

pub(crate) fn board(action: Action) -> Task {
    task(action, Vector2::new(0.40, 0.28), Vec::new(), 80)
}

pub(crate) fn table(action: Action) -> Task {
    let cuboid = Mesh::cuboid(Vector3::new(0.10, 0.06, 0.2)).expect("a box");
    let cup = Mesh::cylinder(0.04, 0.1, 48).expect("a cup");
    let bowl = Mesh::cylinder(0.06, 0.08, 48).expect("a bowl");
    let scene = vec![
        object("cup", cup, [-0.30, 0.18, 0.05], 0.0),
        object("bowl", bowl, [0.33, 0.19, 0.04], 0.0),
        object("box", cuboid, [-0.02, 0.22, 0.1], 0.0),
    ];
    task(action, Vector2::new(0.80, 0.50), scene, 80)
}

pub(crate) fn windshield(action: Action) -> Task {
    let pillar = |side: f64| {
        let mesh = Mesh::cuboid(Vector3::new(0.06, 0.6, 0.06)).expect("a box");
        object("pillar", mesh, [side * 0.485, 0.0, 0.0], side * 0.12)
    };
    let scene = vec![pillar(-1.0), pillar(1.0)];
    task(action, Vector2::new(0.90, 0.40), scene, 160)
}

/// Keeps a file if [`KEEP`] is set.
pub(crate) fn keep(name: &str, bytes: impl AsRef<[u8]>) {
    let Some(folder) = std::env::var_os(KEEP).map(PathBuf::from) else {
        return;
    };
    std::fs::create_dir_all(&folder).expect("the folder can be made");
    std::fs::write(folder.join(name), bytes).expect("the file is written");
}

/// Writes pictures into a folder, which is kept if [`KEEP`] is set.
fn write(name: &str, input: &ReportInput) {
    let scratch = tempfile::tempdir().expect("a temporary folder");
    let folder = std::env::var_os(KEEP).map_or(scratch.path().to_owned(), PathBuf::from);
    std::fs::create_dir_all(&folder).expect("the folder can be made");
    for (stem, svg) in pictures(input) {
        let png = rasterize(&svg, 1.5).expect("our own pictures can be drawn");
        std::fs::write(folder.join(format!("{name}-{stem}.svg")), &svg).expect("written");
        std::fs::write(folder.join(format!("{name}-{stem}.png")), png).expect("written");
    }
}

/// Returns the addresses that a browser would request; a page or picture must have none. Namespaces do not count.
pub(crate) fn find_requests(text: &str) -> Vec<&str> {
    let named = text
        .replace("http://www.w3.org/2000/svg", "")
        .replace("http://www.w3.org/1999/xhtml", "");
    ["http://", "https://", "url(h", "src=", "@import", "href="]
        .into_iter()
        .filter(|sign| named.contains(sign))
        .collect()
}

#[test]
fn requests_are_found() {
    for bad in [
        r#"<script src="x.js">"#,
        "@import 'x.css'",
        "fetch('https://example.org')",
    ] {
        assert_ne!(find_requests(bad), [""; 0], "{bad}");
    }
    assert_eq!(
        find_requests(r#"<svg xmlns="http://www.w3.org/2000/svg">"#),
        [""; 0]
    );
}

#[test]
fn every_kind_of_run_has_pictures_that_decode_to_their_size() {
    let runs = [
        (
            "board-absorb-grid",
            board(Action::Absorb),
            CoverageStrategy::Grid,
        ),
        (
            "table-collect-kde",
            table(Action::Collect),
            CoverageStrategy::Kde,
        ),
        (
            "table-absorb-grid",
            table(Action::Absorb),
            CoverageStrategy::Grid,
        ),
        (
            "windshield-skim-rrt",
            windshield(Action::Skim),
            CoverageStrategy::Rrt,
        ),
    ];
    for (name, task, strategy) in runs {
        let run = Run::of(task, strategy);
        let input = run.input();
        write(name, &input);
        for (stem, svg) in pictures(&input) {
            assert_eq!(find_requests(&svg), [""; 0], "{name} {stem}");
            let size = usvg::Tree::from_str(&svg, &usvg::Options::default())
                .expect("the picture is SVG")
                .size();
            let png = rasterize(&svg, 2.0).expect("the picture can be drawn");
            let pixels = tiny_skia::Pixmap::decode_png(&png).expect("the picture is PNG");
            let doubled = |side: f32| (2.0 * side).round() as u32;
            assert_eq!(
                (pixels.width(), pixels.height()),
                (doubled(size.width()), doubled(size.height()))
            );
        }
    }
}

#[test]
fn text_is_drawn_with_the_shipped_font() {
    let draw = |word: &str| {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="80" height="20"><text font-family="Inter,sans-serif" font-size="14" y="15">{word}</text></svg>"#
        );
        rasterize(&svg, 1.0).expect("text can be drawn")
    };
    let blank = draw("");
    for word in ["wipe", "×", "−0.25", "…", "ä", "·", "μ"] {
        assert_ne!(draw(word), blank, "{word} leaves no mark");
    }
}

#[test]
fn invalid_pictures_are_rejected() {
    assert!(matches!(rasterize("<p>", 1.0), Err(PictureError::Svg(_))));
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100"/>"#;
    for scale in [0.0, -1.0, f32::NAN, 1e9] {
        assert!(matches!(
            rasterize(svg, scale),
            Err(PictureError::Size { .. } | PictureError::Svg(_))
        ));
    }
}

#[test]
fn hostile_names_stay_text() {
    let evil = r#"</title><script>alert("1")</script>&'"#;
    let mut task = table(Action::Collect);
    task.name = evil.into();
    task.medium = evil.into();
    task.tool.name = evil.into();
    task.surface.name = evil.into();
    task.scene[0].name = evil.into();
    let run = Run::of(task, CoverageStrategy::Grid);
    let texts = pictures(&run.input()).into_iter().map(|(_, svg)| svg);
    for text in texts {
        assert!(!text.contains("<script>alert"));
        assert!(!text.contains("</title><script"));
        assert!(text.contains("&lt;script&gt;alert"));
    }
}

#[test]
fn a_run_without_frames_strokes_or_particles_is_drawn() {
    let mut unwatched = Run::of(board(Action::Collect), CoverageStrategy::Kde);
    unwatched.frames = EffectFrames::new(&unwatched.task, &unwatched.plan);
    let mut still = Run::of(board(Action::Skim), CoverageStrategy::Grid);
    still.plan.strokes.clear();
    still.plan.graph.edges.clear();
    still.plan.graph.nodes.clear();
    still.frames = EffectFrames::new(&still.task, &still.plan);
    still.prediction = predict(&still.task, &still.plan, |p| still.frames.record(p));
    let clean = Run::of(
        task(Action::Absorb, Vector2::new(0.4, 0.28), Vec::new(), 0),
        CoverageStrategy::Kde,
    );
    for (name, run) in [("unwatched", unwatched), ("still", still), ("clean", clean)] {
        write(name, &run.input());
        for (_, svg) in pictures(&run.input()) {
            assert!(!svg.contains("NaN") && !svg.contains("inf "), "{name}");
        }
    }
}

#[test]
fn a_hundred_thousand_particles_are_thinned() {
    let run = Run::of(
        task(Action::Skim, Vector2::new(0.9, 0.4), Vec::new(), 100_000),
        CoverageStrategy::Grid,
    );
    write("many", &run.input());
    assert!(run.frames.frames().len() <= MAX_FRAMES);
    assert!(run.frames.frames()[0].particles.len() <= MAX_DRAWN);
}

#[test]
fn frames_begin_before_the_first_stroke_and_end_with_the_prediction() {
    for task in [
        board(Action::Collect),
        table(Action::Skim),
        windshield(Action::Absorb),
    ] {
        let run = Run::of(task, CoverageStrategy::Grid);
        let frames = run.frames.frames();
        let (first, last) = (&frames[0], &frames[frames.len() - 1]);
        assert_eq!((first.distance, first.stroke), (0.0, None));
        assert!(frames.len() <= MAX_FRAMES);
        assert!(frames.is_sorted_by_key(|frame| frame.distance));
        assert_eq!(last.performance, run.prediction.performance);
        assert!(
            last.particles
                .iter()
                .copied()
                .eq(run.prediction.particles.iter())
        );
    }
}

#[test]
fn of_many_motions_eighty_moments_are_kept_the_last_among_them() {
    let large = task(Action::Collect, Vector2::new(2.0, 1.5), Vec::new(), 300);
    let run = Run::of(large, CoverageStrategy::Grid);
    let frames = run.frames.frames();
    assert!(
        run.plan
            .strokes
            .iter()
            .map(|s| s.motions().count())
            .sum::<usize>()
            > 2 * MAX_FRAMES
    );
    assert_eq!(frames.len(), MAX_FRAMES);
    assert_eq!(
        frames[MAX_FRAMES - 1].performance,
        run.prediction.performance
    );
    write("large", &run.input());
}

#[test]
fn contours_of_one_particle_are_circles_with_the_radius_of_the_kernel() {
    let bandwidth = 0.05;
    let bounds = wisch::geometry::Bounds2 {
        min: Point2::new(-0.2, -0.2),
        max: Point2::new(0.2, 0.2),
    };
    let map = wisch::plan::CoverageDensity::new(&[Point2::origin()], bounds, bandwidth);
    let contours = Contours::new(&map);
    let rings = contours.rings(0.5 * contours.peak);
    assert_eq!(rings.len(), 1);
    // K falls as exp(-r²/h²): half of the peak at r = h √ln 2.
    let radius = bandwidth * 2f64.ln().sqrt();
    for p in &rings[0] {
        // Linear interpolation between samples a stride of at most h/4 apart.
        assert!((p.coords.norm() - radius).abs() < 0.02 * radius, "{p}");
    }
}

#[test]
fn a_ring_of_contours_is_hollow() {
    let ring: Vec<Point2> = (0..200)
        .map(|i| {
            let angle = f64::from(i) * std::f64::consts::TAU / 200.0;
            Point2::new(0.3 * angle.cos(), 0.3 * angle.sin())
        })
        .collect();
    let bounds = wisch::geometry::Bounds2 {
        min: Point2::new(-0.5, -0.5),
        max: Point2::new(0.5, 0.5),
    };
    let map = wisch::plan::CoverageDensity::new(&ring, bounds, 0.08);
    let contours = Contours::new(&map);
    assert_eq!(contours.rings(0.5 * contours.peak).len(), 2);
}

#[test]
fn numbers_are_written_for_people() {
    use crate::draw::{count_decimals, find_tick_step, format_decimal, format_percent, px};
    assert_eq!(format_decimal(-0.25, 2), "\u{2212}0.25");
    assert_eq!(format_decimal(-0.001, 2), "0.00");
    assert_eq!(format_percent(0.84255), "84.3 %");
    assert_eq!([px(-0.04), px(3.0), px(-2.25)], ["0", "3", "-2.3"]);
    assert_eq!(
        [
            find_tick_step(0.07),
            find_tick_step(0.2),
            find_tick_step(3.0)
        ],
        [0.1, 0.2, 5.0]
    );
    assert_eq!(
        [
            count_decimals(0.1),
            count_decimals(0.05),
            count_decimals(5.0)
        ],
        [1, 2, 0]
    );
}
