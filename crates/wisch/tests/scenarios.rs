//! The scenarios of §3.4 and of Fig. 13 as they are shipped: they resolve, nothing lies where things stand, and the
//! grid's path is as long as in the paper.

use std::path::{Path, PathBuf};
use wisch::geometry::Mesh;
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan, predict};
use wisch::represent::{Action, Intent, KnowledgeBase, OccupiedArea, Task, TaskFile};

/// Name, particles, and the distance in contact of Table 1 for grid and absorb [m].
const SCENARIOS: [(&str, usize, f64); 3] = [
    ("chopping-board", 80, 1.52),
    ("table", 80, 4.34),
    ("windshield", 160, 4.44),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A scenario of Table 1 with another action, the sponge and breadcrumbs.
fn task(name: &str, action: Action, seed: u64) -> Task {
    let (_, task) = resolved(name, seed, |_| Use {
        action,
        tool: "sponge".into(),
        medium: "breadcrumbs".into(),
    });
    task
}

/// What is done with what.
struct Use {
    action: Action,
    tool: String,
    medium: String,
}

/// As the file says.
fn as_written(file: &TaskFile) -> Use {
    match file.intent() {
        Intent::Action {
            action,
            tool,
            medium,
        } => Use {
            action: *action,
            tool: tool.clone(),
            medium: medium.clone(),
        },
        Intent::Goal { .. } => panic!("the scenarios name an action"),
    }
}

fn resolved(name: &str, seed: u64, used: impl Fn(&TaskFile) -> Use) -> (TaskFile, Task) {
    let names = [
        "tools.toml",
        "media.toml",
        "surfaces.toml",
        "interactions.toml",
    ];
    let text = |path: String| std::fs::read_to_string(root().join(path)).expect("it is shipped");
    let texts = names.map(|name| text(format!("knowledge/{name}")));
    let files: Vec<(&str, &str)> = names
        .into_iter()
        .zip(texts.iter().map(String::as_str))
        .collect();
    let knowledge = KnowledgeBase::from_toml(&files).expect("shipped knowledge is sound");
    let path = format!("scenarios/{name}.toml");
    let file = TaskFile::parse(&path, &text(path.clone()), &[]).unwrap_or_else(|e| panic!("{e}"));
    let read = |folder: &str| {
        let folder = root().join(folder);
        move |path: &str| std::fs::read(folder.join(path)).map_err(|error| error.to_string())
    };
    let (mut assets, mut meshes) = (read("scenarios"), read("knowledge"));
    let Use {
        action,
        tool,
        medium,
    } = used(&file);
    let task = file.resolve(
        action,
        &tool,
        &medium,
        seed,
        &knowledge,
        &mut assets,
        &mut meshes,
    );
    (file, task.unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn the_grids_path_is_within_15_percent_of_the_papers() {
    for (name, particles, paper) in SCENARIOS {
        let task = task(name, Action::Absorb, 1);
        assert_eq!(task.particles.len(), particles);
        let config = PlanConfig {
            strategy: CoverageStrategy::Grid,
            seed: 1,
            bandwidth: None,
            lift_height: 0.05,
        };
        let distance = plan(&task, &config)
            .expect("there is room")
            .contact_distance();
        assert!(
            (distance / paper - 1.0).abs() < 0.15,
            "{name}: {distance} m, paper {paper} m"
        );
    }
}

#[test]
fn every_action_can_be_planned_with_every_strategy() {
    for (name, ..) in SCENARIOS {
        for action in Action::ALL {
            let task = task(name, action, 1);
            assert!(action != Action::Collect || task.collect_goal.is_some());
            for strategy in CoverageStrategy::ALL {
                let config = PlanConfig {
                    strategy,
                    seed: 1,
                    bandwidth: None,
                    lift_height: 0.05,
                };
                let plan = plan(&task, &config);
                assert!(plan.is_ok(), "{name} {action} {strategy}: {plan:?}");
            }
        }
    }
}

#[test]
fn dirt_lies_on_the_surface_and_not_where_things_stand() {
    for (name, ..) in SCENARIOS {
        for seed in 1..=20 {
            let task = task(name, Action::Absorb, seed);
            let scene: Vec<Mesh> = task.obstacles_in_surface().collect();
            let occupied = OccupiedArea::of(&scene);
            for position in task.particles.remaining() {
                assert!(task.surface.outline.contains(position));
                assert!(!occupied.contains(position), "{name}: {position}");
            }
        }
    }
}

/// What is planned for a scenario as its file has it, and the performance predicted for that.
fn as_planned(name: &str) -> (TaskFile, Task, Plan, f64) {
    let (file, task) = resolved(name, 1, as_written);
    let config = PlanConfig {
        strategy: CoverageStrategy::Kde,
        seed: 1,
        bandwidth: file.bandwidth_m(),
        lift_height: file.lift_height_m(),
    };
    let plan = plan(&task, &config).expect("there is room");
    let performance = predict(&task, &plan, |_| ()).performance.ratio();
    (file, task, plan, performance)
}

#[test]
fn chippings_and_sand_are_swept_with_the_very_same_motion() {
    let (file, chippings, plan, performance) = as_planned("broom-chippings");
    let (_, sand, same, _) = as_planned("broom-sand");
    assert_eq!(
        (chippings.medium.as_str(), sand.medium.as_str()),
        ("glass_chippings", "sand")
    );
    assert_eq!(plan.strokes, same.strokes);
    assert!(performance >= file.target_performance(), "{performance}");
    // What differs is how likely the bristles take a grain along.
    let likelihood = |task: &Task| task.interaction.likelihood.probability(1.0);
    assert!(likelihood(&chippings) > 2.0 * likelihood(&sand));
    assert!(chippings.tool.is_half_turn_symmetric() && chippings.tool.second_grip.is_some());
}

#[test]
fn wiper_and_brush_clean_the_same_panel() {
    let (file, wiper, _, performance) = as_planned("solar-panel-wiper");
    assert!(performance >= file.target_performance(), "{performance}");
    let (file, brush, _, performance) = as_planned("solar-panel-brush");
    assert!(performance >= file.target_performance(), "{performance}");
    assert_eq!(
        (wiper.tool.name.as_str(), brush.tool.name.as_str()),
        ("window_wiper", "brush")
    );
    assert_eq!(wiper.surface.outline, brush.surface.outline);
    assert_eq!(
        wiper.surface.world_from_surface,
        brush.surface.world_from_surface
    );
    let likelihood = |task: &Task| task.interaction.likelihood.probability(1.0);
    assert!(likelihood(&wiper) > 2.0 * likelihood(&brush));
}
