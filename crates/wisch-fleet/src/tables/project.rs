//! Conversion of an episode's record to rows.

use super::columns::TABLES;
use super::rows::{Cell, Rows};
use super::telemetry;
use wisch_memory::{Episode, EpisodeRecord, Individual, MemoryError, Origin, Value};

pub(super) const UNKNOWN_ROBOT: &str = "unknown";
const SECONDS_PER_DAY: f64 = 86_400.0;
const MOTIONS: [&str; 5] = ["Approach", "Stroke", "Transfer", "Drive", "Retreat"];
const COLLISIONS: [&str; 2] = ["Collision", "HumanCollision"];
/// Relations to participants.
const ROLES: [&str; 5] = [
    "semco:usesTool",
    "semco:removesMedium",
    "semco:actsOnSurface",
    "soma:isPerformedBy",
    "dul:hasParticipant",
];

/// Archives of an episode; empty for a local memory.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Keep {
    /// SHA-256 of the episode's check sums, which distinguishes episodes with the same name.
    pub identity: Option<String>,
    /// SHA-256 and length [bytes] of its archive.
    pub archive: Option<(String, u64)>,
    /// SHA-256 and length [bytes] of the archive of its telemetry.
    pub telemetry: Option<(String, u64)>,
}

/// Rows of some episodes, of all tables.
pub struct Projection {
    tables: [Rows; 7],
}

/// Returns the robot of an episode.
pub fn robot_of(record: &EpisodeRecord) -> String {
    let mut all = record.individuals.iter();
    let performer = all.find_map(|one| one.relations.get("soma:isPerformedBy")?.first());
    performer
        .map_or(UNKNOWN_ROBOT, |name| local(name))
        .to_owned()
}

/// Returns the day on which an episode began: days since 1970, UTC.
pub fn day_of(start: f64) -> i32 {
    (start / SECONDS_PER_DAY).floor() as i32
}

impl Default for Projection {
    fn default() -> Self {
        Self {
            tables: std::array::from_fn(|place| Rows::new(&TABLES[place])),
        }
    }
}

impl Projection {
    /// Returns the rows of each table that has some.
    pub fn into_tables(self) -> impl Iterator<Item = Rows> {
        self.tables.into_iter().filter(|rows| !rows.is_empty())
    }

    /// Rows of a table, by its index in [`TABLES`].
    pub fn rows(&mut self, table: usize) -> &mut Rows {
        &mut self.tables[table]
    }

    /// Adds the rows of an episode's record; `robot` is the name of its robot.
    pub fn add(&mut self, robot: &str, record: &EpisodeRecord, keep: &Keep) {
        let about = About::new(robot, record);
        let rounds = round_of_each(record);
        let [episodes, others @ ..] = &mut self.tables;
        let [rounds_rows, strokes, motions, events, participants, _] = others;
        episodes.push(&about.episode(keep));
        for (place, one) in record.individuals.iter().enumerate() {
            let class = local(&one.class);
            let part = Part {
                about: &about,
                place,
                class,
                one,
                round: rounds[place],
            };
            match class {
                "WipingRound" => rounds_rows.push(&part.round()),
                "Stroke" => {
                    strokes.push(&part.stroke());
                    motions.push(&part.motion());
                }
                class if MOTIONS.contains(&class) => motions.push(&part.motion()),
                "WipingEpisode" | "WipingAction" | "GoalEpisode" | "GoalAction" => {}
                // A step towards a goal of several parts; its wiping has an episode of its own.
                _ if one.values.contains_key("semco:step") => {}
                // An individual with a time that is not a motion is an event; one without a time, such as the task, is
                // not.
                _ if one.interval.is_some() => events.push(&part.event()),
                _ => {}
            }
            for role in ROLES {
                for name in one.relations.get(role).into_iter().flatten() {
                    participants.push(&part.participant(role, name));
                }
            }
        }
    }

    /// Adds the telemetry of an episode.
    ///
    /// # Errors
    /// If telemetry cannot be read.
    pub fn add_telemetry(
        &mut self,
        robot: &str,
        record: &EpisodeRecord,
        episode: &Episode,
    ) -> Result<(), MemoryError> {
        let day = day_of(record.interval[0]);
        for (index, start) in record.rounds.iter().enumerate() {
            let round = index + 1;
            if episode.has_telemetry(round)? {
                let log = episode.telemetry(round)?;
                let row = telemetry::Of {
                    robot,
                    day,
                    episode: &record.id,
                    round: whole(round),
                    start: *start,
                };
                telemetry::add(&mut self.tables[6], &row, &log)?;
            }
        }
        Ok(())
    }
}

