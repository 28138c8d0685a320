//! Queries that nobody would ask: the corpus of the fuzz target `query`, and random changes of it.

use super::{asker_with, engines};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fs;
use std::path::Path;
use std::time::Duration;
use wisch_memory::ask::{AskError, AskLimits, EngineCommand};

/// How many changed queries are asked, if `WISCH_QUERIES` does not say so.
const QUERIES: u64 = 150;
/// What may come to stand anywhere.
const PIECES: [&str; 24] = [
    ", ", " ; ", "(", ")", "[", "]", "|", "'", "\"", ".", " . ", "\\", "0'", "%", "/*", "_", "X",
    "!", "\\+ ", " = ", "{", "`", "1e400", "\u{0}",
];

fn corpus() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/query");
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    files
        .iter()
        .map(|file| fs::read_to_string(file).unwrap())
        .collect()
}

/// Some of a query's characters are left out, doubled, moved, or replaced by pieces of it, of another or of syntax.
fn changed(corpus: &[String], seed: u64) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut query: Vec<char> = corpus.choose(&mut random).unwrap().chars().collect();
    for _ in 0..random.random_range(1..6) {
        let from = random.random_range(0..=query.len());
        let to = (from + random.random_range(0..12)).min(query.len());
        let new: Vec<char> = match random.random_range(0..4) {
            0 => Vec::new(),
            1 => PIECES.choose(&mut random).unwrap().chars().collect(),
            2 => query[from..to].repeat(2),
            _ => {
                let other: Vec<char> = corpus.choose(&mut random).unwrap().chars().collect();
                let from = random.random_range(0..=other.len());
                other[from..(from + 20).min(other.len())].to_vec()
            }
        };
        query.splice(from..to, new);
    }
    query.into_iter().collect()
}

/// What is wrong with the answer, if anything: it has to be one, or to say what is wrong with the query.
fn fault(result: Result<wisch_memory::ask::Answers, AskError>) -> Option<String> {
    match result {
        Ok(_) | Err(AskError::Fault(_) | AskError::Time(_)) => None,
        Err(AskError::EngineEnded { words }) if words.contains("memory") => None,
        Err(error) => Some(error.to_string()),
    }
}

#[test]
fn whatever_is_asked_is_answered_or_refused() {
    let count = std::env::var("WISCH_QUERIES").ok();
    let count = count.map_or(QUERIES, |count| count.parse().expect("a number of queries"));
    let corpus = corpus();
    let changed = (0..count).map(|seed| changed(&corpus, seed));
    let queries: Vec<String> = corpus.iter().cloned().chain(changed).collect();
    let limits = AskLimits {
        time: Duration::from_secs(1),
        memory: 1 << 30,
        answers: 20,
    };
    for command in engines() {
        let mut asker = asker_with(command.clone(), limits);
        let mut wrong = Vec::new();
        for query in &queries {
            if let Some(what) = fault(asker.ask(query)) {
                wrong.push(format!("{query:?}: {what}"));
            }
        }
        let engine = match command {
            EngineCommand::Scryer(_) => "Scryer",
            EngineCommand::Swi(_) => "SWI",
        };
        assert!(wrong.is_empty(), "{engine}:\n{}", wrong.join("\n"));
        assert!(asker.ask("true").unwrap().holds());
    }
}
