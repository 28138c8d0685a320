//! Properties of all plans: clearance, coverage, order, and predicted effect.

use proptest::prelude::*;
use wisch::geometry::{Mesh, Point2, Pose, Vector2, Vector3};
use wisch::plan::{
    CoverageStrategy, FreeSpace, KdeConfig, NodeRole, Plan, PlanConfig, PlanError, RrtConfig,
    YawRule, grid, kde, plan, predict, rrt,
};
use wisch::represent::{
    Action, Fate, GoalState, ParticleDistribution, Performance, SceneObject, ScenePart, Task,
};
use wisch_testkit::{interaction, sponge, surface};

const BOARD: [f64; 2] = [0.40, 0.28];

fn cuboid(size: [f64; 3], at: [f64; 3]) -> SceneObject {
    SceneObject {
        name: "block".into(),
        part: ScenePart::Obstacle,
        mesh: Mesh::cuboid(Vector3::from(size)).unwrap(),
        world_from_object: Pose::translation(at[0], at[1], at[2]),
    }
}

/// Particles on a fine lattice, so that every place of the surface has the same weight.
fn lattice([x, y]: [f64; 2], per_side: usize) -> Vec<Point2> {
    let at = |i: usize, length: f64| ((i as f64 + 0.5) / per_side as f64 - 0.5) * length;
    (0..per_side)
        .flat_map(|i| (0..per_side).map(move |j| Point2::new(at(i, x), at(j, y))))
        .collect()
}

