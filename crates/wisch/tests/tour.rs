//! Tours against brute force, published optima and the best lengths known from another solver.

use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wisch::geometry::Point2;
use wisch::plan::{
    CostMatrix, MAX_TOUR_NODES, TourConfig, TourError, shortest_path_from, shortest_tour,
};

/// TSPLIB's published optimal lengths under its rounded distance.
const BERLIN52_OPTIMUM: f64 = 7542.0;
const EIL51_OPTIMUM: f64 = 426.0;

/// Best closed tours known: `python peers/tours.py best` (LKH, ten runs per instance).
const UNIFORM200_BEST: f64 = 10.948_860;
const UNIFORM500_BEST: f64 = 16.241_360;
const UNIFORM1000_BEST: f64 = 23.031_828;
/// The same for an open path from the first point.
const UNIFORM200_OPEN_BEST: f64 = 10.824_554;

/// Slack for the six decimals the lengths above are given with.
const ROUNDED: f64 = 1e-6;

fn points(csv_text: &str) -> Vec<Point2> {
    csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(csv_text.as_bytes())
        .deserialize()
        .map(|row| {
            let (x, y): (f64, f64) = row.expect("two numbers a line");
            Point2::new(x, y)
        })
        .collect()
}

/// Costs as TSPLIB's EUC_2D defines them: distances rounded to whole numbers.
fn rounded_costs(csv_text: &str) -> CostMatrix {
    let points = points(csv_text);
    CostMatrix::from_fn(points.len(), |i, j| (points[i] - points[j]).norm().round())
        .expect("whole costs")
}

fn euclidean(csv_text: &str) -> CostMatrix {
    CostMatrix::euclidean(&points(csv_text)).expect("finite costs")
}

/// Uniform random costs, far from any triangle inequality.
fn unrelated_costs(node_count: usize, seed: u64) -> CostMatrix {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    CostMatrix::from_fn(node_count, |_, _| rng.random_range(-1.0..10.0)).expect("finite costs")
}

/// Tour from `start` that always continues with the cheapest unvisited node.
fn nearest_neighbours(costs: &CostMatrix, start: usize) -> Vec<usize> {
    let mut order = vec![start];
    while order.len() < costs.node_count() {
        let last = order[order.len() - 1];
        let left = (0..costs.node_count()).filter(|node| !order.contains(node));
        let next = left.min_by(|&a, &b| costs.cost(last, a).total_cmp(&costs.cost(last, b)));
        order.extend(next);
    }
    order
}

fn sorted(order: &[usize]) -> Vec<usize> {
    let mut order = order.to_vec();
    order.sort_unstable();
    order
}

/// The lowest cost over all orders of the nodes that begin at `start`.
fn brute_force(node_count: usize, start: usize, cost: &dyn Fn(&[usize]) -> f64) -> f64 {
    fn extend(order: &mut Vec<usize>, node_count: usize, cost: &dyn Fn(&[usize]) -> f64) -> f64 {
        if order.len() == node_count {
            return cost(order);
        }
        let mut best = f64::INFINITY;
        for node in 0..node_count {
            if !order.contains(&node) {
                order.push(node);
                best = best.min(extend(order, node_count, cost));
                order.pop();
            }
        }
        best
    }
    extend(&mut vec![start], node_count, cost)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn few_nodes_are_solved_optimally(node_count in 1..=8_usize, seed: u64, pick: usize) {
        let costs = unrelated_costs(node_count, seed);
        let config = TourConfig::default();
        let start = pick % node_count;

        let tour = shortest_tour(&costs, &config);
        prop_assert_eq!(sorted(&tour), (0..node_count).collect::<Vec<_>>());
        let best = brute_force(node_count, 0, &|order| costs.tour_cost(order));
        prop_assert!((costs.tour_cost(&tour) - best).abs() < 1e-9);

        let path = shortest_path_from(&costs, start, &config).unwrap();
        prop_assert_eq!(path[0], start);
        prop_assert_eq!(sorted(&path), (0..node_count).collect::<Vec<_>>());
        let best = brute_force(node_count, start, &|order| costs.path_cost(order));
        prop_assert!((costs.path_cost(&path) - best).abs() < 1e-9);
    }

    #[test]
    fn many_nodes_are_each_visited_once_and_cheaper_than_by_nearest_neighbours(
        node_count in 13..60_usize,
        seed: u64,
        pick: usize,
    ) {
        let costs = unrelated_costs(node_count, seed);
        let config = TourConfig { kicks_per_node: 5, seed };
        let start = pick % node_count;
        let everyone: Vec<usize> = (0..node_count).collect();

        let tour = shortest_tour(&costs, &config);
        prop_assert_eq!(tour[0], 0);
        prop_assert_eq!(sorted(&tour), everyone.clone());
        let naive = costs.tour_cost(&nearest_neighbours(&costs, 0));
        prop_assert!(costs.tour_cost(&tour) <= naive + 1e-9, "more than {naive}");

        let path = shortest_path_from(&costs, start, &config).unwrap();
        prop_assert_eq!(path[0], start);
        prop_assert_eq!(sorted(&path), everyone);
        let naive = costs.path_cost(&nearest_neighbours(&costs, start));
        prop_assert!(costs.path_cost(&path) <= naive + 1e-9, "more than {naive}");
    }
}

#[test]
fn published_optima_are_reached_and_not_beaten() {
    for (csv_text, optimum) in [
        (include_str!("data/berlin52.csv"), BERLIN52_OPTIMUM),
        (include_str!("data/eil51.csv"), EIL51_OPTIMUM),
    ] {
        let costs = rounded_costs(csv_text);
        for seed in 0..5 {
            let config = TourConfig {
                seed,
                ..TourConfig::default()
            };
            let length = costs.tour_cost(&shortest_tour(&costs, &config));
            assert!(
                (optimum..=1.01 * optimum).contains(&length),
                "{length} for an optimum of {optimum}, seed {seed}"
            );
        }
    }
}

