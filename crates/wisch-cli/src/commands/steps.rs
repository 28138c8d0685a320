//! Goals of several parts: a command wipes step by step, in the order of least expected time, and plans anew when a step
//! fails.

use super::follow::{Chosen, read_robot, workcell_config};
use super::patches::performance_of;
use super::prepare::{load, stage_failure};
use super::words::{counted, internal, percent};
use crate::args::{RobotArgs, TaskArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::remark;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use wisch::goal::{Sequence, Situation, Step, StepPlace, StepTimes, Wiping};
use wisch::run::{NoExecutor, RunConfig, Stage};
use wisch_io::{
    GoalFile, KeptFiles, LoadOptions, LoadedTask, PARTICLES_ESTIMATED_FILE, PARTICLES_TRUE_FILE,
    Robot, Summary, path_in_results,
};

/// The schema of the object.
const SCHEMA: u32 = 1;
/// Assumed times of fetching or putting back a tool, and of emptying one [s], and speed of ways between places [m/s].
const CHANGE: f64 = 10.0;
const EMPTY: f64 = 20.0;
const SPEED: f64 = 0.3;
/// How often a wiping action is tried before another one is planned for.
const TRIES: u32 = 2;
/// Least predicted performance at which further rounds are expected to reach a target [1].
const LEAST_PREDICTED: f64 = 0.05;

/// What is expected of a wiping action.
#[derive(Debug, Clone)]
enum Expected {
    /// It is expected to reach its target.
    Reaches {
        /// Time of a round, with the robot's whole motion, or of the strokes without a robot [s].
        round_s: f64,
        /// Expected number of rounds.
        rounds: f64,
        /// Predicted performance of a round.
        predicted: f64,
    },
    /// It cannot be done, for this reason.
    Impossible(String),
}

/// A task with a goal of several parts, and what is expected of the actions that may serve it.
pub(super) struct GoalTask<'a> {
    args: &'a TaskArgs,
    file: &'a GoalFile,
    expected: BTreeMap<Wiping, Expected>,
    /// Origins of the surfaces in the world [m].
    surfaces: BTreeMap<String, [f64; 3]>,
    has_robot: bool,
    /// Actions whose dirt a camera observes.
    observed: BTreeSet<Wiping>,
}

/// Reads the task, if its goal has several parts.
pub(super) fn read_goal(args: &TaskArgs) -> Result<Option<GoalFile>, Failure> {
    let options = LoadOptions {
        settings: args.settings.clone(),
        knowledge: args.knowledge.clone(),
        action: args.action,
        strategy: args.strategy,
        seed: args.seed,
    };
    Ok(GoalFile::read(&args.task, &options)?)
}

impl<'a> GoalTask<'a> {
    /// Plans every action that may serve the goal, with the robot if there is one, to know its expected time.
    pub fn evaluate(
        args: &'a TaskArgs,
        file: &'a GoalFile,
        robot: Option<&RobotArgs>,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let situation = file
            .situation()
            .map_err(|error| stage_failure(args, error))?;
        let mut task = Self {
            args,
            file,
            expected: BTreeMap::new(),
            surfaces: BTreeMap::new(),
            has_robot: false,
            observed: BTreeSet::new(),
        };
        let mut known: Option<Robot> = None;
        let wipings = situation.possible_wipings(&file.goal);
        for (wiping, number) in wipings.iter().zip(1..) {
            progress.say(format!("planning {wiping} ({number} of {})", wipings.len()));
            let part = task.part(&situation, wiping, &[])?;
            let loaded = match load(&part, &KeptFiles::default()) {
                Ok(loaded) => loaded,
                // The file as a whole is valid; it lacks what this action needs.
                Err(failure) => {
                    let why = Expected::Impossible(failure.to_string());
                    task.expected.insert(wiping.clone(), why);
                    continue;
                }
            };
            let at = loaded.task.surface.world_from_surface.translation.vector;
            task.surfaces.insert(wiping.surface.clone(), at.into());
            let chosen = robot
                .map(|robot| Chosen::new(robot, &loaded))
                .transpose()?
                .flatten();
            if let (Some(chosen), None) = (&chosen, &known) {
                known = Some(read_robot(chosen, &part)?);
            }
            let robot = chosen.as_ref().zip(known.as_ref());
            task.has_robot |= robot.is_some();
            if loaded.file.camera.is_some() {
                task.observed.insert(wiping.clone());
            }
            task.expected.insert(wiping.clone(), expect(&loaded, robot));
        }
        Ok(task)
    }

