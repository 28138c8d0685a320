//! Domains, problems, goals, and the search between them. The first byte chooses.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::plan::{Domain, GoalLiteral, Problem, solve};

const DOMAIN: &str = include_str!("../../knowledge/wiping.pddl");

fuzz_target!(|bytes: &[u8]| {
    let Some((&choice, rest)) = bytes.split_first() else { return };
    let Ok(text) = std::str::from_utf8(rest) else { return };
    match choice % 3 {
        0 => {
            let _ = Domain::parse("fuzz.pddl", text);
        }
        1 => {
            let domain = Domain::parse("wiping.pddl", DOMAIN).expect("the shipped domain parses");
            if let Ok(problem) = Problem::parse("fuzz.pddl", text) {
                let _ = solve(&domain, &problem);
            }
        }
        _ => {
            let _ = GoalLiteral::parse(text);
        }
    }
});