#[test]
fn long_tours_are_within_two_percent_of_the_best_known() {
    for (csv_text, best) in [
        (include_str!("data/uniform200.csv"), UNIFORM200_BEST),
        (include_str!("data/uniform500.csv"), UNIFORM500_BEST),
        (include_str!("data/uniform1000.csv"), UNIFORM1000_BEST),
    ] {
        let costs = euclidean(csv_text);
        let length = costs.tour_cost(&shortest_tour(&costs, &TourConfig::default()));
        assert!(
            (best - ROUNDED..=1.02 * best).contains(&length),
            "{length} where {best} is known"
        );
    }
}

#[test]
fn long_open_paths_are_within_two_percent_of_the_best_known() {
    let costs = euclidean(include_str!("data/uniform200.csv"));
    for seed in 0..5 {
        let config = TourConfig {
            seed,
            ..TourConfig::default()
        };
        let length = costs.path_cost(&shortest_path_from(&costs, 0, &config).unwrap());
        assert!(
            (UNIFORM200_OPEN_BEST - ROUNDED..=1.02 * UNIFORM200_OPEN_BEST).contains(&length),
            "{length} where {UNIFORM200_OPEN_BEST} is known, seed {seed}"
        );
    }
}

/// The free end and the fixed start of an open path are an artificial node and edge above 12 nodes;
/// on a line the answer is known.
#[test]
fn an_open_path_along_a_line_goes_to_the_near_end_first() {
    let positions: Vec<f64> = (0..40).map(|i| f64::from(i * 7 % 40)).collect();
    let line: Vec<Point2> = positions.iter().map(|&x| Point2::new(x, 0.0)).collect();
    let costs = CostMatrix::euclidean(&line).unwrap();
    for (start, &x) in positions.iter().enumerate() {
        let path = shortest_path_from(&costs, start, &TourConfig::default()).unwrap();
        assert_eq!(path[0], start);
        let optimum = 39.0 + x.min(39.0 - x);
        assert!((costs.path_cost(&path) - optimum).abs() < 1e-9, "from {x}");
    }
}

/// Two rooms joined by one door: every other move between them is forbidden.
#[test]
fn forbidden_moves_are_avoided_where_they_can_be() {
    const FORBIDDEN: f64 = 1e6;
    let points = points(include_str!("data/uniform50.csv"));
    let room = |i: usize| i % 2;
    let door = (0, 1);
    let costs = CostMatrix::from_fn(points.len(), |i, j| {
        if room(i) == room(j) || (i, j) == door {
            (points[i] - points[j]).norm()
        } else {
            FORBIDDEN
        }
    })
    .unwrap();

    let path = shortest_path_from(&costs, 2, &TourConfig::default()).unwrap();
    assert!(costs.path_cost(&path) < FORBIDDEN);

    // A closed tour has to return, but the only door is used already.
    let tour = shortest_tour(&costs, &TourConfig::default());
    let forbidden_moves = (costs.tour_cost(&tour) / FORBIDDEN).floor();
    assert_eq!(forbidden_moves, 1.0);
}

#[test]
fn points_that_coincide_are_each_visited_once() {
    let costs = CostMatrix::euclidean(&[Point2::new(1.0, 2.0); 100]).unwrap();
    let config = TourConfig::default();
    let tour = shortest_tour(&costs, &config);
    assert_eq!(sorted(&tour), (0..100).collect::<Vec<_>>());
    let path = shortest_path_from(&costs, 7, &config).unwrap();
    assert_eq!(path[0], 7);
    assert_eq!(sorted(&path), (0..100).collect::<Vec<_>>());
}

#[test]
fn equal_seeds_give_equal_tours() {
    let costs = euclidean(include_str!("data/uniform200.csv"));
    let config = TourConfig {
        kicks_per_node: 2,
        ..TourConfig::default()
    };
    assert_eq!(
        shortest_tour(&costs, &config),
        shortest_tour(&costs, &config)
    );
    let other_seed = TourConfig {
        seed: 1,
        ..config.clone()
    };
    assert_ne!(
        shortest_tour(&costs, &config),
        shortest_tour(&costs, &other_seed)
    );
}

#[test]
fn no_nodes_make_an_empty_tour_but_no_path() {
    let nothing = CostMatrix::euclidean(&[]).unwrap();
    let config = TourConfig::default();
    assert!(shortest_tour(&nothing, &config).is_empty());
    let error = shortest_path_from(&nothing, 0, &config).unwrap_err();
    assert_eq!(
        error.to_string(),
        "start node 0 does not exist: there are 0 nodes"
    );
}

#[test]
fn bad_costs_are_named() {
    for cost in [f64::NAN, f64::INFINITY, -1e101] {
        let error =
            CostMatrix::from_fn(4, |i, j| if (i, j) == (1, 3) { cost } else { 1.0 }).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("cost between nodes 1 and 3 is {cost}; its magnitude must be at most 1e100")
        );
    }
}

#[test]
fn too_many_nodes_are_refused_before_any_cost_is_asked_for() {
    let error = CostMatrix::from_fn(MAX_TOUR_NODES + 1, |_, _| panic!("asked")).unwrap_err();
    assert_eq!(error, TourError::TooManyNodes { count: 5001 });
    assert_eq!(error.to_string(), "5001 nodes exceed the limit of 5000");
}
