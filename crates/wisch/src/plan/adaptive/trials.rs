//! Simulation of drafts in several worlds; the part that a draft shares with the last kept draft is simulated
//! only once.

use super::draft::Draft;
use super::value::{State, Valuation, Value, World};
use crate::geometry::PlanarPose;
use crate::plan::PlanScore;
use crate::plan::edge_margin::EdgeMargin;
use crate::plan::nominal_times::NominalTimes;
use crate::represent::{Effect, EffectModel, GoalState, Surface, Task, ToolMotion};
use std::rc::Rc;

/// Distance from the start of a stroke on which the force is still rising [m].
const LANDING: f64 = 0.005;
/// Depth of a heap of all particles, over the radius of the collision sphere [1]: between the
/// depths of the belief (up to 0.12) and [`HEAP_DEPTH`](crate::represent::HEAP_DEPTH).
const HEAP: f64 = 0.2;
/// Number of steps between kept states, more in long drafts; and the largest number of kept states.
const SPACING: usize = 4;
const MOST_STATES: usize = 256;

/// One step of the tool: a motion in contact, or a touch without motion.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Step {
    motion: Option<ToolMotion>,
    is_first: bool,
    /// Time from the previous contact to the contact of this step [s].
    before: f64,
    /// Whether the tool is lifted after the step.
    lifts: bool,
}

fn steps_of(draft: &Draft, task: &Task) -> Vec<Step> {
    let mut steps = Vec::new();
    let strokes = draft.strokes.iter().map(|stroke| &stroke[..]);
    let times = NominalTimes::of(task).before_strokes(task.tool_start, strokes);
    for (stroke, before) in draft.strokes.iter().zip(times) {
        let motions = stroke.len().saturating_sub(1);
        if motions == 0 {
            steps.push(Step {
                motion: None,
                is_first: true,
                before,
                lifts: true,
            });
        }
        steps.extend(stroke.windows(2).enumerate().map(|(i, pair)| Step {
            motion: Some(ToolMotion {
                from: pair[0],
                to: pair[1],
            }),
            is_first: i == 0,
            before: if i == 0 { before } else { 0.0 },
            lifts: i + 1 == motions,
        }));
    }
    steps
}

/// The steps of a draft, and for each world its state before some of the steps.
#[derive(Default)]
struct Rollout {
    steps: Vec<Step>,
    states: Vec<Vec<(usize, Rc<State>)>>,
}

/// Simulation of one draft after the other. Steps that a draft shares from its start with the draft kept last
/// are not simulated again.
pub(super) struct Trials<'a> {
    valuation: &'a Valuation<'a>,
    models: Vec<EffectModel>,
    kept: Rollout,
    tried: Rollout,
    /// Number of steps simulated so far, over all worlds.
    simulated: usize,
}

impl<'a> Trials<'a> {
    /// Prepares the simulation of drafts whose action is that of `goal`.
    pub(super) fn new(valuation: &'a Valuation<'a>, goal: &GoalState) -> Self {
        let effect = goal.action().effect();
        let models = valuation.worlds().iter().map(|world| {
            let model = valuation.task().effect_model(&world.footprint, effect);
            match world.heap {
                Some(seed) if effect == Effect::Push => {
                    model.with_heap(HEAP * valuation.radius(), seed)
                }
                _ => model,
            }
        });
        let surface = &valuation.task().surface;
        let begin = valuation.worlds().iter().map(|world| {
            let margin = (effect == Effect::Push)
                .then(|| EdgeMargin::new(&world.dirt, surface, goal, valuation.radius()));
            let state = State {
                field: world.field.clone(),
                margin,
                touched: Vec::new(),
            };
            vec![(0, Rc::new(state))]
        });
        Self {
            valuation,
            models: models.collect(),
            kept: Rollout {
                steps: Vec::new(),
                states: begin.collect(),
            },
            tried: Rollout::default(),
            simulated: 0,
        }
    }

    /// Number of steps simulated so far, over all worlds.
    pub(super) fn simulated(&self) -> usize {
        self.simulated
    }

