//! Batches of episodes for a fleet's files.

use crate::store::{Created, FileEntry, FleetError, StorePlace, sha256};
use crate::tables::file::{VERSION, to_bytes};
use crate::tables::{Keep, Projection, TABLES, Table, day_of, robot_of};
use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::error::DataFusionError;
use std::collections::BTreeMap;
use wisch_memory::{Episode, EpisodeRecord};

/// Largest number of episodes that a commit lists, more than a push commits at once.
const MOST_NAMED: usize = 1000;

/// An episode to be added.
pub struct Incoming {
    /// Its record.
    pub record: EpisodeRecord,
    /// Source of its telemetry, if that is added as well.
    pub telemetry: Option<Episode>,
    /// Its archives.
    pub keep: Keep,
    /// Name of its robot.
    pub robot: String,
}

/// Distribution of rows over files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grouping {
    /// A file for each robot and day.
    ByRobotAndDay,
    /// One file for all rows.
    Together,
}

/// Extent of a file's rows.
#[derive(Debug, Clone, PartialEq)]
pub struct BatchExtent {
    /// First and last robot, by name.
    pub robots: [String; 2],
    /// First and last day, days since 1970.
    pub days: [i32; 2],
    /// First start and last end [s since 1970].
    pub times: [f64; 2],
    /// The episodes, if they are few.
    pub episodes: Option<Vec<String>>,
}

impl Incoming {
    /// Wraps a record. `robot` overrides the robot in the record.
    pub fn new(record: EpisodeRecord, robot: Option<&str>) -> Self {
        Self {
            robot: robot.map_or_else(|| robot_of(&record), str::to_owned),
            record,
            telemetry: None,
            keep: Keep::default(),
        }
    }

    /// Returns a copy of the same entry.
    pub(super) fn again(&self) -> Self {
        Self {
            record: self.record.clone(),
            telemetry: self.telemetry.clone(),
            keep: self.keep.clone(),
            robot: self.robot.clone(),
        }
    }

    fn day(&self) -> i32 {
        day_of(self.record.interval[0])
    }
}

/// Formats a day, given as days since 1970.
pub fn day_text(day: i32) -> String {
    let date = jiff::civil::Date::constant(1970, 1, 1);
    let days = jiff::Span::new()
        .try_days(i64::from(day))
        .unwrap_or_default();
    date.saturating_add(days).to_string()
}

/// Writes the sorted rows of some episodes. Returns the files, none of which is valid before a commit.
///
/// # Errors
/// If telemetry cannot be read, or the store cannot be written.
pub async fn write(
    place: &StorePlace,
    mut episodes: Vec<Incoming>,
    grouping: Grouping,
) -> Result<Vec<FileEntry>, FleetError> {
    episodes.sort_by(|a, b| {
        let [one, other] = [a, b].map(|one| (&one.robot, one.day(), &one.record.id));
        one.cmp(&other)
    });
    let mut groups: BTreeMap<(String, i32), Vec<Incoming>> = BTreeMap::new();
    for one in episodes {
        let key = match grouping {
            Grouping::ByRobotAndDay => (one.robot.clone(), one.day()),
            Grouping::Together => (String::new(), 0),
        };
        groups.entry(key).or_default().push(one);
    }
    let mut files = Vec::new();
    for group in groups.into_values() {
        let extent = extent_of(&group);
        let mut projection = Projection::default();
        for one in &group {
            projection.add(&one.robot, &one.record, &one.keep);
            if let Some(episode) = &one.telemetry {
                projection.add_telemetry(&one.robot, &one.record, episode)?;
            }
        }
        files.extend(write_tables(place, projection, &extent).await?);
    }
    Ok(files)
}

/// Writes only the telemetry of episodes whose other rows the fleet has.
///
/// # Errors
/// As [`write`].
pub async fn write_telemetry(
    place: &StorePlace,
    episodes: Vec<Incoming>,
) -> Result<Vec<FileEntry>, FleetError> {
    let mut files = Vec::new();
    for one in episodes {
        let extent = extent_of(std::slice::from_ref(&one));
        let mut projection = Projection::default();
        if let Some(episode) = &one.telemetry {
            projection.add_telemetry(&one.robot, &one.record, episode)?;
        }
        files.extend(write_tables(place, projection, &extent).await?);
    }
    Ok(files)
}

/// Writes a file for each table with rows.
async fn write_tables(
    place: &StorePlace,
    projection: Projection,
    extent: &BatchExtent,
) -> Result<Vec<FileEntry>, FleetError> {
    let mut files = Vec::new();
    for mut rows in projection.into_tables() {
        let batch = rows.take();
        let schema = batch.schema();
        files.push(write_file(place, rows.table(), schema, &[batch], extent.clone()).await?);
    }
    Ok(files)
}

/// Returns the extent of a file with these episodes, at least one.
fn extent_of(group: &[Incoming]) -> BatchExtent {
    let robots = || group.iter().map(|one| one.robot.clone());
    let days = || group.iter().map(Incoming::day);
    let starts = group.iter().map(|one| one.record.interval[0]);
    let ends = group.iter().map(|one| one.record.interval[1]);
    BatchExtent {
        robots: [
            robots().min().unwrap_or_default(),
            robots().max().unwrap_or_default(),
        ],
        days: [
            days().min().unwrap_or_default(),
            days().max().unwrap_or_default(),
        ],
        times: [
            starts.fold(f64::INFINITY, f64::min),
            ends.fold(f64::NEG_INFINITY, f64::max),
        ],
        episodes: Some(group.iter().map(|one| one.record.id.clone()).collect()),
    }
}

/// Writes batches of a table as one file, whose name is derived from its contents.
///
/// # Errors
/// If the store cannot be written.
pub async fn write_file(
    place: &StorePlace,
    table: &Table,
    schema: SchemaRef,
    batches: &[RecordBatch],
    extent: BatchExtent,
) -> Result<FileEntry, FleetError> {
    let bytes = to_bytes(table, schema, batches).map_err(DataFusionError::from)?;
    let sum = sha256(&bytes);
    let folder = if extent.robots[0] == extent.robots[1] && extent.days[0] == extent.days[1] {
        let robot = &extent.robots[0];
        format!("robot={}/day={}", plain(robot), day_text(extent.days[0]))
    } else {
        "merged".to_owned()
    };
    let path = format!("tables/{}/{folder}/{sum}.parquet", table.name);
    let length = bytes.len() as u64;
    // An object with these bytes exists if a writer was killed before its commit.
    if place.create(&path, bytes.into()).await? == Created::There
        && place
            .head(&path)
            .await?
            .is_none_or(|meta| meta.size != length)
    {
        return Err(FleetError::Damaged {
            object: place.shown(&path),
            what: format!("its length is not {length} bytes, which its name implies"),
        });
    }
    let rows = batches.iter().map(|batch| batch.num_rows() as u64).sum();
    Ok(FileEntry {
        path,
        table: table.name.to_owned(),
        robots: extent.robots,
        days: extent.days.map(day_text),
        rows,
        bytes: length,
        sha256: sum,
        schema: VERSION,
        times: extent.times,
        // Only those of the table of episodes are needed, by concurrent pushes.
        episodes: (extent.episodes)
            .filter(|ids| table.name == TABLES[0].name && ids.len() <= MOST_NAMED),
    })
}

/// Returns a robot's name in a form for object names.
fn plain(name: &str) -> String {
    let keep = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    name.chars()
        .map(|c| if keep(c) { c } else { '_' })
        .collect()
}
