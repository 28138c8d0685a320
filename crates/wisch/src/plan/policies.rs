//! The policies of the actions: from nodes to a graph, and from the graph to strokes; paper §3.2.

use super::coverage::CoverageInput;
use super::lanes::lanes;
use super::objective::best_by_objective;
use super::tree::{branches, forest};
use super::yaw::YawPattern;
use super::{
    CostMatrix, CoverageStrategy, FreeSpace, MAX_TOUR_NODES, Node, NodeRole, Plan, PlanConfig,
    PlanError, SemanticDirectedGraph, Stroke, TourConfig, TourError, YawRule, predict,
    shortest_path_from,
};
use crate::geometry::{Bounds2, Edge, Point2};
use crate::represent::{Action, GoalState, ParticleDistribution, Task};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Largest number of particles with which headings are chosen.
const CHOSEN_BY: usize = 2000;

/// Number of nodes in a tile of a tour that is made of tiles.
const TILE_NODES: usize = 500;
/// Random kicks per node of a tile.
const TILE_KICKS: usize = 5;

/// Largest product of the number of nodes and the number of tried goals, where the planner chooses
/// the goal itself; computing time is proportional to it. And the number of goals that are always
/// tried.
const TRIED_GOAL_NODES: usize = 250_000;
const FEWEST_GOALS: usize = 9;

/// Plans with the strokes of a coverage strategy and of the action's policy.
pub(super) fn plan_by_coverage(
    task: &Task,
    space: &FreeSpace,
    strategy: CoverageStrategy,
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    let radius = space.radius();
    let particles: Vec<Point2> = task.particles.remaining().collect();
    let input = CoverageInput {
        space,
        particles: &particles,
        tool_start: task.tool_start,
        tool_reach: task.tool.reach(),
        seed: config.seed,
        bandwidth: config.bandwidth,
    };
    let coverage = strategy.nodes(&input)?;
    if coverage.is_empty() && !particles.is_empty() {
        if let Some(bandwidth) = config.bandwidth
            && strategy.uses_bandwidth()
            && !CoverageStrategy::Grid.nodes(&input)?.is_empty()
        {
            return Err(PlanError::BandwidthTooWide {
                surface: task.surface.name.clone(),
                bandwidth,
                usual: radius,
            });
        }
        return Err(space.explain_no_free_node());
    }
    let mut plan = match task.action {
        Action::Absorb => absorb(task, config, space, coverage)?,
        Action::Collect => match task.collect_goal {
            Some(goal) => collect(task, config, space, coverage, goal)?,
            None => best_collect(task, config, space, &coverage)?,
        },
        Action::Skim => skim(task, config, space, coverage)?,
        Action::Polish | Action::Dispense => return lanes(task, space, config),
    };
    plan.strategy = strategy.into();
    Ok(plan)
}

/// Returns new strokes through some nodes of a plan, for example the nodes within a robot's reach.
/// To absorb, the strokes are an open tour from the node nearest to `from`, in the surface frame
/// [m]. For other actions, they are trees that lead to the goals among these nodes. A node without
/// a path to a goal is in no stroke.
///
/// # Errors
/// Geometry and costs that the libraries refuse.
pub(crate) fn rejoin_nodes(
    task: &Task,
    plan: &Plan,
    nodes: &[usize],
    from: Point2,
    seed: u64,
) -> Result<Vec<Stroke>, PlanError> {
    let scene: Vec<_> = task.obstacles_in_surface().collect();
    let space = FreeSpace::new(&task.surface, &scene, plan.collision_radius)?;
    let positions: Vec<Point2> = nodes
        .iter()
        .map(|&node| plan.graph.position(node))
        .collect();
    let absorbs = task.action == Action::Absorb;
    let chains = if absorbs {
        nearest_tour(&space, &positions, from, plan.lift_height, seed)?
    } else {
        let is_goal = |i: &usize| plan.graph.nodes[nodes[*i]].role == NodeRole::Goal;
        let goals: Vec<usize> = (0..nodes.len()).filter(is_goal).collect();
        let forest = forest(&space, &positions, &goals, 2.0 * plan.collision_radius);
        branches(&positions, &forest.parent, from)
    };
    let named = |chain: Vec<usize>| chain.into_iter().map(|i| nodes[i]).collect();
    let chains: Vec<Vec<usize>> = chains.into_iter().map(named).collect();
    // A robot that reaches only some nodes is less able to turn the tool on the spot.
    Ok(YawPattern::Blended.strokes(task, &plan.graph, &chains))
}

