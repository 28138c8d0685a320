//! The recording of a stored episode. An episode that was kept without one, such as an imported log, gets one from its
//! telemetry and its events.

use crate::error::{RecordError, internal};
use crate::folder::title;
use crate::packed::pack;
use std::io::Read;
use wisch::follow::Phase;
use wisch::geometry::{Vector3, restore_pose};
use wisch::interpret::TouchSample;
use wisch::robot::RobotModel;
use wisch::run::{RunEvent, TelemetrySample};
use wisch_io::LoadedTask;
use wisch_memory::view::ShownEpisode;
use wisch_memory::{
    Episode, Frames, LOG_COLUMNS, MemoryError, RECORDING_FILE, RoundScene, Telemetry,
    TelemetryError,
};
use wisch_report::{
    LoggedEpisode, LoggedOccurrence, LoggedRobot, LoggedRound, LoggedTask, RecordingWriter,
};

/// Number of rows of telemetry that are read at a time.
const ROWS: usize = 10_000;
/// Returns the recording of an episode, compressed by gzip: the stored one, or else one from its telemetry and events.
///
/// # Parameters
/// - `shown`: the episode's actions and events.
/// - `loaded`: the episode's task; `None` if it is unknown, so that the page shows neither surface nor tool.
///
/// # Errors
/// If the episode cannot be read.
pub fn episode_recording(
    episode: &Episode,
    shown: &ShownEpisode,
    loaded: Option<&LoadedTask>,
) -> Result<Vec<u8>, RecordError> {
    if !episode.folder().join(RECORDING_FILE).is_file() {
        return pack(&recording_of_log(episode, shown, loaded)?);
    }
    let mut packed = Vec::new();
    let mut file = episode.open_checked(RECORDING_FILE)?;
    file.read_to_end(&mut packed)
        .map_err(|error| RecordError::Unreadable {
            place: episode.folder().join(RECORDING_FILE),
            error,
        })?;
    Ok(packed)
}

/// A round's telemetry, with the poses that its samples do not hold.
struct Log {
    telemetry: Telemetry,
    scene: RoundScene,
}

fn recording_of_log(
    episode: &Episode,
    shown: &ShownEpisode,
    loaded: Option<&LoadedTask>,
) -> Result<Vec<u8>, RecordError> {
    let record = episode.record()?;
    let robot = match episode.has_robot() {
        true => Some(episode.robot()?),
        false => None,
    };
    let rounds = 1..=record.rounds.len();
    let logs: Vec<Option<Log>> = rounds
        .map(|number| read_log(episode, number, robot.as_ref()))
        .collect::<Result<_, _>>()?;
    let scene = logs.iter().flatten().map(|log| &log.scene).next();
    let headline = loaded.map_or_else(|| record.task.clone(), title);
    let mut writer = RecordingWriter::new(Vec::new());
    writer
        .begin_log(&LoggedEpisode {
            title: &headline,
            program: &record.program,
            task: loaded.map(|loaded| LoggedTask {
                task: &loaded.task,
                strategy: loaded.run.plan.strategy,
                target: loaded.run.target,
            }),
            robot: (robot.as_ref().zip(scene)).and_then(|(model, scene)| {
                Some(LoggedRobot {
                    model,
                    tip: model.link(&scene.tip).ok()?,
                    tip_from_tool: scene.tip_from_tool.into(),
                })
            }),
        })
        .map_err(internal)?;
    let ends = record.rounds.iter().skip(1).chain([&record.interval[1]]);
    for ((number, log), (&begin, &end)) in (1..).zip(&logs).zip(record.rounds.iter().zip(ends)) {
        let starts_within = |time: f64| begin <= time && (time < end || number == logs.len());
        let occurrences = shown.occurrences.iter();
        let occurrences = occurrences.filter(|one| starts_within(one.interval[0]));
        let has_surface = |log: &&Log| !log.scene.surface.is_empty();
        writer
            .record_log(&LoggedRound {
                number,
                duration: end - begin,
                world_from_root: (log.as_ref().filter(|_| robot.is_some()))
                    .map(|log| log.scene.world_from_root.into()),
                world_from_surface: (log.as_ref().filter(has_surface))
                    .map(|log| log.scene.world_from_surface.into()),
                task: loaded.map(|loaded| &loaded.task),
                occurrences: occurrences
                    .map(|one| LoggedOccurrence {
                        name: &one.name,
                        class: &one.class,
                        interval: one.interval.map(|time| time - begin),
                        is_collision: one.is_collision,
                    })
                    .collect(),
            })
            .map_err(internal)?;
        if let Some(log) = log {
            record_samples(&mut writer, &log.telemetry).map_err(MemoryError::from)?;
        }
        writer.flush().map_err(internal)?;
    }
    Ok(writer.into_inner())
}

