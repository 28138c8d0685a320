//! Writes a memory of synthetic episodes, for measurements and for trying queries.
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

/// Number of parallel writers, each of which mostly waits for the disk.
const WRITERS: usize = 16;

/// Command-line arguments.
struct Arguments {
    episodes: usize,
    seed: u64,
    out: PathBuf,
    hour: bool,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = parse_arguments()?;
    let memory = &Memory::create(&arguments.out)?;
    let arguments = &arguments;
    let begun = Instant::now();
    thread::scope(|scope| {
        let writers: Vec<_> = (0..WRITERS)
            .map(|writer| scope.spawn(move || write_some(memory, arguments, writer)))
            .collect();
        let mut written = writers.into_iter().map(|writer| match writer.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        written.try_for_each(|result| result)
    })?;
    let seconds = begun.elapsed().as_secs_f64();
    println!("{} episodes written in {seconds:.1} s", arguments.episodes);
    if arguments.hour {
        write_hour(memory, arguments)?;
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

/// Writes the episodes of one of the parallel writers.
fn write_some(memory: &Memory, arguments: &Arguments, writer: usize) -> Result<(), MemoryError> {
    for number in (writer..arguments.episodes).step_by(WRITERS) {
        let record = records::record(arguments.seed, number);
        memory.begin(&record.id)?.commit(&record)?;
    }
    Ok(())
}

fn write_hour(memory: &Memory, arguments: &Arguments) -> Result<(), Box<dyn std::error::Error>> {
    let record = pushed::record(arguments.seed);
    let writer = memory.begin(&record.id)?;
    let robot = RobotText {
        urdf: hour::urdf(),
        ..RobotText::default()
    };
    robot.attach_to(&writer)?;
    let head = RoundScene::with_upright_tool("arm", "tip", "sponge", "chopping_board")
        .head(hour::joints());
    let mut telemetry = writer.telemetry(1, head)?;
    let begun = Instant::now();
    hour::write(arguments.seed, hour::SAMPLES, &mut |sample| {
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

fn parse_arguments() -> Result<Arguments, Box<dyn std::error::Error>> {
    let mut arguments = Arguments {
        episodes: 0,
        seed: 1,
        out: PathBuf::from("episodes"),
        hour: false,
    };
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        let mut value = || args.next().ok_or(format!("{arg} needs a value"));
        match arg.as_str() {
            "--episodes" => arguments.episodes = value()?.parse()?,
            "--seed" => arguments.seed = value()?.parse()?,
            "--out" => arguments.out = value()?.into(),
            "--hour" => arguments.hour = true,
            _ => {
                return Err(format!(
                    "unexpected argument {arg}; expected --episodes, --seed, --out or --hour"
                )
                .into());
            }
        }
    }
    Ok(arguments)
}
