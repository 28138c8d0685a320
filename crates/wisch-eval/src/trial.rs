//! One world: the method wipes in it, and what it believed is held against what was so.

use crate::baselines::Baselines;
use crate::pushes::PushCounts;
use crate::simulated::{robot_of, words};
use crate::variants::{Seen, Variant, VariantBelief};
use crate::world::{Senses, WorldCase};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;
use wisch::interpret::{EventKind, PerformanceDistribution, TouchSample};
use wisch::recover::Verdict;
use wisch::represent::{GoalState, Observation};
use wisch::run::{AfterStop, RunConfig, RunEvent, Session};
use wisch_io::{LoadOptions, load_task};
use wisch_sim::{SimulationSettings, Site, World};

/// The shares of probability whose intervals are looked at [1].
pub const LEVELS: [f64; 4] = [0.5, 0.8, 0.9, 0.95];
/// Slack for values that are equal but for rounding [1].
const ROUNDING: f64 = 1e-9;

/// Why a world could not be evaluated.
#[derive(Debug, thiserror::Error)]
#[error("seed {seed}: {message}")]
pub struct EvaluationError {
    /// The seed of the world.
    pub seed: u64,
    /// What went wrong.
    pub message: String,
}

/// A belief about a performance held against what was so.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BeliefScore {
    /// Expected performance.
    pub mean: f64,
    /// The intervals of [`LEVELS`], their lower ends and upper ends.
    pub intervals: [[f64; 2]; 4],
    /// Probability below what was so.
    pub rank: f64,
    /// Continuous ranked probability score.
    pub crps: f64,
}

impl BeliefScore {
    /// The score of a belief.
    pub fn of(belief: &PerformanceDistribution, outcome: f64) -> Self {
        Self {
            mean: belief.mean(),
            intervals: LEVELS.map(|level| belief.interval(level)),
            rank: belief.probability_below(outcome),
            crps: belief.score(outcome),
        }
    }

    /// Whether the interval of a level holds what was so.
    pub fn holds(&self, level: usize, outcome: f64) -> bool {
        let [low, high] = self.intervals[level];
        (low - ROUNDING..=high + ROUNDING).contains(&outcome)
    }
}

/// One round.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RoundScore {
    /// What was so.
    pub outcome: f64,
    /// What the method believed.
    pub belief: BeliefScore,
    /// What the plan was predicted to do.
    pub prediction: f64,
    /// What a replay without forces believed.
    pub force_blind: BeliefScore,
    /// What the paper's rule said.
    pub paper: f64,
    /// What the method would have believed with other uncertainties, in the order in which they were given.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub variants: Vec<BeliefScore>,
    /// Pushes as they were and as they were told.
    pub pushes: PushCounts,
    /// The verdict in words.
    pub verdict: String,
    /// Whether the goal was claimed.
    pub is_claimed: bool,
}

/// One world.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorldScore {
    /// What its seed decided.
    pub case: WorldCase,
    /// What the robot perceived the effect by.
    pub senses: Senses,
    /// What else was asked on the same rounds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub variants: Vec<Variant>,
    /// Keys of the task that were set, with their values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub settings: Vec<(String, String)>,
    /// The performance that was to be reached.
    pub target: f64,
    /// Rounds, in order.
    pub rounds: Vec<RoundScore>,
    /// How long it took [s].
    pub seconds: f64,
}

impl WorldCase {
    /// Lets the method wipe in this world, with these keys of its task set.
    ///
    /// # Errors
    /// What a stage refuses, in words.
    pub fn evaluate(
        &self,
        senses: Senses,
        variants: &[Variant],
        settings: &[(String, String)],
    ) -> Result<WorldScore, EvaluationError> {
        let evaluated = self.evaluated(senses, variants, settings);
        evaluated.map_err(|message| EvaluationError {
            seed: self.seed,
            message,
        })
    }