/// Returns chains of some nodes of a plan to absorb: an open tour of low cost, cut where the tool has to be
/// lifted. Numbers in a chain are indices into `nodes`.
///
/// `start`: index of the first node. `cost`: cost of moving the tool between two nodes in contact. `lift`: cost
/// of lifting and lowering it between them, for example the movement of joints.
///
/// # Errors
/// A cost that is not a number, more nodes than a tour may have, or geometry that the libraries refuse.
pub(crate) fn order_nodes(
    task: &Task,
    plan: &Plan,
    nodes: &[usize],
    start: usize,
    cost: impl Fn(usize, usize) -> f64,
    lift: f64,
    seed: u64,
) -> Result<Vec<Vec<usize>>, PlanError> {
    let scene: Vec<_> = task.obstacles_in_surface().collect();
    let space = FreeSpace::new(&task.surface, &scene, plan.collision_radius)?;
    let nodes: Vec<Point2> = (nodes.iter())
        .map(|&node| plan.graph.position(node))
        .collect();
    let config = TourConfig {
        seed,
        ..TourConfig::default()
    };
    tour(&space, &nodes, start, cost, lift, &config)
}

/// Absorb: an open tour from the node nearest the tool; paper §3.2.
fn absorb(
    task: &Task,
    config: &PlanConfig,
    space: &FreeSpace,
    nodes: Vec<Point2>,
) -> Result<Plan, PlanError> {
    let chains = nearest_tour(
        space,
        &nodes,
        task.tool_start,
        config.lift_height,
        config.seed,
    )?;
    let edges = chains
        .iter()
        .flat_map(|chain| chain.windows(2).map(|pair| (pair[0], pair[1])))
        .collect();
    let graph = SemanticDirectedGraph {
        nodes: coverage_nodes(nodes),
        edges,
        goal: GoalState::Absorbed,
        max_edge_length: None,
        unreachable: Vec::new(),
    };
    Ok(assemble(task, config, space, graph, chains))
}

/// Returns a short open tour of all nodes from the node nearest to a place, cut where the tool is lifted.
fn nearest_tour(
    space: &FreeSpace,
    nodes: &[Point2],
    from: Point2,
    lift_height: f64,
    seed: u64,
) -> Result<Vec<Vec<usize>>, PlanError> {
    let length = |i: usize, j: usize| (nodes[i] - nodes[j]).norm();
    if nodes.len() > MAX_TOUR_NODES {
        return tour_by_tiles(space, nodes, from, lift_height, seed);
    }
    let config = TourConfig {
        seed,
        ..TourConfig::default()
    };
    match nearest(nodes, from) {
        Some(start) => tour(space, nodes, start, length, 2.0 * lift_height, &config),
        None => Ok(Vec::new()),
    }
}

/// Returns a tour of more nodes than a single tour may have. Tiles of at most [`TILE_NODES`] nodes are visited
/// in columns to and fro. Each has a tour of its own from the node nearest to the end of the last tile (after
/// Karp, 1977). Time is proportional to the number of nodes.
fn tour_by_tiles(
    space: &FreeSpace,
    nodes: &[Point2],
    from: Point2,
    lift_height: f64,
    seed: u64,
) -> Result<Vec<Vec<usize>>, PlanError> {
    let mut at = from;
    let mut chains: Vec<Vec<usize>> = Vec::new();
    for tile in tiles(nodes, from) {
        let places: Vec<Point2> = tile.iter().map(|&node| nodes[node]).collect();
        let length = |i: usize, j: usize| (places[i] - places[j]).norm();
        let Some(start) = nearest(&places, at) else {
            continue;
        };
        let config = TourConfig {
            kicks_per_node: TILE_KICKS,
            seed,
        };
        for chain in tour(space, &places, start, length, 2.0 * lift_height, &config)? {
            let chain: Vec<usize> = chain.into_iter().map(|place| tile[place]).collect();
            let (Some(&first), Some(&last)) = (chain.first(), chain.last()) else {
                continue;
            };
            at = nodes[last];
            match chains.last_mut() {
                Some(before)
                    if (before.last())
                        .is_some_and(|&end| space.is_clear_between(nodes[end], nodes[first])) =>
                {
                    before.extend(chain);
                }
                _ => chains.push(chain),
            }
        }
    }
    Ok(chains)
}

