//! The episode of a run for a goal of several parts, which connects the episodes of its wiping steps.

use super::super::PROGRAM;
use super::summary::{GoalPart, GoalSummary, TakenStep};
use crate::failure::Failure;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use wisch::goal::{Situation, Wiping};
use wisch_io::{GoalFile, Summary};
use wisch_memory::{
    EpisodeHeader, GoalOutcome, Memory, RememberedGoal, RememberedPart, RememberedStep, StepKind,
    remember_goal,
};
use wisch_record::{RunClock, begin_episode};

/// Names of the actions by which the robot fetches a tool and puts it back.
const GRASP: &str = "grasp";
const RELEASE: &str = "release";

/// The episode of a goal before it is kept.
pub struct GoalEpisode {
    /// Folder of the memory.
    pub memory: PathBuf,
    /// When the command began.
    pub clock: RunClock,
    /// Names of the episodes of the wiping steps, by number of the step.
    pub step_episodes: BTreeMap<usize, String>,
}

impl GoalEpisode {
    /// Writes the episode to the memory. Returns its folder; `None` if no wiping step was taken.
    ///
    /// `file`: the task; `summary`: the steps that were taken.
    ///
    /// # Errors
    /// If the task does not fit the knowledge base, or the memory cannot be written.
    pub fn keep(self, file: &GoalFile, summary: &GoalSummary) -> Result<Option<PathBuf>, Failure> {
        let Some(first) = summary.steps.iter().find_map(|step| step.summary.as_ref()) else {
            return Ok(None);
        };
        let goal = self.remember(file, summary, first)?;
        let store = || {
            let memory = Memory::create(&self.memory)?;
            let start = self.clock.begin();
            let (writer, unfinished) = begin_episode(&memory, start, std::process::id() as u16)?;
            let header = EpisodeHeader {
                id: writer.id().to_owned(),
                task: summary.task.clone(),
                start,
                target: 1.0,
                seed: first.seed,
                program: PROGRAM.to_owned(),
            };
            let record = remember_goal(&header, &goal);
            unfinished.place(|| writer.commit(&record))?;
            Ok(self.memory.join(header.id))
        };
        store()
            .map(Some)
            .map_err(|error: wisch_memory::MemoryError| {
                Failure::new(error).after("the episode of the goal is not kept")
            })
    }

    /// Describes the steps. `first`: the summary of the first wiping step.
    fn remember(
        &self,
        file: &GoalFile,
        summary: &GoalSummary,
        first: &Summary,
    ) -> Result<RememberedGoal, Failure> {
        let situation = file.situation().map_err(Failure::new)?;
        let wipings: BTreeMap<String, Wiping> = (situation.list_possible_wipings(&file.goal))
            .into_iter()
            .map(|wiping| (wiping.to_string(), wiping))
            .collect();
        let wiping_of = |step: &TakenStep| wipings.get(&step.words);
        let serves = find_served_parts(file, &situation, &summary.steps, wiping_of);
        let steps = (summary.steps.iter().zip(1..)).zip(serves);
        let steps = steps.map(|((step, number), serves)| RememberedStep {
            serves,
            episode: self.step_episodes.get(&number).cloned(),
            ..describe(step, wiping_of(step))
        });
        let parts = summary.parts.iter().enumerate().map(|(place, part)| {
            let reaches = |step: &&TakenStep| {
                wiping_of(step).is_some_and(|wiping| {
                    let reached = situation.find_reached_parts(wiping, &file.goal);
                    reached.contains(&place)
                })
            };
            remember_part(part, summary.steps.iter().rev().find(reaches))
        });
        let robot = first.following.as_ref();
        Ok(RememberedGoal {
            goal: summary.goal.clone(),
            robot: robot.map(|following| following.robot.clone()),
            expected: summary.expected_s,
            clock_duration: self.clock.duration(),
            parts: parts.collect(),
            steps: steps.collect(),
        })
    }
}

/// Returns the number of the wiping step whose results are in a folder, such as 2 for `step-2`; `None` for another folder.
pub fn read_step_number(folder: &Path) -> Option<usize> {
    let name = folder.file_name()?.to_str()?;
    name.strip_prefix("step-")?.parse().ok()
}

