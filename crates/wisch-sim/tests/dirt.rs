//! The true dirt of a world: as the task sets it, independent of the belief, by separate random
//! numbers.

use std::path::Path;
use wisch::geometry::{Point2, Vector2};
use wisch::represent::Cluster;
use wisch_io::{GoalFile, LoadOptions, LoadedTask, load_task};
use wisch_sim::{
    Dirt, GrainCount, Mismatch, RealTool, SimulationError, SimulationSettings, TrueDirt,
    WorkSurface,
};
use wisch_testkit::scenario;

/// The board, with settings that override those of its file.
fn board(seed: u64, settings: &[(&str, &str)]) -> LoadedTask {
    let text = |(key, value): &(&str, &str)| ((*key).to_owned(), (*value).to_owned());
    let options = LoadOptions {
        seed: Some(seed),
        settings: settings.iter().map(text).collect(),
        ..LoadOptions::default()
    };
    load_task(&scenario("chopping-board"), &options).unwrap()
}

fn settings(dirt: &str) -> SimulationSettings {
    board(1, &[("execution.dirt", dirt)]).simulation
}

/// Positions of the grains on the board under these settings.
fn drawn(settings: &SimulationSettings, seed: u64) -> Result<Vec<Point2>, SimulationError> {
    let dirt = Dirt::draw(&WorkSurface::from_task(&board(1, &[]).task), settings, seed)?;
    let grains = dirt.grains().iter();
    Ok(grains.map(|grain| grain.position).collect())
}

fn places(dirt: &str, seed: u64) -> Vec<Point2> {
    drawn(&settings(dirt), seed).unwrap()
}

#[test]
fn real_dirt_is_not_where_it_is_believed_unless_asked_for() {
    for seed in 1..=3 {
        let believed: Vec<Point2> = board(seed, &[]).task.particles.remaining().collect();
        let apart = places("{ source = \"uniform\" }", seed);
        assert!(apart.iter().all(|place| !believed.contains(place)));
        assert_eq!(settings("{ source = \"uniform\" }").dirt, TrueDirt::Uniform);
        let loaded = board(seed, &[("execution.dirt", "{ source = \"as_believed\" }")]);
        let as_believed = loaded.simulation.clone();
        assert_eq!(drawn(&as_believed, seed).unwrap(), believed);
    }
}

#[test]
fn every_shipped_scenario_draws_its_dirt_apart() {
    let folder = wisch_testkit::root().join("scenarios");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        // The parts of a goal have dirt of their own.
        if GoalFile::read(&path, &LoadOptions::default())
            .unwrap()
            .is_some()
        {
            continue;
        }
        let loaded = load_task(&path, &LoadOptions::default()).unwrap();
        // A treated task has points of the whole surface instead of dirt.
        if loaded.task.action.treats() {
            continue;
        }
        let settings = loaded.simulation.clone();
        assert_eq!(settings.dirt, TrueDirt::Uniform, "{}", path.display());
        let about = GrainCount::About(loaded.task.particles.len());
        assert_eq!(settings.count, about, "{}", path.display());
        count += 1;
    }
    assert_eq!(count, 16);
}

#[test]
fn the_amount_of_dirt_is_about_as_believed_or_exactly_as_set() {
    let mut settings = settings("{ source = \"uniform\" }");
    let counts: Vec<f64> = (1..=200)
        .map(|seed| (drawn(&settings, seed).unwrap().len() as f64 / 80.0).ln())
        .collect();
    let mean = counts.iter().sum::<f64>() / 200.0;
    let deviation = (counts.iter().map(|c| (c - mean).powi(2)).sum::<f64>() / 200.0).sqrt();
    // Four standard errors of 200 draws.
    assert!(mean.abs() < 0.06, "{mean}");
    assert!((deviation - 0.2).abs() < 0.04, "{deviation}");
    settings.count = GrainCount::Exactly(33);
    assert_eq!(drawn(&settings, 1).unwrap().len(), 33);
    // With more grains than can be simulated, none are.
    settings.count = GrainCount::Exactly(401);
    assert_eq!(drawn(&settings, 1).unwrap(), []);
    assert_eq!(places("{ source = \"edge\", count = 12 }", 1).len(), 12);
}

#[test]
fn dirt_lies_where_its_source_puts_it() {
    let heap =
        "{ source = \"clusters\", clusters = [{ center_m = [0.1, 0.05], sigma_m = 0.005 }] }";
    for place in places(heap, 1) {
        assert!((place - Point2::new(0.1, 0.05)).norm() < 0.03, "{place}");
    }
    let stripe = "{ source = \"stripe\", center_m = [0, 0], direction_rad = 0.5, width_m = 0.02 }";
    let along = Vector2::new(0.5_f64.cos(), 0.5_f64.sin());
    let found = places(stripe, 1);
    assert!(found.iter().all(|p| along.perp(&p.coords).abs() <= 0.01));
    assert!(found.iter().any(|p| along.dot(&p.coords).abs() > 0.1));
    for place in places("{ source = \"edge\", within_m = 0.02 }", 1) {
        let inside = (0.20 - place.x.abs()).min(0.14 - place.y.abs());
        assert!((0.0..=0.02).contains(&inside), "{place}");
    }
    // Missing parameters are drawn at random, differently with another seed.
    for drawn in ["{ source = \"stripe\" }", "{ source = \"clusters\" }"] {
        assert_eq!(places(drawn, 1), places(drawn, 1));
        assert_ne!(places(drawn, 1), places(drawn, 2));
        assert!(places(drawn, 1).len() > 40);
    }
}