    /// Whether a robot follows the strokes.
    pub const fn has_robot(&self) -> bool {
        self.has_robot
    }

    /// Returns the arguments of the task of a wiping action, with further settings.
    pub fn part(
        &self,
        situation: &Situation<'_>,
        wiping: &Wiping,
        further: &[(&str, String)],
    ) -> Result<TaskArgs, Failure> {
        let Wiping {
            action,
            tool,
            medium,
            surface,
        } = wiping;
        let fact = situation.effect_of(wiping);
        let fact = fact.ok_or_else(|| internal("a wiping action has no effect"))?;
        let text = |text: &str| serde_json::Value::from(text).to_string();
        let own = [
            ("goal", text(&fact.to_string())),
            (
                "name",
                text(&format!("{}-{action}-{medium}-{surface}", self.file.name)),
            ),
            ("tool.name", text(tool)),
            ("tool.in_hand", text(tool)),
            ("tool.available", "[]".to_owned()),
        ];
        let mut args = self.args.clone();
        let added = own.iter().chain(further);
        args.settings
            .extend(added.map(|(key, value)| ((*key).to_owned(), value.clone())));
        Ok(args)
    }

    /// Plans the sequence of least expected time from a situation.
    pub fn plan(
        &self,
        situation: &Situation<'_>,
        place: StepPlace<'_>,
    ) -> Result<Sequence, Failure> {
        let sequence = situation.plan(&self.file.goal, place, self);
        sequence.map_err(|error| stage_failure(self.args, error))
    }

    fn expected_actions(&self) -> Vec<ExpectedAction> {
        let actions = self.expected.iter().map(|(wiping, expected)| {
            let (numbers, impossible) = match expected {
                Expected::Reaches {
                    round_s,
                    rounds,
                    predicted,
                } => (Some([*round_s, *rounds, *predicted]), None),
                Expected::Impossible(why) => (None, Some(why.clone())),
            };
            ExpectedAction {
                wiping: wiping.to_string(),
                round_s: numbers.map(|[round_s, _, _]| round_s),
                rounds: numbers.map(|[_, rounds, _]| rounds),
                predicted: numbers.map(|[_, _, predicted]| predicted),
                impossible,
            }
        });
        actions.collect()
    }

    fn place_of(&self, place: StepPlace<'_>) -> Option<[f64; 3]> {
        match place {
            StepPlace::Start => None,
            StepPlace::Surface(name) => self.surfaces.get(name).copied(),
            StepPlace::Rack(name) => {
                let mut tools = self.file.tools.iter();
                tools.find(|tool| tool.name == name)?.position
            }
        }
    }
}

impl StepTimes for GoalTask<'_> {
    fn wiping(&self, wiping: &Wiping) -> Option<f64> {
        match self.expected.get(wiping)? {
            Expected::Reaches {
                round_s, rounds, ..
            } => Some(round_s * rounds),
            Expected::Impossible(_) => None,
        }
    }

    fn handling(&self, name: &str) -> f64 {
        if name == "empty" { EMPTY } else { CHANGE }
    }

    fn moving(&self, from: StepPlace<'_>, to: StepPlace<'_>) -> f64 {
        match (self.place_of(from), self.place_of(to)) {
            (Some(from), Some(to)) => {
                let squares = from.iter().zip(to).map(|(a, b)| (a - b).powi(2));
                squares.sum::<f64>().sqrt() / SPEED
            }
            _ => 0.0,
        }
    }
}

