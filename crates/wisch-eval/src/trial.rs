//! Evaluation in one world: runs the method and compares its estimates with ground truth.

use crate::baselines::Baselines;
use crate::pushes::PushCounts;
use crate::simulated::{format_error, read_robot};
use crate::variants::{CameraObservation, Variant, VariantBelief};
use crate::world::{Senses, WorldCase};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;
use wisch::interpret::{Belief, EventKind, PerformanceDistribution, TouchSample};
use wisch::recover::Verdict;
use wisch::represent::{GoalState, Observation, Sight, Task};
use wisch::run::{AfterStop, Round, RunConfig, RunEvent, Session};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{GroundTruth, WorkSurface, World};

/// Nominal probabilities of the scored intervals \[1\].
pub const LEVELS: [f64; 4] = [0.5, 0.8, 0.9, 0.95];
/// Tolerance for values that differ only by rounding [1].
const ROUNDING: f64 = 1e-9;

/// The failure of a world's evaluation.
#[derive(Debug, thiserror::Error)]
#[error("seed {seed}: {message}")]
pub struct EvaluationError {
    /// The seed of the world.
    pub seed: u64,
    /// The problem.
    pub message: String,
}

/// The score of an estimated performance against the true performance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BeliefScore {
    /// Expected performance.
    pub mean: f64,
    /// Lower and upper ends of the intervals of [`LEVELS`].
    pub intervals: [[f64; 2]; 4],
    /// Estimated probability of a performance below the true one \[1\].
    pub rank: f64,
    /// Continuous ranked probability score.
    pub crps: f64,
}

impl BeliefScore {
    /// Scores an estimated performance. `outcome`: the true performance, in [0, 1].
    pub fn evaluate(belief: &PerformanceDistribution, outcome: f64) -> Self {
        Self {
            mean: belief.mean(),
            intervals: LEVELS.map(|level| belief.interval(level)),
            rank: belief.probability_below(outcome),
            crps: belief.score(outcome),
        }
    }

    /// Whether the interval of a level contains the true performance.
    ///
    /// `level`: index into [`LEVELS`]; `outcome`: the true performance.
    pub fn holds(&self, level: usize, outcome: f64) -> bool {
        let [low, high] = self.intervals[level];
        (low - ROUNDING..=high + ROUNDING).contains(&outcome)
    }
}

/// The scores of one round in a world.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RoundScore {
    /// True performance.
    pub outcome: f64,
    /// Score of the method.
    pub belief: BeliefScore,
    /// Predicted performance of the plan.
    pub prediction: f64,
    /// Score of the force-blind replay.
    pub force_blind: BeliefScore,
    /// Estimate of the paper's rule.
    pub paper: f64,
    /// Scores of the variants, in their order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub variants: Vec<BeliefScore>,
    /// True and detected pushes.
    pub pushes: PushCounts,
    /// The verdict as text.
    pub verdict: String,
    /// Whether the goal was claimed.
    pub is_claimed: bool,
}

/// The scores of all rounds in a world.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorldScore {
    /// The world.
    pub case: WorldCase,
    /// The robot's senses.
    pub senses: Senses,
    /// The variants that were scored on the same rounds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub variants: Vec<Variant>,
    /// Overrides of the task: keys and values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub settings: Vec<(String, String)>,
    /// Target performance.
    pub target: f64,
    /// Rounds, in order.
    pub rounds: Vec<RoundScore>,
    /// Computation time \[s\].
    pub seconds: f64,
}

impl WorldCase {
    /// Runs the method in this world, with overrides of the task.
    ///
    /// # Errors
    /// A message if a stage fails.
    pub fn evaluate(
        &self,
        senses: Senses,
        variants: &[Variant],
        settings: &[(String, String)],
    ) -> Result<WorldScore, EvaluationError> {
        let evaluated = self.try_evaluate(senses, variants, settings);
        evaluated.map_err(|message| EvaluationError {
            seed: self.seed,
            message,
        })
    }

    fn try_evaluate(
        &self,
        senses: Senses,
        asked: &[Variant],
        set: &[(String, String)],
    ) -> Result<WorldScore, String> {
        let begin = Instant::now();
        let loaded = self.load(senses, set)?;
        let robot = read_robot(&loaded)?;
        let settings = self.settings(&loaded.simulation, &loaded.task);
        let config = RunConfig {
            // The person who pushes lets go, and the robot resumes without an operator.
            after_stop: AfterStop::Retreat,
            ..loaded.run.clone()
        };
        let (target, sight) = (config.target, config.sight);
        let site = WorkSurface::from_task(&loaded.task);
        let mut world = World::new(&site, settings, self.seed).map_err(format_error)?;
        let prior = loaded.belief();
        let session = Session::new(&loaded.task, config).with_belief(prior.clone());
        let mut session = session.with_robot(robot.robot_setup());
        let mut record = SensingRecord::default();
        session
            .run(&mut world, &mut |event| {
                record.add(event);
                ControlFlow::Continue(())
            })
            .map_err(format_error)?;
        let first_observation = record.first_observation.as_ref();
        let mut scorer = RoundScorer::new(&loaded.task, prior, asked, first_observation, sight);
        let rounds = (session.rounds().iter())
            .zip(world.truth())
            .zip(&record.touch)
            .map(|((round, truth), touch)| scorer.score(round, truth, touch));
        Ok(WorldScore {
            case: *self,
            senses,
            variants: asked.to_vec(),
            settings: set.to_vec(),
            target,
            rounds: rounds.collect::<Result<_, String>>()?,
            seconds: begin.elapsed().as_secs_f64(),
        })
    }

