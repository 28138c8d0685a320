//! Strokes of the adaptive strategy: better than those of the coverage strategies, equal on any
//! number of threads, and robust against dirt that lies a little elsewhere.

use rayon::ThreadPoolBuilder;
use wisch::geometry::{Mesh, Point2, Pose, Vector2, Vector3};
use wisch::plan::{
    Candidate, CoverageStrategy, FreeSpace, Plan, PlanConfig, PlanError, PlanScore, Planner,
    SearchConfig, Strategy, plan, predict,
};
use wisch::random::normal_pair;
use wisch::represent::{
    Action, Fate, GoalState, ParticleDistribution, Performance, SceneObject, ScenePart, Task,
};
use wisch_io::{LoadOptions, load_task};
use wisch_testkit::{TABLE_1, scenario};

use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

const FEW: SearchConfig = SearchConfig {
    evaluations: 6_000,
    margin_m: 0.003,
};

fn task(name: &str, action: Action, seed: u64) -> Task {
    let options = LoadOptions {
        action: Some(action),
        seed: Some(seed),
        ..LoadOptions::default()
    };
    load_task(&scenario(name), &options).unwrap().task
}

fn config(strategy: impl Into<Strategy>, search: SearchConfig) -> PlanConfig {
    PlanConfig {
        strategy: strategy.into(),
        seed: 1,
        search,
        ..PlanConfig::default()
    }
}

fn performance(task: &Task, plan: &Plan) -> f64 {
    predict(task, plan, |_| ()).performance.ratio()
}

/// Returns the faults of the positions of a plan.
fn faults(task: &Task, plan: &Plan) -> Vec<String> {
    let scene: Vec<Mesh> = task.obstacles_in_surface().collect();
    let space = FreeSpace::new(&task.surface, &scene, task.tool.collision_radius()).unwrap();
    let mut faults = Vec::new();
    for (i, stroke) in plan.strokes.iter().enumerate() {
        for (k, pose) in stroke.poses.iter().enumerate() {
            let is_end = k + 1 == stroke.poses.len();
            let may_be_beyond = is_end && task.action == Action::Skim;
            let is_on = task.surface.outline.contains(pose.position);
            if !space.is_clear(pose.position) || !is_on && !may_be_beyond {
                faults.push(format!("stroke {i} stands where it may not"));
            }
            if plan.graph.position(stroke.nodes[k]) != pose.position {
                faults.push(format!("stroke {i} is not at its node {k}"));
            }
        }
        for motion in stroke.motions() {
            if !space.is_clear_between(motion.from.position, motion.to.position) {
                faults.push(format!("stroke {i} drags the tool through the scene"));
            }
        }
    }
    faults
}

#[test]
#[ignore = "slow: many cases; `just slow`"]
fn in_every_cell_of_table_1_more_is_reached_than_by_any_coverage() {
    for action in Action::WIPING {
        for name in TABLE_1 {
            let task = task(name, action, 1);
            let searched = plan(&task, &config(Strategy::Adaptive, FEW)).unwrap();
            assert_eq!(searched.strategy, Strategy::Adaptive);
            assert_eq!(faults(&task, &searched), [""; 0], "{action} {name}");
            let found = performance(&task, &searched);
            for strategy in CoverageStrategy::ALL {
                let covering = plan(&task, &config(strategy, FEW)).unwrap();
                let theirs = performance(&task, &covering);
                assert!(
                    found >= theirs,
                    "{action} {name}: {found}, {strategy} {theirs}"
                );
            }
            let lost = predict(&task, &searched, |_| ()).performance.lost;
            assert_eq!(lost, 0, "{action} {name}");
        }
    }
}

#[test]
fn a_plan_that_may_not_be_long_does_the_most_on_its_way() {
    let task = task("table", Action::Collect, 3);
    let most = 1.5;
    let config = PlanConfig {
        max_distance: Some(most),
        ..config(Strategy::Adaptive, FEW)
    };
    let ratio = |plan: &Plan| predict(&task, plan, |_| ()).performance.ratio();
    let short = plan(&task, &config).unwrap();
    assert!(short.contact_distance() <= most + 1e-9);
    let whole = PlanConfig {
        max_distance: None,
        ..config
    };
    let whole = plan(&task, &whole).unwrap();
    let (short, cut) = (ratio(&short), ratio(&whole.truncate(most)));
    assert!(short > cut + 0.1, "{short} {cut}");
}

