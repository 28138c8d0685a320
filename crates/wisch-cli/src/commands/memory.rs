//! `wisch memory`: lists, shows, verifies and removes the episodes of a memory.

use super::interpret::UNKNOWN;
use super::words::{format_count, internal, percent};
use crate::args::{EpisodeArgs, GlobalArgs, MemoryArgs, MemoryListArgs, MemoryVerifyArgs, suggest};
use crate::failure::Failure;
use crate::terminal::{Outcome, print, print_json, remark};
use serde::Serialize;
use std::collections::BTreeMap;
use wisch_memory::ask::Assertions;
use wisch_memory::catalogue::{EpisodeRow, entries};
use wisch_memory::{
    Catalogue, CatalogueNode, Episode, EpisodeRecord, Individual, IndividualId, Memory,
    MemoryError, Value, is_date, local_date_and_time,
};

/// An episode in the list.
#[derive(Debug, Serialize)]
struct Listed<'a> {
    id: &'a str,
    task: &'a str,
    /// When it began [s since 1970]; null if its times are no dates.
    start_s: Option<f64>,
    #[serde(skip)]
    begin: f64,
    /// Duration of the robot's motions.
    duration_s: f64,
    /// Duration of the program by its machine's clock; absent for imported logs.
    #[serde(skip_serializing_if = "Option::is_none")]
    clock_duration_s: Option<f64>,
    rounds: usize,
    /// Number of steps of a goal of several parts, whose wiping steps have episodes of their own; absent for other episodes.
    #[serde(skip_serializing_if = "Option::is_none")]
    steps: Option<usize>,
    /// Estimated performance after the last round; absent without a wiping action.
    #[serde(skip_serializing_if = "Option::is_none")]
    performance: Option<f64>,
    /// Whether the goal was met; null if that is unknown.
    succeeded: Option<bool>,
    /// `met`, `not met` or `unknown`.
    goal: &'static str,
    /// Number of human collisions; absent for a goal of several parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    human_collisions: Option<usize>,
}

/// Lists the episodes.
pub fn list(args: &MemoryListArgs) -> Result<Outcome, Failure> {
    let catalogue = open(&args.memory)?.catalogue().map_err(memory_failure)?;
    for why in catalogue.omitted_episodes() {
        let verify = suggest("memory verify");
        remark(&format!("{why}: left out; {verify} lists damaged files"));
    }
    let actions = actions(&catalogue);
    let collisions = count_individuals(&catalogue, "semco:HumanCollision");
    let steps = count_steps(&catalogue);
    let mut listed: Vec<Listed<'_>> = catalogue
        .episodes()
        .iter()
        .map(|row| Listed::new(&catalogue, row, &actions, [&collisions, &steps]))
        .collect();
    listed.sort_by(|a, b| a.begin.total_cmp(&b.begin).then(a.id.cmp(b.id)));
    let mut text = String::new();
    if args.json {
        for one in &listed {
            text += &serde_json::to_string(one).map_err(internal)?;
            text.push('\n');
        }
    } else if listed.is_empty() {
        text = "the memory has no episodes; wisch run adds one\n".to_owned();
    } else {
        text = format_table(&listed);
    }
    print(&text)?;
    Ok(Outcome::Done)
}

impl<'a> Listed<'a> {
    fn new(
        catalogue: &'a Catalogue,
        row: &'a EpisodeRow,
        actions: &BTreeMap<IndividualId, IndividualId>,
        [collisions, steps]: [&BTreeMap<IndividualId, usize>; 2],
    ) -> Self {
        let steps = steps.get(&row.first).copied();
        let action = actions.get(&row.first).copied();
        let performance = action.and_then(|action| {
            let found = entries(catalogue.numbers("semco:performance"), action);
            found.first().map(|(_, value)| *value)
        });
        let goal = action.map_or("not met", |action| {
            let states = entries(catalogue.relations("soma:hasExecutionState"), action);
            match states.first() {
                None => UNKNOWN,
                Some((_, CatalogueNode::Shared(place)))
                    if catalogue.shared_individuals()[*place as usize]
                        == "soma:ExecutionState_Succeeded" =>
                {
                    "met"
                }
                Some(_) => "not met",
            }
        });
        Self {
            id: &row.id,
            task: &row.task,
            start_s: Some(row.interval[0]).filter(|start| is_date(*start)),
            begin: row.interval[0],
            clock_duration_s: clock_duration(catalogue, row),
            duration_s: row.interval[1] - row.interval[0],
            rounds: row.rounds.len(),
            steps,
            performance,
            succeeded: (goal != UNKNOWN).then_some(goal == "met"),
            goal,
            human_collisions: (steps.is_none())
                .then(|| collisions.get(&row.first).copied().unwrap_or(0)),
        }
    }
}

impl Listed<'_> {
    /// The number of rounds, or in words that of the steps of a goal of several parts.
    fn rounds_in_words(&self) -> String {
        match self.steps {
            Some(steps) => format_count(steps, "step"),
            None => self.rounds.to_string(),
        }
    }
}