/// Returns number and index of the round that each individual is part of.
fn round_of_each(record: &EpisodeRecord) -> Vec<Option<usize>> {
    let mut rounds: Vec<Option<usize>> = Vec::with_capacity(record.individuals.len());
    for (place, one) in record.individuals.iter().enumerate() {
        let is_round = local(&one.class) == "WipingRound";
        let above = one.parent.and_then(|parent| rounds[parent]);
        rounds.push(if is_round { Some(place) } else { above });
    }
    rounds
}

/// Values that all rows of an episode share.
struct About<'a> {
    record: &'a EpisodeRecord,
    robot: &'a str,
    day: i32,
}

impl<'a> About<'a> {
    fn new(robot: &'a str, record: &'a EpisodeRecord) -> Self {
        Self {
            record,
            robot,
            day: day_of(record.interval[0]),
        }
    }

    fn head(&self) -> [Cell<'a>; 3] {
        [
            Cell::Text(Some(self.robot)),
            Cell::Day(self.day),
            Cell::Text(Some(&self.record.id)),
        ]
    }

    fn episode<'b>(&'b self, keep: &'b Keep) -> Vec<Cell<'b>> {
        let record = self.record;
        let of_class = |class: &str| record.individuals.iter().find(|one| one.class == class);
        let action = of_class("semco:WipingAction").or_else(|| of_class("semco:GoalAction"));
        let number = |name: &str| Cell::Number(action.and_then(|one| number(one, name)));
        let text = |name: &str| Cell::Text(action.and_then(|one| text(one, name)));
        let thing = |name: &str| Cell::Text(action.and_then(|one| related(one, name)));
        let task = action.and_then(|one| one.relations.get("dul:executesTask")?.first());
        let task = task.and_then(|name| name.strip_prefix('#')?.parse::<usize>().ok());
        let task = task.and_then(|place| record.individuals.get(place));
        let collides = |one: &&Individual| COLLISIONS.contains(&local(&one.class));
        let collisions = record.individuals.iter().filter(collides).count();
        let sum = |kept: &'b Option<(String, u64)>| {
            [
                Cell::Text(kept.as_ref().map(|(sum, _)| sum.as_str())),
                Cell::Long(kept.as_ref().map(|(_, bytes)| *bytes as i64)),
            ]
        };
        let [archive, archive_bytes] = sum(&keep.archive);
        let [telemetry, telemetry_bytes] = sum(&keep.telemetry);
        let [robot, day, episode] = self.head();
        vec![
            robot,
            day,
            episode,
            Cell::Number(Some(record.interval[0])),
            Cell::Number(Some(record.interval[1])),
            Cell::Text(Some(&record.task)),
            Cell::Text(Some(match &record.origin {
                Origin::Simulated => "simulated",
                Origin::Executor(_) => "executor",
                Origin::Imported(log) => log,
            })),
            Cell::Text(Some(&record.program)),
            // SQL has no unsigned integers: the upper half becomes negative.
            Cell::Long(Some(record.seed as i64)),
            Cell::Text(task.map(|one| local(&one.class))),
            thing("semco:usesTool"),
            thing("semco:removesMedium"),
            thing("semco:actsOnSurface"),
            text("semco:strategy"),
            text("semco:goal"),
            number("semco:target"),
            Cell::Whole(Some(whole(record.rounds.len()))),
            Cell::Whole(Some(whole(collisions))),
            number("semco:predictedPerformance"),
            Cell::Number(action.and_then(Individual::performance)),
            number("semco:performanceLow"),
            number("semco:performanceHigh"),
            number("semco:simulatedPerformance"),
            Cell::Truth(action.and_then(succeeded)),
            Cell::Text(keep.identity.as_deref()),
            archive,
            archive_bytes,
            telemetry,
            telemetry_bytes,
        ]
    }
}

/// An individual and its position in the record.
struct Part<'a> {
    about: &'a About<'a>,
    place: usize,
    class: &'a str,
    one: &'a Individual,
    /// Index of its round.
    round: Option<usize>,
}

