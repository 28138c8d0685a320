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
use wisch::interpret::{Belief, EventKind, PerformanceDistribution, TouchSample};
use wisch::recover::Verdict;
use wisch::represent::{GoalState, Observation, Sight, Task};
use wisch::run::{AfterStop, Round, RunConfig, RunEvent, Session};
use wisch_io::{LoadOptions, LoadedTask, load_task};
use wisch_sim::{GroundTruth, SimulationSettings, Site, World};

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
        let loaded = self.load(senses, set)?;
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
        let session = Session::new(&loaded.task, config).with_belief(prior.clone());
        let mut session = session.with_robot(robot.performer());
        let mut record = SensingRecord::default();
        session
            .run(&mut world, &mut |event| {
                record.add(event);
                ControlFlow::Continue(())
            })
            .map_err(words)?;
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

    /// Loads the task with its seed, action, senses and these settings.
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
        load_task(Path::new(self.task.scenario()), &options).map_err(words)
    }
}

/// What the robot perceived during a session.
#[derive(Debug, Default)]
struct SensingRecord {
    /// The observation before the first round.
    first_observation: Option<Observation>,
    /// Touch samples of each executed round.
    touch: Vec<Vec<TouchSample>>,
}

impl SensingRecord {
    /// Adds what an event tells of the senses.
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

/// Scores the rounds of a session, in order, with the baselines and variants beside the method.
struct RoundScorer<'a> {
    sight: Option<Sight>,
    baselines: Baselines,
    variants: Vec<VariantBelief<'a>>,
    /// The goal of the first round, which all rounds are scored by.
    goal: Option<GoalState>,
}

impl<'a> RoundScorer<'a> {
    /// A scorer before the first round; the variants start from the prior after the first observation.
    fn new(
        task: &Task,
        prior: Belief,
        variants: &'a [Variant],
        first_observation: Option<&Observation>,
        sight: Option<Sight>,
    ) -> Self {
        let baselines = Baselines::new(&prior, task);
        let mut before = prior;
        if let Some(seen) = Seen::of(first_observation, sight) {
            // As the session does: a goal that is left to the planner is no place.
            let goal = task.goal().unwrap_or(GoalState::Skimmed);
            before = before.seen(&seen.look(task, &goal));
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
            .map_err(words)?
            .ok_or("there is no dirt in this world")?;
        let simpler = (self.baselines.after(motion, touch, &goal)).map_err(words)?;
        let seen = Seen::of(interpretation.observation.as_ref(), self.sight);
        let score_variant = |variant: &mut VariantBelief<'_>| {
            let belief = variant.after(motion, touch, seen, &goal);
            Ok(BeliefScore::of(&belief.map_err(words)?, outcome))
        };
        let variants: Result<_, String> = self.variants.iter_mut().map(score_variant).collect();
        let events = interpretation.events.iter();
        let collisions = events.filter(|event| event.kind == EventKind::Collision);
        let detected: Vec<_> = collisions.map(|event| [event.start, event.end]).collect();
        Ok(RoundScore {
            outcome,
            belief: BeliefScore::of(&interpretation.distribution, outcome),
            prediction: simpler.prediction,
            force_blind: BeliefScore::of(&simpler.force_blind, outcome),
            paper: simpler.paper,
            variants: variants?,
            pushes: PushCounts::of_round(
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