#[test]
fn strokes_for_some_of_very_much_dirt_serve_all_of_it() {
    let mut task = task("chopping-board", Action::Collect, 1);
    let half = Vector2::new(0.19, 0.13);
    let places: Vec<Point2> = (0..20_000)
        .map(|i| {
            let at = [755.0, 570.0].map(|steps| (f64::from(i) * steps / 1000.0).fract());
            Point2::new((2.0 * at[0] - 1.0) * half.x, (2.0 * at[1] - 1.0) * half.y)
        })
        .collect();
    task.particles = ParticleDistribution::new(&places).unwrap();
    let plan = plan(&task, &config(Strategy::Adaptive, FEW)).unwrap();
    let ratio = predict(&task, &plan, |_| ()).performance.ratio();
    assert!(ratio > 0.9, "{ratio}");
}

#[test]
fn the_same_plan_is_found_on_any_number_of_threads() {
    let task = task("chopping-board", Action::Collect, 2);
    let config = config(Strategy::Adaptive, FEW);
    let [one, two] = [1, 2].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| plan(&task, &config).unwrap())
    });
    assert_eq!(one, two);
    let other = PlanConfig { seed: 2, ..config };
    assert_ne!(one.strokes, plan(&task, &other).unwrap().strokes);
}

#[test]
fn the_search_finds_a_plan_with_a_higher_score_than_it_began_with() {
    let task = task("chopping-board", Action::Skim, 1);
    let score = |evaluations| {
        let search = SearchConfig { evaluations, ..FEW };
        let config = config(Strategy::Best, search);
        let candidates = Planner::new(&task, &config).plan_by_every_strategy();
        let candidates = candidates.unwrap();
        assert_eq!(candidates.len(), 4);
        let (strategy, searched) = candidates.last().unwrap();
        assert_eq!(*strategy, Strategy::Adaptive);
        searched.as_ref().unwrap().score.total
    };
    // One plan for each search: only the first plan is evaluated.
    let scores = [1, 6_000].map(score);
    assert!(scores[0] < scores[1], "{scores:?}");
}

#[test]
fn the_score_of_a_plan_is_what_it_does_less_what_it_costs() {
    // Plans of all strategies, also of those that turn and push dirt along.
    let task = task("chopping-board", Action::Collect, 1);
    let config = config(Strategy::Best, FEW);
    let found = Planner::new(&task, &config)
        .plan_by_every_strategy()
        .unwrap();
    for (strategy, candidate) in found {
        let candidate = candidate.unwrap();
        let score = candidate.score;
        let performance = predict(&task, &candidate.plan, |_| ()).performance;
        let share = |count: usize| count as f64 / performance.initial as f64;
        let most = share(performance.achieved);
        assert!(score.total <= most, "{strategy} {score:?} {most}");
        let PlanScore {
            in_place,
            lost,
            at_risk,
            away,
            way,
            too_long,
            time,
            total,
        } = score;
        let terms = in_place - lost - at_risk - away - way - too_long - time;
        assert!((terms - total).abs() < 1e-12, "{strategy} {score:?}");
        assert!(
            in_place > 0.0 && way > 0.0 && too_long == 0.0 && time == 0.0,
            "{score:?}"
        );
        assert_eq!(score.with_motion(100.0).total, total - 0.03);
        // The score counts a slightly smaller tool, and the costs of the path.
        let least = most - 3.0 * share(performance.lost) - 0.25;
        assert!(score.total >= least, "{strategy} {score:?} {least}");
    }
}

#[test]
fn the_best_of_all_has_the_highest_score() {
    let task = task("chopping-board", Action::Collect, 1);
    for evaluations in [4, 6_000] {
        let search = SearchConfig { evaluations, ..FEW };
        let config = config(Strategy::Best, search);
        let candidates = Planner::new(&task, &config)
            .plan_by_every_strategy()
            .unwrap();
        let candidates: Vec<Candidate> = (candidates.into_iter())
            .map(|(_, one)| one.unwrap())
            .collect();
        let best = plan(&task, &config).unwrap();
        let most = (candidates.iter().map(|one| one.score.total)).fold(f64::NEG_INFINITY, f64::max);
        let chosen = candidates.iter().find(|one| one.plan == best).unwrap();
        assert_eq!(chosen.score.total, most);
        assert_ne!(best.strategy, Strategy::Best);
    }
}