fn task(action: Action, size: [f64; 2], scene: Vec<SceneObject>) -> Task {
    Task {
        name: "test".into(),
        action,
        surface: surface(size),
        scene,
        tool: sponge(),
        medium: "breadcrumbs".into(),
        interaction: interaction(),
        particles: ParticleDistribution::new(&lattice(size, 12)).unwrap(),
        collect_goal: Some(Point2::new(0.1, -0.05)),
        treatment: None,
        mobility: Default::default(),
        tool_start: Point2::new(0.0, -0.3),
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

fn space(task: &Task) -> FreeSpace {
    let meshes: Vec<Mesh> = task.obstacles_in_surface().collect();
    FreeSpace::new(&task.surface, &meshes, task.tool.collision_radius()).unwrap()
}

/// Distance from a point to a straight line between two others [m].
fn distance_to_segment(point: Point2, from: Point2, to: Point2) -> f64 {
    let (x, y) = (to.x - from.x, to.y - from.y);
    let squared = x * x + y * y;
    let along = (point.x - from.x) * x + (point.y - from.y) * y;
    let share = if squared > 0.0 {
        (along / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from.x + share * x - point.x).hypot(from.y + share * y - point.y)
}

/// The path of the tool centre point in contact: the segments of each stroke; a touch has one of
/// length 0.
fn legs(plan: &Plan) -> Vec<(Point2, Point2)> {
    let motions = plan.strokes.iter().flat_map(wisch::plan::Stroke::motions);
    motions
        .map(|motion| (motion.from.position, motion.to.position))
        .collect()
}

/// Share of points that are further than this from every segment and from every node on its path to
/// a goal.
fn share_beyond(points: &[Point2], plan: &Plan, radius: f64) -> f64 {
    let nodes = plan.graph.nodes.iter().enumerate();
    let nodes = nodes.filter(|(i, _)| !plan.graph.unreachable.contains(i));
    let places: Vec<Point2> = nodes.map(|(_, node)| node.position).collect();
    let legs = legs(plan);
    let beyond = points.iter().filter(|&&point| {
        let near_leg = (legs.iter()).any(|leg| distance_to_segment(point, leg.0, leg.1) <= radius);
        !near_leg && places.iter().all(|place| (place - point).norm() > radius)
    });
    beyond.count() as f64 / points.len() as f64
}

/// A block that stands on the surface, turned about the normal.
#[derive(Debug, Clone, Copy)]
struct Block {
    size: [f64; 3],
    at: [f64; 2],
    yaw: f64,
}

impl Block {
    fn object(self) -> SceneObject {
        SceneObject {
            name: "block".into(),
            part: ScenePart::Obstacle,
            mesh: Mesh::cuboid(Vector3::from(self.size)).unwrap(),
            world_from_object: Pose::new(
                Vector3::new(self.at[0], self.at[1], self.size[2] / 2.0),
                Vector3::z() * self.yaw,
            ),
        }
    }

    /// Distance from a point of the surface's plane, in closed form [m].
    fn clearance(self, point: Point2) -> f64 {
        let (sin, cos) = self.yaw.sin_cos();
        let (x, y) = (point.x - self.at[0], point.y - self.at[1]);
        let beyond = |along: f64, size: f64| (along.abs() - size / 2.0).max(0.0);
        let along_x = beyond(cos * x + sin * y, self.size[0]);
        along_x.hypot(beyond(cos * y - sin * x, self.size[1]))
    }
}

/// Returns all faults of a plan.
fn faults(task: &Task, plan: &Plan) -> Vec<String> {
    let space = space(task);
    let mut faults = Vec::new();
    for (i, node) in plan.graph.nodes.iter().enumerate() {
        let valid = match node.role {
            NodeRole::Coverage => space.is_free(node.position),
            NodeRole::Goal => space.is_clear(node.position),
        };
        if !valid {
            faults.push(format!("node {i} touches the scene"));
        }
    }
    for &(from, to) in &plan.graph.edges {
        if !space.is_clear_between(plan.graph.position(from), plan.graph.position(to)) {
            faults.push(format!("edge {from} → {to} touches the scene"));
        }
    }
    let mut wiped: Vec<(usize, usize)> = plan
        .strokes
        .iter()
        .flat_map(|stroke| stroke.nodes.windows(2).map(|pair| (pair[0], pair[1])))
        .collect();
    let mut edges = plan.graph.edges.clone();
    wiped.sort_unstable();
    edges.sort_unstable();
    if wiped != edges {
        faults.push("the strokes do not run through every edge once".into());
    }
    for (i, stroke) in plan.strokes.iter().enumerate() {
        for motion in stroke.motions() {
            let along = motion.to.position - motion.from.position;
            let heading = motion.from.heading;
            let ahead = along.x * heading.cos() + along.y * heading.sin();
            let symmetric = task.action == Action::Absorb;
            let across = if symmetric { ahead.abs() } else { ahead };
            if (across - along.norm()).abs() > 1e-9 {
                faults.push(format!(
                    "stroke {i} does not begin its edge across the motion"
                ));
            }
        }
    }
    faults
}

#[test]
fn the_grid_of_the_board_is_four_by_six() {
    let task = task(Action::Absorb, BOARD, vec![]);
    let nodes = grid(&space(&task));
    assert_eq!(nodes.len(), 24);
    let pitch = task.tool.collision_radius();
    assert!((nodes[1].x - nodes[0].x - pitch).abs() < 1e-12);
    let center: Vector2 = nodes.iter().map(|n| n.coords).sum::<Vector2>() / 24.0;
    assert!(center.norm() < 1e-12);
}

#[test]
fn the_sphere_keeps_its_radius_from_a_block() {
    // The block's face stands at x = 0.1.
    let task = task(
        Action::Absorb,
        BOARD,
        vec![cuboid([0.1, 0.1, 0.1], [0.15, 0.0, 0.05])],
    );
    let space = space(&task);
    let radius = task.tool.collision_radius();
    assert!((space.distance(Point2::new(0.0, 0.0)) - 0.1).abs() < 1e-4);
    assert!(space.is_clear(Point2::new(0.1 - radius - 1e-3, 0.0)));
    assert!(!space.is_clear(Point2::new(0.1 - radius + 1e-3, 0.0)));
    assert_eq!(
        space.distance(Point2::new(0.15, 0.0)),
        0.0,
        "inside the block"
    );
    let (left, right) = (Point2::new(0.15, -0.12), Point2::new(0.15, 0.12));
    assert!(space.is_clear(left) && space.is_clear(right));
    assert!(!space.is_clear_between(left, right), "through the block");
    assert!(space.is_clear_between(Point2::new(-0.1, -0.1), Point2::new(-0.1, 0.1)));
}

#[test]
fn a_shelf_overhead_and_a_table_underneath() {
    let radius = sponge().collision_radius();
    let shelf = |height: f64| {
        let task = task(
            Action::Absorb,
            BOARD,
            vec![cuboid([0.5, 0.5, 0.02], [0.0, 0.0, height + 0.01])],
        );
        space(&task)
    };
    assert!(shelf(radius + 0.01).is_clear(Point2::origin()));
    assert!(!shelf(radius - 0.01).is_clear(Point2::origin()));
    let table = task(
        Action::Absorb,
        BOARD,
        vec![cuboid([2.0, 2.0, 0.1], [0.0, 0.0, -0.07])],
    );
    assert!(space(&table).is_clear(Point2::origin()));
}

#[test]
fn every_strategy_keeps_clear_and_does_no_less_and_no_more_than_its_strokes_reach() {
    let scene = vec![cuboid([0.08, 0.08, 0.1], [0.1, 0.08, 0.05])];
    let points = lattice([0.6, 0.4], 12);
    for strategy in CoverageStrategy::ALL {
        for action in Action::WIPING {
            let task = task(action, [0.6, 0.4], scene.clone());
            let plan = plan(&task, &config(strategy)).unwrap();
            assert_eq!(
                faults(&task, &plan),
                Vec::<String>::new(),
                "{strategy} {action}"
            );
            let radius = task.tool.collision_radius();
            let beyond = share_beyond(&points, &plan, radius);
            assert!(plan.unreachable_share <= beyond, "{strategy} {action}");
            assert!(beyond < 0.1, "{strategy} {action}: {beyond}");
            let ratio = predict(&task, &plan, |_| ()).performance.ratio();
            assert!(
                ratio <= 1.0 - beyond + 1e-12,
                "{strategy} {action}: {ratio}, {beyond} out of reach"
            );
            // A sponge that absorbs reaches all particles within half its narrow side. Particles
            // that are pushed may be left where a stroke turns, and the strokes of the random tree
            // turn most.
            let floor = match (action, strategy) {
                (Action::Absorb, _) => 1.0 - share_beyond(&points, &plan, 0.035),
                (_, CoverageStrategy::Rrt) => 0.6,
                (_, CoverageStrategy::Grid | CoverageStrategy::Kde) => 0.8,
            };
            assert!(ratio >= floor, "{strategy} {action}: {ratio} below {floor}");
        }
    }
}

#[test]
fn rrt_nodes_grow_by_at_most_the_radius() {
    let task = task(Action::Absorb, [0.8, 0.5], vec![]);
    let space = space(&task);
    let nodes = rrt(&space, task.tool_start, &RrtConfig::default());
    for i in 1..nodes.len() {
        let nearest = nodes[..i]
            .iter()
            .map(|n| (n - nodes[i]).norm())
            .fold(f64::INFINITY, f64::min);
        assert!(nearest <= space.radius() + 1e-12);
    }
    // A node covers cells of pitch r_s / 2 within r_s / √2: no free place is further than that and
    // half a cell's diagonal.
    let furthest = space.radius() * (0.5f64.sqrt() + 0.125f64.sqrt());
    for cell in grid(&space) {
        let covered = nodes.iter().any(|n| (n - cell).norm() <= furthest);
        assert!(covered, "cell {cell} is not covered");
    }
}

#[test]
fn kde_puts_its_first_node_on_the_heap_and_keeps_clearance() {
    let task = task(Action::Absorb, BOARD, vec![]);
    let space = space(&task);
    let heap = Point2::new(-0.08, 0.03);
    let mut points = vec![heap; 30];
    points.push(Point2::new(0.15, -0.1));
    let nodes = kde(
        &space,
        &points,
        &KdeConfig {
            bandwidth: Some(0.03),
            reach: 0.035,
        },
    );
    assert_eq!(nodes.len(), 2);
    assert!((nodes[0] - heap).norm() < 0.003);
    assert!((nodes[1] - points[30]).norm() < 0.003);
}

#[test]
fn skim_goals_lie_beyond_the_skim_edge_only() {
    let task = task(Action::Skim, BOARD, vec![]);
    let plan = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
    let goals: Vec<Point2> = plan
        .graph
        .nodes
        .iter()
        .filter(|n| n.role == NodeRole::Goal)
        .map(|n| n.position)
        .collect();
    let radius = task.tool.collision_radius();
    assert!(goals.len() as f64 * radius >= BOARD[0]);
    for goal in goals {
        assert!((goal.y + BOARD[1] / 2.0 + radius).abs() < 1e-12);
    }
    let prediction = predict(&task, &plan, |_| ());
    for (_, fate) in prediction.particles.iter() {
        assert!(fate != Fate::Absorbed);
    }
    assert!(prediction.performance.ratio() > 0.85);
}

#[test]
fn a_goal_inside_an_obstacle_is_refused_with_its_place() {
    let mut task = task(
        Action::Collect,
        BOARD,
        vec![cuboid([0.05, 0.05, 0.1], [0.1, -0.05, 0.05])],
    );
    task.collect_goal = Some(Point2::new(0.1, -0.05));
    let error = plan(&task, &config(CoverageStrategy::Grid)).unwrap_err();
    assert!(matches!(error, PlanError::GoalNotFree { .. }));
    assert!(error.to_string().contains("(0.100, -0.050) m"), "{error}");
}

#[test]
fn a_goal_beside_the_surface_is_refused_without_a_distance_to_obstacles() {
    let obstacle = cuboid([0.05, 0.05, 0.1], [0.1, -0.05, 0.05]);
    for scene in [vec![], vec![obstacle]] {
        let mut task = task(Action::Collect, BOARD, scene);
        task.collect_goal = Some(Point2::new(1.0, 0.0));
        let error = plan(&task, &config(CoverageStrategy::Grid)).unwrap_err();
        assert!(matches!(error, PlanError::GoalOffSurface { .. }));
        let shown = error.to_string();
        assert!(
            shown.contains("(1.000, 0.000) m is off the surface"),
            "{shown}"
        );
    }
}

#[test]
fn a_goal_nobody_gave_is_chosen_by_its_effect() {
    let mut task = task(Action::Collect, BOARD, vec![]);
    task.collect_goal = None;
    let chosen = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
    let achieved = |plan: &Plan| predict(&task, plan, |_| ()).performance.achieved;
    let of_each = grid(&space(&task)).into_iter().map(|goal| {
        let mut given = task.clone();
        given.collect_goal = Some(goal);
        achieved(&plan(&given, &config(CoverageStrategy::Grid)).unwrap())
    });
    let of_each: Vec<usize> = of_each.collect();
    assert_eq!(Some(achieved(&chosen)), of_each.iter().copied().max());
    assert!(
        of_each.iter().any(|&one| one < achieved(&chosen)),
        "the goal makes no difference"
    );
}

#[test]
fn a_surface_too_crowded_for_the_tool_is_an_error() {
    let task = task(
        Action::Absorb,
        BOARD,
        vec![cuboid([0.3, 0.2, 0.1], [0.0, 0.0, 0.05])],
    );
    let error = plan(&task, &config(CoverageStrategy::Grid)).unwrap_err();
    assert!(matches!(error, PlanError::NoFreeNode { .. }), "{error}");
}

#[test]
fn a_bandwidth_far_beyond_the_surface_is_named_as_the_cause() {
    // Samples lie 1 m apart: the only one on the board is its first corner, and a block stands there.
    let block = cuboid([0.1, 0.1, 0.1], [-0.15, -0.09, 0.05]);
    let task = task(Action::Absorb, BOARD, vec![block]);
    let with = |bandwidth| PlanConfig {
        bandwidth: Some(bandwidth),
        ..config(CoverageStrategy::Kde)
    };
    assert!(plan(&task, &with(0.06)).is_ok());
    let error = plan(&task, &with(10.0)).unwrap_err();
    assert!(
        matches!(error, PlanError::BandwidthTooWide { .. }),
        "{error}"
    );
    assert!(
        error
            .to_string()
            .contains("plan.bandwidth_m = 10 has no sample"),
        "{error}"
    );
}

#[test]
fn what_stands_apart_is_not_joined_to_the_goal_but_within_reach() {
    // A wall across the surface: the far side has nodes but no edge to the goal.
    let task = task(
        Action::Collect,
        [0.8, 0.4],
        vec![cuboid([0.02, 0.5, 0.1], [-0.1, 0.0, 0.05])],
    );
    let plan = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
    assert!(!plan.graph.unreachable.is_empty());
    for &i in &plan.graph.unreachable {
        assert!(plan.graph.position(i).x < -0.1);
    }
    // The particles beyond the wall are missed, except for those near strokes on this side.
    let points = lattice([0.8, 0.4], 12);
    let beyond = share_beyond(&points, &plan, task.tool.collision_radius());
    assert!(beyond >= 4.0 / 12.0, "{beyond}");
    // No pose covers the particles inside the wall, and all others are covered from their side of
    // it.
    assert_eq!(plan.unreachable_share, 1.0 / 12.0);
}

#[test]
fn a_plan_is_cut_off_where_its_way_ends() {
    for action in Action::WIPING {
        let task = task(action, [0.6, 0.4], vec![]);
        let whole = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
        let length = whole.contact_distance();
        for share in [0.0, 0.013, 0.37, 0.999] {
            let cut = whole.truncate(share * length);
            let kept = cut.contact_distance();
            assert!(
                (kept - share * length).abs() < 1e-9,
                "{action} {share}: {kept}"
            );
            assert_eq!(cut.strokes.is_empty(), share == 0.0);
            for (cut, whole) in cut.strokes.iter().zip(&whole.strokes) {
                assert_eq!(cut.nodes.len(), cut.poses.len());
                let same = cut.poses.len() - 1;
                assert_eq!(cut.poses[..same], whole.poses[..same]);
            }
            for stroke in &cut.strokes {
                for (&node, pose) in stroke.nodes.iter().zip(&stroke.poses) {
                    assert_eq!(cut.graph.position(node), pose.position);
                }
            }
        }
        assert_eq!(whole.truncate(length + 1e-9), whole);
        let short = PlanConfig {
            max_distance: Some(0.5 * length),
            ..config(CoverageStrategy::Grid)
        };
        let short = plan(&task, &short).unwrap();
        assert!((short.contact_distance() - 0.5 * length).abs() < 1e-9);
    }
}

#[test]
fn no_pose_of_the_tool_covers_the_corner_between_two_walls() {
    // Walls along two borders: the sphere stays r_s away from both, and its corner r_s √2 from theirs.
    let walls = vec![
        cuboid([0.02, 0.6, 0.1], [-0.29, 0.0, 0.05]),
        cuboid([0.6, 0.02, 0.1], [0.0, -0.19, 0.05]),
    ];
    let task = task(Action::Absorb, [0.6, 0.4], walls);
    let space = space(&task);
    let radius = task.tool.collision_radius();
    // Along the diagonal of the corner (−0.28, −0.18), whose next free place is `radius` away from both walls.
    let gap = radius * (std::f64::consts::SQRT_2 - 1.0);
    let at = |distance: f64| {
        let along = distance * std::f64::consts::FRAC_1_SQRT_2;
        Point2::new(-0.28 + along, -0.18 + along)
    };
    for (distance, expected) in [(gap - 1e-3, 1.0), (gap + 1e-3, 0.0)] {
        let share =
            space.unreachable_share(&[at(distance)], &task.tool.footprint, &Vector2::zeros());
        assert_eq!(share, expected, "{distance} m from the corner");
    }
    assert_eq!(
        space.unreachable_share(&[], &task.tool.footprint, &Vector2::zeros()),
        0.0
    );
    // One place can be reached, and three are inside the wall.
    let places = [at(2.0 * gap), at(-0.02), at(-0.015), at(-0.02)];
    let share = space.unreachable_share(&places, &task.tool.footprint, &Vector2::zeros());
    assert_eq!(share, 0.75);
}

#[test]
fn performance_counts_what_the_goal_wants() {
    let surface = surface(BOARD);
    let points = [
        Point2::origin(),
        Point2::new(0.05, 0.0),
        Point2::new(0.1, 0.0),
    ];
    let particles = ParticleDistribution::new(&points).unwrap();
    let goal = GoalState::Collected {
        center: Point2::origin(),
        radius: 0.06,
    };
    let collected = Performance::evaluate(&particles, &goal, &surface);
    assert_eq!(
        (collected.achieved, collected.initial, collected.lost),
        (2, 3, 0)
    );
    assert_eq!(
        Performance::evaluate(&particles, &GoalState::Absorbed, &surface).ratio(),
        0.0
    );
}

#[test]
fn the_path_is_lifted_between_strokes() {
    let task = task(Action::Collect, BOARD, vec![]);
    let plan = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
    let path = plan.tcp_path();
    assert_eq!(path[0].surface_from_tool.position, task.tool_start);
    let contact: f64 = path
        .windows(2)
        .filter(|leg| leg[0].height == 0.0 && leg[1].height == 0.0)
        .map(|leg| (leg[1].surface_from_tool.position - leg[0].surface_from_tool.position).norm())
        .sum();
    assert!((contact - plan.contact_distance()).abs() < 1e-12);
    let mut at = task.tool_start;
    let mut total = plan.contact_distance();
    for stroke in &plan.strokes {
        total += (stroke.poses[0].position - at).norm() + 2.0 * 0.05;
        at = stroke.poses[stroke.poses.len() - 1].position;
    }
    assert!((plan.total_distance() - total).abs() < 1e-9);
    let touches = path
        .windows(2)
        .filter(|leg| leg[0].height > 0.0 && leg[1].height == 0.0)
        .count();
    assert_eq!(touches, plan.strokes.len());
}

#[test]
fn the_fault_finder_finds_planted_faults() {
    let scene = vec![cuboid([0.08, 0.08, 0.1], [0.1, 0.08, 0.05])];
    let task = task(Action::Collect, [0.6, 0.4], scene);
    let sound = plan(&task, &config(CoverageStrategy::Grid)).unwrap();
    let mut inside = sound.clone();
    inside.graph.nodes[0].position = Point2::new(0.1, 0.08);
    assert!(!faults(&task, &inside).is_empty());
    let mut skipped = sound.clone();
    skipped.strokes.pop();
    assert!(!faults(&task, &skipped).is_empty());
    let mut turned = sound;
    turned.strokes[0].poses[0].heading += 0.5;
    assert!(!faults(&task, &turned).is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// With any objects on the surface, no stroke touches one and no particle is forgotten.
    #[test]
    fn plans_keep_clear_of_random_scenes(
        blocks in prop::collection::vec(((0.03..0.15f64, 0.03..0.15f64), (-0.4..0.4f64, -0.25..0.25f64), 0.02..0.3f64, -3.0..3.0f64), 0..5),
        action in prop::sample::select(Action::WIPING.to_vec()),
        strategy in prop::sample::select(CoverageStrategy::ALL.to_vec()),
    ) {
        let blocks: Vec<Block> = blocks
            .into_iter()
            .map(|((x, y), at, height, yaw)| Block { size: [x, y, height], at: at.into(), yaw })
            .collect();
        let scene = blocks.iter().map(|block| block.object()).collect();
        let mut task = task(action, [0.8, 0.5], scene);
        task.collect_goal = None;
        match plan(&task, &config(strategy)) {
            Ok(plan) => {
                prop_assert_eq!(faults(&task, &plan), Vec::<String>::new());
                let after = predict(&task, &plan, |_| ()).particles.tally();
                prop_assert_eq!(after.initial, task.particles.len());
                prop_assert_eq!(after.initial, after.remaining + after.absorbed + after.off_surface);
                let none = if action == Action::Absorb { after.off_surface } else { after.absorbed };
                prop_assert_eq!(none, 0, "an effect that {} does not have", action);
                let points: Vec<Point2> = task.particles.remaining().collect();
                let radius = task.tool.collision_radius();
                let missed = share_beyond(&points, &plan, radius);
                prop_assert!(plan.unreachable_share <= missed, "{} {missed}", plan.unreachable_share);
                // Clearance is checked in steps, so that half a step between two clear places can
                // be missed.
                for (from, to) in legs(&plan) {
                    for i in 0..=50 {
                        let place = from + (to - from) * (f64::from(i) / 50.0);
                        for block in &blocks {
                            let clearance = block.clearance(place);
                            prop_assert!(clearance > radius - 0.6e-3, "{} of {} m at {}", clearance, radius, place);
                        }
                    }
                }
            }
            Err(PlanError::NoFreeNode { .. } | PlanError::NoSkimEdge { .. }) => {}
            Err(error) => prop_assert!(false, "{error}"),
        }
    }
}
