//! Logs of a tool that wipes, from whatever wrote them, as what the interpretation takes.

use super::bag::{BagReader, active_path};
use super::error::{ReadError, ReadFault};
use super::options::{Axes, AxesChoice, LogOptions, WrenchSign};
use super::table;
use super::track::{RawLog, paired, seconds};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use wisch::geometry::Pose;
use wisch::interpret::TouchSample;

/// How the axes of a force were found out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxesSource {
    /// It was said which.
    Given,
    /// The log says so.
    Logged,
    /// Nothing says so.
    Assumed,
}

/// A log as the interpretation takes it.
#[derive(Debug, Clone)]
pub struct Log {
    /// Where the tool was and what force it felt, in the task's world; time counts from `start`.
    pub samples: Vec<TouchSample>,
    /// The log's time when the samples' time is 0 [ns].
    pub start: i64,
    /// Where the poses come from.
    pub pose_name: String,
    /// Where the forces come from.
    pub wrench_name: String,
    /// In whose axes the log gave the force.
    pub axes: Axes,
    /// How that was found out.
    pub axes_source: AxesSource,
    /// How many poses or forces were left out, as they bore the time of the one before.
    pub repeated: usize,
    /// How many times of the more frequent one were left out, as the other was not known.
    pub unpaired: usize,
    /// Whether the log ends where its writer was killed, or is still writing.
    pub is_unfinished: bool,
}

/// Reads a log: a bag, a folder with the parts of one, or a table. Where there is no such file but a bag of that
/// name is being written, reads that.
///
/// # Errors
/// See [`ReadFault`].
pub fn read(path: &Path, options: &LogOptions) -> Result<Log, ReadError> {
    let active = active_path(path);
    let path = if !path.exists() && active.exists() {
        &active
    } else {
        path
    };
    let within = |path: &Path, fault| ReadError {
        file: path.display().to_string(),
        fault,
    };
    let parts = parts(path).map_err(|error| within(path, ReadFault::System(error)))?;
    let raw = if is_bag(&parts[0]).map_err(|error| within(path, ReadFault::System(error)))? {
        let mut reader = BagReader::new(&options.pose_topic, &options.wrench_topic);
        for part in &parts {
            reader.read(part).map_err(|fault| within(part, fault))?;
        }
        reader.finish()
    } else {
        bytes(path).and_then(|bytes| table::read(&bytes, options))
    };
    raw.and_then(|raw| understood(&raw, options))
        .map_err(|fault| within(path, fault))
}

/// Longest table that is read [bytes]: half an hour at 1 kHz.
const MAX_TABLE_LEN: u64 = 256 << 20;

fn bytes(path: &Path) -> Result<Vec<u8>, ReadFault> {
    let file = std::fs::File::open(path).map_err(ReadFault::System)?;
    let mut bytes = Vec::new();
    // Pipes and devices do not tell their length: count what comes.
    file.take(MAX_TABLE_LEN + 1)
        .read_to_end(&mut bytes)
        .map_err(ReadFault::System)?;
    if bytes.len() as u64 > MAX_TABLE_LEN {
        return Err(ReadFault::TableLength {
            limit: MAX_TABLE_LEN,
        });
    }
    Ok(bytes)
}

/// The file, or the bags in the folder, in the order in which they were recorded.
fn parts(path: &Path) -> std::io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let mut parts = Vec::new();
    for entry in std::fs::read_dir(path)? {
        let path = entry?.path();
        if has_bag_ending(&path) {
            parts.push(path);
        }
    }
    // Recorders number the parts without zeros in front: bag_2 before bag_10.
    parts.sort_by_key(|path| (path.as_os_str().len(), path.clone()));
    if parts.is_empty() {
        return Err(std::io::Error::new(
            ErrorKind::NotFound,
            "the folder holds no .mcap file",
        ));
    }
    Ok(parts)
}

fn has_bag_ending(path: &Path) -> bool {
    let name = path.as_os_str().to_string_lossy();
    name.ends_with(".mcap") || name.ends_with(".mcap.active")
}

/// By its ending, or by what it begins with.
fn is_bag(path: &Path) -> std::io::Result<bool> {
    let mut begin = Vec::new();
    let file = std::fs::File::open(path)?;
    file.take(mcap::MAGIC.len() as u64)
        .read_to_end(&mut begin)?;
    Ok(has_bag_ending(path) || begin == mcap::MAGIC)
}

/// Poses and forces together, in the task's world.
fn understood(raw: &RawLog, options: &LogOptions) -> Result<Log, ReadFault> {
    let pairs = paired(&raw.poses, &raw.wrenches, options.max_gap)?;
    let (axes, axes_source) = axes(raw, options.axes);
    let start = raw.start.unwrap_or(pairs[0].0);
    let scale = match options.sign {
        WrenchSign::OnTool => options.force_unit,
        WrenchSign::ByTool => -options.force_unit,
    };
    let samples = pairs.iter().map(|&(time, mut log_from_logged, force)| {
        log_from_logged.translation.vector *= options.length_unit;
        let world_from_logged = options.world_from_log * log_from_logged;
        let world_from_axes = match axes {
            Axes::World => Pose::identity(),
            Axes::Log => options.world_from_log,
            Axes::Tool => world_from_logged,
            Axes::Surface => options.world_from_surface,
        };
        TouchSample {
            time: seconds(time.saturating_sub(start)),
            world_from_tool: world_from_logged * options.logged_from_tool,
            force: world_from_axes.rotation * (force * scale),
        }
    });
    let frequent = raw.poses.entries.len().max(raw.wrenches.entries.len());
    Ok(Log {
        samples: samples.collect(),
        start,
        pose_name: raw.poses.name.clone(),
        wrench_name: raw.wrenches.name.clone(),
        axes,
        axes_source,
        repeated: raw.poses.repeated + raw.wrenches.repeated,
        unpaired: frequent - pairs.len(),
        is_unfinished: raw.unfinished,
    })
}

fn axes(raw: &RawLog, choice: AxesChoice) -> (Axes, AxesSource) {
    if let AxesChoice::Given(axes) = choice {
        return (axes, AxesSource::Given);
    }
    let named = |name: &str| Axes::ALL.into_iter().find(|axes| axes.as_str() == name);
    let frame = &raw.wrenches.frame;
    match raw.axes.as_deref().and_then(named) {
        Some(axes) => (axes, AxesSource::Logged),
        None if !frame.is_empty() && *frame == raw.poses.frame => (Axes::Log, AxesSource::Logged),
        None => (Axes::Tool, AxesSource::Assumed),
    }
}