/// A step that a command has taken.
#[derive(Serialize)]
struct TakenStep {
    /// The step as a PDDL action, such as `(grasp sponge)`.
    step: String,
    /// What it does, in words.
    words: String,
    /// Expected time, with the way to its place [s].
    expected_s: f64,
    /// Time since the first step at which it began [s].
    began_s: f64,
    /// Its time [s]: of a wiping step the motions, with the expected way to its place; of others as expected.
    took_s: f64,
    /// Whether the goal of the wiping step is met; null for other steps.
    goal_met: Option<bool>,
    /// How often this wiping step was tried before; 0 for other steps.
    earlier_tries: u32,
    /// Summary of the wiping step; null for other steps.
    summary: Option<Summary>,
}

/// A part of the goal.
#[derive(Serialize)]
struct GoalPart {
    part: String,
    /// Whether it holds after the last step, as far as is known.
    holds: bool,
    /// Why it does not hold: no sequence of steps reaches it, or its step missed its target; null otherwise.
    left_out: Option<String>,
}

/// What is expected of an action that may serve the goal.
#[derive(Serialize)]
struct ExpectedAction {
    wiping: String,
    /// Time of a round [s], expected number of rounds, and predicted performance of a round; null if it is impossible.
    round_s: Option<f64>,
    rounds: Option<f64>,
    predicted: Option<f64>,
    /// Why it is impossible; null if it is possible.
    impossible: Option<String>,
}

/// What a command for a goal of several parts has found.
#[derive(Serialize)]
pub(super) struct GoalSummary {
    format: &'static str,
    schema: u32,
    task: String,
    goal: String,
    /// Whether every part of the goal holds, as far as is known.
    goal_met: bool,
    /// Whether the steps were executed; otherwise each step is assumed to reach its goal.
    is_executed: bool,
    /// Expected time of the sequence that was planned before the first step [s].
    expected_s: f64,
    /// Time of all steps [s].
    took_s: f64,
    /// Assumed times of steps without a motion [s], and assumed speed of ways between places [m/s].
    assumed: AssumedTimes,
    parts: Vec<GoalPart>,
    steps: Vec<TakenStep>,
    expected_actions: Vec<ExpectedAction>,
    out: String,
}

/// Assumed times of steps without a motion.
#[derive(Serialize)]
struct AssumedTimes {
    fetch_or_put_back_s: f64,
    empty_s: f64,
    speed_m_per_s: f64,
}

/// The outcome of a wiping step.
pub(super) struct WipedStep {
    /// Its summary.
    pub summary: Summary,
    /// Whether its goal is met.
    pub is_met: bool,
    /// Whether the run waits for its operator, or was interrupted.
    pub is_stopped: bool,
}

/// A command over the steps of a goal.
pub(super) struct GoalRun<'a> {
    task: &'a GoalTask<'a>,
    situation: Situation<'a>,
    is_executed: bool,
    out: PathBuf,
    steps: Vec<TakenStep>,
    tries: BTreeMap<Wiping, u32>,
    /// Wiping actions whose goals were not met when they were last tried or predicted.
    unmet: BTreeSet<Wiping>,
    /// Folder of the last attempt at a medium on a surface, relative to the folder of results.
    last: BTreeMap<[String; 2], PathBuf>,
    clock: f64,
}

impl<'a> GoalRun<'a> {
    /// Begins before the first step. `is_executed`: whether steps are executed; otherwise each is assumed to succeed.
    pub fn begin(task: &'a GoalTask<'a>, is_executed: bool, out: PathBuf) -> Result<Self, Failure> {
        let situation = task.file.situation();
        Ok(Self {
            task,
            situation: situation.map_err(|error| stage_failure(task.args, error))?,
            is_executed,
            out,
            steps: Vec::new(),
            tries: BTreeMap::new(),
            unmet: BTreeSet::new(),
            last: BTreeMap::new(),
            clock: 0.0,
        })
    }