    /// Returns the mean value of a draft over all worlds.
    pub(super) fn value(&mut self, draft: &Draft) -> Value {
        let after = self.simulate(draft);
        self.valuation.value(draft, &after)
    }

    /// Returns the score of a draft, term by term.
    pub(super) fn score(&mut self, draft: &Draft) -> PlanScore {
        let after = self.simulate(draft);
        self.valuation.score(draft, &after)
    }

    /// Returns the state of each world after a draft.
    fn simulate(&mut self, draft: &Draft) -> Vec<State> {
        let steps = steps_of(draft, self.valuation.task());
        let pairs = steps.iter().zip(&self.kept.steps);
        let common = pairs.take_while(|(one, other)| one == other).count();
        let mut states = Vec::with_capacity(self.models.len());
        let worlds = self.valuation.worlds().iter().zip(&mut self.models);
        let after = worlds
            .zip(&self.kept.states)
            .map(|((world, model), before)| {
                let shared = before.partition_point(|(at, _)| *at <= common);
                let mut known = before[..shared].to_vec();
                self.simulated += steps.len() - known.last().map_or(0, |(at, _)| *at);
                let state = roll_out(model, (self.valuation.task(), world), &steps, &mut known);
                states.push(known);
                state
            });
        let after: Vec<State> = after.collect();
        self.tried = Rollout { steps, states };
        after
    }

    /// Keeps the draft that was simulated last; the next drafts resemble it.
    pub(super) fn keep(&mut self) {
        std::mem::swap(&mut self.kept, &mut self.tried);
    }
}

/// Simulates the remaining steps in a world, from its last known state; adds states on the way to `states`.
fn roll_out(
    model: &mut EffectModel,
    (task, world): (&Task, &World),
    steps: &[Step],
    states: &mut Vec<(usize, Rc<State>)>,
) -> State {
    let surface = &task.surface;
    let times = NominalTimes::of(task);
    let (from, state) = states.last().expect("the state before all steps");
    let (from, mut state) = (*from, State::clone(state));
    model.resume_after(steps[..from].iter().filter(|step| step.lifts).count() as u32);
    let spacing = SPACING.max(steps.len().div_ceil(MOST_STATES));
    for (at, step) in steps.iter().enumerate().skip(from) {
        // During a stroke, a pushing tool may carry dirt, which a state does not contain.
        let is_whole = state.margin.is_none() || at == 0 || steps[at - 1].lifts;
        if at > from && at % spacing == 0 && is_whole {
            states.push((at, Rc::new(state.clone())));
        }
        model.wait(&mut state.field, surface, step.before);
        if let Some(mut motion) = step.motion {
            if world.heap.is_some() {
                motion = delay_contact(motion, step.is_first);
                motion.from = displace_in_hand(&motion.from, &world.grasp);
                motion.to = displace_in_hand(&motion.to, &world.grasp);
            }
            for (part, time) in times.parts(&motion) {
                apply(model, &mut state, surface, &part);
                model.wait(&mut state.field, surface, time);
            }
        }
        if step.lifts {
            model.lift_off(&mut state.field, surface);
        }
    }
    state
}

/// Applies a motion in contact to a state.
fn apply(model: &mut EffectModel, state: &mut State, surface: &Surface, motion: &ToolMotion) {
    match &mut state.margin {
        None => {
            model.apply(&mut state.field, surface, motion);
        }
        Some(margin) => {
            let displaced = state.touched.len();
            let touched = &mut state.touched;
            model.apply_where(&mut state.field, surface, motion, |particle, _| {
                touched.push(particle);
                true
            });
            margin.pass_of(&state.field, state.touched.iter().copied());
            state.touched.drain(..displaced);
        }
    }
}

/// Returns a motion whose contact begins [`LANDING`] late, if it is the first of a stroke.
fn delay_contact(motion: ToolMotion, is_first: bool) -> ToolMotion {
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

/// Returns the true tool pose for a commanded pose, with the tool displaced in the hand by `grasp`.
fn displace_in_hand(pose: &PlanarPose, grasp: &PlanarPose) -> PlanarPose {
    PlanarPose::new(pose.transform(grasp.position), pose.heading + grasp.heading)
}
