//! The record of an hour of wiping.

use super::records;
use wisch_memory::EpisodeRecord;

/// Duration [s].
const LENGTH: f64 = 3600.0;
/// Duration of a stroke, and of the return motion [s].
const STROKE: f64 = 4.0;

/// Returns a record with one round of an hour and several pushes.
pub fn record(seed: u64) -> EpisodeRecord {
    let length = LENGTH;
    let mut record = records::record(seed, usize::from(u16::MAX));
    let start = record.interval[0];
    let end = start + length;
    record.task = "an-hour".into();
    record.interval = [start, end];
    record.rounds = vec![start];
    let find = |class: &str| {
        let found = record.individuals.iter().find(|one| one.class == class);
        found.cloned().into_iter()
    };
    let head: Vec<_> = find("semco:WipingEpisode")
        .chain(find("semco:WipingAction"))
        .chain(record.individuals.get(2).cloned())
        .chain(find("semco:WipingRound"))
        .collect();
    let stroke = find("semco:Stroke").next();
    record.individuals = head;
    for place in [0, 1, 3] {
        record.individuals[place].interval = Some([start, end]);
    }
    for number in 0..(length / (2.0 * STROKE)) as usize {
        let from = start + 2.0 * STROKE * number as f64;
        let mut motion = stroke
            .clone()
            .unwrap_or_else(|| record.individuals[3].clone());
        motion.parent = Some(3);
        motion.interval = Some([from, from + STROKE]);
        record.individuals.push(motion.clone());
        if number % 10 == 7 {
            let parent = record.individuals.len() - 1;
            motion.class = "semco:HumanCollision".into();
            motion.parent = Some(parent);
            motion.interval = Some([from + 1.0, from + 2.5]);
            record.individuals.push(motion);
        }
    }
    record
}