/// Returns the node numbers in tiles of neighbours, in columns to and fro from the corner nearest to a place.
fn tiles(nodes: &[Point2], from: Point2) -> Vec<Vec<usize>> {
    let Some(bounds) = Bounds2::from_points(nodes.iter().copied()) else {
        return Vec::new();
    };
    let (size, center) = (bounds.size(), bounds.center());
    let count = nodes.len().div_ceil(TILE_NODES);
    let columns = (count as f64 * size.x / size.y.max(1e-9)).sqrt().round();
    let columns = (columns as usize).clamp(1, count);
    let per_column = nodes.len().div_ceil(columns);
    let [away_x, away_y] =
        [from.x <= center.x, from.y <= center.y].map(|is_low| if is_low { 1.0 } else { -1.0 });
    let by = |key: &dyn Fn(usize) -> f64, numbers: &mut [usize]| {
        numbers.sort_by(|&a, &b| key(a).total_cmp(&key(b)).then(a.cmp(&b)));
    };
    let mut numbers: Vec<usize> = (0..nodes.len()).collect();
    by(&|node| away_x * nodes[node].x, &mut numbers);
    let mut tiles = Vec::new();
    for (column, numbers) in numbers.chunks_mut(per_column).enumerate() {
        let up = if column % 2 == 0 { away_y } else { -away_y };
        by(&|node| up * nodes[node].y, numbers);
        let per_tile = numbers.len().div_ceil(numbers.len().div_ceil(TILE_NODES));
        tiles.extend(numbers.chunks(per_tile).map(<[usize]>::to_vec));
    }
    tiles
}

/// Returns an open tour of all nodes from one of them, cut where the tool is lifted.
///
/// A move that would drag the tool through an obstacle becomes a lifted move: it costs its length once more,
/// and the lift and the descent.
fn tour(
    space: &FreeSpace,
    nodes: &[Point2],
    start: usize,
    cost: impl Fn(usize, usize) -> f64,
    lift: f64,
    config: &TourConfig,
) -> Result<Vec<Vec<usize>>, PlanError> {
    if nodes.len() > MAX_TOUR_NODES {
        let count = nodes.len();
        return Err(TourError::TooManyNodes { count }.into());
    }
    let mut clear = vec![true; nodes.len() * nodes.len()];
    let costs = CostMatrix::from_fn(nodes.len(), |i, j| {
        let cost = cost(i, j);
        if space.is_clear_between(nodes[i], nodes[j]) {
            cost
        } else {
            clear[i * nodes.len() + j] = false;
            clear[j * nodes.len() + i] = false;
            2.0 * cost + lift
        }
    })?;
    let order = shortest_path_from(&costs, start, config)?;
    let chains = order.chunk_by(|&a, &b| clear[a * nodes.len() + b]);
    Ok(chains.map(<[usize]>::to_vec).collect())
}

/// Collect: a minimum spanning tree rooted at the goal node; paper §3.2.
fn collect(
    task: &Task,
    config: &PlanConfig,
    space: &FreeSpace,
    mut nodes: Vec<Point2>,
    goal: Point2,
) -> Result<Plan, PlanError> {
    let surface = task.surface.name.clone();
    if !task.surface.outline.contains(goal) {
        let (x, y) = (goal.x, goal.y);
        return Err(PlanError::GoalOffSurface { surface, x, y });
    }
    if !space.is_clear(goal) {
        return Err(PlanError::GoalNotFree {
            surface,
            x: goal.x,
            y: goal.y,
            distance: space.distance(goal),
            radius: space.radius(),
        });
    }
    nodes.retain(|node| (node - goal).norm() > 1e-9);
    let state = GoalState::Collected {
        center: goal,
        radius: space.radius(),
    };
    Ok(build_forest_plan(
        task,
        config,
        space,
        nodes,
        &[goal],
        state,
    ))
}

/// Collect without a given goal: the node with the best predicted performance, then the shortest path. Of many
/// nodes an evenly spread subset is tried, smaller for more nodes.
fn best_collect(
    task: &Task,
    config: &PlanConfig,
    space: &FreeSpace,
    nodes: &[Point2],
) -> Result<Plan, PlanError> {
    let mut best: Option<((usize, f64), Plan)> = None;
    let apart = nodes
        .len()
        .div_ceil((TRIED_GOAL_NODES / nodes.len().max(1)).max(FEWEST_GOALS));
    for &goal in nodes.iter().step_by(apart.max(1)) {
        let plan = collect(task, config, space, nodes.to_vec(), goal)?;
        let achieved = predict(task, &plan, |_| ()).performance.achieved;
        let distance = plan.contact_distance();
        let better = best
            .as_ref()
            .is_none_or(|((a, d), _)| achieved > *a || (achieved == *a && distance < *d));
        if better {
            best = Some(((achieved, distance), plan));
        }
    }
    best.map(|(_, plan)| plan)
        .ok_or_else(|| space.explain_no_free_node())
}

/// Skim: a forest of minimum spanning trees, one for each goal node beyond the edge; paper §3.2.
fn skim(
    task: &Task,
    config: &PlanConfig,
    space: &FreeSpace,
    nodes: Vec<Point2>,
) -> Result<Plan, PlanError> {
    let goals = skim_goals(space);
    if goals.is_empty() {
        return Err(PlanError::NoSkimEdge {
            surface: task.surface.name.clone(),
        });
    }
    Ok(build_forest_plan(
        task,
        config,
        space,
        nodes,
        &goals,
        GoalState::Skimmed,
    ))
}

