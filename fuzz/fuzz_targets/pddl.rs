//! Domains, goals, and the search between them. The first byte chooses.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;
use wisch::goal::{Domain, GoalLiteral, resolve_goal};
use wisch::represent::KnowledgeBase;

static KNOWLEDGE: LazyLock<KnowledgeBase> = LazyLock::new(|| {
    let files = [
        ("tools.toml", include_str!("../../knowledge/tools.toml")),
        ("media.toml", include_str!("../../knowledge/media.toml")),
        (
            "surfaces.toml",
            include_str!("../../knowledge/surfaces.toml"),
        ),
        (
            "interactions.toml",
            include_str!("../../knowledge/interactions.toml"),
        ),
    ];
    wisch_io::parse_knowledge(&files).expect("the shipped knowledge parses")
});
const DOMAIN: &str = include_str!("../../knowledge/wiping.pddl");
const GOAL: &str = "(collected dust floor)";

fuzz_target!(|bytes: &[u8]| {
    let Some((&choice, rest)) = bytes.split_first() else {
        return;
    };
    let Ok(text) = std::str::from_utf8(rest) else {
        return;
    };
    let (domain, goal) = if choice % 2 == 0 {
        (text, GOAL)
    } else {
        (DOMAIN, text)
    };
    if let (Ok(domain), Ok(goal)) = (Domain::parse("fuzz.pddl", domain), GoalLiteral::parse(goal)) {
        let _ = resolve_goal(
            &goal,
            &domain,
            &KNOWLEDGE,
            Some("sponge"),
            &["broom", "brush"],
        );
    }
});
