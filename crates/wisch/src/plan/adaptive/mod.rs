//! Search for strokes: random moves change whole plans, and the simulated effect decides which are kept.
//!
//! Simulated annealing (Kirkpatrick, Gelatt and Vecchi, 1983) over the poses of all strokes. A move shifts,
//! turns, adds, drops, joins or reorders strokes (`draft`); the effect model then simulates the plan's effect
//! on all of the dirt (`trials`, `value`). Poses are not bound to nodes of a coverage graph: plans of coverage
//! strategies only start the search.

mod draft;
mod trials;
mod value;
mod ways;

use super::{
    FreeSpace, Node, NodeRole, Plan, PlanConfig, PlanScore, SemanticDirectedGraph, Strategy, Stroke,
};
use crate::geometry::{PlanarPose, Point2};
use crate::represent::{GoalState, ParticleDistribution, Task, ToolMotion};
use draft::{Draft, Mutator};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use rayon::prelude::*;
use trials::Trials;
pub(super) use value::Valuation;
use value::Value;
use ways::KnownWays;

/// Number of independent searches, of which the best counts; it does not depend on the number of threads.
const SEARCHES: usize = 4;
/// Temperatures at the start and at the end: the loss of value accepted with probability 1/e, in shares of the
/// dirt [1].
const TEMPERATURES: [f64; 2] = [0.01, 2e-4];
/// Start temperature of a search that only repairs a plan [1], and the share of the evaluations
/// that it uses [1].
const REPAIR_TEMPERATURE: f64 = 1e-3;
const REPAIR: f64 = 0.3;
/// Share of the evaluations that also value the plan for the tool at its exact size, where the dirt is certain
/// [1]; and the start temperature of that phase [1].
const REFINEMENT: f64 = 0.4;
const REFINEMENT_TEMPERATURE: f64 = 3e-3;
/// Largest number of impossible moves per evaluated plan.
const MAX_REFUSED: usize = 8;
/// Above this number of strokes, a draft starts without strokes that touch no dirt.
const MANY_STROKES: usize = 200;
/// Largest mean number of simulated steps per evaluated plan: plans of thousands of strokes get fewer
/// evaluations.
const MAX_STEPS: usize = 1000;

/// Returns the best plan that the search finds from the plans `begun_with`, for all given
/// distributions of the dirt. The result does not depend on the number of threads. `mending`: the
/// places that a repaired plan must avoid, in the surface frame [m]; `None` for a full search.
pub(super) fn search(
    task: &Task,
    dirt: &[ParticleDistribution],
    space: &FreeSpace,
    begun_with: &[Plan],
    mending: Option<&[Point2]>,
    config: &PlanConfig,
) -> Option<Plan> {
    let search = &config.search;
    let avoid = mending.unwrap_or_default();
    let (hot, share) = match mending {
        Some(_) => (REPAIR_TEMPERATURE, REPAIR),
        None => (TEMPERATURES[0], 1.0),
    };
    let evaluations = (share * search.evaluations as f64) as usize;
    let valuation =
        Valuation::new(task, dirt, space, search.margin_m, config.max_distance).for_search();
    let mut starts: Vec<(Value, Draft)> = begun_with
        .iter()
        .map(|plan| drop_idle_strokes(Draft::of(plan).without(avoid), &valuation))
        .map(|draft| (Trials::new(&valuation, &draft.goal).value(&draft), draft))
        .collect();
    starts.sort_by(|a, b| b.0.total.total_cmp(&a.0.total));
    let pattern = begun_with.first()?;
    let polishing = valuation.for_refinement();
    let searches = (0..SEARCHES).into_par_iter().map(|number| {
        let (value, draft) = starts[number % starts.len().min(SEARCHES)].clone();
        let mut random = ChaCha8Rng::seed_from_u64(config.seed);
        random.set_stream(number as u64);
        let mut mutator = Mutator {
            task,
            space,
            allowed_edges: valuation.allowed_edges(),
            avoid,
            ways: KnownWays::new(space),
            footprint: task.tool.footprint.bounds()?,
            random,
        };
        let steps = |share: f64, valuation: &Valuation| {
            (share * evaluations as f64) as usize / (SEARCHES * valuation.worlds().len()).max(1)
        };
        let Some(polishing) = &polishing else {
            let steps = steps(1.0, &valuation);
            return Some(anneal(&valuation, &mut mutator, (value, draft), steps, hot));
        };
        let first = steps(1.0 - REFINEMENT, &valuation);
        let (_, draft) = anneal(&valuation, &mut mutator, (value, draft), first, hot);
        let value = Trials::new(polishing, &draft.goal).value(&draft);
        let (hot, last) = (
            hot.min(REFINEMENT_TEMPERATURE),
            steps(REFINEMENT, polishing),
        );
        let start = (value, draft);
        Some(anneal(polishing, &mut mutator, start, last, hot))
    });
    let found: Vec<Option<(Value, Draft)>> = searches.collect();
    let best = (found.into_iter().flatten()).reduce(|best, next| {
        if next.0.total > best.0.total {
            next
        } else {
            best
        }
    });
    best.map(|(_, draft)| assemble_plan(pattern, draft))
}