    /// Takes the steps. `wipe` executes a wiping step, with its arguments and the folder of its results.
    pub fn run(
        mut self,
        wipe: &mut dyn FnMut(&TaskArgs, &Path) -> Result<WipedStep, Failure>,
    ) -> Result<(GoalSummary, Option<Failure>), Failure> {
        let mut sequence = self.plan_on()?;
        let expected_s = sequence.time();
        remark(&describe_sequence(&sequence));
        let mut broken = None;
        while let Some(step) = sequence.steps.first().cloned() {
            let Some(wiping) = step.wiping.clone() else {
                self.situation.apply(&step);
                self.note(&step, step.time, None, 0);
                sequence.steps.remove(0);
                continue;
            };
            let (number, tries) = (self.steps.len() + 1, *self.tries.get(&wiping).unwrap_or(&0));
            let name = format!("step-{number}");
            let args = self
                .task
                .part(&self.situation, &wiping, &self.remaining(&wiping))?;
            let wiped = match wipe(&args, &self.out.join(&name)) {
                Ok(wiped) => wiped,
                Err(failure) => {
                    let failure = failure.after(&format!("step {number}, {wiping}"));
                    if self.steps.iter().all(|step| step.summary.is_none()) {
                        return Err(failure);
                    }
                    let place = self.out.display();
                    remark(&format!(
                        "the steps before it are finished and kept in {place}"
                    ));
                    broken = Some(failure);
                    break;
                }
            };
            let is_stopped = wiped.is_stopped;
            let is_reached = wiped.is_met || !self.is_executed;
            if !wiped.is_met {
                self.unmet.insert(wiping.clone());
            } else {
                self.unmet.remove(&wiping);
            }
            // The way to the surface is not part of the motions.
            let way = step.time - self.task.wiping(&wiping).unwrap_or(step.time);
            let took = time_of(&wiped.summary).map_or(step.time, |motions| way + motions);
            self.note(&step, took, Some(wiped), tries);
            let on = [wiping.medium.clone(), wiping.surface.clone()];
            self.last.insert(on, PathBuf::from(name));
            if is_reached {
                self.situation.apply(&step);
                sequence.steps.remove(0);
            } else {
                self.note_failure(&wiping);
            }
            if is_stopped {
                remark(&format!(
                    "stopped at step {number}: the steps after it are not carried out"
                ));
                break;
            }
            if !is_reached {
                sequence = self.plan_on()?;
            }
        }
        Ok((self.finish(expected_s), broken))
    }

    /// Counts a try whose goal was not met, and rules actions out that are not to be tried again.
    fn note_failure(&mut self, wiping: &Wiping) {
        let tried = self.tries.entry(wiping.clone()).or_default();
        *tried += 1;
        let tried = *tried;
        // A new session knows where dirt is left only if it sees it.
        let is_retried = self.task.observed.contains(wiping) && !wiping.action.treats();
        if is_retried && tried < TRIES {
            return;
        }
        let of_dirt = self.task.expected.keys().filter(|other| {
            *other == wiping
                || (!is_retried
                    && (&other.medium, &other.surface) == (&wiping.medium, &wiping.surface))
        });
        for other in of_dirt {
            self.situation.rule_out(other);
        }
        let why = if is_retried {
            "it is ruled out"
        } else {
            "it is ruled out, with all tools, because a new step would not know what is left to wipe"
        };
        let tries = if tried == 1 { "try" } else { "tries" };
        remark(&format!(
            "{wiping} has not reached its goal after {tried} {tries}: {why}; the other steps are planned anew"
        ));
    }

    /// Plans the steps from here on.
    fn plan_on(&self) -> Result<Sequence, Failure> {
        let last = self.steps.last().map(|step| step.place());
        let place = match &last {
            Some((true, name)) => StepPlace::Surface(name),
            Some((false, name)) => StepPlace::Rack(name),
            None => StepPlace::Start,
        };
        self.task.plan(&self.situation, place)
    }

