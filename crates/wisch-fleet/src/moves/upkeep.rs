//! Maintenance of a fleet: merge small files, remove old telemetry, and delete objects that have long been unused.
//! Files in use are never deleted: they leave the log first, and objects are deleted only when they have long been
//! unused.

use super::batch::{BatchExtent, day_text, write_file};
use crate::ask::{SqlSession, SqlSource};
use crate::store::{Commit, Committed, FileEntry, FleetError, Snapshot, StorePlace};
use crate::tables::{TABLES, Table, day_of, table};
use datafusion::arrow::array::RecordBatch;
use std::collections::HashSet;
use std::sync::Arc;

/// Length below which files are merged [bytes].
const SMALL: u64 = 32 << 20;
/// Length of a merged file [bytes]; well compressed data need ten times as much memory.
const TOGETHER: u64 = 64 << 20;
/// Number of attempts to commit against other writers.
const TRIES: usize = 100;

/// Result of a compaction.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Compacted {
    /// Number of merged files.
    pub before: usize,
    /// Number of files after the merge.
    pub after: usize,
    /// Number of deleted objects, which had long been unused.
    pub deleted: usize,
}

/// Result of a retention.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Retained {
    /// First day whose telemetry is kept.
    pub since: String,
    /// Number of files of rows that became unused.
    pub files: usize,
    /// Their length [bytes].
    pub bytes: u64,
}

/// Merges small files: telemetry by robot and day, other tables across robots and days, sorted by them.
///
/// # Errors
/// If the store cannot be read or written.
pub async fn compact(place: &StorePlace) -> Result<Compacted, FleetError> {
    let mut compacted = Compacted::default();
    let mut snapshot = Snapshot::read(place).await?;
    for table in &TABLES {
        for group in groups(&snapshot, table) {
            let Some(file) = merge(place, &snapshot, table, &group).await? else {
                continue;
            };
            let mut commit = Commit::new("compact");
            commit.remove = group.iter().map(|file| file.path.clone()).collect();
            // The merge of a single sorted file is the file itself.
            if commit.remove.contains(&file.path) {
                continue;
            }
            commit.add = vec![file];
            if replace(place, &mut snapshot, &commit).await? {
                compacted.before += group.len();
                compacted.after += 1;
            }
        }
    }
    Ok(compacted)
}

/// Commits, unless a file to be removed is gone already. Returns whether it committed.
async fn replace(
    place: &StorePlace,
    snapshot: &mut Snapshot,
    commit: &Commit,
) -> Result<bool, FleetError> {
    for _ in 0..TRIES {
        if !commit
            .remove
            .iter()
            .all(|path| snapshot.files.contains_key(path))
        {
            return Ok(false);
        }
        if snapshot.commit(place, commit).await? == Committed::Done {
            return Ok(true);
        }
    }
    Err(FleetError::Contended {
        url: place.url().to_owned(),
        tries: TRIES,
    })
}

/// Returns groups of a table's small files that are merged, in the order of robot and day.
fn groups(snapshot: &Snapshot, table: &Table) -> Vec<Vec<FileEntry>> {
    let mut small: Vec<FileEntry> = (snapshot.files_of(table.name))
        .filter(|file| file.bytes < SMALL)
        .cloned()
        .collect();
    small.sort_by(|a, b| (&a.robots, &a.days, &a.path).cmp(&(&b.robots, &b.days, &b.path)));
    let mut groups: Vec<Vec<FileEntry>> = Vec::new();
    let mut length = 0;
    for file in small {
        let fits = groups
            .last()
            .and_then(|group| group.last())
            .is_some_and(|last| {
                let is_of_one_day = last.robots == file.robots && last.days == file.days;
                length + file.bytes <= TOGETHER && (table.name != "telemetry" || is_of_one_day)
            });
        if !fits {
            groups.push(Vec::new());
            length = 0;
        }
        length += file.bytes;
        groups.last_mut().expect("there is one now").push(file);
    }
    groups.retain(|group| group.len() > 1);
    groups
}

/// Writes the rows of some files as one file.
async fn merge(
    place: &StorePlace,
    snapshot: &Snapshot,
    table: &Table,
    group: &[FileEntry],
) -> Result<Option<FileEntry>, FleetError> {
    let file = write_rows(place, snapshot, table, group, "TRUE").await?;
    let rows = file.as_ref().map_or(0, |file| file.rows);
    let expected: u64 = group.iter().map(|file| file.rows).sum();
    if file.is_some() && rows != expected {
        return Err(FleetError::Damaged {
            object: place.shown(&format!("tables/{}", table.name)),
            what: format!(
                "{} files have {rows} rows, but {expected} were written",
                group.len()
            ),
        });
    }
    Ok(file)
}

/// Writes the rows of some files that meet a condition in SQL as one file; `None` if no row meets it.
pub(super) async fn write_rows(
    place: &StorePlace,
    snapshot: &Snapshot,
    table: &Table,
    group: &[FileEntry],
    condition: &str,
) -> Result<Option<FileEntry>, FleetError> {
    let files = group.iter().map(|file| (file.path.clone(), file.clone()));
    let only = Snapshot {
        files: files.collect(),
        ..snapshot.clone()
    };
    let source = SqlSource {
        place: place.clone(),
        snapshot: only,
    };
    let session = SqlSession::new(&[source]).await?;
    let within = if table.place("place").is_some() {
        "place"
    } else if table.name == "telemetry" {
        "time_s"
    } else {
        "start_s"
    };
    let sorted = format!(
        "SELECT * FROM {} WHERE {condition} ORDER BY robot, day, episode, {within}",
        table.name
    );
    let batches = session.rows(&sorted).await?;
    if batches.iter().all(|batch| batch.num_rows() == 0) {
        return Ok(None);
    }
    let schema = table.schema();
    let plain: Result<Vec<RecordBatch>, _> = (batches.iter())
        .map(|batch| {
            let columns = batch.columns().iter().zip(schema.fields());
            let columns: Result<Vec<_>, _> = columns
                .map(|(column, field)| datafusion::arrow::compute::cast(column, field.data_type()))
                .collect();
            RecordBatch::try_new(Arc::clone(&schema), columns?)
        })
        .collect();
    let plain = plain.map_err(datafusion::error::DataFusionError::from)?;
    let file = write_file(place, table, schema, &plain, extent(group)).await?;
    Ok(Some(file))
}

