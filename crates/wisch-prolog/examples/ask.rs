//! Asks a memory, and takes the time: `ask [--swi] FOLDER QUERY…`.
//!
//! Each query is asked six times: the first of an engine that knows nothing yet; of the others the median counts. A
//! memory of many episodes is made by the example `synthetic`.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};
use wisch_memory::Memory;
use wisch_memory::ask::{AskLimits, Assertions, EngineCommand, QuerySession, TelemetryPredicates};

/// How often a query is asked of an engine that knows it.
const WARM: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_swi = arguments.first().is_some_and(|first| first == "--swi");
    let command = if is_swi {
        arguments.remove(0);
        EngineCommand::find_swi().ok_or("swipl cannot be found")?
    } else {
        EngineCommand::find_scryer()
            .ok_or("wisch-prolog cannot be found: cargo build --release -p wisch-prolog")?
    };
    let Some((folder, queries)) = arguments.split_first() else {
        return Err("ask [--swi] FOLDER QUERY...".into());
    };
    let begin = Instant::now();
    let memory = Memory::open(Path::new(folder))?;
    let catalogue = Arc::new(memory.catalogue()?);
    let episodes = catalogue.episodes().len();
    println!("{episodes} episodes, opened in {:.1?}", begin.elapsed());
    let limits = AskLimits {
        answers: 100_000,
        ..AskLimits::default()
    };
    let telemetry = TelemetryPredicates::new(memory);
    let mut asker = QuerySession::new(command, limits, catalogue, telemetry, Assertions::default());
    println!("{:>10} {:>10} {:>8}", "cold", "warm", "answers");
    for query in queries {
        match times(&mut asker, query) {
            Ok((cold, warm, answers)) => {
                let [cold, warm] =
                    [cold, warm].map(|time| format!("{:.1} ms", 1e3 * time.as_secs_f64()));
                println!("{cold:>10} {warm:>10} {answers:>8}  {query}");
            }
            Err(error) => println!("{query}: {error}"),
        }
    }
    Ok(())
}

/// The first time, the median of the later ones, and how many answers there are.
fn times(
    asker: &mut QuerySession,
    query: &str,
) -> Result<(Duration, Duration, usize), wisch_memory::ask::AskError> {
    let begin = Instant::now();
    let answers = asker.ask(query)?.rows.len();
    let cold = begin.elapsed();
    let mut warm = Vec::new();
    for _ in 0..WARM {
        let begin = Instant::now();
        asker.ask(query)?;
        warm.push(begin.elapsed());
    }
    warm.sort();
    Ok((cold, warm[WARM / 2], answers))
}
