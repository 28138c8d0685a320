//! Push: copies episodes of a memory into a fleet, each as an archive and as rows.

use super::batch::{Grouping, Incoming, write};
use super::known::Known;
use crate::store::{
    Archive, Commit, Committed, Created, FleetError, Snapshot, StorePlace, identity_of,
};
use crate::tables::{Keep, day_of};
use std::collections::HashSet;
use wisch_memory::{Catalogue, Episode, Memory};

/// Limits of a commit in episodes and bytes, which bound the work that a killed push repeats.
const BATCH_EPISODES: usize = 256;
const BATCH_BYTES: u64 = 256 << 20;
/// Number of attempts to commit against other writers.
const TRIES: usize = 100;

/// Options of a push.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PushOptions {
    /// Name of the robot, if the record's own is not unique.
    pub robot: Option<String>,
}

/// Result of a push.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Pushed {
    /// Number of added episodes.
    pub episodes: usize,
    /// Number of episodes that the fleet had already.
    pub there: usize,
    /// Length of added archives and files [bytes].
    pub bytes: u64,
    /// Number of commits.
    pub commits: usize,
}

/// Copies the episodes that the fleet lacks. `report` receives the numbers of finished and of all episodes.
///
/// # Errors
/// If an episode is damaged, its name is taken by another episode, or the store cannot be written. Earlier commits
/// stay.
pub async fn push(
    memory: &Memory,
    place: &StorePlace,
    options: &PushOptions,
    report: &mut (dyn FnMut(usize, usize) + Send),
) -> Result<Pushed, FleetError> {
    let catalogue = memory.catalogue()?;
    if let Some(why) = catalogue.omitted_episodes().first() {
        return Err(FleetError::Damaged {
            object: memory.folder().display().to_string(),
            what: why.clone(),
        });
    }
    let mut snapshot = Snapshot::read(place).await?;
    let mut known = Known::new();
    known.read(place, &snapshot, Some(days(&catalogue))).await?;
    let mut rows: Vec<_> = catalogue.episodes().iter().collect();
    rows.sort_by(|a, b| {
        a.interval[0]
            .total_cmp(&b.interval[0])
            .then(a.id.cmp(&b.id))
    });
    let total = rows.len();
    let mut pushed = Pushed::default();
    let mut batch: Vec<Incoming> = Vec::new();
    let mut length = 0;
    for (done, row) in rows.into_iter().enumerate() {
        report(done, total);
        let episode = memory.episode(&row.id)?;
        let identity = identity_of(&episode)?;
        if let Some(there) = known.identity(&row.id) {
            same(&episode, &identity, place, there)?;
            pushed.there += 1;
            continue;
        }
        let incoming = archive(place, &episode, identity, options, &snapshot).await?;
        length += [&incoming.keep.archive, &incoming.keep.telemetry]
            .into_iter()
            .flatten()
            .map(|(_, bytes)| bytes)
            .sum::<u64>();
        batch.push(incoming);
        if batch.len() >= BATCH_EPISODES || length >= BATCH_BYTES {
            pushed.bytes += length;
            length = 0;
            commit(
                place,
                &mut snapshot,
                std::mem::take(&mut batch),
                &mut pushed,
            )
            .await?;
        }
    }
    pushed.bytes += length;
    commit(place, &mut snapshot, batch, &mut pushed).await?;
    report(total, total);
    Ok(pushed)
}

/// Returns first and last day of all episodes.
fn days(catalogue: &Catalogue) -> [i32; 2] {
    let days = || {
        catalogue
            .episodes()
            .iter()
            .map(|row| day_of(row.interval[0]))
    };
    [
        days().min().unwrap_or_default(),
        days().max().unwrap_or_default(),
    ]
}

/// Whether the fleet's episode is the same.
fn same(
    episode: &Episode,
    identity: &str,
    place: &StorePlace,
    there: &str,
) -> Result<(), FleetError> {
    if identity == there {
        return Ok(());
    }
    Err(FleetError::Conflict {
        id: episode.id().to_owned(),
        here: episode.folder().display().to_string(),
        here_identity: identity.to_owned(),
        there: place.shown(&archive_name(episode.id())),
        there_identity: there.to_owned(),
    })
}

