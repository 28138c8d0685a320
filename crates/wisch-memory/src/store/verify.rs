//! Verification that all stored data are what was written, and readable.

use super::episode::{Episode, telemetry_file};
use super::sums::FileSum;
use super::{Memory, MemoryError, RECORD_FILE};

/// A fault of an episode's file.
#[derive(Debug)]
pub struct Fault {
    /// Name of the episode.
    pub episode: String,
    /// The fault and its place.
    pub error: MemoryError,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.episode, self.error)
    }
}

impl Memory {
    /// Verifies every file against its check sum, reads every record and every page of telemetry, and reports rounds
    /// without telemetry.
    ///
    /// # Errors
    /// If the folder cannot be listed.
    pub fn verify(&self) -> Result<Vec<Fault>, MemoryError> {
        let mut faults = Vec::new();
        for id in self.episodes()? {
            let found = match self.episode(&id) {
                Ok(episode) => {
                    let mut faults = episode.faults();
                    faults.extend(episode.missing_telemetry());
                    faults
                }
                // Deleted meanwhile.
                Err(MemoryError::Unknown { .. }) => continue,
                Err(error) => vec![error],
            };
            faults.extend(found.into_iter().map(|error| Fault {
                episode: id.clone(),
                error,
            }));
        }
        Ok(faults)
    }
}

impl Episode {
    /// Verifies every file against its check sum, and reads record and telemetry. Returns all faults.
    pub fn faults(&self) -> Vec<MemoryError> {
        let sums = match self.sums() {
            Ok(sums) => sums,
            Err(error) => return vec![error],
        };
        let mut faults = Vec::new();
        // The record must exist even if the check sums do not list it.
        if !sums.contains_key(RECORD_FILE) {
            faults.extend(self.record().err());
        }
        for (name, written) in &sums {
            faults.extend(fault_of(self, name, written).err());
        }
        faults
    }

    /// Returns the rounds without telemetry. The rest of the episode is complete and can be copied.
    fn missing_telemetry(&self) -> Vec<MemoryError> {
        let (Ok(sums), Ok(record)) = (self.sums(), self.record()) else {
            return Vec::new();
        };
        let rounds = 1..=record.rounds.len();
        let missing = rounds.filter(|round| !sums.contains_key(&telemetry_file(*round)));
        missing.map(|round| self.without_telemetry(round)).collect()
    }
}

fn fault_of(episode: &Episode, name: &str, written: &FileSum) -> Result<(), MemoryError> {
    let path = episode.folder().join(name);
    if let Some(what) = written.difference(&FileSum::of(&path)?) {
        return Err(MemoryError::Changed { path, what });
    }
    if name == RECORD_FILE {
        episode.record()?;
    }
    let round = name.strip_prefix("round-");
    let round = round.and_then(|rest| rest.strip_suffix(".parquet")?.parse().ok());
    if let Some(round) = round {
        episode.telemetry(round)?.verify()?;
    }
    let round = name.strip_prefix("round-");
    let round = round.and_then(|rest| rest.strip_suffix("/observations.json")?.parse().ok());
    if let Some(round) = round {
        episode.observations(round)?;
    }
    Ok(())
}
