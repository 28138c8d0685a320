//! Writes the tables of synthetic episodes into a fleet for measurements; its files equal those of `push` and
//! `compact`.
//!
//! ```text
//! cargo run --release --features synthetic --bin synthetic_fleet -- --episodes 1000000 --robots 100 --out /tmp/fleet
//! ```
//!
//! Episodes are 20 minutes apart, 72 a day. Each robot has its own clock, so that it has 72 episodes a day. There are
//! no archives and no telemetry.

#[path = "../../../wisch-memory/examples/synthetic/records.rs"]
#[allow(dead_code)]
mod records;

use std::collections::BTreeMap;
use std::time::Instant;
use wisch_fleet::moves::batch::{Grouping, Incoming, write};
use wisch_fleet::store::{Commit, Snapshot, StorePlace};

/// Number of episodes in one file of each table.
const TOGETHER: usize = 50_000;

#[tokio::main]
async fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let pairs = args
        .chunks(2)
        .filter_map(|pair| Some((pair.first()?.as_str(), pair.get(1)?.as_str())));
    let options: BTreeMap<&str, &str> = pairs.collect();
    let number =
        |name: &str, otherwise: usize| options.get(name).map_or(Ok(otherwise), |text| text.parse());
    let (episodes, robots) = (
        number("--episodes", 10_000)?,
        number("--robots", 100)?.max(1),
    );
    let place = StorePlace::open(options.get("--out").copied().unwrap_or("fleet"))?;
    let mut snapshot = Snapshot::read(&place).await?;
    let begun = Instant::now();
    let each = episodes.div_ceil(robots);
    let mut batch = Vec::new();
    let mut done = 0;
    for robot in 0..robots {
        let name = format!("robot-{robot:03}");
        for number in 0..each.min(episodes - done) {
            let mut record = records::record(robot as u64 + 1, number);
            record.id = format!("{}-{robot:03}", record.id);
            batch.push(Incoming::new(record, Some(&name)));
            done += 1;
            if batch.len() == TOGETHER || done == episodes {
                let mut commit = Commit::new("synthetic");
                commit.add = write(&place, std::mem::take(&mut batch), Grouping::Together).await?;
                snapshot.commit(&place, &commit).await?;
            }
        }
    }
    let seconds = begun.elapsed().as_secs_f64();
    let mut tables: BTreeMap<&str, (u64, u64)> = BTreeMap::new();
    for file in snapshot.files.values() {
        let (rows, bytes) = tables.entry(&file.table).or_default();
        *rows += file.rows;
        *bytes += file.bytes;
    }
    for (table, (rows, bytes)) in &tables {
        println!(
            "{table:<13} {rows:>10} rows {:>8.1} bytes per episode",
            *bytes as f64 / episodes as f64
        );
    }
    let bytes: u64 = tables.values().map(|(_, bytes)| bytes).sum();
    println!(
        "{episodes} episodes: {:.1} bytes and {:.1} µs each, {seconds:.1} s in all",
        bytes as f64 / episodes as f64,
        seconds / episodes as f64 * 1e6
    );
    Ok(())
}