/// Name of an episode's archive.
pub(super) fn archive_name(id: &str) -> String {
    format!("episodes/{id}.tar.zst")
}

/// Name of the archive of its telemetry.
pub(super) fn telemetry_name(id: &str) -> String {
    format!("episodes/{id}.telemetry.tar.zst")
}

/// Adds an episode's archives, which become valid with the commit that lists them.
async fn archive(
    place: &StorePlace,
    episode: &Episode,
    identity: String,
    options: &PushOptions,
    snapshot: &Snapshot,
) -> Result<Incoming, FleetError> {
    if let Some(fault) = episode.faults().into_iter().next() {
        return Err(fault.into());
    }
    let record = episode.record()?;
    let day = super::batch::day_text(day_of(record.interval[0]));
    let mut incoming = Incoming::new(record, options.robot.as_deref());
    let whole = Archive::of_episode(episode)?;
    let name = archive_name(episode.id());
    let whole = match place.create(&name, whole.bytes.clone()).await? {
        Created::New => whole,
        // Left by a push that was killed or runs in parallel, perhaps compressed by another version of zstd.
        Created::There => {
            let there = Archive::from_bytes(place.get(&name).await?);
            let other = there.identity(&place.shown(&name))?;
            same(episode, &identity, place, &other)?;
            there
        }
    };
    let is_kept = snapshot
        .telemetry_since
        .as_ref()
        .is_none_or(|since| day >= *since);
    let telemetry = match is_kept {
        true => Archive::of_telemetry(episode)?,
        false => None,
    };
    let sum_of = |archive: &Archive| (archive.sha256.clone(), archive.bytes.len() as u64);
    let mut keep = Keep {
        identity: Some(identity),
        archive: Some(sum_of(&whole)),
        telemetry: None,
    };
    if let Some(telemetry) = telemetry {
        let name = telemetry_name(episode.id());
        let there = match place.create(&name, telemetry.bytes.clone()).await? {
            Created::New => telemetry,
            Created::There => {
                let there = Archive::from_bytes(place.get(&name).await?);
                // The episode is the same, so its telemetry must be, unless this object is damaged.
                if there.files(&place.shown(&name))? != telemetry.files(&place.shown(&name))? {
                    return Err(FleetError::Damaged {
                        object: place.shown(&name),
                        what: format!("it is not the telemetry of {}", episode.folder().display()),
                    });
                }
                there
            }
        };
        keep.telemetry = Some(sum_of(&there));
        incoming.telemetry = Some(episode.clone());
    }
    incoming.keep = keep;
    Ok(incoming)
}

/// Writes and commits the rows of a batch, without episodes that another writer has added meanwhile.
async fn commit(
    place: &StorePlace,
    snapshot: &mut Snapshot,
    mut batch: Vec<Incoming>,
    pushed: &mut Pushed,
) -> Result<(), FleetError> {
    for _ in 0..TRIES {
        if batch.is_empty() {
            return Ok(());
        }
        let count = batch.len();
        let kept: Vec<Incoming> = batch.iter().map(Incoming::again).collect();
        let mut commit = Commit::new("push");
        commit.add = write(place, batch, Grouping::ByRobotAndDay).await?;
        batch = kept;
        loop {
            match snapshot.commit(place, &commit).await? {
                Committed::Done => {
                    pushed.episodes += count;
                    pushed.bytes += commit.add.iter().map(|file| file.bytes).sum::<u64>();
                    pushed.commits += 1;
                    return Ok(());
                }
                Committed::Lost(newer) => {
                    let files = newer.iter().flat_map(|commit| &commit.add);
                    let theirs: HashSet<&String> = files
                        .flat_map(|file| file.episodes.iter().flatten())
                        .collect();
                    let before = batch.len();
                    batch.retain(|one| !theirs.contains(&one.record.id));
                    if batch.len() < before {
                        // The names of the archives guarantee the same bytes.
                        pushed.there += before - batch.len();
                        break;
                    }
                }
            }
        }
    }
    Err(FleetError::Contended {
        url: place.url().to_owned(),
        tries: TRIES,
    })
}