    /// Settings for the dirt that an earlier attempt has left, which a camera observes before the next one.
    fn remaining(&self, wiping: &Wiping) -> Vec<(&'static str, String)> {
        let on = [wiping.medium.clone(), wiping.surface.clone()];
        let Some(earlier) = self.last.get(&on) else {
            return Vec::new();
        };
        let file = |name: &str| {
            let path = self.out.join(earlier).join(path_in_results(name));
            let path = std::path::absolute(&path).unwrap_or(path);
            path.exists().then(|| {
                let path = serde_json::Value::from(path.display().to_string());
                format!("{{ source = \"csv\", file = {path} }}")
            })
        };
        let mut settings = Vec::new();
        if let Some(believed) = file(PARTICLES_ESTIMATED_FILE) {
            settings.push(("particles", believed));
        }
        if let Some(real) = file(PARTICLES_TRUE_FILE) {
            settings.push(("execution.dirt", real));
        }
        settings
    }

    fn note(&mut self, step: &Step, took: f64, wiped: Option<WipedStep>, earlier_tries: u32) {
        self.steps.push(TakenStep {
            step: step.to_string(),
            words: describe_step(step),
            expected_s: step.time,
            began_s: self.clock,
            took_s: took,
            goal_met: wiped.as_ref().map(|wiped| wiped.is_met),
            earlier_tries,
            summary: wiped.map(|wiped| wiped.summary),
        });
        self.clock += took;
    }

    fn finish(self, expected_s: f64) -> GoalSummary {
        let file = self.task.file;
        let open = self.task.plan(&self.situation, StepPlace::Start);
        let left_out = open.map(|sequence| sequence.left_out).unwrap_or_default();
        let parts: Vec<GoalPart> = (file.goal.parts())
            .map(|(holds, fact)| {
                let part = if holds {
                    fact.to_string()
                } else {
                    format!("(not {fact})")
                };
                let reason = left_out.iter().find(|(left, _)| *left == part);
                let reason = reason.map(|(_, reason)| self.explain(fact, reason));
                // Without an execution, a step is assumed to succeed; its prediction may say otherwise.
                let unmet = self.unmet.iter().find(|wiping| {
                    self.situation.effect_of(wiping).as_ref() == Some(fact)
                        || (!holds && fact.arguments() == [wiping.surface.clone()])
                });
                let unmet =
                    unmet.map(|wiping| format!("{wiping}: its goal is not predicted to be met"));
                GoalPart {
                    holds: self.situation.holds(fact) == holds && unmet.is_none(),
                    left_out: reason.or(unmet),
                    part,
                }
            })
            .collect();
        GoalSummary {
            format: "wisch-steps",
            schema: SCHEMA,
            task: file.name.clone(),
            goal: file.goal.to_string(),
            goal_met: parts.iter().all(|part| part.holds),
            is_executed: self.is_executed,
            expected_s,
            took_s: self.clock,
            assumed: AssumedTimes {
                fetch_or_put_back_s: CHANGE,
                empty_s: EMPTY,
                speed_m_per_s: SPEED,
            },
            parts,
            steps: self.steps,
            expected_actions: self.task.expected_actions(),
            out: self.out.display().to_string(),
        }
    }

    /// Explains why no step reaches a fact: by the actions for its objects that are impossible, else by `reason`.
    fn explain(&self, fact: &wisch::goal::GoalLiteral, reason: &str) -> String {
        let names = fact.arguments();
        let of_fact = self.task.expected.iter().filter_map(|(wiping, expected)| {
            let serves = self.situation.effect_of(wiping).as_ref() == Some(fact)
                || (names == [wiping.surface.clone()]);
            match expected {
                Expected::Impossible(why) if serves => Some(format!("{wiping}: {why}")),
                _ if serves && self.tries.contains_key(wiping) => {
                    Some(format!("{wiping}: its goal was not reached"))
                }
                _ => None,
            }
        });
        let why: Vec<String> = of_fact.collect();
        if why.is_empty() {
            reason.to_owned()
        } else {
            why.join("; ")
        }
    }
}

