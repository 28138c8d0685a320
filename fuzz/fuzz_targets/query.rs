//! Queries to an empty memory. The engine is the first in `PATH`: `wisch-prolog`, else `swipl`. Any query
//! gets answers, or an error that names its fault.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;
use wisch_memory::Catalogue;
use wisch_memory::ask::{
    AskError, AskLimits, Assertions, EngineCommand, QuerySession, TelemetryPredicates,
};

thread_local! {
    static ASKER: RefCell<QuerySession> = RefCell::new(asker());
}

fn asker() -> QuerySession {
    let limits = AskLimits {
        time: Duration::from_secs(2),
        memory: 1 << 30,
        answers: 100,
    };
    QuerySession::new(
        EngineCommand::find().expect("wisch-prolog or swipl in PATH"),
        limits,
        Arc::new(Catalogue::default()),
        TelemetryPredicates::default(),
        Assertions::default(),
    )
}

fuzz_target!(|query: &str| {
    ASKER.with_borrow_mut(|asker| match asker.ask(query) {
        // Out of time or of memory.
        Ok(_) | Err(AskError::Fault(_) | AskError::Time(_)) => {}
        Err(AskError::EngineEnded { words }) if words.contains("memory") => {}
        Err(error) => panic!("{error}"),
    });
});