#[test]
fn clusters_that_are_drawn_are_clumped() {
    // Mean distance to the nearest other grain, over that of evenly drawn ones.
    let nearest = |places: &[Point2]| {
        let of = |p: &Point2| {
            let others = places.iter().filter(|q| *q != p).map(|q| (p - q).norm());
            others.fold(f64::INFINITY, f64::min)
        };
        places.iter().map(of).sum::<f64>() / places.len() as f64
    };
    let mean = |dirt: &str| {
        (1..=20)
            .map(|seed| nearest(&places(dirt, seed)))
            .sum::<f64>()
            / 20.0
    };
    let clumped = mean("{ source = \"clusters\", count = 80 }");
    let even = mean("{ source = \"uniform\", count = 80 }");
    assert!(clumped < 0.8 * even, "{clumped} m, {even} m");
}

#[test]
fn listed_dirt_is_read_beside_the_task() {
    let folder = std::env::temp_dir().join(format!("wisch-dirt-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("real.csv"), "x,y\n0.1,0.05\n-0.1,0\n").unwrap();
    let text = std::fs::read_to_string(scenario("chopping-board")).unwrap();
    let task = folder.join("task.toml");
    std::fs::write(&task, text).unwrap();
    let load = |file: &str| {
        let dirt = format!("{{ source = \"csv\", file = \"{file}\" }}");
        let options = LoadOptions {
            settings: vec![("execution.dirt".to_owned(), dirt)],
            ..LoadOptions::default()
        };
        load_task(Path::new(&task), &options)
    };
    let settings = load("real.csv").unwrap().simulation;
    let expected = vec![Point2::new(0.1, 0.05), Point2::new(-0.1, 0.0)];
    assert_eq!(drawn(&settings, 1).unwrap(), expected);
    let missing = load("unreal.csv").unwrap_err().to_string();
    assert!(missing.contains("unreal.csv"), "{missing}");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn dirt_beside_the_surface_is_refused() {
    let beside = "{ source = \"stripe\", center_m = [5, 5], direction_rad = 0, width_m = 0.01 }";
    let error = drawn(&settings(beside), 1).unwrap_err().to_string();
    assert!(
        error.starts_with("the simulated world's dirt cannot be placed: "),
        "{error}"
    );
}

#[test]
fn laws_and_sizes_are_the_worlds_own() {
    let own = [
        ("execution.mu", "-2"),
        ("execution.sigma", "0.5"),
        ("execution.grain_size_m", "[0.003, 0.004]"),
    ];
    let settings = board(1, &own).simulation;
    let site = WorkSurface::from_task(&board(1, &[]).task);
    let dirt = Dirt::draw(&site, &settings, 1).unwrap();
    let logs: Vec<f64> = dirt.grains().iter().map(|g| g.threshold.ln()).collect();
    let mean = logs.iter().sum::<f64>() / logs.len() as f64;
    assert!((mean + 2.0).abs() < 0.25, "{mean}");
    let sizes = dirt.grains().iter().map(|grain| 2.0 * grain.radius);
    assert!(sizes.into_iter().all(|d| (0.003..=0.004).contains(&d)));
}

#[test]
fn a_mismatch_is_laid_over_the_settings() {
    let settings = settings("{ source = \"uniform\" }");
    assert_eq!(settings.with_mismatch(&Mismatch::default()), settings);
    let mismatch = Mismatch {
        dirt: Some(TrueDirt::Edge(0.03)),
        count: Some(GrainCount::Exactly(5)),
        mu_shift: -0.5,
        sigma: Some(0.4),
        stiffness: 0.7,
        footprint: 0.9,
        grasp_offset: Vector2::new(0.01, 0.0),
        grasp_turn: 0.1,
        joint_friction: 0.2,
        ..Mismatch::default()
    };
    let world = settings.with_mismatch(&mismatch).with_mismatch(&mismatch);
    assert_eq!(
        (world.dirt, world.count),
        (TrueDirt::Edge(0.03), GrainCount::Exactly(5))
    );
    assert!((world.likelihood.mu - settings.likelihood.mu + 1.0).abs() < 1e-12);
    let tool = RealTool {
        stiffness: 0.7 * 0.7,
        footprint: 0.9 * 0.9,
        grasp_offset: Vector2::new(0.02, 0.0),
        grasp_turn: 0.2,
    };
    assert_eq!((world.tool, world.joint_friction), (tool, 0.4));
    let heap = Cluster {
        center: Point2::origin(),
        sigma: 0.01,
        weight: 1.0,
    };
    let heaped = Mismatch {
        dirt: Some(TrueDirt::Clusters(Some(vec![heap]))),
        ..Mismatch::default()
    };
    let found = drawn(&settings.with_mismatch(&heaped), 1).unwrap();
    assert!(found.iter().all(|place| place.coords.norm() < 0.06));
    // Random worlds have dirt of every kind.
    let random: Vec<_> = (1..=40).map(|seed| Mismatch::draw(seed).dirt).collect();
    for kind in [TrueDirt::Uniform, TrueDirt::Clusters(None)] {
        assert!(random.contains(&Some(kind)));
    }
}
