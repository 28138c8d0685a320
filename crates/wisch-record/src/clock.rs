//! The machine's clock, and remarks on implausible times.

use std::time::{Instant, SystemTime, UNIX_EPOCH};
use wisch_memory::{Memory, local_date_and_time};

/// Least difference of two clocks that gives a remark [s].
const MIN_DIFFERENCE: f64 = 60.0;

/// Returns the current time [s since 1970, UTC].
pub fn unix_time() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.unwrap_or_default().as_secs_f64()
}

/// The time at which a run began, by both clocks of this machine.
#[derive(Debug, Clone, Copy)]
pub struct RunClock {
    /// By the clock that can be set [s since 1970, UTC].
    begin: f64,
    monotonic: Instant,
}

impl RunClock {
    /// Returns the clock of a run that begins now.
    pub fn start() -> Self {
        Self {
            begin: unix_time(),
            monotonic: Instant::now(),
        }
    }

    /// Start of the run by the machine's clock [s since 1970, UTC].
    pub const fn begin(&self) -> f64 {
        self.begin
    }

    /// Returns the duration of the run so far, by the monotonic clock \[s\].
    pub fn duration(&self) -> f64 {
        self.monotonic.elapsed().as_secs_f64()
    }
}

/// Returns a remark if the memory's last episode begins after `now` [s since 1970]: the clock was fast then or is slow now.
pub(crate) fn future_episode_remark(memory: &Memory, now: f64) -> Option<String> {
    let names = memory.episodes().unwrap_or_default();
    // Names begin with the date. An unreadable episode must not prevent new episodes.
    let last = names.iter().max()?;
    let record = memory.episode(last).ok()?.record().ok()?;
    let ahead = record.interval[0] - now;
    (ahead > MIN_DIFFERENCE).then(|| {
        format!(
            "episode {last} is dated {}, {} ahead of this machine's clock ({}): the clock was fast then or is slow now; the \
             new episode uses the clock",
            local_date_and_time(record.interval[0]),
            format_duration(ahead),
            local_date_and_time(now),
        )
    })
}

/// Returns a remark if this machine's clock was set during the run. `by`: the change [s].
pub(crate) fn clock_change_remark(by: f64) -> Option<String> {
    let direction = if by > 0.0 { "forward" } else { "back" };
    (by.abs() > MIN_DIFFERENCE).then(|| {
        format!(
            "this machine's clock was set {direction} by {} during the run; the episode uses the clock as set at its start",
            format_duration(by)
        )
    })
}

/// Formats a duration with a suitable unit.
fn format_duration(seconds: f64) -> String {
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
    fn a_clock_change_of_a_year_in_either_direction_gives_a_remark() {
        for (by, way) in [(YEAR, "forward by 365 days"), (-YEAR, "back by 365 days")] {
            let remark = clock_change_remark(by).expect("a remark");
            assert!(remark.contains(way), "{remark}");
        }
        for by in [0.0, 0.4, -30.0] {
            assert_eq!(clock_change_remark(by), None);
        }
    }

    #[test]
    fn an_episode_that_is_dated_ahead_gives_a_remark() {
        let folder = tempfile::tempdir().expect("a folder");
        let memory = Memory::create(folder.path()).expect("a memory");
        assert_eq!(future_episode_remark(&memory, 2e9), None);
        let id = episode_id(2e9, 1);
        let record = EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id: id.clone(),
            task: "board".to_owned(),
            // Only the start counts; the duration does not matter.
            interval: [2e9, 9e9],
            origin: Origin::Simulated,
            program: "by hand".to_owned(),
            seed: 1,
            rounds: Vec::new(),
            individuals: Vec::new(),
        };
        let writer = memory.begin(&id).expect("a writer");
        writer.commit(&record).expect("an episode");
        let remark = future_episode_remark(&memory, 2e9 - YEAR).expect("a remark");
        assert!(
            remark.contains(&id) && remark.contains("365 days"),
            "{remark}"
        );
        assert_eq!(future_episode_remark(&memory, 2e9 + YEAR), None);
    }
}