    /// Loads the task with its seed, action, senses and the overrides.
    fn load(&self, senses: Senses, set: &[(String, String)]) -> Result<LoadedTask, String> {
        let senses_key = match senses {
            Senses::Touch => r#"["touch"]"#,
            Senses::TouchAndSight => r#"["touch", "sight"]"#,
        };
        let perceived = ("perception.senses".to_owned(), senses_key.to_owned());
        let options = LoadOptions {
            settings: set.iter().cloned().chain([perceived]).collect(),
            seed: Some(self.seed),
            action: Some(self.task.action()),
            ..LoadOptions::default()
        };
        load_task(Path::new(self.task.scenario()), &options).map_err(format_error)
    }
}

/// The measurements of a session.
#[derive(Debug, Default)]
struct SensingRecord {
    /// The observation before the first round.
    first_observation: Option<Observation>,
    /// Touch samples of each executed round.
    touch: Vec<Vec<TouchSample>>,
}

impl SensingRecord {
    /// Adds the measurements of an event.
    fn add(&mut self, event: &RunEvent<'_>) {
        match event {
            RunEvent::Executing(_) => self.touch.push(Vec::new()),
            RunEvent::Observed {
                round: 0,
                observation,
            } => self.first_observation = Some(Observation::clone(observation)),
            RunEvent::Sample(sample) => {
                if let Some(round) = self.touch.last_mut() {
                    let force = sample.external.force;
                    round.push(TouchSample::new(sample.time, sample.world_from_tool, force));
                }
            }
            _ => (),
        }
    }
}

/// A scorer of a session's rounds, in order, for the method, the baselines and the variants.
struct RoundScorer<'a> {
    sight: Option<Sight>,
    baselines: Baselines,
    variants: Vec<VariantBelief<'a>>,
    /// The goal of the first round, with which all rounds are scored.
    goal: Option<GoalState>,
}

impl<'a> RoundScorer<'a> {
    /// Makes a scorer before the first round; the variants start from the prior after the first observation.
    fn new(
        task: &Task,
        prior: Belief,
        variants: &'a [Variant],
        first_observation: Option<&Observation>,
        sight: Option<Sight>,
    ) -> Self {
        let baselines = Baselines::new(&prior, task);
        let mut before = prior;
        if let Some(observed) = CameraObservation::from_observation(first_observation, sight) {
            // As in the session: a goal area that the planner chooses is unknown at this point.
            let goal = task.goal().unwrap_or(GoalState::Skimmed);
            before = before.observe(&observed.update(task, &goal));
        }
        Self {
            sight,
            baselines,
            variants: (variants.iter())
                .map(|variant| VariantBelief::new(variant, before.clone()))
                .collect(),
            goal: None,
        }
    }

    /// Scores the next round by its ground truth.
    fn score(
        &mut self,
        round: &Round,
        truth: &GroundTruth,
        touch: &[TouchSample],
    ) -> Result<RoundScore, String> {
        let (motion, interpretation) = (&round.motion, &round.interpretation);
        let goal = *self.goal.get_or_insert(motion.plan.graph.goal);
        let outcome = truth.performance(&goal, &motion.task.surface);
        let outcome = outcome
            .map_err(format_error)?
            .ok_or("there is no dirt in this world")?;
        let simpler = (self.baselines.update(motion, touch, &goal)).map_err(format_error)?;
        let observed =
            CameraObservation::from_observation(interpretation.observation.as_ref(), self.sight);
        let score_variant = |variant: &mut VariantBelief<'_>| {
            let belief = variant.update_belief(motion, touch, observed, &goal);
            Ok(BeliefScore::evaluate(
                &belief.map_err(format_error)?,
                outcome,
            ))
        };
        let variants: Result<_, String> = self.variants.iter_mut().map(score_variant).collect();
        let events = interpretation.events.iter();
        let collisions = events.filter(|event| event.kind == EventKind::Push);
        let detected: Vec<_> = collisions.map(|event| [event.start, event.end]).collect();
        Ok(RoundScore {
            outcome,
            belief: BeliefScore::evaluate(&interpretation.distribution, outcome),
            prediction: simpler.prediction,
            force_blind: BeliefScore::evaluate(&simpler.force_blind, outcome),
            paper: simpler.paper,
            variants: variants?,
            pushes: PushCounts::count(
                round.execution.duration,
                &truth.pushes,
                &truth.obstructions,
                &detected,
            ),
            verdict: round.verdict.as_str().to_owned(),
            is_claimed: round.verdict == Verdict::GoalMet,
        })
    }
}