/// Returns the duration of an episode's program by its machine's clock [s]; `None` for an imported log.
fn clock_duration(catalogue: &Catalogue, row: &EpisodeRow) -> Option<f64> {
    let found = entries(catalogue.numbers("semco:clockDuration"), row.first);
    found.first().map(|(_, seconds)| *seconds)
}

/// The wiping of each episode, or the action towards its goal, by the episode's first individual.
fn actions(catalogue: &Catalogue) -> BTreeMap<IndividualId, IndividualId> {
    let of_class = |class| catalogue.individuals_of_class(class).iter();
    let actions = of_class("semco:WipingAction").chain(of_class("semco:GoalAction"));
    let by_episode = actions.map(|&id| (catalogue.episode_of(id).first, id));
    by_episode.collect()
}

/// The number of individuals of a class in each episode, by the episode's first individual.
fn count_individuals(catalogue: &Catalogue, class: &str) -> BTreeMap<IndividualId, usize> {
    let mut counts = BTreeMap::new();
    for &id in catalogue.individuals_of_class(class) {
        *counts.entry(catalogue.episode_of(id).first).or_default() += 1;
    }
    counts
}

/// The number of steps of each goal of several parts, by the episode's first individual.
fn count_steps(catalogue: &Catalogue) -> BTreeMap<IndividualId, usize> {
    let goals = catalogue.individuals_of_class("semco:GoalEpisode").iter();
    let mut counts: BTreeMap<_, _> = goals.map(|&id| (id, 0)).collect();
    for &(step, _) in catalogue.numbers("semco:step") {
        *counts.entry(catalogue.episode_of(step).first).or_default() += 1;
    }
    counts
}