impl TakenStep {
    /// Whether the step ended at a surface, and the name of the surface or tool.
    fn place(&self) -> (bool, String) {
        match &self.summary {
            Some(summary) => (true, summary.surface.clone()),
            None => {
                let mut words = self.step.trim_matches(['(', ')']).split(' ');
                (false, words.next_back().unwrap_or_default().to_owned())
            }
        }
    }
}

/// Time of the motions of a wiping step [s].
fn time_of(summary: &Summary) -> Option<f64> {
    match (&summary.execution, &summary.following) {
        (Some(execution), _) => Some(execution.total(|round| round.execution_time_s)),
        (None, Some(following)) => Some(following.execution_time_s),
        (None, None) => None,
    }
}

/// A step in words.
fn describe_step(step: &Step) -> String {
    match (&step.wiping, step.name()) {
        (Some(wiping), _) => wiping.to_string(),
        (None, "grasp") => format!("fetch {}", step.objects().join(" ")),
        (None, "release") => format!("put {} back", step.objects().join(" ")),
        (None, name) => format!("{name} {}", step.objects().join(" ")),
    }
}

fn describe_sequence(sequence: &Sequence) -> String {
    let steps: Vec<String> = sequence.steps.iter().map(describe_step).collect();
    let mut text = match steps.len() {
        0 => "no step is needed".to_owned(),
        count => format!(
            "{} in {:.0} s as expected: {}",
            counted(count, "step"),
            sequence.time(),
            steps.join(", ")
        ),
    };
    for (part, reason) in &sequence.left_out {
        text += &format!("; {part} is left out: {reason}");
    }
    text
}

impl GoalSummary {
    /// Whether every part of the goal holds, as far as is known.
    pub const fn is_met(&self) -> bool {
        self.goal_met
    }

    /// The summary for people.
    pub fn in_words(&self) -> String {
        let mut text = format!("{}: {}\n", self.task, self.goal);
        let mut add = |name: &str, value: String| text += &format!("  {name:<18} {value}\n");
        let holding = self.parts.iter().filter(|part| part.holds).count();
        let parts = counted(self.parts.len(), "part");
        let how = if self.is_executed {
            "as estimated"
        } else {
            "as predicted, not executed"
        };
        add("goal", format!("{holding} of {parts} hold, {how}"));
        for part in self.parts.iter().filter(|part| !part.holds) {
            let why = part.left_out.as_deref().unwrap_or("not reached");
            add("open", format!("{}: {why}", part.part));
        }
        for (step, number) in self.steps.iter().zip(1..) {
            let TakenStep {
                words,
                took_s,
                expected_s,
                ..
            } = step;
            let times = format!("{took_s:.1} s ({expected_s:.1} s expected)");
            let result = match (&step.summary, step.goal_met) {
                (Some(summary), Some(is_met)) => {
                    format!(
                        ", {}: {}",
                        performance_of(summary),
                        if is_met { "met" } else { "not met" }
                    )
                }
                _ => String::new(),
            };
            add(
                &format!("step {number}"),
                format!("{words}: {times}{result}"),
            );
        }
        add(
            "time",
            format!("{:.1} s ({:.1} s expected)", self.took_s, self.expected_s),
        );
        add(
            "assumed",
            format!(
                "{CHANGE} s to fetch or put back a tool, {EMPTY} s to empty one, {SPEED} m/s between places"
            ),
        );
        add("results", self.out.clone());
        text
    }

