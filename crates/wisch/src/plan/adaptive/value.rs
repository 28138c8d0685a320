//! What a plan is worth: the dirt that it brings where it belongs, less what it costs.

use super::draft::Draft;
use crate::geometry::{Bounds2, Edge, PlanarPose, Point2, Region};
use crate::plan::objective::{EdgeMargin, RISK};
use crate::plan::predict::LOSS;
use crate::plan::{FreeSpace, PlanScore};
use crate::random::normal_pair;
use crate::represent::{
    GoalState, ParticleDistribution, ParticleField, Performance, Task, ToolMotion,
};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// What the way that wipes all of the surface once costs, as a share of the dirt [1].
const WAY: f64 = 0.01;
/// Way in contact that one lift of the tool is worth [m], and one metre of lifted way [1].
const LIFT: f64 = 0.02;
const LIFTED: f64 = 0.2;
/// Way in contact that a radian of turning is worth [m].
const TURN: f64 = 0.02;
/// What dirt counts less that is not yet where it belongs, for each diagonal of the surface that it is away [1]: to bring it
/// nearer is worth something too.
const AWAY: f64 = 0.3;

/// What a metre costs by which a plan is longer than it may be, in shares of the dirt [1/m]: more than a stroke brings.
const BEYOND: f64 = 3.0;

/// The worth of a plan, and what it leaves to be done.
#[derive(Debug, Clone)]
pub(super) struct Value {
    /// In shares of the dirt; more is better [1].
    pub(super) worth: f64,
    /// Where dirt is left that does not belong there [m].
    pub(super) left: Vec<Point2>,
}

/// What a plan gains and loses in one world, in particles.
struct Terms {
    in_place: f64,
    lost: f64,
    at_risk: f64,
    away: f64,
}

/// How much it counts what the tool does exactly as it is, beside what one does that is smaller by the margin [1].
const WHOLE_TOOL: f64 = 0.5;
/// By how much the tool is narrower to each side, at most, than what it carries needs: heaps leak at its ends [m].
const LEAK: f64 = 0.012;
/// Radius of the goal within which dirt is to end where strokes are searched for, over the goal's [1].
const RIM: f64 = 0.75;
/// Stream of random numbers for how the tool is held.
const STREAM: u64 = 0x6772_6173_7000_0000;

/// Dirt as it may lie, and the tool as it may be held.
#[derive(Clone)]
pub(super) struct World {
    pub(super) dirt: ParticleDistribution,
    pub(super) field: ParticleField,
    /// Of the tool in the hand, and its size over the believed one.
    pub(super) grasp: PlanarPose,
    pub(super) footprint: Region,
    pub(super) heap: Option<u64>,
    /// How much it counts among all [1].
    weight: f64,
}

/// A world amid a draft.
#[derive(Clone)]
pub(super) struct State {
    pub(super) field: ParticleField,
    pub(super) margin: Option<EdgeMargin>,
    /// Particles that the last motion touched: they may move once more when the tool lifts off.
    pub(super) touched: Vec<usize>,
}

/// Judges plans for one task.
pub(in crate::plan) struct Judge<'a> {
    task: &'a Task,
    radius: f64,
    worlds: Vec<World>,
    /// Edges over which dirt is to go.
    allowed_edges: Vec<Edge>,
    diagonal: f64,
    /// Cost of a metre in contact [1/m].
    per_metre: f64,
    /// How far the tool may go in contact [m].
    max_distance: f64,
    /// Radius within which dirt is to end that may lie elsewhere, over the goal's [1].
    rim: f64,
}