impl<'a> Part<'a> {
    fn number(&self, name: &str) -> Cell<'a> {
        Cell::Number(number(self.one, name))
    }

    fn text(&self, name: &str) -> Cell<'a> {
        Cell::Text(text(self.one, name))
    }

    fn count(&self, name: &str) -> Cell<'a> {
        Cell::Whole(number(self.one, name).map(|value| value as i32))
    }

    fn place(&self) -> Cell<'a> {
        Cell::Whole(Some(whole(self.place)))
    }

    fn times(&self) -> [Cell<'a>; 2] {
        let times = self.one.interval;
        [
            Cell::Number(times.map(|[start, _]| start)),
            Cell::Number(times.map(|[_, end]| end)),
        ]
    }

    /// Returns the round that it is part of.
    fn whose(&self) -> Option<&'a Individual> {
        self.round
            .map(|place| &self.about.record.individuals[place])
    }

    fn round_number(&self) -> Cell<'a> {
        let number = self.whose().and_then(|one| number(one, "semco:round"));
        Cell::Whole(number.map(|number| number as i32))
    }

    fn of_round(&self, name: &str) -> Cell<'a> {
        Cell::Text(self.whose().and_then(|one| related(one, name)))
    }

    fn round(&self) -> [Cell<'a>; 27] {
        let [robot, day, episode] = self.about.head();
        let [start, end] = self.times();
        [
            robot,
            day,
            episode,
            self.round_number(),
            self.place(),
            start,
            end,
            self.of_round("semco:usesTool"),
            self.of_round("semco:removesMedium"),
            self.of_round("semco:actsOnSurface"),
            self.count("semco:strokes"),
            self.number("semco:predictedPerformance"),
            Cell::Number(self.one.performance()),
            self.number("semco:performanceLow"),
            self.number("semco:performanceHigh"),
            self.number("semco:simulatedPerformance"),
            self.number("semco:contactShare"),
            self.number("semco:meanNormalForce"),
            self.number("semco:forceBias"),
            self.number("semco:planeTilt"),
            self.number("semco:planeOffset"),
            self.text("semco:verdict"),
            self.text("semco:diagnosis"),
            self.text("semco:ending"),
            Cell::Truth(succeeded(self.one)),
            self.number("semco:pressForce"),
            self.number("semco:toolStiffness"),
        ]
    }

    fn stroke(&self) -> [Cell<'a>; 13] {
        let [robot, day, episode] = self.about.head();
        let [start, end] = self.times();
        [
            robot,
            day,
            episode,
            self.round_number(),
            self.place(),
            self.count("semco:stroke"),
            start,
            end,
            self.of_round("semco:usesTool"),
            self.of_round("semco:actsOnSurface"),
            self.number("semco:contactShare"),
            self.number("semco:meanNormalForce"),
            self.number("semco:peakForce"),
        ]
    }

    fn motion(&self) -> [Cell<'a>; 8] {
        let [robot, day, episode] = self.about.head();
        let [start, end] = self.times();
        [
            robot,
            day,
            episode,
            self.round_number(),
            self.place(),
            Cell::Text(Some(self.class)),
            start,
            end,
        ]
    }

    fn event(&self) -> [Cell<'a>; 22] {
        let [robot, day, episode] = self.about.head();
        let [start, end] = self.times();
        let all = &self.about.record.individuals;
        let parent = self
            .one
            .parent
            .map(|parent| (parent, local(&all[parent].class)));
        let during = parent.filter(|(_, class)| MOTIONS.contains(class));
        [
            robot,
            day,
            episode,
            self.round_number(),
            self.place(),
            Cell::Text(Some(self.class)),
            start,
            end,
            Cell::Whole(during.map(|(place, _)| whole(place))),
            Cell::Text(during.map(|(_, class)| class)),
            self.of_round("semco:usesTool"),
            self.count("semco:samples"),
            self.number("semco:meanNormalForce"),
            self.number("semco:peakForce"),
            self.number("semco:peakHeight"),
            self.number("semco:edgeDistance"),
            self.text("semco:warningChannel"),
            self.number("semco:warningValue"),
            self.number("semco:bandLow"),
            self.number("semco:bandHigh"),
            self.number("semco:pValue"),
            self.text("semco:alikeEpisodes"),
        ]
    }

    fn participant<'b>(&'b self, role: &'static str, name: &'b str) -> [Cell<'b>; 7] {
        let [robot, day, episode] = self.about.head();
        [
            robot,
            day,
            episode,
            self.place(),
            Cell::Text(Some(self.class)),
            Cell::Text(Some(local(role))),
            Cell::Text(Some(local(name))),
        ]
    }
}

fn number(one: &Individual, name: &str) -> Option<f64> {
    match one.values.get(name) {
        Some(Value::Number(value)) => Some(*value),
        _ => None,
    }
}

fn text<'a>(one: &'a Individual, name: &str) -> Option<&'a str> {
    match one.values.get(name) {
        Some(Value::Text(value)) => Some(value),
        _ => None,
    }
}

/// Returns the first object of a relation.
fn related<'a>(one: &'a Individual, name: &str) -> Option<&'a str> {
    one.relations.get(name)?.first().map(|name| local(name))
}

fn succeeded(one: &Individual) -> Option<bool> {
    let states = one.relations.get("soma:hasExecutionState")?;
    Some(
        states
            .iter()
            .any(|state| state == "soma:ExecutionState_Succeeded"),
    )
}

/// Returns a name without its prefix.
fn local(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}

fn whole(number: usize) -> i32 {
    i32::try_from(number).unwrap_or(i32::MAX)
}