    fn evaluated(
        &self,
        senses: Senses,
        asked: &[Variant],
        set: &[(String, String)],
    ) -> Result<WorldScore, String> {
        let begin = Instant::now();
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
        let loaded = load_task(Path::new(self.task.scenario()), &options).map_err(words)?;
        let robot = robot_of(&loaded)?;
        let calm = SimulationSettings::of(&loaded).map_err(words)?;
        let settings = self.settings(&calm, &loaded.task);
        let config = RunConfig {
            // Whoever pushes lets go, and the robot goes on without an operator.
            after_stop: AfterStop::Retreat,
            ..loaded.run_config()
        };
        let (target, sight) = (config.target, config.sight);
        let site = Site::of(&loaded.task);
        let mut world = World::new(&site, settings, self.seed).map_err(words)?;
        let prior = loaded.belief();
        let mut baselines = Baselines::new(&prior, &loaded.task);
        let session = Session::new(&loaded.task, config).with_belief(prior.clone());
        let mut session = session.with_robot(robot.performer());
        let mut first_look = None;
        let mut felt: Vec<Vec<TouchSample>> = Vec::new();
        session
            .run(&mut world, &mut |event| {
                match event {
                    RunEvent::Executing(_) => felt.push(Vec::new()),
                    RunEvent::Observed {
                        round: 0,
                        observation,
                    } => first_look = Some(Observation::clone(observation)),
                    RunEvent::Sample(sample) => {
                        if let Some(round) = felt.last_mut() {
                            let force = sample.external.force;
                            round.push(TouchSample::new(
                                sample.time,
                                sample.world_from_tool,
                                force,
                            ));
                        }
                    }
                    _ => (),
                }
                ControlFlow::Continue(())
            })
            .map_err(words)?;
        let mut before = prior;
        if let Some(seen) = Seen::of(first_look.as_ref(), sight) {
            // As the session does: a goal that is left to the planner is no place.
            let goal = loaded.task.goal().unwrap_or(GoalState::Skimmed);
            before = before.seen(&seen.look(&loaded.task, &goal));
        }
        let mut variants: Vec<VariantBelief<'_>> = (asked.iter())
            .map(|variant| VariantBelief::new(variant, before.clone()))
            .collect();
        let mut rounds = Vec::new();
        let mut goal: Option<GoalState> = None;
        for ((round, truth), felt) in session.rounds().iter().zip(world.truth()).zip(&felt) {
            let goal = *goal.get_or_insert(round.motion.plan.graph.goal);
            let surface = &round.motion.task.surface;
            let outcome = truth.performance(&goal, surface).map_err(words)?;
            let outcome = outcome.ok_or("there is no dirt in this world")?;
            let simpler = baselines.after(&round.motion, felt, &goal).map_err(words)?;
            let observation = round.interpretation.observation.as_ref();
            let after = |variant: &mut VariantBelief<'_>| {
                let seen = Seen::of(observation, sight);
                let belief = variant.after(&round.motion, felt, seen, &goal);
                Ok(BeliefScore::of(&belief.map_err(words)?, outcome))
            };
            let others: Result<Vec<_>, String> = variants.iter_mut().map(after).collect();
            let events = round.interpretation.events.iter();
            let collisions = events.filter(|event| event.kind == EventKind::Collision);
            let told: Vec<_> = collisions.map(|event| [event.start, event.end]).collect();
            rounds.push(RoundScore {
                outcome,
                belief: BeliefScore::of(&round.interpretation.distribution, outcome),
                prediction: simpler.prediction,
                force_blind: BeliefScore::of(&simpler.force_blind, outcome),
                paper: simpler.paper,
                variants: others?,
                pushes: PushCounts::of_round(
                    round.execution.duration,
                    &truth.pushes,
                    &truth.obstructions,
                    &told,
                ),
                verdict: round.verdict.as_str().to_owned(),
                is_claimed: round.verdict == Verdict::GoalMet,
            });
        }
        Ok(WorldScore {
            case: *self,
            senses,
            variants: asked.to_vec(),
            settings: set.to_vec(),
            target,
            rounds,
            seconds: begin.elapsed().as_secs_f64(),
        })
    }
}