/// Returns name and tool of a step that does not wipe, such as `grasp` and `sponge`.
fn split_handling(step: &TakenStep) -> (&str, Option<&str>) {
    let mut words = step.step.trim_matches(['(', ')']).split(' ');
    (words.next().unwrap_or_default(), words.next())
}

/// Returns the indices of the parts that each step serves. A step that handles a tool serves the parts of the wiping steps
/// with this tool: fetching and emptying those after it until the tool is put back, putting it back those since it was
/// fetched.
fn find_served_parts<'a>(
    file: &GoalFile,
    situation: &Situation<'_>,
    steps: &'a [TakenStep],
    wiping_of: impl Fn(&'a TakenStep) -> Option<&'a Wiping>,
) -> Vec<Vec<usize>> {
    let own: Vec<Vec<usize>> = (steps.iter())
        .map(|step| {
            wiping_of(step).map_or_else(Vec::new, |wiping| {
                situation.find_served_parts(wiping, &file.goal)
            })
        })
        .collect();
    let is = |place: usize, name: &str| {
        wiping_of(&steps[place]).is_none() && split_handling(&steps[place]).0 == name
    };
    let of = |places: std::ops::Range<usize>| {
        let mut parts: Vec<usize> = own[places].iter().flatten().copied().collect();
        parts.sort_unstable();
        parts.dedup();
        parts
    };
    let served = (0..steps.len()).map(|place| {
        if wiping_of(&steps[place]).is_some() {
            return own[place].clone();
        }
        if is(place, RELEASE) {
            let fetched = (0..place).rev().find(|before| is(*before, GRASP));
            return of(fetched.unwrap_or(0)..place);
        }
        let put_back = (place + 1..steps.len()).find(|after| is(*after, RELEASE));
        of(place..put_back.unwrap_or(steps.len()))
    });
    served.collect()
}

/// Describes a step, without the parts that it serves and without its episode. `wiping`: the wiping action of the step.
fn describe(step: &TakenStep, wiping: Option<&Wiping>) -> RememberedStep {
    let (name, tool) = split_handling(step);
    let kind = match (wiping, name) {
        (Some(_), _) => StepKind::Wipe,
        (None, GRASP) => StepKind::Fetch,
        (None, RELEASE) => StepKind::PutBack,
        (None, "empty") => StepKind::Empty,
        (None, _) => StepKind::Other,
    };
    let things = match wiping {
        Some(wiping) => [&wiping.tool, &wiping.medium, &wiping.surface].map(|it| Some(it.clone())),
        None => [tool.map(str::to_owned), None, None],
    };
    RememberedStep {
        kind,
        words: step.words.clone(),
        things,
        times: [step.began_s, step.expected_s, step.took_s],
        is_met: wiping.map(|_| outcome_of(step)),
        serves: Vec::new(),
        episode: None,
    }
}

/// Returns whether the goal of a wiping step was met.
fn outcome_of(step: &TakenStep) -> GoalOutcome {
    let stated = (step.summary.as_ref()).and_then(|summary| summary.prediction.as_ref());
    match (step.goal_met, stated.map(|stated| stated.goal)) {
        (Some(true), _) => GoalOutcome::Met,
        (_, Some("unknown")) => GoalOutcome::Unknown,
        _ => GoalOutcome::NotMet,
    }
}

/// Describes a part. `last`: the last step that was to bring it about; if it allows no verdict, neither does the part.
fn remember_part(part: &GoalPart, last: Option<&TakenStep>) -> RememberedPart {
    let outcome = match (part.holds, last.map(outcome_of)) {
        (true, _) => GoalOutcome::Met,
        (false, Some(GoalOutcome::Unknown)) => GoalOutcome::Unknown,
        (false, _) => GoalOutcome::NotMet,
    };
    RememberedPart {
        part: part.part.clone(),
        outcome,
        why: (part.left_out.clone()).filter(|_| outcome != GoalOutcome::Met),
    }
}
