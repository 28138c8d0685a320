//! The whole loop: plan, predict, follow, execute, interpret, and again until the goal is met; paper §4.

use crate::execute::{
    Dirt, Ending, ExecuteConfig, ExecuteError, Executed, TelemetrySample, execute,
};
use crate::follow::{FollowConfig, FollowError, Followed, Workcell, WorkcellConfig, follow};
use crate::geometry::{PlanarPose, Point2, Pose, Vector3};
use crate::interpret::{
    Belief, EventKind, InterpretConfig, InterpretError, Interpretation, Interpreter, TouchSample,
};
use crate::plan::{
    CoverageStrategy, Plan, PlanConfig, PlanError, Prediction, best_plan, best_subplan,
    best_subplan_of_candidates, predict,
};
use crate::recover::{
    Circumstances, LEAST_PROGRESS, Pace, Verdict, believed_performance, decide, judge, next_task,
    unfinished,
};
use crate::represent::{
    GoalState, ParticleDistribution, ParticleError, Performance, Reality, Task,
};
use crate::robot::{CapabilityMap, RobotModel, Srdf};
use nalgebra::{Translation3, UnitQuaternion};
use std::ops::ControlFlow;

/// Plans that are tried for what is left over, at most and at least; there the density is that of a few
/// scattered grains, and the prediction tells best what becomes of them.
const RECOVERY_VARIANTS: [usize; 2] = [50, 3];
/// Predicting takes time by the edges of the tool's footprint: a brush of a thousand tufts tries few plans.
const RECOVERY_EDGES: usize = 2000;

/// Draws from the belief that plans of later rounds are made on, and where their seeds differ [bits].
const DRAWS: u64 = 8;
const DRAW_SHIFT: u32 = 32;
/// After so many strokes in a row that brought nothing, the next one is not expected to.
const STALLED_STROKES: usize = 4;

/// After a push, how far the lower end of the estimate may lie below the target for it to be claimed; half of what a
/// claim may be wrong by.
const DOUBT_TOLERATED: f64 = 0.05;

/// The robot that does it.
#[derive(Debug, Clone, Copy)]
pub struct Performer<'a> {
    /// Its description.
    pub robot: &'a RobotModel,
    /// Its groups, states and pairs that may touch.
    pub srdf: Option<&'a Srdf>,
    /// What it reaches.
    pub map: Option<&'a CapabilityMap>,
}

/// How each stage works, and when to stop.
#[derive(Debug, Clone)]
pub struct RunConfig {
    /// Of the plans.
    pub plan: PlanConfig,
    /// How many plans the prediction chooses from in the first round.
    pub variants: usize,
    /// Of robot and tool.
    pub workcell: WorkcellConfig,
    /// Of the motions.
    pub follow: FollowConfig,
    /// Of the executions; round and seed are set by the loop.
    pub execute: ExecuteConfig,
    /// Estimated performance at which the goal is met.
    pub target: f64,
    /// Most rounds.
    pub max_rounds: usize,
    /// How far a round goes.
    pub pace: Pace,
}

