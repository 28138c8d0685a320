//! The first rounds of a memory in groups: only rounds with the same tool, surface and so on make a
//! series of comparable values.

use super::channel::HealthChannel;
use crate::catalogue::{Catalogue, CatalogueNode, IndividualId, entries};
use crate::id::is_date;
use serde::Serialize;
use std::collections::HashMap;

/// How the values of a run were obtained.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RunSource {
    /// A robot, or another program that executes motions.
    Executed,
    /// The simulated world of this program: its rounds state the true performance.
    Simulated,
    /// A log without a known robot.
    Imported,
}

impl RunSource {
    /// Name of the source in reports for people.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Executed => "executed",
            Self::Simulated => "simulated",
            Self::Imported => "imported logs",
        }
    }
}

/// The first rounds of the same robot, tool, surface, dirt, press force and kind of run, in the order of their ends.
#[derive(Debug, Clone, PartialEq)]
pub struct RunGroup {
    /// Name of the robot, if known.
    pub robot: Option<String>,
    /// Name of the tool.
    pub tool: Option<String>,
    /// Name of the surface.
    pub surface: Option<String>,
    /// Name of the dirt.
    pub medium: Option<String>,
    /// Press force of the task \[N\]; `None` if the episodes do not state it.
    pub press_force_n: Option<f64>,
    /// How the values were obtained.
    pub source: RunSource,
    /// Number of rounds that are left out because their times are no dates, so that they have no place in the order.
    pub undated: usize,
    pub(super) rounds: Vec<FirstRound>,
}

/// The first round of an episode, with its values in the scale of the fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FirstRound {
    /// Begin and end of its episode [s since 1970].
    pub interval: [f64; 2],
    /// Values by channel, in the order of [`HealthChannel::ALL`].
    pub values: [Option<f64>; HealthChannel::ALL.len()],
    /// Performance at which the goal counts as met, and predicted performance \[1\].
    pub target: Option<f64>,
    pub predicted: Option<f64>,
}

impl FirstRound {
    /// Whether the tool was at the surface, and the force shows no contact at any time.
    pub(super) fn shows_no_contact(&self) -> bool {
        self.value(HealthChannel::ContactShare) == Some(0.0)
    }

    pub(super) const fn value(&self, channel: HealthChannel) -> Option<f64> {
        self.values[channel as usize]
    }
}

/// The first round of an episode, as a table of rounds states it. Names have no prefix.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FirstRun {
    /// Name of the robot, if known.
    pub robot: Option<String>,
    /// Name of the tool.
    pub tool: Option<String>,
    /// Name of the surface.
    pub surface: Option<String>,
    /// Name of the dirt.
    pub medium: Option<String>,
    /// Press force of the task \[N\], if the episode states it.
    pub press_force_n: Option<f64>,
    /// Whether the round states the true performance of a simulation.
    pub is_simulated: bool,
    /// Begin and end of its episode [s since 1970].
    pub interval: [f64; 2],
    /// Recorded values in the units of the channels, in the order of [`HealthChannel::ALL`].
    pub values: [Option<f64>; HealthChannel::ALL.len()],
    /// Performance at which the goal counts as met \[1\].
    pub target: Option<f64>,
    /// Performance that the plan predicted \[1\].
    pub predicted: Option<f64>,
}

/// Robot, tool, surface, dirt, press force (by its bits) and source, which are equal in a group.
type GroupKey = ([Option<String>; 4], Option<u64>, RunSource);

/// Relations of a round to robot, tool, surface and dirt.
const THINGS: [&str; 4] = [
    "soma:isPerformedBy",
    "semco:usesTool",
    "semco:actsOnSurface",
    "semco:removesMedium",
];

/// Words of the doubts by which a round of an earlier version states that its force shows no contact, and that the force
/// is not usable or misread.
const NO_CONTACT_FORCE: &str = "its force shows no contact";
const MISREAD: [&str; 2] = ["not used as touch", "× press_force_n"];

/// Collects the first rounds of all episodes, sorted by robot, tool, surface, dirt, force and source.
///
/// Episodes of earlier versions state no press force; they are in a group without one.
pub fn gather_groups(catalogue: &Catalogue) -> Vec<RunGroup> {
    // Only rounds have a number.
    let rounds = catalogue.numbers("semco:round").iter();
    let first = rounds.filter(|(_, number)| *number < 1.5);
    group_runs(first.map(|(round, _)| read_run(catalogue, *round)))
}

