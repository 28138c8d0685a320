//! Verification that all valid data of a fleet are what was written.

use super::pull::{read_archive, texts};
use super::push::{archive_name, telemetry_name};
use super::upkeep::table_of;
use crate::ask::{SqlSession, SqlSource};
use crate::store::{FleetError, StorePlace, sha256};
use std::collections::HashSet;

/// Result of a verification.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Verified {
    /// Number of files of rows that were read.
    pub files: usize,
    /// Number of episodes whose archives were read.
    pub episodes: usize,
    /// Faults.
    pub faults: Vec<String>,
}

/// Reads every file and every episode's archives. `report` receives the number of finished ones.
///
/// # Errors
/// If the log or the table of episodes cannot be read.
pub async fn verify(
    place: &StorePlace,
    report: &mut (dyn FnMut(usize, usize) + Send),
) -> Result<Verified, FleetError> {
    let source = SqlSource::open(place.clone()).await?;
    let files: Vec<_> = source.snapshot.files.values().cloned().collect();
    let since = source.snapshot.telemetry_since.clone().unwrap_or_default();
    let mut verified = Verified::default();
    let total = files.len();
    for file in &files {
        report(verified.files, total);
        verified.files += 1;
        let shown = place.shown(&file.path);
        if table_of(file).is_none() {
            verified
                .faults
                .push(format!("{shown}: there is no table {:?}", file.table));
        }
        let bytes = match place.get(&file.path).await {
            Ok(bytes) => bytes,
            Err(error) => {
                verified.faults.push(error.to_string());
                continue;
            }
        };
        let (now, then) = (bytes.len() as u64, file.bytes);
        if now != then {
            verified.faults.push(format!(
                "{shown}: it is {now} bytes long, but {then} were written"
            ));
        } else if sha256(&bytes) != file.sha256 {
            verified
                .faults
                .push(format!("{shown}: its SHA-256 is not {}", file.sha256));
        }
    }
    if !verified.faults.is_empty() {
        return Ok(verified);
    }
    let session = SqlSession::new(&[source]).await?;
    let all = "SELECT episode, CAST(day AS VARCHAR), archive_sha256, telemetry_sha256 FROM episodes ORDER BY episode";
    let mut seen = HashSet::new();
    for batch in session.rows(all).await? {
        let [ids, days, archives, telemetry] =
            [0, 1, 2, 3].map(|column| texts(batch.column(column)));
        let kept = archives?.into_iter().zip(telemetry?);
        for ((id, day), (archive, telemetry)) in ids?.into_iter().zip(days?).zip(kept) {
            if !seen.insert(id.clone()) {
                verified
                    .faults
                    .push(format!("{}: episode {id} occurs twice", place.url()));
            }
            verified.episodes += 1;
            if archive.is_empty() {
                continue;
            }
            let mut wanted = vec![(archive_name(&id), archive)];
            if !telemetry.is_empty() && day >= since {
                wanted.push((telemetry_name(&id), telemetry));
            }
            for (name, sum) in wanted {
                let read = read_archive(place, &name, &sum).await;
                verified
                    .faults
                    .extend(read.err().map(|error| error.to_string()));
            }
        }
    }
    Ok(verified)
}
