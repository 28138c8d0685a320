//! Forget: removes single episodes from a fleet. Files that hold their rows are written anew without them.

use super::pull::{quote, texts};
use super::push::{archive_name, telemetry_name};
use super::upkeep::write_rows;
use crate::ask::{SqlSession, SqlSource};
use crate::store::{Commit, Committed, FileEntry, FleetError, Snapshot, StorePlace};
use crate::tables::TABLES;
use std::collections::BTreeSet;

/// Number of attempts to commit against other writers.
const TRIES: usize = 100;

/// Result of forgetting episodes.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Forgotten {
    /// Number of removed episodes.
    pub episodes: usize,
    /// Number of files of rows that were written anew or removed.
    pub files: usize,
}

/// Removes episodes from a fleet: their rows leave the log in one commit, and then their archives are deleted. The old
/// files of rows are unused, and a later compaction deletes them.
///
/// # Errors
/// If the fleet has no episode of one of these names, which leaves the fleet as it was; or if the store cannot be read
/// or written.
pub async fn forget(place: &StorePlace, ids: &[String]) -> Result<Forgotten, FleetError> {
    let ids: BTreeSet<&str> = ids.iter().map(String::as_str).collect();
    let names: Vec<String> = ids.iter().map(|id| quote(id)).collect();
    let names = names.join(", ");
    let mut snapshot = Snapshot::read(place).await?;
    for _ in 0..TRIES {
        let found = find_episodes(place, &snapshot, &names).await?;
        for id in &ids {
            // A process that ended early may have left an archive of an episode that is no longer in the log.
            let is_known = found.iter().any(|one| one.id == *id);
            if !is_known && (id.contains('/') || place.head(&archive_name(id)).await?.is_none()) {
                return Err(FleetError::Asked(format!(
                    "{} has no episode {id:?}, so nothing was removed; SELECT episode FROM episodes lists the names",
                    place.url()
                )));
            }
        }
        let mut commit = Commit::new("forget");
        let condition = format!("episode NOT IN ({names})");
        for table in &TABLES {
            let files: Vec<FileEntry> = snapshot.files_of(table.name).cloned().collect();
            for file in files {
                if !found.iter().any(|one| one.may_be_in(&file)) {
                    continue;
                }
                let group = std::slice::from_ref(&file);
                let left = write_rows(place, &snapshot, table, group, &condition).await?;
                if left.as_ref().is_some_and(|left| left.rows == file.rows) {
                    continue;
                }
                commit.remove.push(file.path);
                commit.add.extend(left);
            }
        }
        if !commit.remove.is_empty() && snapshot.commit(place, &commit).await? != Committed::Done {
            continue;
        }
        for id in &ids {
            for name in [archive_name(id), telemetry_name(id)] {
                place.delete(&name).await?;
            }
        }
        return Ok(Forgotten {
            episodes: ids.len(),
            files: commit.remove.len(),
        });
    }
    Err(FleetError::Contended {
        url: place.url().to_owned(),
        tries: TRIES,
    })
}

/// An episode of the fleet.
struct FoundEpisode {
    id: String,
    robot: String,
    day: String,
}

impl FoundEpisode {
    /// Whether a file may hold rows of the episode.
    fn may_be_in(&self, file: &FileEntry) -> bool {
        let [first, last] = &file.robots;
        let [from, to] = &file.days;
        (first..=last).contains(&&self.robot) && (from..=to).contains(&&self.day)
    }
}

/// Returns the episodes of these quoted names.
async fn find_episodes(
    place: &StorePlace,
    snapshot: &Snapshot,
    names: &str,
) -> Result<Vec<FoundEpisode>, FleetError> {
    let source = SqlSource {
        place: place.clone(),
        snapshot: snapshot.clone(),
    };
    let session = SqlSession::new(&[source]).await?;
    let sql = format!(
        "SELECT episode, robot, CAST(day AS VARCHAR) FROM episodes WHERE episode IN ({names})"
    );
    let mut found = Vec::new();
    for batch in session.rows(&sql).await? {
        let [ids, robots, days] = [0, 1, 2].map(|column| texts(batch.column(column)));
        let places = robots?.into_iter().zip(days?);
        let rows = ids?.into_iter().zip(places);
        found.extend(rows.map(|(id, (robot, day))| FoundEpisode { id, robot, day }));
    }
    Ok(found)
}
