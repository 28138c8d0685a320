//! Random queries, for holding engines against each other.

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const CLASSES: [&str; 9] = [
    "semco:'Collision'",
    "soma:'Collision'",
    "'WipingRound'",
    "semco:'Motion'",
    "'Stroke'",
    "dul:'Action'",
    "semco:'ToolContact'",
    "dul:'Process'",
    "semco:'WipingTool'",
];
const NUMBERS: [&str; 6] = [
    "performance",
    "contactShare",
    "meanNormalForce",
    "semco:peakForce",
    "round",
    "planeTilt",
];
const RELATIONS: [&str; 14] = [
    "before",
    "after",
    "meets",
    "met_by",
    "overlaps",
    "overlapped_by",
    "starts",
    "started_by",
    "finishes",
    "finished_by",
    "during",
    "contains",
    "equals",
    "intersects",
];
const PROPERTIES: [&str; 5] = [
    "dul:hasParticipant",
    "semco:usesTool",
    "dul:hasConstituent",
    "dul:isConstituentOf",
    "soma:hasExecutionState",
];

/// A query of one to three goals about the same things.
pub fn query(seed: u64) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut goals = vec![first(&mut random)];
    for _ in 0..random.random_range(0..3) {
        goals.push(further(&mut random));
    }
    goals.join(", ")
}

fn one<'a>(random: &mut ChaCha8Rng, among: &[&'a str]) -> &'a str {
    among.choose(random).copied().unwrap_or_default()
}

/// A goal that finds A.
fn first(random: &mut ChaCha8Rng) -> String {
    let bound = f64::from(random.random_range(-1000..1000)) / 100.0;
    match random.random_range(0..5) {
        0 => format!("has_type(A, {})", one(random, &CLASSES)),
        1 => format!("owl_individual_of(A, {})", one(random, &CLASSES)),
        2 => {
            let operator = one(random, &["=<", ">=", "<", ">"]);
            format!(
                "has_data_value(A, {} {operator} {bound})",
                one(random, &NUMBERS)
            )
        }
        3 => format!("triple(A, {}, B)", one(random, &PROPERTIES)),
        _ => {
            let class = one(random, &["'HumanCollision'", "'Stroke'", "'ToolContact'"]);
            let relation = one(random, &RELATIONS);
            format!("has_type(B, {class}), interval_{relation}(A, B)")
        }
    }
}

/// A goal about A that may find more.
fn further(random: &mut ChaCha8Rng) -> String {
    match random.random_range(0..6) {
        0 => "occurs(A, [S, E])".to_owned(),
        1 => format!("has_type(A, {})", one(random, &CLASSES)),
        2 => format!("\\+ has_type(A, {})", one(random, &CLASSES)),
        3 => format!("triple(A, {}, O)", one(random, &PROPERTIES)),
        4 => format!(
            "aggregate_all(count, has_subevent(A, _), N{})",
            random.random_range(0..9)
        ),
        _ => format!("has_data_value(A, {} = V)", one(random, &NUMBERS)),
    }
}

/// A query of several goals that ask for facts, with what is made of their solutions.
pub fn of_facts(seed: u64) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let goals = facts(&mut random);
    let number = one(&mut random, &NUMBERS);
    match random.random_range(0..9) {
        0 => format!("findall(A, ({goals}), L), length(L, N)"),
        1 => format!("aggregate_all(count, ({goals}), N)"),
        2 => format!("aggregate_all(max(V, A), ({goals}, has_data_value(A, {number} = V)), M)"),
        3 => format!("aggregate_all(sum(V), ({goals}, has_data_value(A, {number}(V))), S)"),
        4 => format!("aggregate_all(set(A), ({goals}), S), member(A, S), occurs(A, [F, T])"),
        5 => format!("{goals}, \\+ (has_subevent(A, P), has_type(P, 'Stroke'))"),
        6 => format!("{goals}, atom(A), once((has_subevent(A, P), occurs(P, [F, T])))"),
        _ => goals,
    }
}

/// Goals about A, and about B beside it.
fn facts(random: &mut ChaCha8Rng) -> String {
    let mut goals = vec![first(random)];
    for _ in 0..random.random_range(1..4) {
        goals.push(match random.random_range(0..9) {
            0 => "occurs(A, [S, E]), E - S > 1.0".to_owned(),
            1 => format!("has_type(B, {})", one(random, &CLASSES)),
            2 => format!("has_type(C, {}), has_subevent(C, A)", one(random, &CLASSES)),
            3 => format!(
                "interval_{}(A, B)",
                one(random, &["overlaps", "during", "before", "intersects"])
            ),
            4 => format!(
                "(has_type(A, {}) ; has_type(A, {}))",
                one(random, &CLASSES),
                one(random, &CLASSES)
            ),
            5 => format!("triple(A, {}, O)", one(random, &PROPERTIES)),
            6 => format!("has_data_value(A, {} = W), W > 0.5", one(random, &NUMBERS)),
            7 => "low_performance_round(A, P)".to_owned(),
            _ => "aggregate_all(count, has_subevent(A, _), N1), N1 < 4".to_owned(),
        });
    }
    goals.join(", ")
}
