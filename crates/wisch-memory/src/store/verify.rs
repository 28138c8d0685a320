//! Whether all that is stored is what was written, and can be read.

use super::episode::{Episode, telemetry_file};
use super::sums::FileSum;
use super::{Memory, MemoryError, RECORD_FILE};

/// Something wrong with a file of an episode.
#[derive(Debug)]
pub struct Fault {
    /// The episode.
    pub episode: String,
    /// What is wrong, and where.
    pub error: MemoryError,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.episode, self.error)
    }
}

impl Memory {
    /// Holds every file against its check sum, and reads every record and every page of every telemetry; names rounds
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
                // Forgotten meanwhile.
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
    /// What is wrong with it: every file is held against its check sum, its record and all telemetry are read.
    pub fn faults(&self) -> Vec<MemoryError> {
        let sums = match self.sums() {
            Ok(sums) => sums,
            Err(error) => return vec![error],
        };
        let mut faults = Vec::new();
        // The record has to be there even if the sums know nothing of it.
        if !sums.contains_key(RECORD_FILE) {
            faults.extend(self.record().err());
        }
        for (name, written) in &sums {
            faults.extend(fault_of(self, name, written).err());
        }
        faults
    }

    /// The rounds of its record of which no telemetry was kept. The rest of it is whole, and can be copied.
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
