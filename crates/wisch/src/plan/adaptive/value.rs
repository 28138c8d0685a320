//! The value of a plan: the dirt that it brings where it belongs, less its costs.

use super::draft::Draft;
use crate::geometry::{Bounds2, Edge, PlanarPose, Point2, Region};
use crate::plan::edge_margin::EdgeMargin;
use crate::plan::score::DirtTerms;
use crate::plan::{FreeSpace, PlanScore};
use crate::random::normal_pair;
use crate::represent::{GoalState, ParticleDistribution, ParticleField, Task, ToolMotion};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Cost of the path that wipes the whole surface once, as a share of the dirt [1].
const WAY: f64 = 0.01;
/// Path in contact that costs as much as one lift of the tool [m], and as one metre of lifted path [1].
const LIFT: f64 = 0.02;
const LIFTED: f64 = 0.2;
/// Path in contact that costs as much as a radian of turning [m].
const TURN: f64 = 0.02;
/// Cost of dirt that is not where it belongs, per diagonal of the surface of distance [1]: a plan that brings
/// dirt nearer scores more.
const AWAY: f64 = 0.3;

/// Cost per metre by which a plan exceeds its longest distance, in shares of the dirt [1/m]: more than a stroke
/// brings.
const BEYOND: f64 = 3.0;

/// The value of a draft, and the dirt that it leaves.
#[derive(Debug, Clone)]
pub(super) struct Value {
    /// Value in shares of the dirt; more is better [1].
    pub(super) total: f64,
    /// Positions of dirt that is not where it belongs [m].
    pub(super) left: Vec<Point2>,
}

/// Weight of the tool at its exact size, beside a tool that is smaller by the margin [1].
const WHOLE_TOOL: f64 = 0.5;
/// Largest width by which the effective tool is narrower on each side, because heaps leak at its ends [m].
const LEAK: f64 = 0.012;
/// Radius of the goal that the search aims at, over the goal's radius [1].
const RIM: f64 = 0.75;
/// Stream of random numbers for the displacement of the tool in the hand.
const STREAM: u64 = 0x6772_6173_7000_0000;

/// A possible distribution of the dirt, and a possible displacement of the tool in the hand.
#[derive(Clone)]
pub(super) struct World {
    pub(super) dirt: ParticleDistribution,
    pub(super) field: ParticleField,
    /// Displacement of the tool in the hand, and its effective footprint.
    pub(super) grasp: PlanarPose,
    pub(super) footprint: Region,
    pub(super) heap: Option<u64>,
    /// Weight of this world among all [1].
    weight: f64,
}

/// The state of a world between two steps of a draft.
#[derive(Clone)]
pub(super) struct State {
    pub(super) field: ParticleField,
    pub(super) margin: Option<EdgeMargin>,
    /// Particles that the last motion touched: they may move once more when the tool lifts off.
    pub(super) touched: Vec<usize>,
}

/// The valuation of drafts for one task.
pub(in crate::plan) struct Valuation<'a> {
    task: &'a Task,
    radius: f64,
    worlds: Vec<World>,
    /// Edges over which dirt may go.
    allowed_edges: Vec<Edge>,
    diagonal: f64,
    /// Cost of a metre in contact [1/m].
    per_metre: f64,
    /// Longest distance of the tool in contact [m].
    max_distance: f64,
    /// Radius within which uncertain dirt is to end, over the goal's radius [1].
    rim: f64,
}

impl<'a> Valuation<'a> {
    /// Prepares the valuation for a task whose dirt has one or several possible distributions `dirt`.
    ///
    /// A single distribution is taken for certain, with a tool that is narrower by `margin` on each side [m].
    /// With several, each world displaces the tool by a random offset of this size, heaps have a depth, and
    /// contact begins late. Plans lose value for the distance by which they exceed `max_distance` [m].
    pub(in crate::plan) fn new(
        task: &'a Task,
        dirt: &[ParticleDistribution],
        space: &FreeSpace,
        margin: f64,
        max_distance: Option<f64>,
    ) -> Self {
        let surface = &task.surface;
        let bounds = Bounds2::from_points(surface.outline.outer().iter().copied());
        let broad = task.tool.area_of_effect.max();
        let allowed = surface.skim_edges.iter();
        let edges: Vec<Edge> = surface.outline.edges().collect();
        let is_certain = dirt.len() == 1;
        let worlds = dirt.iter().enumerate().map(|(number, particles)| {
            let mut random = ChaCha8Rng::seed_from_u64(task.seed);
            random.set_stream(STREAM ^ number as u64);
            let offset = normal_pair(&mut random) * if is_certain { 0.0 } else { margin };
            let narrower = if is_certain {
                margin
            } else {
                LEAK * random.random::<f64>()
            };
            World {
                field: ParticleField::new(particles),
                dirt: particles.clone(),
                grasp: PlanarPose::new(Point2::from(offset), 0.0),
                footprint: task.tool.footprint.shrink(narrower),
                heap: (!is_certain).then_some(number as u64),
                weight: 1.0 / dirt.len() as f64,
            }
        });
        Self {
            task,
            radius: space.radius(),
            worlds: worlds.collect(),
            allowed_edges: allowed
                .filter_map(|&edge| edges.get(edge).copied())
                .collect(),
            diagonal: bounds.map_or(1.0, |bounds| bounds.size().norm()),
            max_distance: max_distance.unwrap_or(f64::INFINITY),
            rim: 1.0,
            per_metre: WAY * broad / surface.outline.area().max(f64::MIN_POSITIVE),
        }
    }

