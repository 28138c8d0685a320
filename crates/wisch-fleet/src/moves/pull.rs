//! Pull: copies selected episodes of a fleet into a memory, byte for byte.

use super::push::{archive_name, telemetry_name};
use crate::ask::{SqlSession, SqlSource};
use crate::store::{Archive, FleetError, Snapshot, StorePlace, identity_of, is_telemetry};
use datafusion::arrow::array::{Array, ArrayRef, AsArray, RecordBatch};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Int64Type};
use datafusion::error::DataFusionError;
use wisch_memory::{Memory, MemoryError};

/// Selection of episodes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Filter {
    /// Episodes that ended at this time or later [s since 1970].
    pub since: Option<f64>,
    /// Episodes that began at this time or earlier [s since 1970].
    pub until: Option<f64>,
    /// Episodes of these robots; empty for all.
    pub robots: Vec<String>,
    /// Episodes with an individual of one of these classes; empty for all.
    pub classes: Vec<String>,
    /// Episodes with these names; empty for all.
    pub episodes: Vec<String>,
    /// A condition over the table of episodes, in SQL.
    pub condition: Option<String>,
}

/// Result of a pull.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Pulled {
    /// Number of selected episodes.
    pub selected: usize,
    /// Names of the selected episodes.
    pub ids: Vec<String>,
    /// Number of episodes in the fleet.
    pub of: usize,
    /// Number of copied episodes.
    pub episodes: usize,
    /// Number of episodes that the memory had already.
    pub there: usize,
    /// Number of episodes copied without telemetry, which the fleet no longer keeps.
    pub thinned: usize,
    /// Length of the copied archives [bytes].
    pub bytes: u64,
    /// Episodes that were not copied because they are damaged or their name is taken, with the reason.
    pub left_out: Vec<String>,
}

/// An episode in the fleet's table.
struct Kept {
    id: String,
    day: String,
    identity: String,
    archive: Option<String>,
    telemetry: Option<String>,
    bytes: u64,
}

impl Filter {
    /// Returns the SQL statement of the selection.
    fn statement(&self) -> String {
        let quoted = |names: &[String]| {
            let quoted = names.iter().map(|name| quote(name));
            quoted.collect::<Vec<_>>().join(", ")
        };
        let mut all = Vec::new();
        all.extend(self.since.map(|time| format!("end_s >= {time:?}")));
        all.extend(self.until.map(|time| format!("start_s <= {time:?}")));
        if !self.robots.is_empty() {
            all.push(format!("robot IN ({})", quoted(&self.robots)));
        }
        if !self.episodes.is_empty() {
            all.push(format!("episode IN ({})", quoted(&self.episodes)));
        }
        if !self.classes.is_empty() {
            let names = quoted(&self.classes);
            all.push(format!(
                "episode IN (SELECT episode FROM events WHERE class IN ({names}) UNION ALL \
                 SELECT episode FROM motions WHERE class IN ({names}))"
            ));
        }
        all.extend(self.condition.as_ref().map(|sql| format!("({sql})")));
        let wanted = if all.is_empty() {
            "TRUE".to_owned()
        } else {
            all.join(" AND ")
        };
        format!(
            "SELECT episode, CAST(day AS VARCHAR) AS day, identity, archive_sha256, telemetry_sha256, \
             coalesce(archive_bytes, 0) + coalesce(telemetry_bytes, 0) AS bytes \
             FROM episodes WHERE {wanted} ORDER BY episode"
        )
    }
}

/// Copies the selected episodes that the memory lacks. `report` receives the numbers of finished and of all episodes.
/// An episode that is damaged, or whose name another episode has, is skipped.
///
/// # Errors
/// If the log or a table is damaged, the store cannot be read, or the memory cannot be written. Episodes copied before
/// stay.
pub async fn pull(
    place: &StorePlace,
    memory: &Memory,
    filter: &Filter,
    report: &mut (dyn FnMut(usize, usize) + Send),
) -> Result<Pulled, FleetError> {
    let source = SqlSource::open(place.clone()).await?;
    let snapshot = source.snapshot.clone();
    let of = snapshot
        .files_of("episodes")
        .map(|file| file.rows)
        .sum::<u64>();
    let session = SqlSession::new(&[source]).await?;
    let mut selected = Vec::new();
    for batch in session.rows(&filter.statement()).await? {
        selected.extend(parse_rows(&batch)?);
    }
    let mut pulled = Pulled {
        selected: selected.len(),
        ids: selected.iter().map(|one| one.id.clone()).collect(),
        of: usize::try_from(of).unwrap_or(usize::MAX),
        ..Pulled::default()
    };
    for (done, one) in selected.iter().enumerate() {
        report(done, selected.len());
        match copy_if_absent(place, memory, &snapshot, one).await {
            Ok(Came::Before) => pulled.there += 1,
            Ok(came) => {
                pulled.thinned += usize::from(came == Came::WithoutTelemetry);
                pulled.episodes += 1;
                pulled.bytes += one.bytes;
            }
            Err(error) if is_of_one_episode(&error) => {
                pulled.left_out.push(format!("episode {}: {error}", one.id));
            }
            Err(error) => return Err(error),
        }
    }
    report(selected.len(), selected.len());
    Ok(pulled)
}

/// Returns a text of SQL.
pub(super) fn quote(text: &str) -> String {
    format!("'{}'", text.replace('\'', "''"))
}

