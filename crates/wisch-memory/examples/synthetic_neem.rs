//! Writes synthetic episodes as a NEEM, for tests of other readers and for measurements.
//!
//! ```text
//! cargo run --release --workspace --example synthetic_neem -- FOLDER COUNT
//! ```

#[path = "synthetic/records.rs"]
mod records;

use std::error::Error;
use std::path::Path;
use wisch::geometry::Pose;
use wisch_memory::Ontology;
use wisch_memory::neem::{FrameSample, NeemConfig, NeemMeta, NeemWriter, import};

const SEED: u64 = 1;
/// Rate at which the tool's pose is passed to the writer [Hz].
const RATE: f64 = 100.0;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(folder), Some(count)) = (arguments.next(), arguments.next()) else {
        return Err("usage: synthetic_neem FOLDER COUNT".into());
    };
    let count: usize = count.parse()?;
    let meta = NeemMeta {
        name: "Synthetic wiping".to_owned(),
        description: format!("{count} synthetic episodes"),
        created_by: "wisch".to_owned(),
        created_at: records::FIRST_START,
        keywords: vec!["wiping".to_owned(), "synthetic".to_owned()],
        url: String::new(),
        activity: [
            "Wiping".to_owned(),
            Ontology::load().expand("semco:Wiping")?,
        ],
        environment: "none".to_owned(),
        agent: "humanoid".to_owned(),
        image: String::new(),
    };
    let folder = Path::new(&folder);
    let mut neem = NeemWriter::create(folder, &meta, &NeemConfig::default())?;
    for number in 0..count {
        let record = records::record(SEED, number);
        neem.episode(&record)?;
        let [start, end] = record.interval;
        for step in 0..((end - start) * RATE) as u64 {
            let time = start + step as f64 / RATE;
            // The tool circles with a radius of 0.1 m, once in 2 s.
            let (y, x) = (std::f64::consts::PI * (time - start)).sin_cos();
            neem.frame(&FrameSample {
                time,
                frame: "sponge",
                parent: "world",
                parent_from_frame: Pose::translation(0.1 * x, 0.1 * y, 0.8),
            })?;
        }
    }
    println!("{:?}", neem.finish()?);
    // The import must return what was written.
    for (number, record) in import(folder)?.iter().enumerate() {
        let written = (0..count).any(|number| records::record(SEED, number) == *record);
        if !written {
            return Err(
                format!("episode {number}, {}, differs after the import", record.id).into(),
            );
        }
    }
    Ok(())
}