    /// The page over all steps, which links to those of the wiping steps.
    pub fn page(&self) -> String {
        let rows: Vec<wisch_report::StepRow> = (self.steps.iter().zip(1..))
            .map(|(step, number)| wisch_report::StepRow {
                words: step.words.clone(),
                began: step.began_s,
                took: step.took_s,
                expected: step.expected_s,
                result: match (&step.summary, step.goal_met) {
                    (Some(summary), Some(true)) => format!("{}: met", performance_of(summary)),
                    (Some(summary), _) => format!("{}: not met", performance_of(summary)),
                    (None, _) => String::new(),
                },
                report: (step.summary.as_ref())
                    .filter(|summary| Path::new(&summary.out).join(wisch_io::REPORT_FILE).exists())
                    .map(|_| format!("step-{number}/{}", wisch_io::REPORT_FILE)),
            })
            .collect();
        let parts: Vec<(String, String)> = (self.parts.iter())
            .map(|part| {
                let state = match (&part.left_out, part.holds) {
                    (_, true) => "holds".to_owned(),
                    (Some(why), false) => format!("does not hold: {why}"),
                    (None, false) => "does not hold".to_owned(),
                };
                (part.part.clone(), state)
            })
            .collect();
        let time = format!("{:.1} s ({:.1} s expected)", self.took_s, self.expected_s);
        let assumed = format!(
            "{CHANGE} s to fetch or put back a tool, {EMPTY} s to empty one, {SPEED} m/s between places"
        );
        let facts = [("time".to_owned(), time), ("assumed".to_owned(), assumed)];
        wisch_report::steps_page(&self.task, &[&parts[..], &facts[..]].concat(), &rows)
    }
}

/// Plans a task, with the robot if there is one, and predicts it.
fn expect(loaded: &LoadedTask, robot: Option<(&Chosen<'_>, &Robot)>) -> Expected {
    let config = RunConfig {
        workcell: robot.map_or_else(Default::default, |(chosen, _)| {
            workcell_config(chosen, loaded)
        }),
        ..loaded.run.clone()
    };
    let mut session = wisch::run::Session::new(&loaded.task, config).with_belief(loaded.belief());
    let until = match robot {
        Some((_, robot)) => {
            session = session.with_robot(robot.robot_setup());
            Stage::Audited
        }
        None => Stage::Planned,
    };
    let mut ignore = |_: &wisch::run::RunEvent<'_>| ControlFlow::Continue(());
    if let Err(error) = session.run_until(until, &mut NoExecutor, &mut ignore) {
        return Expected::Impossible(error.to_string());
    }
    let (round_s, performance) = match (session.first_motion(), session.plan()) {
        (Some((_, audit)), _) if !audit.is_sound() => {
            let fault = audit.faults.first().map(ToString::to_string);
            return Expected::Impossible(format!("unsafe motion: {}", fault.unwrap_or_default()));
        }
        (Some((motion, _)), _) => (motion.followed.duration(), motion.prediction.performance),
        (None, Some(plan)) => {
            let predicted = wisch::plan::predict(&loaded.task, plan, |_| {});
            (plan.total_distance() / SPEED, predicted.performance)
        }
        (None, None) => return Expected::Impossible("there is no plan".to_owned()),
    };
    let (predicted, target) = (performance.ratio(), loaded.run.target);
    let lost = performance.lost as f64 / performance.initial.max(1) as f64;
    if lost > 1.0 - target {
        let lost = percent(lost);
        return Expected::Impossible(format!(
            "a plan would lose {lost} of the dirt over an edge, and the target is {}",
            percent(target)
        ));
    }
    if predicted < LEAST_PREDICTED {
        return Expected::Impossible(format!(
            "a plan is predicted to reach {} only, and the target is {}",
            percent(predicted),
            percent(target)
        ));
    }
    // A round leaves the share 1 - r of the dirt, and n rounds (1 - r)^n.
    let rounds = if predicted >= target {
        1.0
    } else {
        ((1.0 - target).max(1e-3).ln() / (1.0 - predicted).ln()).max(1.0)
    };
    Expected::Reaches {
        round_s,
        rounds,
        predicted,
    }
}
