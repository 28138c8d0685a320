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