/// Returns the extent of a group's files.
fn extent(group: &[FileEntry]) -> BatchExtent {
    let least =
        |of: fn(&FileEntry) -> &String| group.iter().map(of).min().cloned().unwrap_or_default();
    let greatest =
        |of: fn(&FileEntry) -> &String| group.iter().map(of).max().cloned().unwrap_or_default();
    let day = |text: String| {
        let date: Option<jiff::civil::Date> = text.parse().ok();
        let zoned = date.and_then(|date| date.to_zoned(jiff::tz::TimeZone::UTC).ok());
        zoned.map_or(0, |zoned| day_of(zoned.timestamp().as_second() as f64))
    };
    BatchExtent {
        robots: [
            least(|file| &file.robots[0]),
            greatest(|file| &file.robots[1]),
        ],
        days: [
            day(least(|file| &file.days[0])),
            day(greatest(|file| &file.days[1])),
        ],
        times: [
            group
                .iter()
                .map(|file| file.times[0])
                .fold(f64::INFINITY, f64::min),
            group
                .iter()
                .map(|file| file.times[1])
                .fold(f64::NEG_INFINITY, f64::max),
        ],
        episodes: None,
    }
}

/// Makes telemetry of days before a time [s since 1970] unused: its rows, and its archives.
///
/// # Errors
/// If the store cannot be read or written.
pub async fn retain(place: &StorePlace, before: f64) -> Result<Retained, FleetError> {
    let since = day_text(day_of(before));
    let mut snapshot = Snapshot::read(place).await?;
    for _ in 0..TRIES {
        let old = snapshot
            .files_of("telemetry")
            .filter(|file| file.days[1] < since);
        let old: Vec<FileEntry> = old.cloned().collect();
        let mut commit = Commit::new("retain");
        commit.remove = old.iter().map(|file| file.path.clone()).collect();
        commit.telemetry_since = Some(since.clone());
        if snapshot.commit(place, &commit).await? == Committed::Done {
            return Ok(Retained {
                since,
                files: old.len(),
                bytes: old.iter().map(|file| file.bytes).sum(),
            });
        }
    }
    Err(FleetError::Contended {
        url: place.url().to_owned(),
        tries: TRIES,
    })
}

/// Deletes objects that have been unused since a time [s since 1970], and returns their number. Archives of telemetry
/// are deleted by the day of retention, and objects of killed writers without a commit by their age.
///
/// # Errors
/// If the store cannot be read or written.
pub async fn purge(place: &StorePlace, before: f64) -> Result<usize, FleetError> {
    let mut snapshot = Snapshot::read(place).await?;
    let removed = snapshot
        .removed
        .iter()
        .filter(|removed| removed.time <= before);
    let removed: Vec<String> = removed.map(|removed| removed.path.clone()).collect();
    let mut doomed: HashSet<String> = removed.iter().cloned().collect();
    let still: HashSet<&String> = snapshot
        .removed
        .iter()
        .map(|removed| &removed.path)
        .collect();
    for (name, _, time) in place.list("tables").await? {
        if time <= before && !snapshot.files.contains_key(&name) && !still.contains(&name) {
            doomed.insert(name);
        }
    }
    if snapshot.telemetry_since.is_some() {
        doomed.extend(telemetry_before(place, &snapshot, before).await?);
    }
    for name in &doomed {
        place.delete(name).await?;
    }
    if !removed.is_empty() {
        let mut commit = Commit::new("purge");
        commit.remove = removed;
        for _ in 0..TRIES {
            if snapshot.commit(place, &commit).await? == Committed::Done {
                break;
            }
        }
    }
    Ok(doomed.len())
}

/// Returns the archives of telemetry that is no longer kept and was written before this time.
async fn telemetry_before(
    place: &StorePlace,
    snapshot: &Snapshot,
    before: f64,
) -> Result<Vec<String>, FleetError> {
    let since = snapshot.telemetry_since.clone().unwrap_or_default();
    let source = SqlSource {
        place: place.clone(),
        snapshot: snapshot.clone(),
    };
    let session = SqlSession::new(&[source]).await?;
    let old = format!(
        "SELECT episode FROM episodes WHERE day < '{since}' AND telemetry_sha256 IS NOT NULL"
    );
    let mut ids = HashSet::new();
    for batch in session.rows(&old).await? {
        ids.extend(super::pull::texts(batch.column(0))?);
    }
    let listed = place.list("episodes").await?.into_iter();
    let old = listed.filter(|(name, _, time)| {
        let id = name
            .strip_prefix("episodes/")
            .and_then(|name| name.strip_suffix(".telemetry.tar.zst"));
        *time <= before && id.is_some_and(|id| ids.contains(id))
    });
    Ok(old.map(|(name, ..)| name).collect())
}

/// Returns the table of a file, if this program knows it.
pub(super) fn table_of(file: &FileEntry) -> Option<&'static Table> {
    table(&file.table)
}