/// What the loop is at.
#[derive(Debug)]
pub enum News<'a> {
    /// A round, from 1, is being planned.
    Planning(usize),
    /// The plan is being followed; so many nodes are passed.
    Following {
        /// Nodes passed.
        passed: usize,
        /// Of so many.
        nodes: usize,
    },
    /// An execution begins.
    Executing(&'a Motion),
    /// One sample of it.
    Sample(&'a TelemetrySample<'a>),
    /// No execution: one of an earlier run takes its place.
    Recalling(&'a Motion),
    /// The log is being interpreted.
    Interpreting,
    /// A round is over.
    Over(&'a Round),
}

/// What is about to be executed.
#[derive(Debug, Clone)]
pub struct Motion {
    /// The round, from 1.
    pub number: usize,
    /// The task as it was believed.
    pub task: Task,
    /// Where the dirt was believed to lie.
    pub believed: Belief,
    /// The plan.
    pub plan: Plan,
    /// Robot, tool and scene.
    pub cell: Workcell,
    /// The joint motion.
    pub followed: Followed,
    /// What it is predicted to do.
    pub prediction: Prediction,
}

/// One round.
#[derive(Debug, Clone)]
pub struct Round {
    /// What was planned.
    pub motion: Motion,
    /// What was executed, with the truth that only reports and tests may look at.
    pub executed: Executed,
    /// What the robot makes of it.
    pub interpretation: Interpretation,
    /// What follows.
    pub verdict: Verdict,
    /// The true performance; `None` where no dirt was simulated.
    pub true_performance: Option<f64>,
}

/// A round that an earlier run executed before it was cut short: what was felt, and how it went.
#[derive(Debug, Clone, PartialEq)]
pub struct Past {
    /// All that the interpreter was given.
    pub touches: Vec<TouchSample>,
    /// What was executed.
    pub executed: Executed,
}

/// Why a run failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// No plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// No motion.
    #[error(transparent)]
    Follow(#[from] FollowError),
    /// No execution.
    #[error(transparent)]
    Execute(#[from] ExecuteError),
    /// No interpretation.
    #[error(transparent)]
    Interpret(#[from] InterpretError),
    /// Dirt at places that are none.
    #[error(transparent)]
    Particles(#[from] ParticleError),
}

/// Wipes until the estimated performance reaches the target, no progress is made, or the rounds are spent.
///
/// The robot knows of the world only what it measures. `first_plan` is used in the first round, if given.
/// `news` may stop an execution; the round is then interpreted as far as it went, and is the last.
///
/// # Errors
/// Those of the stages.
pub fn run(
    task: &Task,
    performer: &Performer<'_>,
    reality: &Reality,
    first_plan: Option<Plan>,
    config: &RunConfig,
    news: &mut dyn FnMut(News<'_>) -> ControlFlow<()>,
) -> Result<Vec<Round>, RunError> {
    resume(
        task,
        performer,
        reality,
        first_plan,
        Vec::new(),
        config,
        news,
    )
}

/// Like [`run`], but the first rounds are those of an earlier run of the same task, reality, plan and
/// configuration: they are planned and interpreted again, which gives the same, but not executed.
///
/// # Errors
/// Those of the stages.
pub fn resume(
    task: &Task,
    performer: &Performer<'_>,
    reality: &Reality,
    first_plan: Option<Plan>,
    past: Vec<Past>,
    config: &RunConfig,
    news: &mut dyn FnMut(News<'_>) -> ControlFlow<()>,
) -> Result<Vec<Round>, RunError> {
    let mut past = past.into_iter();
    let world_from_real = task.surface.world_from_surface * reality.believed_from_real;
    let mut rounds: Vec<Round> = Vec::new();
    let mut task = task.clone();
    let mut belief = Belief::certain(task.particles.clone());
    let mut dirt = real_dirt(&task, reality);
    let mut workcell = config.workcell.clone();
    let mut given = first_plan;
    let mut goal = None;
    let mut stalled = 0;
    for number in 1..=config.max_rounds {
        let _ = news(News::Planning(number));
        let plan = match (
            plan_round(&task, &belief, goal.as_ref(), given.take(), config),
            rounds.last_mut(),
        ) {
            (Ok(plan), Some(last)) if plan.strokes.is_empty() => {
                last.verdict = Verdict::NothingToGain;
                break;
            }
            (Err(_), Some(last)) => {
                last.verdict = Verdict::NoWay;
                break;
            }
            (plan, _) => plan?,
        };
        let goal = *goal.get_or_insert(plan.graph.goal);
        let motion = follow_round(
            number, &task, &belief, plan, performer, &workcell, config, news,
        );
        let motion = match (motion, rounds.last_mut()) {
            (Err(_), Some(last)) => {
                last.verdict = Verdict::NoWay;
                break;
            }
            (motion, _) => motion?,
        };

        let real = Reality {
            believed_from_real: task.surface.world_from_surface.inverse() * world_from_real,
            ..reality.clone()
        };
        let interpret_config = InterpretConfig::of(&task);
        let mut interpreter = Interpreter::new(&task, &interpret_config)?;
        let executed = match past.next() {
            Some(past) => recall(past, &motion, &mut interpreter, news)?,
            None => execute_round(&motion, &real, &dirt, config, &mut interpreter, news)?,
        };

        let _ = news(News::Interpreting);
        let interpretation = interpreter.conclude(&belief, &goal)?;
        let before = believed_performance(&belief, &goal, &task.surface);
        let is_last = executed.ending == Ending::Stopped;
        let next = next_task(&task, &goal, &interpretation, task.seed.wrapping_add(1))?;
        let doubted = drawn(&next, &interpretation.belief)?;
        let is_done = unfinished(&doubted, &goal)?.is_empty();
        let judged = judge(&interpretation, before, config.target);
        stalled = if judged == Verdict::NoProgress {
            stalled + 1
        } else {
            0
        };
        let circumstances = Circumstances {
            is_done,
            is_disturbed: was_disturbed(&executed, &interpretation),
            is_doubtful: was_pushed(&rounds) && is_doubtful(&interpretation, config),
            is_rising: interpretation.performance.mean >= before + LEAST_PROGRESS,
            // A single stroke says little: the next best one is another.
            is_patient: config.pace == Pace::Greedy && stalled < STALLED_STROKES,
        };
        let verdict = decide(judged, &circumstances);
        let round = Round {
            verdict,
            true_performance: true_performance(&executed.truth.dirt, &goal, &task)?,
            motion,
            interpretation,
            executed,
        };
        let _ = news(News::Over(&round));

        belief = round.interpretation.belief.clone();
        dirt = round.executed.truth.dirt.clone();
        task = next;
        workcell.world_from_robot = Some(standing(&round, config));
        rounds.push(round);
        if verdict != Verdict::Again || is_last {
            break;
        }
    }
    Ok(rounds)
}

/// The plan of a round: on what is not yet done.
fn plan_round(
    task: &Task,
    belief: &Belief,
    goal: Option<&GoalState>,
    given: Option<Plan>,
    config: &RunConfig,
) -> Result<Plan, RunError> {
    let whole = match (given, goal) {
        (Some(plan), _) => plan,
        (None, None) => best_plan(task, &task.particles, &config.plan, config.variants)?,
        (None, Some(goal)) => {
            let task = &drawn(task, belief)?;
            let open = unfinished(task, goal)?;
            let kde = PlanConfig {
                strategy: CoverageStrategy::Kde,
                seed: task.seed,
                ..config.plan.clone()
            };
            let count = recovery_variants(task);
            return Ok(match config.pace {
                Pace::Whole => best_plan(task, &open, &kde, count)?,
                Pace::Greedy => best_subplan_of_candidates(task, &open, &kde, count)?,
            });
        }
    };
    Ok(match config.pace {
        Pace::Whole => whole,
        Pace::Greedy => best_subplan(task, &whole)?,
    })
}

/// The task with all that the dirt may be like: several draws from the belief, one on top of the other.
///
/// A single draw has dirt where there is none and none where there is some; plans are to be good on average.
fn drawn(task: &Task, belief: &Belief) -> Result<Task, ParticleError> {
    let mut particles = Vec::new();
    for draw in 0..DRAWS {
        let seed = task.seed.wrapping_add(draw << DRAW_SHIFT);
        particles.extend(belief.sample(seed)?.iter());
    }
    Ok(Task {
        particles: ParticleDistribution::with_fates(&particles)?,
        ..task.clone()
    })
}

/// How many plans are tried for what is left over.
fn recovery_variants(task: &Task) -> usize {
    let [most, least] = RECOVERY_VARIANTS;
    let edges = task.tool.footprint.edges().count().max(1);
    (RECOVERY_EDGES / edges).clamp(least, most)
}

/// The joint motion of a round, and what it is predicted to do.
#[allow(clippy::too_many_arguments, reason = "what a round is made of")]
fn follow_round(
    number: usize,
    task: &Task,
    belief: &Belief,
    plan: Plan,
    performer: &Performer<'_>,
    workcell: &WorkcellConfig,
    config: &RunConfig,
    news: &mut dyn FnMut(News<'_>) -> ControlFlow<()>,
) -> Result<Motion, RunError> {
    let cell = Workcell::new(performer.robot.clone(), performer.srdf, task, workcell)?;
    let nodes = plan.strokes.iter().map(|stroke| stroke.nodes.len()).sum();
    let mut say = |passed| {
        let _ = news(News::Following { passed, nodes });
    };
    let followed = follow(task, &plan, &cell, performer.map, &config.follow, &mut say)?;
    let wiped = Plan {
        strokes: followed.strokes.clone(),
        ..plan.clone()
    };
    Ok(Motion {
        number,
        prediction: predict(task, &wiped, |_| ()),
        task: task.clone(),
        believed: belief.clone(),
        plan,
        cell,
        followed,
    })
}

/// Executes a round, and lets the interpreter feel it.
fn execute_round(
    motion: &Motion,
    reality: &Reality,
    dirt: &Dirt,
    config: &RunConfig,
    interpreter: &mut Interpreter,
    news: &mut dyn FnMut(News<'_>) -> ControlFlow<()>,
) -> Result<Executed, RunError> {
    let _ = news(News::Executing(motion));
    let execute_config = ExecuteConfig {
        round: motion.number,
        seed: motion.task.seed,
        ..config.execute
    };
    let mut refused = None;
    let Motion {
        task,
        cell,
        followed,
        ..
    } = motion;
    let executed = execute(
        task,
        cell,
        followed,
        reality,
        dirt,
        &execute_config,
        &mut |sample| {
            let touch = TouchSample {
                time: sample.time,
                world_from_tool: sample.world_from_tool,
                force: sample.external.force,
            };
            if let Err(error) = interpreter.push(&touch) {
                refused = Some(error);
                return ControlFlow::Break(());
            }
            news(News::Sample(sample))
        },
    )?;
    refused.map_or(Ok(executed), |error| Err(error.into()))
}

/// Lets the interpreter feel what was executed before.
fn recall(
    past: Past,
    motion: &Motion,
    interpreter: &mut Interpreter,
    news: &mut dyn FnMut(News<'_>) -> ControlFlow<()>,
) -> Result<Executed, RunError> {
    let _ = news(News::Recalling(motion));
    for touch in &past.touches {
        interpreter.push(touch)?;
    }
    Ok(past.executed)
}

/// Whether the robot was pushed, or stopped itself.
fn was_disturbed(executed: &Executed, interpretation: &Interpretation) -> bool {
    let mut events = interpretation.events.iter();
    matches!(executed.ending, Ending::ProtectiveStop { .. })
        || events.any(|event| event.kind == EventKind::Collision)
}

/// Whether an earlier round was disturbed.
fn was_pushed(rounds: &[Round]) -> bool {
    let mut rounds = rounds.iter();
    rounds.any(|round| was_disturbed(&round.executed, &round.interpretation))
}

/// Whether the lower end of the estimate is too far below the target to claim it.
fn is_doubtful(interpretation: &Interpretation, config: &RunConfig) -> bool {
    interpretation.performance.low < config.target - DOUBT_TOLERATED
}

/// The dirt as it really lies: where the task has it, unless there is too much of it for the simulation.
fn real_dirt(task: &Task, reality: &Reality) -> Dirt {
    if task.particles.len() > reality.max_bodies {
        return Dirt::default();
    }
    Dirt::scatter(&task.particles, reality, task.seed)
}

fn true_performance(
    dirt: &Dirt,
    goal: &GoalState,
    task: &Task,
) -> Result<Option<f64>, ParticleError> {
    if dirt.grains().is_empty() {
        return Ok(None);
    }
    let particles = dirt.particles()?;
    Ok(Some(
        Performance::of(&particles, goal, &task.surface).ratio(),
    ))
}

/// Where the robot stands after a round.
fn standing(round: &Round, config: &RunConfig) -> Pose {
    let cell = &round.motion.cell;
    let Some(base) = cell.base() else {
        return *cell.world_from_root();
    };
    let q = &round.executed.positions;
    let at = PlanarPose::new(Point2::new(q[base.x], q[base.y]), q[base.yaw]);
    let start = config
        .workcell
        .world_from_robot
        .unwrap_or_else(Pose::identity);
    Pose::from_parts(
        Translation3::new(at.position.x, at.position.y, start.translation.z),
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), at.heading),
    )
}