    /// Returns the valuation for the search. With several worlds, dirt must end well within the goal, because
    /// dirt at the rim in these worlds may end outside it in another.
    pub(super) fn for_search(self) -> Self {
        Self { rim: RIM, ..self }
    }

    /// Returns the valuation that also counts the effect of the tool at its exact size, so that the search does
    /// not abandon dirt that only this tool reaches. `None` where the dirt is not certain.
    pub(super) fn for_refinement(&self) -> Option<Self> {
        let [world] = &self.worlds[..] else {
            return None;
        };
        let whole = World {
            footprint: self.task.tool.footprint.clone(),
            weight: WHOLE_TOOL,
            ..world.clone()
        };
        let smaller = World {
            weight: 1.0 - WHOLE_TOOL,
            ..world.clone()
        };
        Some(Self {
            worlds: vec![smaller, whole],
            allowed_edges: self.allowed_edges.clone(),
            ..*self
        })
    }

    /// Returns the value of a draft from the states `after` it.
    pub(super) fn value(&self, draft: &Draft, after: &[State]) -> Value {
        let mut left = Vec::new();
        let worlds = self.worlds.iter().zip(after);
        let gains = worlds
            .map(|(world, state)| world.weight * self.gain(world, state, &draft.goal, &mut left));
        let gain = gains.sum::<f64>();
        let beyond = (draft.distance() - self.max_distance).max(0.0);
        Value {
            // Mean gain over the worlds − cost of the path − cost of the excess length.
            total: gain - self.per_metre * self.cost(draft) - BEYOND * beyond,
            left,
        }
    }

    /// Cost of the path, lifts and turns of a draft, as an equivalent path in contact [m].
    fn cost(&self, draft: &Draft) -> f64 {
        let mut cost = 0.0;
        let mut tool = self.task.tool_start;
        for stroke in &draft.strokes {
            let (Some(first), Some(last)) = (stroke.first(), stroke.last()) else {
                continue;
            };
            // Path in contact + 0.02 m per lift + 0.2 of the lifted path + 0.02 m per radian.
            cost += LIFT + LIFTED * (first.position - tool).norm();
            tool = last.position;
            let motions = stroke.windows(2).map(|pair| ToolMotion {
                from: pair[0],
                to: pair[1],
            });
            cost += motions
                .map(|motion| motion.travel().1 + TURN * motion.turn().abs())
                .sum::<f64>();
        }
        cost
    }

    /// Returns the share of the dirt brought where it belongs in a world, less lost dirt and dirt at risk [1].
    /// Adds the positions of the remaining dirt to `left`.
    fn gain(&self, world: &World, state: &State, goal: &GoalState, left: &mut Vec<Point2>) -> f64 {
        self.terms(world, state, goal, left).total() / world.dirt.len().max(1) as f64
    }

    /// Returns the gains and losses of a draft in one world, in particles. Adds the positions of the remaining
    /// dirt to `left`.
    fn terms(
        &self,
        world: &World,
        state: &State,
        goal: &GoalState,
        left: &mut Vec<Point2>,
    ) -> DirtTerms {
        let surface = &self.task.surface;
        let after = state.field.distribution();
        let wanted = match *goal {
            GoalState::Collected { center, radius } if world.heap.is_some() => {
                GoalState::Collected {
                    center,
                    radius: self.rim * radius,
                }
            }
            goal => goal,
        };
        let mut away = 0.0;
        for (place, fate) in after.iter() {
            if fate.is_on_surface() && !wanted.is_met_by(place, fate, surface) {
                away += self.distance(&wanted, place);
                left.push(place);
            }
        }
        DirtTerms {
            away: AWAY * away / self.diagonal,
            ..DirtTerms::evaluate(&after, &wanted, surface, state.margin.as_ref())
        }
    }

    /// Returns the score of a draft from the states `after` it, term by term.
    pub(super) fn score(&self, draft: &Draft, after: &[State]) -> PlanScore {
        let mut score = PlanScore {
            total: self.value(draft, after).total,
            way: self.per_metre * self.cost(draft),
            too_long: BEYOND * (draft.distance() - self.max_distance).max(0.0),
            ..PlanScore::default()
        };
        for (world, state) in self.worlds.iter().zip(after) {
            let terms = self.terms(world, state, &draft.goal, &mut Vec::new());
            score.add(world.weight / world.dirt.len().max(1) as f64, &terms);
        }
        score
    }

    /// Distance of dirt from where it belongs [m].
    fn distance(&self, goal: &GoalState, place: Point2) -> f64 {
        match goal {
            GoalState::Absorbed | GoalState::Polished { .. } | GoalState::Dispensed { .. } => 0.0,
            GoalState::Collected { center, radius } => ((place - center).norm() - radius).max(0.0),
            GoalState::Skimmed => {
                let distances = self.allowed_edges.iter().map(|edge| edge.distance(place));
                distances.fold(self.diagonal, f64::min)
            }
        }
    }

    /// The worlds in which each draft is simulated.
    pub(super) fn worlds(&self) -> &[World] {
        &self.worlds
    }

    pub(super) fn task(&self) -> &Task {
        self.task
    }

    /// Radius of the collision sphere [m].
    pub(super) fn radius(&self) -> f64 {
        self.radius
    }

    /// The edges over which dirt may go.
    pub(super) fn allowed_edges(&self) -> &[Edge] {
        &self.allowed_edges
    }
}