fn parse_rows(batch: &RecordBatch) -> Result<Vec<Kept>, FleetError> {
    let texts: Result<Vec<_>, _> = (batch.columns()[..5].iter())
        .map(|column| cast(column, &DataType::Utf8))
        .collect();
    let texts = texts.map_err(DataFusionError::from)?;
    let bytes = batch.column(5).as_primitive::<Int64Type>();
    let rows = (0..batch.num_rows()).map(|row| {
        let text = |column: usize| {
            let column = texts[column].as_string::<i32>();
            column.is_valid(row).then(|| column.value(row).to_owned())
        };
        Kept {
            id: text(0).unwrap_or_default(),
            day: text(1).unwrap_or_default(),
            identity: text(2).unwrap_or_default(),
            archive: text(3),
            telemetry: text(4),
            bytes: u64::try_from(bytes.value(row)).unwrap_or_default(),
        }
    });
    Ok(rows.collect())
}

/// Returns the texts of a column; empty texts for nulls.
pub(super) fn texts(column: &ArrayRef) -> Result<Vec<String>, FleetError> {
    let texts = cast(column, &DataType::Utf8).map_err(DataFusionError::from)?;
    let texts = texts.as_string::<i32>().iter();
    Ok(texts
        .map(|text| text.unwrap_or_default().to_owned())
        .collect())
}

/// Whether the fleet no longer keeps an episode's telemetry.
fn is_thinned(snapshot: &Snapshot, one: &Kept) -> bool {
    let since = snapshot.telemetry_since.as_ref();
    one.telemetry.is_some() && since.is_some_and(|since| one.day < *since)
}

/// Whether an error concerns a single episode, not the store, the disk or other episodes.
fn is_of_one_episode(error: &FleetError) -> bool {
    match error {
        FleetError::Damaged { .. } | FleetError::Conflict { .. } => true,
        // A file in the check sums may be missing.
        FleetError::Memory(MemoryError::File { error, .. }) | FleetError::File { error, .. } => {
            error.kind() == std::io::ErrorKind::NotFound
        }
        FleetError::Memory(_) => true,
        _ => false,
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Came {
    Before,
    Whole,
    WithoutTelemetry,
}

/// Copies an episode into the memory, unless the memory has it.
async fn copy_if_absent(
    place: &StorePlace,
    memory: &Memory,
    snapshot: &Snapshot,
    one: &Kept,
) -> Result<Came, FleetError> {
    let Ok(episode) = memory.episode(&one.id) else {
        return fetch(place, memory, snapshot, one).await;
    };
    let identity = identity_of(&episode)?;
    // Without telemetry, the episode is the same but not its bytes.
    if identity != one.identity && !is_thinned(snapshot, one) {
        return Err(FleetError::Conflict {
            id: one.id.clone(),
            here: place.shown(&archive_name(&one.id)),
            here_identity: one.identity.clone(),
            there: episode.folder().display().to_string(),
            there_identity: identity,
        });
    }
    Ok(Came::Before)
}

/// Copies an episode into the memory.
async fn fetch(
    place: &StorePlace,
    memory: &Memory,
    snapshot: &Snapshot,
    one: &Kept,
) -> Result<Came, FleetError> {
    let name = archive_name(&one.id);
    let Some(sum) = &one.archive else {
        return Err(FleetError::Damaged {
            object: place.shown(&name),
            what: "the fleet has rows of this episode, but no archive".to_owned(),
        });
    };
    let mut files = read_archive(place, &name, sum).await?;
    let mut came = Came::Whole;
    if let Some(sum) = &one.telemetry {
        let name = telemetry_name(&one.id);
        if is_thinned(snapshot, one) {
            came = Came::WithoutTelemetry;
            forget_telemetry(&mut files, &place.shown(&archive_name(&one.id)))?;
        } else {
            files.extend(read_archive(place, &name, sum).await?);
        }
    }
    let writer = memory.begin(&one.id)?;
    for (name, contents) in &files {
        writer.restore(name, contents)?;
    }
    writer.commit_restored()?;
    Ok(came)
}

/// Returns the files of an archive, after verifying its checksum.
pub(super) async fn read_archive(
    place: &StorePlace,
    name: &str,
    sum: &str,
) -> Result<Vec<(String, Vec<u8>)>, FleetError> {
    let archive = Archive::from_bytes(place.get(name).await?);
    if archive.sha256 != sum {
        return Err(FleetError::Damaged {
            object: place.shown(name),
            what: format!(
                "its SHA-256 is {}, but {sum} was written ({} bytes are there)",
                archive.sha256,
                archive.bytes.len()
            ),
        });
    }
    archive.files(&place.shown(name))
}

/// Removes telemetry from the check sums, so that the remaining episode is complete.
fn forget_telemetry(files: &mut [(String, Vec<u8>)], object: &str) -> Result<(), FleetError> {
    for (_, contents) in files
        .iter_mut()
        .filter(|(name, _)| name == "checksums.json")
    {
        let sums = serde_json::from_slice::<serde_json::Map<_, _>>(contents);
        let mut sums = sums.map_err(|error| FleetError::Damaged {
            object: object.to_owned(),
            what: format!("checksums.json: {error}"),
        })?;
        sums.retain(|name, _| !is_telemetry(name));
        *contents = serde_json::to_vec(&sums).unwrap_or_default();
    }
    Ok(())
}