/// Returns places beyond the skim edges, at a pitch of at most r_s, r_s outside the border.
///
/// The leading edge lies within r_s of the tool centre point. At that distance it has passed the border from
/// any direction.
fn skim_goals(space: &FreeSpace) -> Vec<Point2> {
    let radius = space.radius();
    let edges: Vec<Edge> = space.surface().outline.edges().collect();
    space
        .surface()
        .skim_edges
        .iter()
        .filter_map(|&index| edges.get(index))
        .flat_map(|edge| {
            let along = edge.end - edge.start;
            let outward = nalgebra::Vector2::new(along.y, -along.x).normalize();
            let count = (along.norm() / radius).ceil().max(1.0) as usize;
            (0..count).map(move |i| {
                edge.start + along * ((i as f64 + 0.5) / count as f64) + outward * radius
            })
        })
        .filter(|&goal| space.is_clear(goal))
        .collect()
}

/// Builds the trees that lead the nodes to the goals, and their branches as strokes.
fn build_forest_plan(
    task: &Task,
    config: &PlanConfig,
    space: &FreeSpace,
    nodes: Vec<Point2>,
    goals: &[Point2],
    state: GoalState,
) -> Plan {
    let coverage = nodes.len();
    let positions: Vec<Point2> = nodes.iter().chain(goals).copied().collect();
    let roots: Vec<usize> = (coverage..positions.len()).collect();
    let forest = forest(space, &positions, &roots, 2.0 * space.radius());
    let chains = branches(&positions, &forest.parent, task.tool_start);
    let mut graph_nodes = coverage_nodes(nodes);
    graph_nodes.extend(goals.iter().map(|&position| Node {
        position,
        role: NodeRole::Goal,
    }));
    let graph = SemanticDirectedGraph {
        nodes: graph_nodes,
        edges: forest
            .parent
            .iter()
            .enumerate()
            .filter_map(|(from, to)| to.map(|to| (from, to)))
            .collect(),
        goal: state,
        max_edge_length: Some(forest.edge_length),
        unreachable: forest.unreachable,
    };
    assemble(task, config, space, graph, chains)
}

fn assemble(
    task: &Task,
    config: &PlanConfig,
    space: &FreeSpace,
    graph: SemanticDirectedGraph,
    chains: Vec<Vec<usize>>,
) -> Plan {
    let plan = Plan {
        strategy: config.strategy,
        strokes: Vec::new(),
        graph,
        collision_radius: space.radius(),
        unreachable_share: 0.0,
        tool_start: task.tool_start,
        lift_height: config.lift_height,
    };
    choose_yaw(task, &plan, config.yaw, &chains)
}

/// Returns the plan with strokes through these chains of its nodes, with the headings of the best predicted
/// effect.
fn choose_yaw(task: &Task, plan: &Plan, rule: YawRule, chains: &[Vec<usize>]) -> Plan {
    let headed = rule.choices(task).into_iter().map(|headings| Plan {
        strokes: headings.strokes(task, &plan.graph, chains),
        ..plan.clone()
    });
    let few = sample_task(task, CHOSEN_BY);
    best_by_objective(&few, headed).expect("a rule has at least one heading")
}

/// Returns the task with its dirt, or with a random subset of `most` of its particles, each of which then stands for more
/// liquid.
pub(super) fn sample_task(task: &Task, most: usize) -> Task {
    let particles = sample_particles(&task.particles, most);
    let share = particles.len() as f64 / task.particles.len().max(1) as f64;
    Task {
        mobility: task.mobility.sample(share),
        particles,
        ..task.clone()
    }
}

/// Returns the dirt, or a random subset of `most` of its particles.
pub(super) fn sample_particles(dirt: &ParticleDistribution, most: usize) -> ParticleDistribution {
    if dirt.len() <= most {
        return dirt.clone();
    }
    let mut random = ChaCha8Rng::seed_from_u64(dirt.len() as u64);
    let mut numbers: Vec<usize> = (0..dirt.len()).collect();
    for i in 0..most {
        let other = random.random_range(i..numbers.len());
        numbers.swap(i, other);
    }
    dirt.chosen(&numbers[..most])
}

fn coverage_nodes(positions: Vec<Point2>) -> Vec<Node> {
    positions
        .into_iter()
        .map(|position| Node {
            position,
            role: NodeRole::Coverage,
        })
        .collect()
}

fn nearest(nodes: &[Point2], to: Point2) -> Option<usize> {
    (0..nodes.len()).min_by(|&a, &b| (nodes[a] - to).norm().total_cmp(&(nodes[b] - to).norm()))
}
