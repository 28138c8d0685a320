//! A local memory as a source. Its rows are cached beside its catalogue in `.catalogue/fleet/`, a fleet without
//! archives. The cache is updated before each use, and may be deleted at any time.

use super::batch::{Grouping, Incoming, write, write_telemetry};
use super::known::Known;
use crate::ask::SqlSource;
use crate::store::{Commit, Committed, FleetError, Snapshot, StorePlace};
use crate::tables::file::VERSION;
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use wisch_memory::Memory;

/// Number of episodes in one file.
const BATCH: usize = 10_000;

/// Requested tables of a memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// All tables except telemetry.
    Facts,
    /// All tables.
    Telemetry,
}

/// Rows of a memory, with their temporary folder if the memory is read-only.
pub struct Local {
    /// Sources for a session.
    pub sources: Vec<SqlSource>,
    /// Episodes that cannot be read, with the reason.
    pub left_out: Vec<String>,
    _elsewhere: Option<tempfile::TempDir>,
}

/// Returns the rows of a memory in its present state.
///
/// # Errors
/// If the memory cannot be read, or a file cannot be written.
pub async fn open_local(memory: &Memory, part: Part) -> Result<Local, FleetError> {
    let beside = memory.folder().join(".catalogue");
    let (folder, elsewhere) = match is_writable(&beside) {
        true => (beside, None),
        false => {
            let elsewhere = tempfile::tempdir().map_err(|error| FleetError::File {
                path: std::env::temp_dir(),
                error,
            })?;
            (elsewhere.path().to_path_buf(), Some(elsewhere))
        }
    };
    let mut left_out = Vec::new();
    let facts = up_to_date(memory, &folder.join("fleet"), Part::Facts, &mut left_out).await?;
    let mut facts = SqlSource::open(facts).await?;
    if part == Part::Telemetry {
        let mut again = Vec::new();
        let place = folder.join("fleet").join("telemetry");
        let place = up_to_date(memory, &place, Part::Telemetry, &mut again).await?;
        // A fleet inside the fleet, so that one store holds both.
        let telemetry = Snapshot::read(&place).await?;
        let only = telemetry
            .files
            .into_values()
            .filter(|file| file.table == "telemetry");
        for mut file in only {
            file.path = format!("telemetry/{}", file.path);
            facts.snapshot.files.insert(file.path.clone(), file);
        }
    }
    Ok(Local {
        sources: vec![facts],
        left_out,
        _elsewhere: elsewhere,
    })
}

fn is_writable(folder: &Path) -> bool {
    fs::create_dir_all(folder).is_ok() && tempfile::tempfile_in(folder).is_ok()
}

/// Adds the rows of new episodes; starts anew if an episode was deleted or replaced, or an earlier version wrote rows.
async fn up_to_date(
    memory: &Memory,
    folder: &Path,
    part: Part,
    left_out: &mut Vec<String>,
) -> Result<StorePlace, FleetError> {
    let place = StorePlace::open(&folder.display().to_string())?;
    let (mut snapshot, mut known) = match read(&place).await {
        Ok(found) => found,
        // A damaged cache is rebuilt.
        Err(_) => empty(folder, &place).await?,
    };
    let ids = memory.episodes()?;
    let there: HashSet<&str> = ids.iter().map(String::as_str).collect();
    // Rows by an earlier version lack columns.
    let mut stale = snapshot.files.values().any(|file| file.schema < VERSION)
        || known.names().any(|id| !there.contains(id));
    for id in &ids {
        stale = stale
            || known
                .identity(id)
                .is_some_and(|then| then != stamp(memory, id));
    }
    if stale {
        (snapshot, known) = empty(folder, &place).await?;
    }
    let mut new: Vec<&String> = ids
        .iter()
        .filter(|id| known.identity(id).is_none())
        .collect();
    // If several processes do the same, each batch is added by one of them.
    while !new.is_empty() {
        let batch: Vec<&String> = new.drain(..new.len().min(BATCH)).collect();
        let mut incoming = Vec::new();
        for id in batch {
            let episode = memory.episode(id)?;
            match episode.record() {
                Ok(record) => {
                    let mut one = Incoming::new(record, None);
                    one.keep.identity = Some(stamp(memory, id));
                    one.telemetry = (part == Part::Telemetry).then_some(episode);
                    incoming.push(one);
                }
                Err(error) => left_out.push(format!("episode {id}: {error}")),
            }
        }
        if incoming.is_empty() {
            continue;
        }
        let mut commit = Commit::new("project");
        if part == Part::Telemetry {
            let rows = incoming.iter().map(Incoming::again).collect();
            commit.add = write_telemetry(&place, rows).await?;
            incoming.iter_mut().for_each(|one| one.telemetry = None);
        }
        commit
            .add
            .extend(write(&place, incoming, Grouping::Together).await?);
        if let Committed::Lost(_) = snapshot.commit(&place, &commit).await? {
            // Another process has added episodes, so the list of new ones is recomputed.
            let (now, known) = read(&place).await?;
            snapshot = now;
            new = ids
                .iter()
                .filter(|id| known.identity(id).is_none())
                .collect();
        }
    }
    Ok(place)
}

async fn read(place: &StorePlace) -> Result<(Snapshot, Known), FleetError> {
    let snapshot = Snapshot::read(place).await?;
    let mut known = Known::new();
    known.read(place, &snapshot, None).await?;
    Ok((snapshot, known))
}

async fn empty(folder: &Path, place: &StorePlace) -> Result<(Snapshot, Known), FleetError> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(FleetError::File {
            path: PathBuf::from(folder),
            error,
        }),
        _ => read(place).await,
    }
}

/// Returns a stamp that changes when an episode is replaced by another with its name: time and length of its check
/// sums.
fn stamp(memory: &Memory, id: &str) -> String {
    let path = memory.folder().join(id).join("checksums.json");
    let Ok(meta) = fs::metadata(path) else {
        return String::new();
    };
    let time = meta.modified().ok();
    let time = time.and_then(|time| time.duration_since(std::time::UNIX_EPOCH).ok());
    format!("{:x}-{:x}", time.unwrap_or_default().as_nanos(), meta.len())
}
