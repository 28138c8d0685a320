//! Names of episodes.

const SECONDS_PER_DAY: i64 = 86_400;

/// The name of an episode that begins at this time [s since 1970]: date and time (UTC), and four hex digits that
/// tell those apart that begin in the same second.
///
/// ```
/// assert_eq!(wisch_memory::episode_id(1_795_309_772.5, 0x3f2a), "20261122-010932-3f2a");
/// ```
pub fn episode_id(start: f64, salt: u16) -> String {
    let [year, month, day, hour, minute, second] = parts_of(start);
    format!("{year:04}{month:02}{day:02}-{hour:02}{minute:02}{second:02}-{salt:04x}")
}

/// Date and time (UTC) for people.
///
/// ```
/// assert_eq!(wisch_memory::date_and_time(1_795_309_772.5), "2026-11-22 01:09:32");
/// ```
pub fn date_and_time(time: f64) -> String {
    let [year, month, day, hour, minute, second] = parts_of(time);
    format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}")
}

/// Year, month, day, hour, minute and second (UTC).
fn parts_of(time: f64) -> [i64; 6] {
    let seconds = time.floor() as i64;
    let [year, month, day] = date_of(seconds.div_euclid(SECONDS_PER_DAY));
    let second = seconds.rem_euclid(SECONDS_PER_DAY);
    let [hour, minute, second] = [second / 3600, second / 60 % 60, second % 60];
    [year, month, day, hour, minute, second]
}

/// Year, month and day of a day, counted from 1970-01-01, in the Gregorian calendar (Howard Hinnant,
/// "chrono-compatible low-level date algorithms": years begin in March, so that the leap day is their last).
fn date_of(day: i64) -> [i64; 3] {
    let day = day + 719_468;
    let (era, of_era) = (day.div_euclid(146_097), day.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    [400 * era + year + i64::from(month <= 2), month, day]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_follow_each_other_through_four_centuries() {
        let leap = |y: i64| (y % 4 == 0 && y % 100 != 0) || y % 400 == 0;
        let mut expected = [1970, 1, 1];
        for day in 0..146_097 {
            assert_eq!(date_of(day), expected, "day {day}");
            let [year, month, date] = expected;
            let length = match month {
                2 => 28 + i64::from(leap(year)),
                4 | 6 | 9 | 11 => 30,
                _ => 31,
            };
            expected = match (date == length, month) {
                (false, _) => [year, month, date + 1],
                (true, 12) => [year + 1, 1, 1],
                (true, _) => [year, month + 1, 1],
            };
        }
    }
}