impl<'a> Judge<'a> {
    /// For a task with dirt that may lie like any of these. One alone is taken for certain, and the tool for one that
    /// reaches `margin` less far to each side [m]; with several, the tool is off by so much in each of them, heaps need
    /// room, and contact begins a little late. Plans lose worth for what they are longer than `max_distance` [m].
    pub(in crate::plan) fn new(
        task: &'a Task,
        dirt: &[ParticleDistribution],
        space: &FreeSpace,
        margin: f64,
        max_distance: Option<f64>,
    ) -> Self {
        let surface = &task.surface;
        let bounds = Bounds2::of(surface.outline.outer().iter().copied());
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
                footprint: task.tool.footprint.narrowed(narrower),
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

    /// The same where strokes are searched for: with several worlds dirt is to be brought well within the goal, as what ends
    /// at its rim for these may end beside it for another.
    pub(super) fn searching(self) -> Self {
        Self { rim: RIM, ..self }
    }

    /// The same where dirt that is certain counts in part for what the tool does to it exactly as it is, so that what lies within
    /// reach of no smaller one is not given up; `None` where dirt is not certain.
    pub(super) fn polishing(&self) -> Option<Self> {
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

    /// What a draft is worth that leaves its worlds so.
    pub(super) fn value(&self, draft: &Draft, after: &[State]) -> Value {
        let mut left = Vec::new();
        let worlds = self.worlds.iter().zip(after);
        let gains = worlds
            .map(|(world, state)| world.weight * self.gain(world, state, &draft.goal, &mut left));
        let gain = gains.sum::<f64>();
        let beyond = (draft.distance() - self.max_distance).max(0.0);
        Value {
            worth: gain - self.per_metre * self.cost(draft) - BEYOND * beyond,
            left,
        }
    }

    /// Way, lifts and turns of a draft, as a way in contact [m].
    fn cost(&self, draft: &Draft) -> f64 {
        let mut cost = 0.0;
        let mut tool = self.task.tool_start;
        for stroke in &draft.strokes {
            let (Some(first), Some(last)) = (stroke.first(), stroke.last()) else {
                continue;
            };
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

    /// The share of the dirt that is brought where it belongs in a world, less what is lost or at risk [1]; and where dirt is
    /// left.
    fn gain(&self, world: &World, state: &State, goal: &GoalState, left: &mut Vec<Point2>) -> f64 {
        let terms = self.terms(world, state, goal, left);
        let gain = terms.in_place - terms.lost - terms.at_risk - terms.away;
        gain / world.dirt.len().max(1) as f64
    }

    /// What a draft that leaves a world so gains and loses there, in particles; and where dirt is left.
    fn terms(
        &self,
        world: &World,
        state: &State,
        goal: &GoalState,
        left: &mut Vec<Point2>,
    ) -> Terms {
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
        let performance = Performance::of(&after, &wanted, surface);
        let mut away = 0.0;
        for (place, fate) in after.iter() {
            if fate.is_on_surface() && !wanted.is_met_by(place, fate, surface) {
                away += self.distance(&wanted, place);
                left.push(place);
            }
        }
        Terms {
            in_place: performance.achieved as f64,
            lost: LOSS as f64 * performance.lost as f64,
            at_risk: state.margin.as_ref().map_or(0.0, |margin| {
                RISK * margin.nearness() + margin.beyond(&wanted, &surface.outline)
            }),
            away: AWAY * away / self.diagonal,
        }
    }

    /// The score of a draft that leaves its worlds so, term by term.
    pub(super) fn score(&self, draft: &Draft, after: &[State]) -> PlanScore {
        let mut score = PlanScore {
            total: self.value(draft, after).worth,
            way: self.per_metre * self.cost(draft),
            too_long: BEYOND * (draft.distance() - self.max_distance).max(0.0),
            ..PlanScore::default()
        };
        for (world, state) in self.worlds.iter().zip(after) {
            let terms = self.terms(world, state, &draft.goal, &mut Vec::new());
            let weight = world.weight / world.dirt.len().max(1) as f64;
            score.in_place += weight * terms.in_place;
            score.lost += weight * terms.lost;
            score.at_risk += weight * terms.at_risk;
            score.away += weight * terms.away;
        }
        score
    }

    /// How far dirt is from where it belongs [m].
    fn distance(&self, goal: &GoalState, place: Point2) -> f64 {
        match goal {
            GoalState::Absorbed | GoalState::Polished { .. } | GoalState::Emitted { .. } => 0.0,
            GoalState::Collected { center, radius } => ((place - center).norm() - radius).max(0.0),
            GoalState::Skimmed => {
                let distances = self.allowed_edges.iter().map(|edge| edge.distance(place));
                distances.fold(self.diagonal, f64::min)
            }
        }
    }

    /// The worlds that a draft is tried in: each takes an evaluation.
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

    /// The edges over which dirt is to go.
    pub(super) fn allowed_edges(&self) -> &[Edge] {
        &self.allowed_edges
    }
}
