//! Memories for the tests.

use crate::records;
use std::collections::BTreeMap;
use std::path::Path;
use wisch::follow::Phase;
use wisch_fleet::ask::{SqlSession, SqlSource};
use wisch_fleet::store::StorePlace;
use wisch_memory::{EpisodeRecord, Mark, Memory, TelemetryHead};

pub const SEED: u64 = 7;
/// Number of samples in the telemetry.
pub const SAMPLES: usize = 1000;

/// Returns the first synthetic records.
pub fn some(count: usize) -> Vec<EpisodeRecord> {
    (0..count)
        .map(|number| records::record(SEED, number))
        .collect()
}

/// Creates a memory of these episodes. The first synthetic one has telemetry of its first round.
pub fn memory(folder: &Path, records: &[EpisodeRecord]) -> Memory {
    let memory = Memory::create(folder).unwrap();
    for record in records {
        let writer = memory.begin(&record.id).unwrap();
        writer
            .attach("task.toml", format!("name = {:?}\n", record.task))
            .unwrap();
        writer.attach("round-1/plan.json", "{}").unwrap();
        if record.seed == 0 {
            let columns = ["external/fz", "measured/x"].map(str::to_owned);
            let head = TelemetryHead::default();
            let mut log = writer.telemetry_with_columns(1, head, &columns).unwrap();
            let mark = Mark {
                motion: 0,
                phase: Phase::FreeMotion,
            };
            for i in 0..SAMPLES {
                let time = 0.001 * i as f64;
                log.push(time, mark, [5.0 + time, time]).unwrap();
            }
            log.finish().unwrap();
        }
        writer.commit(record).unwrap();
    }
    memory
}

/// Returns all files of a memory's episodes, by name.
pub fn contents(memory: &Memory) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for id in memory.episodes().unwrap() {
        let folder = memory.folder().join(&id);
        for name in memory.episode(&id).unwrap().files().unwrap() {
            all.insert(
                format!("{id}/{name}"),
                std::fs::read(folder.join(&name)).unwrap(),
            );
        }
    }
    all
}

pub fn place(folder: &Path) -> StorePlace {
    StorePlace::open(folder.to_str().unwrap()).unwrap()
}

pub async fn session(place: &StorePlace) -> SqlSession {
    let source = SqlSource::open(place.clone()).await.unwrap();
    SqlSession::new(&[source]).await.unwrap()
}
