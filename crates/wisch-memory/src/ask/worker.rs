//! The Prolog engine as a process of its own, so that a runaway or a panic ends a query and not the program.

use super::EngineKind;
use scryer_prolog::{MachineBuilder, StreamConfig};

const SCRYER: &str = include_str!("../../prolog/engine_scryer.pl");
const SWI: &str = include_str!("../../prolog/engine_swi.pl");
/// The predicates, the same for every engine.
const PORTABLE: [&str; 9] = [
    include_str!("../../prolog/host.pl"),
    include_str!("../../prolog/guard.pl"),
    include_str!("../../prolog/facts.pl"),
    include_str!("../../prolog/intervals.pl"),
    include_str!("../../prolog/knowrob.pl"),
    include_str!("../../prolog/poses.pl"),
    include_str!("../../prolog/views.pl"),
    include_str!("../../prolog/queries.pl"),
    include_str!("../../prolog/listing.pl"),
];

/// The predicates as one text, for an engine.
pub fn program(kind: EngineKind) -> String {
    let dialect = match kind {
        EngineKind::Scryer => SCRYER,
        EngineKind::Swi => SWI,
    };
    let mut text = dialect.to_owned();
    for part in PORTABLE {
        text.push('\n');
        text.push_str(part);
    }
    text
}

/// Answers queries from standard input to standard output until it ends; what a process does that was begun as an
/// engine. It may use so much memory [bytes].
///
/// # Errors
/// If the limit cannot be set.
pub fn work(memory: u64) -> std::io::Result<()> {
    rlimit::setrlimit(rlimit::Resource::AS, memory, memory)?;
    let streams = StreamConfig::stdio();
    let mut machine = MachineBuilder::default().with_streams(streams).build();
    machine.load_module_string("user", program(EngineKind::Scryer));
    for _ in machine.run_query("main.") {}
    Ok(())
}
