//! Export of a stored episode to a NEEM: its record, and poses and wrenches from its telemetry.

use super::NeemError;
use super::observation::NeemRound;
use super::writer::{FrameSample, NeemWriter, WrenchSample};
use crate::frames::Frames;
use crate::record::EpisodeRecord;
use crate::store::Episode;
use crate::telemetry::{POSE, Telemetry};
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};
use std::collections::BTreeSet;
use wisch::geometry::Pose;
use wisch::robot::RobotModel;

/// Number of rows in memory at once.
const ROWS: usize = 10_000;

/// Frame of all poses.
const WORLD: &str = "world";

const FORCE: [&str; 3] = ["fx", "fy", "fz"];
const TORQUE: [&str; 3] = ["mx", "my", "mz"];
/// The wrenches of a sample.
const WRENCHES: [&str; 2] = ["controller", EXTERNAL];
const EXTERNAL: &str = "external";

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
    /// Those of [`Self::episode`], [`Self::frame`], [`Self::wrench`] and [`Self::observations`];
    /// also if the episode cannot be read or its telemetry belongs to another robot.
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
            let tool = match poses {
                PoseSource::Tool => {
                    let tool = related_name(&record, "semco:usesTool", "tool");
                    self.tool_of(&telemetry, start, tool)?;
                    tool.to_owned()
                }
                PoseSource::Robot(robot) => self.frames_of(&telemetry, start, robot)?,
            };
            self.wrenches_of(&telemetry, start, [&record.id, &tool])?;
        }
        Ok(())
    }

    /// Writes the usable wrenches of a round in the frame of the tool: telemetry has them about its origin, in the world's axes.
    /// A controller's wrench that is always 0 is not stated, so it is left out.
    fn wrenches_of(
        &mut self,
        telemetry: &Telemetry,
        start: f64,
        [episode, tool]: [&str; 2],
    ) -> Result<(), NeemError> {
        let qualities = telemetry.wrench_qualities(0..telemetry.rows())?;
        let unusable = qualities.iter().filter(|quality| !quality.is_usable());
        self.unusable_wrenches += unusable.count() as u64;
        for what in WRENCHES {
            let topic = format!("wrench/{what}");
            let named = |parts: &[&str]| -> Vec<String> {
                parts.iter().map(|part| format!("{what}/{part}")).collect()
            };
            let mut columns: Vec<String> = (POSE.iter())
                .map(|part| format!("measured/{part}"))
                .chain(named(&FORCE))
                .collect();
            let torque = named(&TORQUE);
            if has_all(telemetry, &torque) {
                columns.extend(torque);
            }
            let mut is_stated = what == EXTERNAL;
            if !is_stated {
                each_row(telemetry, &columns, |_, row| {
                    is_stated |= row[POSE.len()..].iter().any(|part| *part != 0.0);
                    Ok(())
                })?;
            }
            let mut place = 0;
            each_row(telemetry, &columns, |time, row| {
                let is_usable = what != EXTERNAL || qualities[place].is_usable();
                place += 1;
                let (pose, wrench) = row.split_at(POSE.len());
                let Some((force, torque)) = wrench.split_first_chunk::<3>() else {
                    return Ok(());
                };
                if !is_stated || !is_usable {
                    return Ok(());
                }
                let tool_from_world = to_pose(pose).rotation.inverse();
                let in_tool = |part: &[f64; 3]| (tool_from_world * Vector3::from(*part)).into();
                self.wrench(&WrenchSample {
                    time: start + time,
                    frame: tool,
                    episode,
                    topic: &topic,
                    force: in_tool(force),
                    torque: torque.first_chunk().map(in_tool),
                })
            })?;
        }
        Ok(())
    }

    fn tool_of(&mut self, telemetry: &Telemetry, start: f64, tool: &str) -> Result<(), NeemError> {
        let columns = POSE.map(|part| format!("measured/{part}"));
        each_row(telemetry, &columns, |time, row| {
            self.frame(&FrameSample {
                time: start + time,
                frame: tool,
                parent: WORLD,
                parent_from_frame: to_pose(row),
            })
        })
    }

    /// Writes the frames of a round, and returns the name of the tool's.
    fn frames_of(
        &mut self,
        telemetry: &Telemetry,
        start: f64,
        robot: &RobotModel,
    ) -> Result<String, NeemError> {
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
        })?;
        Ok(scene.tool.clone())
    }
}

/// Returns the pose of a row with position and quaternion (x, y, z, w).
fn to_pose(row: &[f64]) -> Pose {
    match row {
        &[x, y, z, qx, qy, qz, qw] => {
            let rotation = UnitQuaternion::from_quaternion(Quaternion::new(qw, qx, qy, qz));
            Pose::from_parts(Translation3::new(x, y, z), rotation)
        }
        _ => Pose::identity(),
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
