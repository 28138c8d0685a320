//! Export of a stored episode to a NEEM: its record, and poses and wrenches from its telemetry.

use super::NeemError;
use super::observation::NeemRound;
use super::writer::{FrameSample, NeemWriter, WrenchSample};
use crate::frames::Frames;
use crate::record::EpisodeRecord;
use crate::store::Episode;
use crate::telemetry::{POSE, Telemetry};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use std::collections::BTreeSet;
use wisch::geometry::Pose;
use wisch::robot::RobotModel;

/// Number of rows in memory at once.
const ROWS: usize = 10_000;

/// Frame of all poses and wrenches.
const WORLD: &str = "world";

const FORCE: [&str; 3] = ["fx", "fy", "fz"];
const TORQUE: [&str; 3] = ["mx", "my", "mz"];

/// The source of the poses in a NEEM.
#[derive(Debug, Clone, Copy)]
pub enum PoseSource<'a> {
    /// The tool's measured pose; gives the tool's frame only.
    Tool,
    /// The joints of this robot; gives its links, the robot, the tool and the surface.
    Robot(&'a RobotModel),
}

impl NeemWriter {
    /// Writes a stored episode: its triples, poses and wrenches of all rounds with telemetry, and camera observations.
    ///
    /// # Errors
    /// As the other methods; also if the episode cannot be read or its telemetry belongs to another robot.
    pub fn write_stored_episode(
        &mut self,
        episode: &Episode,
        poses: PoseSource,
    ) -> Result<(), NeemError> {
        let record = episode.record()?;
        self.episode(&record)?;
        let files = episode.files()?;
        for (number, &start) in (1..).zip(&record.rounds) {
            if let Some(seen) = episode.observations(number)? {
                // Rounds follow each other without pauses.
                let end = record.rounds.get(number).copied();
                let round = NeemRound {
                    episode: &record.id,
                    number,
                    interval: [start, end.unwrap_or(record.interval[1])],
                    surface: related_name(&record, "semco:actsOnSurface", "surface"),
                };
                self.observations(&round, &seen)?;
            }
            if !files.contains(&format!("round-{number}.parquet")) {
                continue;
            }
            let telemetry = episode.telemetry(number)?;
            self.wrenches_of(&telemetry, start)?;
            match poses {
                PoseSource::Tool => self.tool_of(
                    &telemetry,
                    start,
                    related_name(&record, "semco:usesTool", "tool"),
                )?,
                PoseSource::Robot(robot) => self.frames_of(&telemetry, start, robot)?,
            }
        }
        Ok(())
    }

    fn wrenches_of(&mut self, telemetry: &Telemetry, start: f64) -> Result<(), NeemError> {
        for what in ["controller", "external"] {
            let topic = format!("wrench/{what}");
            let named = |parts: &[&str]| -> Vec<String> {
                parts.iter().map(|part| format!("{what}/{part}")).collect()
            };
            let mut columns = named(&FORCE);
            let torque = named(&TORQUE);
            if has_all(telemetry, &torque) {
                columns.extend(torque);
            }
            each_row(telemetry, &columns, |time, row| {
                let Some((&force, torque)) = row.split_first_chunk() else {
                    return Ok(());
                };
                self.wrench(&WrenchSample {
                    time: start + time,
                    frame: WORLD,
                    topic: &topic,
                    force,
                    torque: torque.first_chunk().copied(),
                })
            })?;
        }
        Ok(())
    }

    fn tool_of(&mut self, telemetry: &Telemetry, start: f64, tool: &str) -> Result<(), NeemError> {
        let columns = POSE.map(|part| format!("measured/{part}"));
        each_row(telemetry, &columns, |time, row| {
            let &[x, y, z, qx, qy, qz, qw] = row else {
                return Ok(());
            };
            let rotation = UnitQuaternion::from_quaternion(Quaternion::new(qw, qx, qy, qz));
            self.frame(&FrameSample {
                time: start + time,
                frame: tool,
                parent: WORLD,
                parent_from_frame: Pose::from_parts(Translation3::new(x, y, z), rotation),
            })
        })
    }

    fn frames_of(
        &mut self,
        telemetry: &Telemetry,
        start: f64,
        robot: &RobotModel,
    ) -> Result<(), NeemError> {
        let frames = Frames::new(robot, telemetry)?;
        let scene = frames.scene();
        let mut names = BTreeSet::from([scene.tool.as_str(), &scene.robot, &scene.surface]);
        names.extend(robot.links().iter().map(|link| link.name.as_str()));
        let mut last = f64::NEG_INFINITY;
        each_row(telemetry, &[], |time, _| {
            if time - last < self.shortest_period() {
                return Ok(());
            }
            last = time;
            for &frame in &names {
                self.frame(&FrameSample {
                    time: start + time,
                    frame,
                    parent: WORLD,
                    parent_from_frame: frames.pose(frame, time)?.world_from_frame,
                })?;
            }
            Ok(())
        })
    }
}

/// Local name of the first object of an episode's relation, or `otherwise` without one.
fn related_name<'a>(record: &'a EpisodeRecord, property: &str, otherwise: &'a str) -> &'a str {
    let mut related = (record.individuals.iter())
        .filter_map(|individual| individual.relations.get(property)?.first());
    let name = related.next().and_then(|name| name.split_once(':'));
    name.map_or(otherwise, |(_, local)| local)
}

/// Calls back with time [s since the round began] and values of each row; with none if a column is missing.
fn each_row(
    telemetry: &Telemetry,
    columns: &[String],
    mut row: impl FnMut(f64, &[f64]) -> Result<(), NeemError>,
) -> Result<(), NeemError> {
    let known = telemetry.columns();
    if columns
        .iter()
        .any(|column| !known.contains(&column.as_str()))
    {
        return Ok(());
    }
    let mut values = vec![0.0; columns.len()];
    for from in (0..telemetry.rows()).step_by(ROWS) {
        let rows = from..(from + ROWS).min(telemetry.rows());
        let times = telemetry.times(rows.clone())?;
        let block: Vec<Vec<f64>> = columns
            .iter()
            .map(|column| telemetry.values(column, rows.clone()))
            .collect::<Result<_, _>>()?;
        for (place, &time) in times.iter().enumerate() {
            for (value, column) in values.iter_mut().zip(&block) {
                *value = column[place];
            }
            row(time, &values)?;
        }
    }
    Ok(())
}

fn has_all(telemetry: &Telemetry, columns: &[String]) -> bool {
    let known = telemetry.columns();
    columns
        .iter()
        .all(|column| known.contains(&column.as_str()))
}
