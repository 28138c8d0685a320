//! Camera observations of the dirt around a log: from a list, a photo or a bag.

use super::log_advice::log_failure;
use super::words::format_count;
use crate::args::LoggedArgs;
use crate::failure::Failure;
use std::path::Path;
use wisch::interpret::Doubt;
use wisch::represent::{Action, GoalState, Observation};
use wisch::run::{RunError, check_detections};
use wisch_io::LoadedTask;
use wisch_telemetry::{Log, LogOptions, is_bag, read};

/// Observations of the dirt around a log, in the frame of the task's surface.
pub(super) struct LogObservations {
    /// Before the log, if the bag holds it.
    pub before: Option<Observation>,
    /// After the log.
    pub after: Observation,
    /// Sentence that states the observations and their source.
    pub remark: String,
    /// Remarks on detections that are not used.
    pub doubts: Vec<Doubt>,
}

/// Reads the observation of `--observation`, without the detections that lie beside the surface or repeat another one. A bag,
/// such as the log itself, may also hold an observation before the round.
pub(super) fn read_observation(
    file: &Path,
    source: &LoggedArgs,
    prepared: &LoadedTask,
    (log, goal): (&Log, &GoalState),
) -> Result<LogObservations, Failure> {
    if goal.action().treats() {
        let problem = format!(
            "--observation {}: an observation is a list of dirt locations, and the action {} leaves no dirt to observe",
            file.display(),
            goal.action()
        );
        return Err(Failure::new(problem).with_help("omit --observation"));
    }
    let error = |error: RunError| {
        Failure::new(error.to_string())
            .within(file)
            .after("--observation")
    };
    let sensor = prepared.file.camera.unwrap_or_default();
    let check = |seen: Observation, is_first: bool| {
        let surface = &prepared.task.surface;
        check_detections(seen, surface, sensor.position_error_m, is_first).map_err(error)
    };
    // Skimmed dirt lies beside the surface.
    let skims = prepared.task.action == Action::Skim;
    let is_log = is_same_file(file, &source.log);
    if !is_log && !is_bag(file).unwrap_or(false) {
        let after = prepared.observation(file)?;
        let detections = format_count(after.detections.len(), "detection");
        let remark = format!("after the log: {detections} of dirt in {}", file.display());
        let (after, doubts) = check(after, !skims)?;
        return Ok(LogObservations {
            before: None,
            after,
            remark,
            doubts,
        });
    }
    let other;
    let bag = if is_log {
        log
    } else {
        other = read(file, &LogOptions::default())
            .map_err(|error| log_failure(error, file).after("--observation"))?;
        &other
    };
    let surface = &prepared.task.surface;
    let moved = |seen: &Observation| match bag.world_from_surface {
        Some(then) if then != surface.world_from_surface => {
            let now_from_then = surface.world_from_surface.inverse() * then;
            seen.transform(&now_from_then, &surface.shape)
        }
        _ => seen.clone(),
    };
    let [before, after] = bag
        .observations
        .each_ref()
        .map(|seen| seen.as_ref().map(moved));
    let Some(after) = after else {
        let problem = format!(
            "--observation {}: topic /wisch/dirt_after is missing: the file holds no camera observation of the dirt after the log",
            file.display()
        );
        return Err(Failure::new(problem).with_help(
            "give a list of dirt locations (x,y in the frame of the surface [m]), or omit --observation",
        ));
    };
    let detections = |seen: &Observation| format_count(seen.detections.len(), "detection");
    let earlier = (before.as_ref()).map_or_else(String::new, |before| {
        format!("before the log: {} of dirt; ", detections(before))
    });
    let remark = format!(
        "{earlier}after the log: {} of dirt in {}",
        detections(&after),
        file.display()
    );
    let before = before.map(|before| check(before, true)).transpose()?;
    let (before, mut doubts) =
        before.map_or((None, Vec::new()), |(seen, doubts)| (Some(seen), doubts));
    let (after, left_out) = check(after, before.is_none() && !skims)?;
    doubts.extend(left_out);
    Ok(LogObservations {
        before,
        after,
        remark,
        doubts,
    })
}

fn is_same_file(one: &Path, other: &Path) -> bool {
    match (one.canonicalize(), other.canonicalize()) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}

/// Returns a remark if the log holds observations, which the estimate does not use, with the option that uses them.
pub(super) fn unused_remark(log: &Log, source: &LoggedArgs) -> Option<String> {
    let held: Vec<&str> = (log.observations.iter())
        .zip(["before", "after"])
        .filter_map(|(seen, when)| seen.as_ref().map(|_| when))
        .collect();
    let file = source.log.display();
    let advice = match log.observations[1] {
        Some(_) => format!("wisch interpret uses them with --observation {file}"),
        None => "the one after it is missing, so that only a list of dirt locations can be given with --observation".to_owned(),
    };
    (!held.is_empty()).then(|| {
        format!(
            "the log holds camera observations of the dirt {} it, which this estimate does not use: {advice}",
            held.join(" and ")
        )
    })
}