/// Removes from a draft of more than [`MANY_STROKES`] strokes those that touch no dirt in any
/// world: most strokes of a grid over a floor touch none.
fn drop_idle_strokes(mut draft: Draft, valuation: &Valuation<'_>) -> Draft {
    if draft.strokes.len() <= MANY_STROKES {
        return draft;
    }
    let task = valuation.task();
    let mut meets = vec![false; draft.strokes.len()];
    for world in valuation.worlds() {
        let mut model = task.effect_model(&task.tool.footprint, draft.goal.action().effect());
        let mut field = world.field.clone();
        for (poses, meets) in draft.strokes.iter().zip(&mut meets) {
            for pair in poses.windows(2) {
                let [from, to] = [pair[0], pair[1]];
                let motion = ToolMotion { from, to };
                model.apply_where(&mut field, &task.surface, &motion, |_, _| {
                    *meets = true;
                    true
                });
            }
        }
    }
    let mut meets = meets.into_iter();
    draft.strokes.retain(|_| meets.next().unwrap_or(true));
    draft
}

/// Returns the score of a plan, term by term.
pub(super) fn score(valuation: &Valuation<'_>, plan: &Plan) -> PlanScore {
    let draft = Draft::exactly(plan);
    Trials::new(valuation, &draft.goal).score(&draft)
}

/// Runs simulated annealing from a draft and returns the best draft found, with its value.
///
/// `budget`: number of evaluations. `hot`: temperature at the start [1].
fn anneal(
    valuation: &Valuation<'_>,
    mutator: &mut Mutator<'_>,
    start: (Value, Draft),
    budget: usize,
    hot: f64,
) -> (Value, Draft) {
    let mut now = start.clone();
    let mut best = start;
    let mut trials = Trials::new(valuation, &now.1.goal);
    trials.value(&now.1);
    trials.keep();
    let cold = TEMPERATURES[1];
    let (mut tried, mut refused) = (0, 0);
    let most_steps = MAX_STEPS * budget * valuation.worlds().len();
    while tried < budget && refused < MAX_REFUSED * budget && trials.simulated() < most_steps {
        let Some(draft) = mutator.neighbour(&now.1, &now.0.left) else {
            refused += 1;
            continue;
        };
        let passed = tried as f64 / budget as f64;
        // Geometric cooling: T = T_hot (T_cold / T_hot)^progress.
        let temperature = hot * libm::pow(cold / hot, passed);
        tried += 1;
        let value = trials.value(&draft);
        let gain = value.total - now.0.total;
        let chance: f64 = mutator.random.random();
        // Metropolis rule: a loss is accepted with probability exp(gain / T).
        if gain >= 0.0 || chance < libm::exp(gain / temperature) {
            trials.keep();
            now = (value, draft);
            if now.0.total > best.0.total {
                best = now.clone();
            }
        }
    }
    best
}

/// Returns the plan of a draft: each stroke has its own nodes, and final nodes where dirt belongs are goals.
fn assemble_plan(pattern: &Plan, draft: Draft) -> Plan {
    let Draft { strokes, goal } = draft;
    let is_goal =
        |stroke: &[PlanarPose], i: usize| goal != GoalState::Absorbed && i + 1 == stroke.len();
    let mut nodes = Vec::new();
    let mut numbers: Vec<Vec<usize>> = strokes.iter().map(|stroke| vec![0; stroke.len()]).collect();
    for role in [NodeRole::Coverage, NodeRole::Goal] {
        for (stroke, numbers) in strokes.iter().zip(&mut numbers) {
            for (i, pose) in stroke.iter().enumerate() {
                if is_goal(stroke, i) == (role == NodeRole::Goal) {
                    numbers[i] = nodes.len();
                    nodes.push(Node {
                        position: pose.position,
                        role,
                    });
                }
            }
        }
    }
    let edges = numbers
        .iter()
        .flat_map(|chain| chain.windows(2).map(|pair| (pair[0], pair[1])));
    let edges = edges.collect();
    Plan {
        strategy: Strategy::Adaptive,
        graph: SemanticDirectedGraph {
            nodes,
            edges,
            goal,
            max_edge_length: None,
            unreachable: Vec::new(),
        },
        strokes: (strokes.into_iter().zip(numbers))
            .map(|(poses, nodes)| Stroke { nodes, poses })
            .collect(),
        ..pattern.clone()
    }
}