fn read_run(catalogue: &Catalogue, round: IndividualId) -> FirstRun {
    let number = |property: &str, of: IndividualId| {
        let value = entries(catalogue.numbers(property), of).first();
        value.map(|(_, value)| *value)
    };
    let [robot, tool, surface, medium] = THINGS.map(|relation| {
        let objects = entries(catalogue.relations(relation), round);
        objects.first().map(|(_, node)| name_of(catalogue, *node))
    });
    let action = catalogue.parent(round);
    let mut values = HealthChannel::ALL.map(|channel| number(channel.property(), round));
    let share = &mut values[HealthChannel::ContactShare as usize];
    if share.is_none() && states_no_contact(catalogue, round) {
        *share = Some(0.0);
    }
    FirstRun {
        robot,
        tool,
        surface,
        medium,
        press_force_n: number("semco:pressForce", round),
        is_simulated: number("semco:simulatedPerformance", round).is_some(),
        interval: catalogue.episode_of(round).interval,
        values,
        target: action.and_then(|action| number("semco:target", action)),
        predicted: number("semco:predictedPerformance", round),
    }
}

/// Whether the doubts of a round say that its force shows no contact. Episodes of earlier versions state no contact share
/// then.
fn states_no_contact(catalogue: &Catalogue, round: IndividualId) -> bool {
    let doubts = entries(catalogue.texts("semco:doubt"), round).iter();
    let mut doubts = doubts.map(|(_, doubt)| doubt.as_str());
    doubts.any(|doubt| {
        doubt.contains(NO_CONTACT_FORCE) && !MISREAD.iter().any(|word| doubt.contains(word))
    })
}

/// Groups first rounds whose values are comparable, sorted by robot, tool, surface, dirt, force and source.
///
/// `runs`: one first round of each episode, in the order of the episodes' names. Numbers that are not finite count as
/// not recorded. A round with a contact share of 0 counts with a contact force of 0 N.
///
/// ```
/// use wisch_memory::health::{FirstRun, RunSource, group_runs};
/// let run = FirstRun { interval: [1.79e9, 1.79e9 + 60.0], ..FirstRun::default() };
/// assert_eq!(group_runs([run])[0].source, RunSource::Imported);
/// ```
pub fn group_runs(runs: impl IntoIterator<Item = FirstRun>) -> Vec<RunGroup> {
    let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
    let mut groups: Vec<RunGroup> = Vec::new();
    let mut places: HashMap<GroupKey, usize> = HashMap::new();
    for run in runs {
        let force = finite(run.press_force_n).filter(|force| *force > 0.0);
        let source = if run.is_simulated {
            RunSource::Simulated
        } else if run.robot.is_some() {
            RunSource::Executed
        } else {
            RunSource::Imported
        };
        let things = [run.robot, run.tool, run.surface, run.medium];
        let key = (things, force.map(f64::to_bits), source);
        let place = *places.entry(key).or_insert_with_key(|(things, ..)| {
            let [robot, tool, surface, medium] = things.clone();
            groups.push(RunGroup {
                robot,
                tool,
                surface,
                medium,
                press_force_n: force,
                source,
                undated: 0,
                rounds: Vec::new(),
            });
            groups.len() - 1
        });
        let group = &mut groups[place];
        if !run.interval.iter().all(|time| is_date(*time)) {
            group.undated += 1;
            continue;
        }
        let mut values =
            HealthChannel::ALL.map(|channel| channel.scale(finite(run.values[channel as usize])?));
        // Without contact there is no force during contact: the tool pressed with 0 N.
        if values[HealthChannel::ContactShare as usize] == Some(0.0) {
            values[HealthChannel::ContactForce as usize].get_or_insert(0.0);
        }
        group.rounds.push(FirstRound {
            interval: run.interval,
            values,
            target: finite(run.target),
            predicted: finite(run.predicted),
        });
    }
    for group in &mut groups {
        // Equal times keep the order of the runs.
        let time = |round: &FirstRound| [round.interval[1], round.interval[0]];
        group.rounds.sort_by(|a, b| {
            let [a, b] = [time(a), time(b)];
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
        });
    }
    groups.sort_by(|a, b| key(a).cmp(&key(b)));
    groups
}

/// Returns the order of a group among others.
fn key(group: &RunGroup) -> ([&Option<String>; 4], Option<u64>, RunSource) {
    let things = [&group.robot, &group.tool, &group.surface, &group.medium];
    // Positive numbers and their bits have the same order.
    (things, group.press_force_n.map(f64::to_bits), group.source)
}

/// Returns the name of a thing, without prefix.
fn name_of(catalogue: &Catalogue, node: CatalogueNode) -> String {
    match node {
        CatalogueNode::Individual(id) => catalogue.name(id),
        CatalogueNode::Shared(number) => {
            let name = &catalogue.shared_individuals()[number as usize];
            name.split_once(':')
                .map_or(name.as_str(), |(_, name)| name)
                .to_owned()
        }
    }
}