fn format_table(listed: &[Listed<'_>]) -> String {
    let width = |of: fn(&Listed<'_>) -> usize, least: usize| {
        listed.iter().map(of).max().unwrap_or(0).max(least)
    };
    let id = width(|one| one.id.chars().count(), 7);
    let task = width(|one| one.task.chars().count(), 4);
    let rounds = width(|one| one.rounds_in_words().chars().count(), 6);
    let mut text = format!(
        "{:<id$}  {:<task$}  {:<26}  {:>8}  {:>rounds$}  {:>11}  {:<14}  collisions\n",
        "episode", "task", "began", "duration", "rounds", "performance", "goal"
    );
    for one in listed {
        let performance = one.performance.map_or_else(|| "–".to_owned(), percent);
        let duration = format!("{:.1} s", one.duration_s);
        let collisions = (one.human_collisions).map_or_else(|| "–".to_owned(), |n| n.to_string());
        let (goal, began) = (
            one.goal,
            one.start_s.map_or_else(undated, local_date_and_time),
        );
        text += &format!(
            "{:<id$}  {:<task$}  {began:<26}  {duration:>8}  {:>rounds$}  {performance:>11}  {goal:<14}  {collisions:>10}\n",
            one.id,
            one.task,
            one.rounds_in_words()
        );
    }
    text + &format!("{}\n", format_count(listed.len(), "episode"))
}

/// Formats a time [s since 1970] as a local date and time, if it is one.
fn date_if_known(time: f64) -> String {
    let date = Some(time).filter(|time| is_date(*time));
    date.map_or_else(undated, local_date_and_time)
}

fn undated() -> String {
    "date unknown".to_owned()
}

/// Shows an episode.
pub fn show(args: &EpisodeArgs) -> Result<Outcome, Failure> {
    let episode = open(&args.memory)?
        .episode(&args.id)
        .map_err(memory_failure)?;
    let record = episode.record().map_err(memory_failure)?;
    if args.json {
        print_json(&record)?;
    } else {
        let files = episode.files().map_err(memory_failure)?;
        let stamps = stamps_in_words(&episode, record.rounds.len())?;
        print(&(in_words(&record, &files) + &stamps))?;
    }
    Ok(Outcome::Done)
}

fn in_words(record: &EpisodeRecord, files: &[String]) -> String {
    let [start, end] = record.interval;
    let mut text = format!(
        "{}: {}, {}, {:.1} s, by {}\n",
        record.id,
        record.task,
        date_if_known(start),
        end - start,
        record.program
    );
    let mut depths: Vec<usize> = Vec::new();
    for individual in &record.individuals {
        let depth = individual.parent.map_or(0, |parent| depths[parent] + 1);
        depths.push(depth);
        text += &line(individual, depth, start);
    }
    text + &format!("  files: {}\n", files.join(", "))
}

/// States the absolute times that the robot's driver has given to the samples, a line for each round that has them.
fn stamps_in_words(episode: &Episode, rounds: usize) -> Result<String, Failure> {
    let mut text = String::new();
    for round in 1..=rounds {
        if !episode.has_telemetry(round).map_err(memory_failure)? {
            continue;
        }
        let telemetry = episode.telemetry(round).map_err(memory_failure)?;
        let Some(clock) = telemetry.stamp_clock() else {
            continue;
        };
        let stamps = telemetry.stamps();
        let stamps = stamps.map_err(|error| memory_failure(MemoryError::from(error)))?;
        let seconds = |nanoseconds: u64| nanoseconds as f64 / 1e9;
        let stated = stamps.into_iter().flatten().map(|stamp| stamp.nanoseconds);
        let stated: Vec<f64> = stated.map(seconds).collect();
        if let (Some(first), Some(last)) = (stated.first(), stated.last()) {
            let count = format_count(stated.len(), "sample");
            text += &format!(
                "  stamps of round {round}: {count} from {first:.3} s to {last:.3} s on the clock {:?} of the driver\n",
                clock.as_str()
            );
        }
    }
    Ok(text)
}

/// Formats an individual as one line.
fn line(individual: &Individual, depth: usize, start: f64) -> String {
    let time = individual.interval.map_or_else(String::new, |[from, to]| {
        format!("{:.2} to {:.2} s", from - start, to - start)
    });
    let name = local(&individual.class);
    let name = format!("{:indent$}{name}", "", indent = 2 * depth + 2);
    let values = individual.values.iter().map(|(property, value)| {
        let property = local(property);
        match value {
            Value::Number(number) => format!("{property} {}", format_short(*number)),
            Value::Text(text) => format!("{property} {text:?}"),
        }
    });
    let values: Vec<String> = values.collect();
    let line = format!("{name:<26} {time:<20} {}", values.join(", "));
    format!("{}\n", line.trim_end())
}

/// Formats a number with at most four decimals.
fn format_short(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A name without its prefix.
fn local(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}

/// The object that `verify --json` prints.
#[derive(Debug, Serialize)]
struct Verified {
    episodes: usize,
    faults: Vec<String>,
}

/// Verifies all episodes and prints the faults.
pub fn verify(args: &MemoryVerifyArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let memory = open(&args.memory)?;
    let episodes = memory.episodes().map_err(memory_failure)?.len();
    let faults = memory.verify().map_err(memory_failure)?;
    let mut faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
    faults.extend(memory.ignored_episodes().map_err(memory_failure)?);
    faults.extend(
        Assertions::read(memory.folder())
            .err()
            .map(|error| error.to_string()),
    );
    faults.extend(list_future_episodes(
        &memory.catalogue().map_err(memory_failure)?,
    ));
    let is_well = faults.is_empty();
    if args.json {
        print_json(&Verified { episodes, faults })?;
    } else if !global.quiet || !is_well {
        let mut text: String = faults.iter().map(|fault| format!("{fault}\n")).collect();
        let found = if is_well {
            "no faults".to_owned()
        } else {
            format_count(faults.len(), "fault")
        };
        text += &format!("{}: {found}\n", format_count(episodes, "episode"));
        print(&text)?;
    }
    Ok(if is_well {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// Reports episodes that end in the future of this machine's clock. A simulation may be faster than the clock, so an episode
/// with both durations ends after the shorter one.
fn list_future_episodes(catalogue: &Catalogue) -> Vec<String> {
    let now = wisch_record::unix_time();
    let end_of = |row: &EpisodeRow| {
        let clock = clock_duration(catalogue, row).unwrap_or(f64::INFINITY);
        row.interval[1].min(row.interval[0] + clock)
    };
    let ahead = (catalogue.episodes().iter()).filter(|row| end_of(row) > now + 1.0);
    let faults = ahead.map(|row| {
        let [begin, end] = row.interval.map(local_date_and_time);
        format!(
            "{}: its interval, {begin} to {end}, ends in the future: the clock was fast then, is slow now, or a duration \
             is wrong",
            row.id
        )
    });
    faults.collect()
}

/// Removes an episode.
pub fn forget(args: &EpisodeArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    open(&args.memory)?
        .forget(&args.id)
        .map_err(memory_failure)?;
    if args.json {
        print_json(&serde_json::json!({ "forgotten": args.id }))?;
    } else if !global.quiet {
        print(&format!("forgot {}\n", args.id))?;
    }
    Ok(Outcome::Done)
}

/// Opens the memory of the arguments.
///
/// # Errors
/// If the folder is no memory; the advice says how to create one.
pub(super) fn open(args: &MemoryArgs) -> Result<Memory, Failure> {
    Memory::open(&args.memory).map_err(|error| {
        Failure::new(error)
            .with_help("wisch run creates a memory; choose another folder with --memory DIR")
    })
}

/// Returns a failure from an error of the memory, with advice.
pub(super) fn memory_failure(error: MemoryError) -> Failure {
    let help = match error {
        MemoryError::Unknown { .. } => format!("{} lists the episodes", suggest("memory list")),
        _ if error.is_disk_full() => "free space on the disk of the memory".to_owned(),
        _ => format!(
            "{} lists damaged files, {} removes an episode",
            suggest("memory verify"),
            suggest("memory forget ID")
        ),
    };
    Failure::new(error).with_help(help)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_that_is_counted_from_0_is_no_date() {
        for time in [0.0, 12.5, 1e5] {
            assert_eq!(date_if_known(time), "date unknown");
        }
        assert!(date_if_known(1_795_309_772.0).starts_with("2026-11-2"));
    }
}
