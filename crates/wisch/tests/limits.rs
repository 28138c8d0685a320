//! Large inputs: plans and beliefs near the limits, and errors beyond them.

use std::collections::BTreeSet;
use wisch::geometry::{Mesh, Point2, Point3, Polygon, Vector2, footprint};
use wisch::interpret::{Belief, ObservationUpdate};
use wisch::plan::{
    CoverageStrategy, MAX_NODES, MAX_TOUR_NODES, NodeRole, PlanConfig, PlanError, YawRule, plan,
};
use wisch::represent::{
    Action, GoalState, Observation, ParticleDistribution, SensorModel, Sight, Surface, Task,
    Treatment,
};
use wisch_testkit::{interaction, sponge, surface};

/// Ten particles in a row on a rectangle of this size [m].
fn task(action: Action, size: [f64; 2]) -> Task {
    let particles: Vec<Point2> = (0..10)
        .map(|i| Point2::new(size[0] * (f64::from(i) - 4.5) / 12.0, 0.0))
        .collect();
    Task {
        name: "large".into(),
        action,
        surface: surface(size),
        scene: vec![],
        tool: sponge(),
        medium: "breadcrumbs".into(),
        interaction: interaction(),
        particles: ParticleDistribution::new(&particles).unwrap(),
        collect_goal: None,
        treatment: None,
        mobility: Default::default(),
        tool_start: Point2::new(-size[0], -size[1]),
        seed: 1,
    }
}

fn config(strategy: CoverageStrategy) -> PlanConfig {
    PlanConfig {
        strategy: strategy.into(),
        seed: 1,
        yaw: YawRule::Blended,
        ..PlanConfig::default()
    }
}

#[test]
fn a_tour_of_more_nodes_than_a_matrix_holds_visits_each_once_and_is_short() {
    let task = task(Action::Absorb, [6.0, 5.0]);
    let found = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
    let nodes = found.graph.nodes.len();
    assert!(nodes > MAX_TOUR_NODES, "{nodes}");
    let visits: Vec<usize> = (found.strokes.iter())
        .flat_map(|stroke| &stroke.nodes)
        .copied()
        .collect();
    let visited: BTreeSet<usize> = visits.iter().copied().collect();
    assert_eq!(visited.len(), nodes);
    // Where a stroke ends because the tool was turned too far, the next goes on from the same node.
    assert!(visits.len() - nodes <= 2 * found.strokes.len());
    // No tour of square cells is shorter than a pitch for each.
    let shortest = found.collision_radius * (nodes - 1) as f64;
    let length = found.contact_distance();
    assert!(length < 1.1 * shortest, "{length} m for {shortest} m");
}

#[test]
fn a_goal_is_chosen_and_trees_are_made_of_thousands_of_nodes() {
    for action in [Action::Collect, Action::Skim] {
        let mut task = task(action, [4.0, 3.0]);
        task.surface.skim_edges = vec![0];
        let found = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
        let goals = found.graph.nodes.iter();
        let goals = goals.filter(|node| node.role == NodeRole::Goal).count();
        assert!(found.graph.nodes.len() > 2000);
        assert_eq!(found.graph.unreachable, [0_usize; 0]);
        assert_eq!(found.graph.edges.len(), found.graph.nodes.len() - goals);
    }
}

#[test]
fn a_random_tree_covers_a_large_surface() {
    let task = task(Action::Absorb, [5.0, 4.0]);
    let found = plan(&task, &config(CoverageStrategy::Rrt)).unwrap();
    let step = found.collision_radius;
    let is_covered = |place: Point2| {
        let mut nodes = found.graph.nodes.iter();
        nodes.any(|node| (node.position - place).norm() <= step * 1.1)
    };
    for i in 0..400 {
        let place = Point2::new(
            f64::from(i % 20) * 0.24 - 2.28,
            f64::from(i / 20) * 0.19 - 1.8,
        );
        assert!(is_covered(place), "{place}");
    }
}