/// The dirt, each grain a little elsewhere.
fn moved(dirt: &ParticleDistribution, task: &Task, seed: u64) -> ParticleDistribution {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let moved = dirt.remaining().map(|place| {
        let there = place + normal_pair(&mut random) * 0.006;
        if task.surface.outline.contains(there) {
            there
        } else {
            place
        }
    });
    ParticleDistribution::new(&moved.collect::<Vec<_>>()).unwrap()
}

#[test]
#[ignore = "slow: many cases; `just slow`"]
fn a_plan_for_all_that_may_be_fails_less_on_what_comes() {
    let task = task("chopping-board", Action::Collect, 3);
    let search = SearchConfig {
        evaluations: 24_000,
        ..FEW
    };
    let config = config(Strategy::Adaptive, search);
    let possible: Vec<_> = (0..6)
        .map(|seed| moved(&task.particles, &task, seed))
        .collect();
    let planner = Planner::new(&task, &config);
    let for_any = planner.with_possible_dirt(&possible).plan().unwrap();
    let for_one = planner.with_possible_dirt(&possible[..1]).plan().unwrap();
    assert_eq!(faults(&task, &for_any), [""; 0]);
    // Dirt at new positions, and a slightly smaller goal area, because heaps need space.
    let mean = |plan: &Plan| {
        let GoalState::Collected { center, radius } = plan.graph.goal else {
            panic!("dirt is collected");
        };
        let goal = GoalState::Collected {
            center,
            radius: 0.8 * radius,
        };
        let shares = (100..120).map(|seed| {
            let there = Task {
                particles: moved(&task.particles, &task, seed),
                ..task.clone()
            };
            let after = predict(&there, plan, |_| ()).particles;
            Performance::evaluate(&after, &goal, &task.surface).ratio()
        });
        shares.sum::<f64>() / 20.0
    };
    let (any, one) = (mean(&for_any), mean(&for_one));
    assert!(
        1.0 - any < 0.5 * (1.0 - one) && any > 0.95,
        "{any}, for one {one}"
    );
}

#[test]
fn a_goal_that_is_left_open_is_chosen() {
    let mut open = task("chopping-board", Action::Collect, 1);
    open.collect_goal = None;
    let searched = plan(&open, &config(Strategy::Adaptive, FEW)).unwrap();
    let GoalState::Collected { center, .. } = searched.graph.goal else {
        panic!("dirt is collected");
    };
    assert!(open.surface.outline.contains(center));
    assert!(performance(&open, &searched) > 0.95);
    assert_eq!(faults(&open, &searched), [""; 0]);
}

#[test]
fn without_dirt_nothing_is_done_and_without_room_nothing_can_be() {
    let mut clean = task("chopping-board", Action::Collect, 1);
    clean.particles = ParticleDistribution::default();
    let nothing = plan(&clean, &config(Strategy::Adaptive, FEW)).unwrap();
    assert!(nothing.strokes.is_empty(), "{:?}", nothing.strokes);

    let mut full = task("chopping-board", Action::Absorb, 1);
    full.scene.push(SceneObject {
        name: "crate".into(),
        part: ScenePart::Obstacle,
        mesh: Mesh::cuboid(Vector3::new(1.0, 1.0, 0.5)).unwrap(),
        world_from_object: full.surface.world_from_surface * Pose::translation(0.0, 0.0, 0.2),
    });
    for strategy in [Strategy::Adaptive, Strategy::Best] {
        let error = plan(&full, &config(strategy, FEW)).unwrap_err();
        assert!(matches!(error, PlanError::NoFreeNode { .. }), "{error}");
    }
}

#[test]
fn pushed_dirt_stays_away_from_edges_over_which_it_must_not_go() {
    let mut heap = task("chopping-board", Action::Collect, 1);
    let near = |i: u32| {
        Point2::new(
            -0.1 + 0.002 * f64::from(i % 10),
            -0.06 - 0.002 * f64::from(i / 10),
        )
    };
    heap.particles = ParticleDistribution::new(&(0..50).map(near).collect::<Vec<_>>()).unwrap();
    let searched = plan(&heap, &config(Strategy::Adaptive, FEW)).unwrap();
    let after = predict(&heap, &searched, |_| ()).particles;
    assert!(after.iter().all(|(_, fate)| fate == Fate::OnSurface));
    let broad = Vector2::new(0.07, 0.11).norm() / 2.0;
    let is_kept = |place: Point2| {
        heap.surface
            .outline
            .edges()
            .all(|edge| edge.distance(place) > 0.1 * broad)
    };
    assert!(after.remaining().all(is_kept));
}