/// Reads the telemetry of a round, if it has some.
fn read_log(
    episode: &Episode,
    round: usize,
    robot: Option<&RobotModel>,
) -> Result<Option<Log>, MemoryError> {
    if !episode.has_telemetry(round)? {
        return Ok(None);
    }
    let telemetry = episode.telemetry(round)?;
    let frames = match robot {
        Some(robot) => Frames::new(robot, &telemetry),
        None => Frames::from_log(&telemetry, "tool"),
    };
    // Without poses there is nothing to show; a query that asks for them states the reason.
    let scene = frames.ok().map(|frames| frames.scene().clone());
    Ok(scene.map(|scene| Log { telemetry, scene }))
}

/// Records the samples of a round.
fn record_samples(
    writer: &mut RecordingWriter<Vec<u8>>,
    telemetry: &Telemetry,
) -> Result<(), TelemetryError> {
    let known = telemetry.columns();
    let joints = telemetry.joints().iter();
    let columns: Vec<String> = (LOG_COLUMNS.map(str::to_owned).into_iter())
        .chain(joints.map(|joint| format!("position/{joint}")))
        .collect();
    let has_column: Vec<bool> = columns
        .iter()
        .map(|column| known.contains(&column.as_str()))
        .collect();
    for from in (0..telemetry.rows()).step_by(ROWS) {
        let rows = from..(from + ROWS).min(telemetry.rows());
        let times = telemetry.times(rows.clone())?;
        let mut values = Vec::with_capacity(columns.len());
        for (column, is_known) in columns.iter().zip(&has_column) {
            values.push(match is_known {
                true => telemetry.values(column, rows.clone())?,
                false => vec![0.0; rows.len()],
            });
        }
        for (k, time) in times.into_iter().enumerate() {
            let row: Vec<f64> = values.iter().map(|column| column[k]).collect();
            let [x, y, z, i, j, k, w, fx, fy, fz] = row[..LOG_COLUMNS.len()] else {
                continue;
            };
            let pose = restore_pose(&[x, y, z, i, j, k, w]);
            let touch = TouchSample::new(time, pose, Vector3::new(fx, fy, fz));
            let sample = TelemetrySample {
                positions: &row[LOG_COLUMNS.len()..],
                ..TelemetrySample::from_touch(&touch, 0, Phase::FreeMotion)
            };
            // A buffer in memory takes every sample.
            let _ = writer.record_event(&RunEvent::Sample(&sample));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::GzDecoder;
    use serde_json::Value;
    use std::collections::BTreeMap;
    use wisch::geometry::Pose;
    use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Mark, Memory, Origin};

    const ID: &str = "20261122-010000-abcd";
    /// Start of the episode [s since 1970].
    const BEGIN: f64 = 1000.0;

    fn individual(class: &str, parent: Option<usize>, [from, to]: [f64; 2]) -> Individual {
        Individual {
            class: format!("semco:{class}"),
            interval: Some([BEGIN + from, BEGIN + to]),
            parent,
            relations: BTreeMap::new(),
            values: BTreeMap::new(),
        }
    }

    /// Stores an imported log of two seconds with a tool that moves along x at 0.1 m/s, and returns its recording.
    fn recording(stored: Option<&[u8]>) -> Vec<u8> {
        let folder = tempfile::tempdir().unwrap();
        let memory = Memory::create(folder.path()).unwrap();
        let writer = memory.begin(ID).unwrap();
        let surface = Pose::translation(0.0, 0.0, 0.7);
        let head = RoundScene::from_log("sponge", "board", &surface).head(Vec::new());
        let columns = LOG_COLUMNS.map(str::to_owned);
        let mut telemetry = writer.telemetry_with_columns(1, head, &columns).unwrap();
        let mark = Mark {
            motion: 0,
            phase: Phase::FreeMotion,
        };
        for k in 0..=200 {
            let time = 0.01 * f64::from(k);
            let row = [0.1 * time, 0.0, 0.71, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 5.0];
            telemetry.push(time, mark, row).unwrap();
        }
        telemetry.finish().unwrap();
        if let Some(stored) = stored {
            writer.attach(RECORDING_FILE, stored).unwrap();
        }
        let all = [0.0, 2.0];
        let record = EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id: ID.to_owned(),
            task: "slide".to_owned(),
            interval: all.map(|time| BEGIN + time),
            origin: Origin::Imported("log.csv".to_owned()),
            program: "test".to_owned(),
            seed: 1,
            rounds: vec![BEGIN],
            individuals: vec![
                individual("WipingEpisode", None, all),
                individual("WipingAction", Some(0), all),
                individual("WipingRound", Some(1), all),
                individual("ToolContact", Some(2), [0.5, 1.5]),
                individual("HumanCollision", Some(2), [1.0, 1.25]),
            ],
        };
        writer.commit(&record).unwrap();
        let catalogue = memory.catalogue().unwrap();
        let answer = wisch_memory::ask::Term::atom(format!("semco:WipingRound_{ID}-2"));
        let view = wisch_memory::view::gather(&[], &[vec![answer]], &memory, &catalogue).unwrap();
        let episode = memory.episode(ID).unwrap();
        episode_recording(&episode, &view.episodes[0], None).unwrap()
    }

    #[test]
    fn an_imported_log_gets_a_recording_of_its_telemetry_and_events() {
        let packed = recording(None);
        let mut text = String::new();
        GzDecoder::new(&packed[..])
            .read_to_string(&mut text)
            .unwrap();
        let pieces: Vec<Value> = (text.lines())
            .map(|line| serde_json::from_str(line).unwrap())
            .collect();
        let [head, round, samples @ ..] = &pieces[..] else {
            panic!("{text}");
        };
        assert_eq!(
            (&head["piece"], &head["title"]),
            (&"head".into(), &"slide".into())
        );
        assert!(head["task"].is_null() && head["robot"].is_null());
        assert_eq!(
            (&round["kind"], &round["duration"]),
            (&"logged".into(), &2.0.into())
        );
        assert_eq!(round["surface"]["pose"][2], 0.7);
        assert_eq!(round["contacts"], serde_json::json!([[0.5, 1.5]]));
        assert_eq!(round["events"][0]["kind"], "human collision");
        let times: Vec<f64> = (samples.iter())
            .flat_map(|piece| piece["t"].as_array().unwrap())
            .map(|time| time.as_f64().unwrap())
            .collect();
        assert_eq!((times.len(), times[50]), (51, 2.0), "25 samples a second");
        let last = samples.last().unwrap();
        assert_eq!(
            last["tool"],
            serde_json::json!([0.2, 0.0, 0.71, 0.0, 0.0, 0.0, 1.0])
        );
        assert_eq!(
            (&last["normal"][0], &last["height"][0]),
            (&5.0.into(), &0.01.into())
        );
    }

    #[test]
    fn a_stored_recording_is_returned_as_it_is() {
        assert_eq!(recording(Some(b"packed")), b"packed");
    }
}
