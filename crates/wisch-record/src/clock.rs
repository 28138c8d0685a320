//! The clock of the machine that keeps an episode, and what is odd about it.

use std::time::{SystemTime, UNIX_EPOCH};
use wisch_memory::{Memory, local_date_and_time};

/// How far clocks may be apart before that is told [s].
const CLOCKS_APART: f64 = 60.0;

/// Seconds since 1970.
pub fn now() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_secs_f64()
}

/// Says that an episode of a memory is dated after now [s since 1970]: this machine's clock was ahead then, or is behind now.
pub(crate) fn dated_ahead(memory: &Memory, now: f64) -> Option<String> {
    let names = memory.episodes().unwrap_or_default();
    // Names begin with the date. An episode that cannot be read does not keep others from being written.
    let last = names.iter().max()?;
    let record = memory.episode(last).ok()?.record().ok()?;
    let ahead = record.interval[0] - now;
    (ahead > CLOCKS_APART).then(|| {
        format!(
            "episode {last} is dated {}, {} after this machine's clock, which says {}: the clock was ahead then or is \
             behind now; the new episode is dated by the clock",
            local_date_and_time(record.interval[0]),
            lasting(ahead),
            local_date_and_time(now),
        )
    })
}

/// Says that this machine's clock was set during the run, by so many seconds.
pub(crate) fn clock_was_set(by: f64) -> Option<String> {
    let way = if by > 0.0 { "forward" } else { "back" };
    (by.abs() > CLOCKS_APART).then(|| {
        format!(
            "this machine's clock was set {way} by {} during the run; the episode is dated by the clock as it was at the \
             beginning",
            lasting(by)
        )
    })
}

/// A length of time for people.
fn lasting(seconds: f64) -> String {
    match seconds.abs() {
        s if s >= 172_800.0 => format!("{:.0} days", s / 86_400.0),
        s if s >= 7_200.0 => format!("{:.1} h", s / 3_600.0),
        s => format!("{s:.0} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Origin, episode_id};

    const YEAR: f64 = 31_557_600.0;

    #[test]
    fn a_clock_that_is_set_by_a_year_either_way_is_told() {
        for (by, way) in [(YEAR, "forward by 365 days"), (-YEAR, "back by 365 days")] {
            let told = clock_was_set(by).expect("it is told");
            assert!(told.contains(way), "{told}");
        }
        for by in [0.0, 0.4, -30.0] {
            assert_eq!(clock_was_set(by), None);
        }
    }

    #[test]
    fn an_episode_that_is_dated_ahead_is_told() {
        let folder = tempfile::tempdir().expect("a folder");
        let memory = Memory::create(folder.path()).expect("a memory");
        assert_eq!(dated_ahead(&memory, 2e9), None);
        let id = episode_id(2e9, 1);
        let record = EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id: id.clone(),
            task: "board".to_owned(),
            // Whatever its duration is, it dates no other episode.
            interval: [2e9, 9e9],
            origin: Origin::Simulated,
            program: "by hand".to_owned(),
            seed: 1,
            rounds: Vec::new(),
            individuals: Vec::new(),
        };
        let writer = memory.begin(&id).expect("a writer");
        writer.commit(&record).expect("an episode");
        let told = dated_ahead(&memory, 2e9 - YEAR).expect("it is told");
        assert!(told.contains(&id) && told.contains("365 days"), "{told}");
        assert_eq!(dated_ahead(&memory, 2e9 + YEAR), None);
    }
}