#[test]
fn a_surface_too_large_for_its_tool_is_refused_with_numbers_and_advice() {
    for strategy in [CoverageStrategy::Grid, CoverageStrategy::Rrt] {
        let task = task(Action::Absorb, [100.0, 100.0]);
        let error = plan(&task, &config(strategy)).unwrap_err();
        let PlanError::TooManyNodes { count, .. } = &error else {
            panic!("{error}");
        };
        assert!(*count > MAX_NODES);
        let said = error.to_string();
        assert!(said.contains("exceed the limit of 100000"), "{said}");
        assert!(said.contains("take a wider tool"), "{said}");
    }
    // A plan by the density of dirt is not limited by the surface: there is little dirt.
    let task = task(Action::Absorb, [100.0, 100.0]);
    let found = plan(&task, &config(CoverageStrategy::Kde)).unwrap();
    assert!(found.graph.nodes.len() <= 10);
}

#[test]
fn lanes_over_a_hall_are_refused_before_they_are_laid() {
    let mut task = task(Action::Polish, [100.0, 100.0]);
    task.treatment = Some(Treatment::Polish {
        passes: 9,
        max_passes: 10,
        preston: None,
    });
    let at = |i: i32| {
        Point2::new(f64::from(i % 10), f64::from(i / 10)) * 11.0 - Vector2::new(49.5, 49.5)
    };
    let places: Vec<Point2> = (0..100).map(at).collect();
    task.particles = ParticleDistribution::new(&places).unwrap();
    let error = plan(&task, &config(CoverageStrategy::Grid));
    let lanes = PlanConfig {
        strategy: wisch::plan::Strategy::Lanes,
        ..PlanConfig::default()
    };
    assert!(error.is_err());
    let error = plan(&task, &lanes).unwrap_err();
    assert!(matches!(error, PlanError::TooManyNodes { .. }), "{error}");
}

#[test]
fn a_footprint_of_triangles_that_cross_everywhere_is_found() {
    // Flat triangles across a square, as an export gone wrong leaves them.
    let corner = |i: u32| {
        let angle = f64::from(i.wrapping_mul(2_654_435_761) % 100_000) * 1e-4;
        Point3::new(0.05 * angle.cos(), 0.05 * (angle * 1.7).sin(), 0.0)
    };
    let count = 4000;
    let vertices: Vec<Point3> = (0..3 * count).map(corner).collect();
    let triangles: Vec<[u32; 3]> = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Mesh::new(vertices.clone(), triangles).unwrap();
    let touched = footprint(&mesh, 0.005).unwrap();
    assert!(
        touched.area() > 0.005 && touched.area() < 0.01,
        "{}",
        touched.area()
    );
    for i in [0, 1000, 3999] {
        let [a, b, c] = [0, 1, 2].map(|k| vertices[3 * i + k].coords.xy());
        let middle = Point2::from((a + b + c) / 3.0);
        assert!(touched.contains(middle), "{middle}");
    }
}

#[test]
fn a_hundred_thousand_detections_are_believed() {
    let board = Surface {
        outline: Polygon::rectangle(Vector2::new(2.0, 1.0)),
        ..surface([2.0, 1.0])
    };
    let place = |i: u32| {
        let x = f64::from(i.wrapping_mul(2_654_435_761) % 1_999_993) * 1e-6 - 1.0;
        let y = f64::from(i.wrapping_mul(40_503_001) % 999_983) * 1e-6 - 0.5;
        Point2::new(x, y)
    };
    let count = wisch::represent::MAX_DETECTIONS;
    let detections: Vec<Point2> = (0..count as u32).map(place).collect();
    let member = ParticleDistribution::new(&detections[..20_000]).unwrap();
    let belief = Belief::from_members(vec![member; 64]).unwrap();
    let seen = belief.observe(&ObservationUpdate {
        observation: &Observation {
            detections,
            ..Observation::default()
        },
        sight: Sight {
            sensor: SensorModel::default(),
            detection: 0.98,
        },
        surface: &board,
        goal: &GoalState::Absorbed,
        seed: 1,
    });
    let all: usize = seen.members().iter().map(ParticleDistribution::len).sum();
    assert!(all <= 5_000_000, "{all} particles of all members");
    for member in seen.members() {
        let left = member.tally().remaining as f64;
        assert!((left / count as f64 - 1.0).abs() < 0.06, "{left}");
    }
}
