//! The scenarios of §3.4 as they are shipped: they resolve, nothing lies where things stand, and the
//! grid's path is as long as in the paper.

use std::path::{Path, PathBuf};
use wisch::geometry::Mesh;
use wisch::plan::{CoverageStrategy, PlanConfig, plan};
use wisch::represent::{Action, KnowledgeBase, OccupiedArea, Task, TaskFile};

/// Name, particles, and the distance in contact of Table 1 for grid and absorb [m].
const SCENARIOS: [(&str, usize, f64); 3] = [
    ("chopping-board", 80, 1.52),
    ("table", 80, 4.34),
    ("windshield", 160, 4.44),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn task(name: &str, action: Action, seed: u64) -> Task {
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
    file.resolve(
        action,
        "sponge",
        "breadcrumbs",
        seed,
        &knowledge,
        &mut assets,
        &mut meshes,
    )
    .unwrap_or_else(|error| panic!("{error}"))
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
