//! Writes a memory of synthetic episodes, to measure with and to try queries on.
//!
//! ```text
//! cargo run --release -p wisch-memory --example synthetic -- --episodes 10000 --seed 1 --out /tmp/episodes
//! cargo run --release -p wisch-memory --example synthetic -- --hour --out /tmp/episodes
//! ```

mod hour;
mod pushed;
mod records;

use std::path::PathBuf;
use std::thread;
use std::time::Instant;
use wisch_memory::{Memory, MemoryError, RobotText, RoundScene};

/// Episodes are written by so many at the same time: each waits for the disk most of the time.
const WRITERS: usize = 16;

/// What the command line asks for.
struct Asked {
    episodes: usize,
    seed: u64,
    out: PathBuf,
    hour: bool,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asked = asked()?;
    let memory = &Memory::create(&asked.out)?;
    let asked = &asked;
    let begun = Instant::now();
    thread::scope(|scope| {
        let writers: Vec<_> = (0..WRITERS)
            .map(|writer| scope.spawn(move || write_some(memory, asked, writer)))
            .collect();
        let mut written = writers.into_iter().map(|writer| match writer.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        written.try_for_each(|result| result)
    })?;
    let seconds = begun.elapsed().as_secs_f64();
    println!("{} episodes written in {seconds:.1} s", asked.episodes);
    if asked.hour {
        write_hour(memory, asked)?;
    }
    for time in ["cold", "warm"] {
        let begun = Instant::now();
        let catalogue = memory.catalogue()?;
        println!(
            "{time}: catalogue of {} episodes, {} individuals, in {:.3} s",
            catalogue.episodes().len(),
            catalogue.len(),
            begun.elapsed().as_secs_f64()
        );
    }
    Ok(())
}

/// Every so manieth episode.
fn write_some(memory: &Memory, asked: &Asked, writer: usize) -> Result<(), MemoryError> {
    for number in (writer..asked.episodes).step_by(WRITERS) {
        let record = records::record(asked.seed, number);
        memory.begin(&record.id)?.commit(&record)?;
    }
    Ok(())
}

fn write_hour(memory: &Memory, asked: &Asked) -> Result<(), Box<dyn std::error::Error>> {
    let record = pushed::record(asked.seed);
    let writer = memory.begin(&record.id)?;
    let robot = RobotText {
        urdf: hour::urdf(),
        ..RobotText::default()
    };
    robot.attach_to(&writer)?;
    let head = RoundScene::upright("arm", "tip", "sponge", "chopping_board").head(hour::joints());
    let mut telemetry = writer.telemetry(1, head)?;
    let begun = Instant::now();
    hour::write(asked.seed, hour::SAMPLES, &mut |sample| {
        telemetry.write(sample)
    })?;
    telemetry.finish()?;
    let seconds = begun.elapsed().as_secs_f64();
    writer.commit(&record)?;
    let file = memory.folder().join(&record.id).join("round-1.parquet");
    let bytes = std::fs::metadata(file)?.len();
    println!(
        "an hour at 1 kHz: {:.3} GB, written in {seconds:.1} s ({:.2} % of the hour)",
        bytes as f64 * 1e-9,
        100.0 * seconds / 3600.0
    );
    Ok(())
}

fn asked() -> Result<Asked, Box<dyn std::error::Error>> {
    let mut asked = Asked {
        episodes: 0,
        seed: 1,
        out: PathBuf::from("episodes"),
        hour: false,
    };
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        let mut value = || args.next().ok_or(format!("{arg} wants a value"));
        match arg.as_str() {
            "--episodes" => asked.episodes = value()?.parse()?,
            "--seed" => asked.seed = value()?.parse()?,
            "--out" => asked.out = value()?.into(),
            "--hour" => asked.hour = true,
            _ => return Err(format!("{arg}: known are --episodes, --seed, --out, --hour").into()),
        }
    }
    Ok(asked)
}
