//! What a plan is worth: the dirt that it brings where it belongs, less what it costs.

use super::draft::Draft;
use crate::geometry::{Bounds2, Edge, PlanarPose, Point2, Region};
use crate::plan::FreeSpace;
use crate::plan::objective::{EdgeMargin, LOSS, RISK};
use crate::random::normal_pair;
use crate::represent::{
    Effect, EffectModel, GoalState, ParticleDistribution, ParticleField, Performance, Task,
    ToolMotion,
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

/// How far the force has not yet risen when a stroke begins [m].
const LANDING: f64 = 0.005;
/// Depth of a heap of all particles, over the radius of the collision sphere: between what the belief draws and
/// [`HEAP_DEPTH`](crate::represent::HEAP_DEPTH) [1].
const HEAP: f64 = 0.2;
/// By how much the tool is narrower to each side, at most, than what it carries needs: heaps leak at its ends [m].
const LEAK: f64 = 0.012;
/// Radius of the goal within which dirt is to end where strokes are searched for, over the goal's [1].
const RIM: f64 = 0.75;
/// Stream of random numbers for how the tool is held.
const STREAM: u64 = 0x6772_6173_7000_0000;

/// Dirt as it may lie, and the tool as it may be held.
struct World {
    dirt: ParticleDistribution,
    field: ParticleField,
    /// Of the tool in the hand, and its size over the believed one.
    grasp: PlanarPose,
    footprint: Region,
    heap: Option<u64>,
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

    /// What a draft is worth on average.
    pub(super) fn value(&self, draft: &Draft) -> Value {
        let mut left = Vec::new();
        let worths = self
            .worlds
            .iter()
            .map(|world| self.gain(world, draft, &mut left));
        let gain = worths.sum::<f64>() / self.worlds.len() as f64;
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

    /// The share of the dirt that a draft brings where it belongs in a world, less what it loses or risks [1]; and where dirt
    /// is left.
    fn gain(&self, world: &World, draft: &Draft, left: &mut Vec<Point2>) -> f64 {
        let goal = &draft.goal;
        let surface = &self.task.surface;
        let mut field = world.field.clone();
        let mut model = EffectModel::new(&world.footprint, goal.action().effect());
        if let Some(seed) = world.heap
            && goal.action().effect() == Effect::Push
        {
            model = model.with_heap(HEAP * self.radius, seed);
        }
        let is_pushing = goal.action().effect() == Effect::Push;
        let mut margin =
            is_pushing.then(|| EdgeMargin::new(&world.dirt, surface, goal, self.radius));
        for stroke in &draft.strokes {
            for (i, pair) in stroke.windows(2).enumerate() {
                let mut motion = ToolMotion {
                    from: pair[0],
                    to: pair[1],
                };
                if world.heap.is_some() {
                    motion = late(motion, i == 0);
                    motion.from = held(&motion.from, &world.grasp);
                    motion.to = held(&motion.to, &world.grasp);
                }
                model.apply(&mut field, surface, &motion);
                if let Some(margin) = &mut margin {
                    margin.pass(&field);
                }
            }
            model.lift_off(&mut field, surface);
        }
        let after = field.distribution();
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
        let risk = margin.map_or(0.0, |margin| {
            RISK * margin.nearness() + margin.beyond(&wanted, &surface.outline)
        });
        let gain = performance.achieved as f64
            - LOSS as f64 * performance.lost as f64
            - risk
            - AWAY * away / self.diagonal;
        gain / world.dirt.len().max(1) as f64
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

    /// How many worlds there are: each takes an evaluation.
    pub(super) fn worlds(&self) -> usize {
        self.worlds.len()
    }

    /// The edges over which dirt is to go.
    pub(super) fn allowed_edges(&self) -> &[Edge] {
        &self.allowed_edges
    }
}

/// A motion whose contact begins a little late, if it is a stroke's first.
fn late(motion: ToolMotion, is_first: bool) -> ToolMotion {
    let (along, length) = motion.travel();
    if !is_first || length <= LANDING {
        return motion;
    }
    let share = LANDING / length;
    let heading = motion.from.heading + motion.turn() * share;
    ToolMotion {
        from: PlanarPose::new(motion.from.position + along * LANDING, heading),
        ..motion
    }
}

/// A tool's pose if it sits so in the hand.
fn held(pose: &PlanarPose, grasp: &PlanarPose) -> PlanarPose {
    PlanarPose::new(pose.transform(grasp.position), pose.heading + grasp.heading)
}
