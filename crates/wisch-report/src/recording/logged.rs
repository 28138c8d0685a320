//! The recording of an episode that was kept without one: what its telemetry and its events show.

use super::interpreted::EventRecord;
use super::phases::PhaseRecord;
use super::samples::round_to;
use serde::Serialize;
use wisch::geometry::{Polygon, Pose};
use wisch::plan::Strategy;
use wisch::represent::{Surface, Task};
use wisch::robot::{LinkId, RobotModel};

/// An episode that was kept without a recording, for example an imported log.
#[derive(Debug, Clone, Copy)]
pub struct LoggedEpisode<'a> {
    /// Headline.
    pub title: &'a str,
    /// Name and version of the program that kept the episode.
    pub program: &'a str,
    /// Its task; `None` if it is unknown.
    pub task: Option<LoggedTask<'a>>,
    /// Its robot; `None` if only poses of the tool are known.
    pub robot: Option<LoggedRobot<'a>>,
}

/// The task of an episode, as a recording shows it.
#[derive(Debug, Clone, Copy)]
pub struct LoggedTask<'a> {
    /// The task.
    pub task: &'a Task,
    /// Strategy that plans the strokes.
    pub strategy: Strategy,
    /// Target performance, in [0, 1].
    pub target: f64,
}

/// The robot of an episode, as a recording shows it.
#[derive(Debug, Clone, Copy)]
pub struct LoggedRobot<'a> {
    /// Its model.
    pub model: &'a RobotModel,
    /// Link that holds the tool.
    pub tip: LinkId,
    /// Pose of the tool in the frame of that link.
    pub tip_from_tool: Pose,
}

/// A round of such an episode. Times are in seconds since the round began.
#[derive(Debug, Clone)]
pub struct LoggedRound<'a> {
    /// Its number, from 1.
    pub number: usize,
    /// Its duration \[s\].
    pub duration: f64,
    /// Pose of the robot's root in the world; `None` without a robot.
    pub world_from_root: Option<Pose>,
    /// Believed pose of the surface; `None` shows it where the task believed it.
    pub world_from_surface: Option<Pose>,
    /// The task; `None` if it is unknown.
    pub task: Option<&'a Task>,
    /// Its actions and events.
    pub occurrences: Vec<LoggedOccurrence<'a>>,
}

/// An action or event of a round.
#[derive(Debug, Clone, Copy)]
pub struct LoggedOccurrence<'a> {
    /// Its name in the memory.
    pub name: &'a str,
    /// Its class in the ontology, without prefix, such as "Stroke".
    pub class: &'a str,
    /// Start and end since the round began \[s\].
    pub interval: [f64; 2],
    /// Whether something collided with the robot.
    pub is_collision: bool,
}

/// Fields that only the piece of a logged round has.
#[derive(Serialize)]
pub(super) struct Log {
    events: Vec<EventRecord>,
    contacts: Vec<[f64; 2]>,
}

impl LoggedRound<'_> {
    /// Returns the surface that is shown; without outline if the task is unknown.
    pub(super) fn surface(&self) -> Surface {
        let nowhere = || {
            let outline = Polygon::new(Vec::new(), Vec::new());
            Surface::new("", outline, Pose::identity())
        };
        let mut surface = (self.task).map_or_else(nowhere, |task| task.surface.clone());
        if let Some(world_from_surface) = self.world_from_surface {
            surface.world_from_surface = world_from_surface;
        }
        surface
    }
}

/// Divides the occurrences of a round into its phases and the rest.
pub(super) fn lanes(occurrences: &[LoggedOccurrence<'_>]) -> (Vec<PhaseRecord>, Log) {
    let (mut phases, mut strokes) = (Vec::new(), 0);
    let mut log = Log {
        events: Vec::new(),
        contacts: Vec::new(),
    };
    for occurrence in occurrences {
        let [start, end] = occurrence.interval.map(|time| round_to(time, 1e3));
        let name = match occurrence.class {
            "WipingRound" => continue,
            "ToolContact" => {
                log.contacts.push([start, end]);
                continue;
            }
            "Stroke" => "wipe",
            "Approach" => "approach",
            "Transfer" => "free motion",
            "Drive" => "drive",
            "Retreat" => "retreat",
            "Motion" => "motion",
            class => {
                log.events.push(EventRecord {
                    kind: split_words(class).into(),
                    start,
                    end,
                    words: occurrence.name.to_owned(),
                    by_hand: occurrence.is_collision,
                });
                continue;
            }
        };
        let contact = occurrence.class == "Stroke";
        phases.push(PhaseRecord {
            name,
            start,
            end,
            contact,
            stroke: contact.then_some(strokes),
        });
        strokes += usize::from(contact);
    }
    phases.sort_by(|a, b| a.start.total_cmp(&b.start));
    (phases, log)
}

/// Returns the name of a class in words: "HumanCollision" as "human collision".
fn split_words(class: &str) -> String {
    let mut words = String::new();
    for letter in class.chars() {
        if letter.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    fn occurrence(class: &'static str, interval: [f64; 2]) -> LoggedOccurrence<'static> {
        LoggedOccurrence {
            name: "it",
            class,
            interval,
            is_collision: class == "HumanCollision",
        }
    }

    #[test]
    fn every_occurrence_has_its_lane() {
        let (phases, log) = lanes(&[
            occurrence("WipingRound", [0.0, 9.0]),
            occurrence("Stroke", [3.0, 4.0]),
            occurrence("Transfer", [1.0, 3.0]),
            occurrence("Stroke", [5.0, 6.0]),
            occurrence("ToolContact", [3.1, 3.9]),
            occurrence("HumanCollision", [3.25, 3.5]),
            occurrence("StickSlip", [5.0, 5.5]),
        ]);
        let phases: Vec<_> = (phases.iter())
            .map(|phase| (phase.name, phase.start, phase.stroke))
            .collect();
        assert_eq!(
            phases,
            [
                ("free motion", 1.0, None),
                ("wipe", 3.0, Some(0)),
                ("wipe", 5.0, Some(1))
            ]
        );
        assert_eq!(log.contacts, [[3.1, 3.9]]);
        let events: Vec<_> = (log.events.iter())
            .map(|event| (&*event.kind, event.start, event.end, event.by_hand))
            .collect();
        assert_eq!(
            events,
            [
                ("human collision", 3.25, 3.5, true),
                ("stick slip", 5.0, 5.5, false)
            ]
        );
    }
}
