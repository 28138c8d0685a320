//! Times of a table: counts of a unit, dates, or a sample rate.

use super::cell::Cell;
use crate::error::ReadFault;
use crate::ros2::NANOSECONDS_PER_SECOND;
use jiff::civil::DateTime;
use jiff::{Timestamp, civil, tz::TimeZone};

/// Largest time of a table [s], so that its nanoseconds fit into an integer.
const MAX_TIME: f64 = 9e9;

/// Largest distance of a time from its origin [s].
const FARTHEST: f64 = 1e12;

/// Units that the size of times may reveal, the largest first: their size [s] and name.
const UNITS: [(f64, &str); 4] = [
    (1.0, "seconds"),
    (1e-3, "milliseconds"),
    (1e-6, "microseconds"),
    (1e-9, "nanoseconds"),
];

/// Range of seconds since 1970 in the years 1990 to 2100.
const SINCE_1970: [f64; 2] = [6.3e8, 4.1e9];

/// Clocks of other programs that count a whole number of 100 ns: seconds from their origin to 1970, and their name.
const CLOCKS: [(i64, &str); 2] = [
    (11_644_473_600, "100 ns since 1601 (FILETIME of Windows)"),
    (62_135_596_800, "100 ns since the year 1 (ticks of .NET)"),
];

/// Unit of these clocks [s].
const CLOCK_UNIT: f64 = 1e-7;

/// Range of seconds since 1970 in the years 2000 to 2100, in which these clocks are recognised.
const RECENT: [f64; 2] = [9.46e8, 4.1e9];

/// Steps from this length on are too long for samples in seconds, so the unit is smaller [s].
const LONG_STEP: f64 = 2.0;

/// Longest step between samples for an assumed unit [s]: 5 samples per second.
const USUAL_STEP: f64 = 0.2;

/// Least mean number of rows of the same time from which times are too coarse.
const LEAST_COARSE: usize = 3;

/// Length of a day [ns].
const DAY: i64 = 86_400 * NANOSECONDS_PER_SECOND as i64;

/// Number of values of a 32-bit counter.
const COUNTER: f64 = 4_294_967_296.0;

/// Longest time between two samples at midnight, or where a counter begins anew [ns]; at most a quarter of the period.
const LONGEST_TURN: i64 = 60 * NANOSECONDS_PER_SECOND as i64;

/// A time as a cell states it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Instant {
    /// A whole number of some unit.
    Whole(i64),
    /// A decimal number of some unit, in billionths of it: a float resolves seconds since 1970 to 0.2 µs only.
    Billionths(i128),
    /// A real number of some unit.
    Real(f64),
    /// A date or time of day, in nanoseconds since 1970 or midnight, and whether it states a time zone.
    Date(i64, bool),
}

impl Instant {
    /// Parses a cell.
    pub fn parse(cell: &Cell<'_>) -> Option<Self> {
        let text = match cell {
            Cell::Empty => return None,
            Cell::Real(count) => return Some(Self::Real(*count)),
            Cell::Whole(count) => return Some(Self::Whole(*count)),
            Cell::Date(time, in_utc) => return Some(Self::Date(*time, *in_utc)),
            Cell::Text(text) => text,
        };
        if let Ok(whole) = text.parse() {
            return Some(Self::Whole(whole));
        }
        if let Some(billionths) = parse_billionths(text) {
            return Some(Self::Billionths(billionths));
        }
        match text.parse() {
            Ok(real) => Some(Self::Real(real)),
            Err(_) => date(text).map(|(time, has_zone)| Self::Date(time, has_zone)),
        }
    }

    /// Joins the cells of whole seconds and of the parts of a second beyond them, as messages of ROS state a time. `part`: size
    /// of a part [ns].
    ///
    /// # Errors
    /// 0 if the seconds are no whole number, 1 if the parts are none within a second.
    pub fn join(seconds: &Cell<'_>, parts: &Cell<'_>, part: i64) -> Result<Self, usize> {
        let whole = |cell: &Cell<'_>| {
            let number = cell.number().filter(|number| number.fract() == 0.0)?;
            (number.abs() <= MAX_TIME).then_some(number as i128)
        };
        let second = i128::from(NANOSECONDS_PER_SECOND);
        let rest = whole(parts).map(|rest| rest * i128::from(part));
        let rest = rest.filter(|rest| (0..second).contains(rest));
        let seconds = whole(seconds).ok_or(0_usize)?;
        Ok(Self::Billionths(seconds * second + rest.ok_or(1_usize)?))
    }

    fn count(self) -> f64 {
        match self {
            Self::Whole(count) => count as f64,
            Self::Real(count) => count,
            Self::Billionths(billionths) => billionths as f64 / NANOSECONDS_PER_SECOND as f64,
            Self::Date(nanoseconds, _) => nanoseconds as f64 / NANOSECONDS_PER_SECOND as f64,
        }
    }

    /// Converts a count of a unit [s] since an origin to nanoseconds. `origin`: the time from the count of 0 to the time 0 \[ns\].
    fn nanoseconds(self, unit: f64, origin: i128) -> Option<i64> {
        let per_unit = (unit * NANOSECONDS_PER_SECOND as f64 * 1e6).round() / 1e6;
        let limit = MAX_TIME as i128 * i128::from(NANOSECONDS_PER_SECOND);
        let time = match self {
            Self::Date(time, _) => return Some(time),
            Self::Whole(count) if per_unit.fract() == 0.0 => i128::from(count) * per_unit as i128,
            Self::Billionths(billionths) if per_unit.fract() == 0.0 => {
                let scale = i128::from(NANOSECONDS_PER_SECOND);
                let time = billionths.checked_mul(per_unit as i128)?;
                // Rounded to the nearest nanosecond, halves upwards.
                (time + scale / 2).div_euclid(scale)
            }
            _ => {
                let seconds = self.count() * unit;
                if !seconds.is_finite() || seconds.abs() > FARTHEST {
                    return None;
                }
                (seconds * NANOSECONDS_PER_SECOND as f64).round() as i128
            }
        };
        let time = time - origin;
        (time.abs() <= limit).then_some(time as i64)
    }
}

/// Parses a decimal number without an exponent, rounded to billionths.
fn parse_billionths(text: &str) -> Option<i128> {
    let (whole, decimals) = text.split_once('.')?;
    let is_negative = whole.starts_with('-');
    let digits = whole.strip_prefix(['-', '+']).unwrap_or(whole);
    let is_decimal = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    let has_digits = !digits.is_empty() || !decimals.is_empty();
    if !has_digits || digits.len() > 20 || !is_decimal(digits) || !is_decimal(decimals) {
        return None;
    }
    let (kept, rest) = decimals.split_at(decimals.len().min(9));
    let size: i128 = format!("{digits}{kept:0<9}").parse().ok()?;
    let size = size + i128::from(rest.as_bytes().first().is_some_and(|digit| *digit >= b'5'));
    Some(if is_negative { -size } else { size })
}

/// Parses a date: nanoseconds since 1970, or since midnight, and whether a zone is stated.
fn date(text: &str) -> Option<(i64, bool)> {
    if let Ok(time) = text.parse::<Timestamp>() {
        return Some((i64::try_from(time.as_nanosecond()).ok()?, true));
    }
    if let Ok(time) = text.parse::<DateTime>()
        && text.contains([':', 'T'])
    {
        let time = time.to_zoned(TimeZone::UTC).ok()?.timestamp();
        return Some((i64::try_from(time.as_nanosecond()).ok()?, false));
    }
    let time = text
        .parse::<civil::Time>()
        .ok()
        .filter(|_| text.contains(':'))?;
    let midnight = civil::Time::midnight();
    let since = time.duration_since(midnight);
    Some((i64::try_from(since.as_nanos()).ok()?, false))
}

/// Returns the times [ns] of rows at a constant rate [Hz].
pub(super) fn at_rate(count: usize, rate: f64) -> Vec<i64> {
    let period = NANOSECONDS_PER_SECOND as f64 / rate;
    (0..count)
        .map(|index| (index as f64 * period).round() as i64)
        .collect()
}

/// Times in nanoseconds, and a remark on an assumed unit.
#[derive(Debug)]
pub(super) struct Scaled {
    pub times: Vec<Option<i64>>,
    pub remarks: Vec<String>,
}

/// A time out of range, with its index.
#[derive(Debug)]
pub(super) struct TimeFault {
    index: usize,
    time: f64,
}

impl TimeFault {
    /// Returns the fault of a log, with `place` naming the index.
    pub fn into_read_fault(self, place: impl Fn(usize) -> String) -> ReadFault {
        ReadFault::Time {
            place: place(self.index),
            time: self.time,
            limit: MAX_TIME,
        }
    }
}

/// Converts times to nanoseconds, by a given unit [s] or by a unit that their size implies.
pub(super) fn scale_times(
    instants: &[Option<Instant>],
    given: Option<f64>,
) -> Result<Scaled, TimeFault> {
    let (unit, origin, remark) = match (find_origin(instants, given), given) {
        (Some((unit, origin, remark)), _) => (unit, origin, Some(remark)),
        (None, Some(unit)) => (unit, 0, None),
        (None, None) => {
            let (unit, remark) = assumed_unit(instants);
            (unit, 0, remark)
        }
    };
    let mut times = Vec::with_capacity(instants.len());
    for (index, instant) in instants.iter().enumerate() {
        let time = instant.map(|instant| {
            instant.nanoseconds(unit, origin).ok_or(TimeFault {
                index,
                time: instant.count() * unit,
            })
        });
        times.push(time.transpose()?);
    }
    let lacks_zone = instants
        .iter()
        .flatten()
        .any(|instant| matches!(instant, Instant::Date(_, false)));
    let zone = lacks_zone
        .then(|| "dates and times of day are read as UTC, because they state no zone".to_owned());
    let turned = add_turns(instants, unit, &mut times);
    let coarse = describe_coarse_times(&times);
    let remarks = remark.into_iter().chain(zone).chain(turned).chain(coarse);
    Ok(Scaled {
        remarks: remarks.collect(),
        times,
    })
}

/// Returns the unit [s] of times, the time from their origin to the time 0 [ns], and a remark, if they count from another
/// origin than 1970: that of a known clock, or any that is too far away for a date if their unit is given.
fn find_origin(instants: &[Option<Instant>], given: Option<f64>) -> Option<(f64, i128, String)> {
    let first = instants.iter().flatten().next()?;
    if matches!(first, Instant::Date(..)) {
        return None;
    }
    let second = i128::from(NANOSECONDS_PER_SECOND);
    if given.is_none_or(|unit| (unit / CLOCK_UNIT - 1.0).abs() < 1e-9) {
        let seconds = first.count() * CLOCK_UNIT;
        let is_it = |(to_1970, _): &&(i64, &str)| {
            (RECENT[0]..=RECENT[1]).contains(&(seconds - *to_1970 as f64))
        };
        if let Some((to_1970, name)) = CLOCKS.iter().find(is_it) {
            let remark = format!("times are read as {name}; --time-unit-s states another unit");
            let remark = match given {
                Some(_) => format!("times are read as {name}"),
                None => remark,
            };
            return Some((CLOCK_UNIT, i128::from(*to_1970) * second, remark));
        }
    }
    let unit = given?;
    let seconds = first.count() * unit;
    if !(MAX_TIME..FARTHEST).contains(&seconds.abs()) {
        return None;
    }
    let remark = format!(
        "times begin at {seconds} s, which is no date, and are read as times since the first sample"
    );
    Some((unit, (seconds.round() as i128) * second, remark))
}

/// Returns a remark on times that most rows share with the row before, such as dates without fractions of a second.
fn describe_coarse_times(times: &[Option<i64>]) -> Option<String> {
    let known: Vec<i64> = times.iter().flatten().copied().collect();
    let runs: Vec<&[i64]> = known.chunk_by(|a, b| a == b).collect();
    let most = runs.iter().map(|run| run.len()).max()?;
    let steps = runs
        .windows(2)
        .map(|pair| pair[1][0].saturating_sub(pair[0][0]));
    let period = steps.min()?;
    if LEAST_COARSE * runs.len() > known.len() || period <= 0 {
        return None;
    }
    let rate = most as f64 * NANOSECONDS_PER_SECOND as f64 / period as f64;
    Some(format!(
        "up to {most} rows state the same time, and only the first of them is used; if the rows follow each other evenly, read them with --rate {rate}"
    ))
}

/// Adds days to times of day after midnight, or the range of a 32-bit counter after it begins anew, if that alone makes
/// the times rise without a long gap. Returns a remark if it does.
fn add_turns(instants: &[Option<Instant>], unit: f64, times: &mut [Option<i64>]) -> Option<String> {
    let known = || times.iter().flatten().copied();
    let is_of_day = known().all(|time| (0..DAY).contains(&time));
    let is_counter = instants.iter().flatten().all(|instant| {
        let count = instant.count();
        let is_date = matches!(instant, Instant::Date(..));
        !is_date && count.fract() == 0.0 && (0.0..COUNTER).contains(&count)
    });
    let range = COUNTER * unit * NANOSECONDS_PER_SECOND as f64;
    let range = (is_counter && range.fract() == 0.0 && range < 9e18).then_some(range as i64);
    let periods = [is_of_day.then_some(DAY), range];
    for (period, what) in (periods.into_iter().flatten()).map(|period| match period {
        DAY => (DAY, "times of day that pass midnight, and a day is added"),
        range => (
            range,
            "counts of 32 bits that begin anew, and their range is added",
        ),
    }) {
        let longest = LONGEST_TURN.min(period / 4);
        let (mut last, mut first_turn): (Option<i64>, Option<usize>) = (None, None);
        let mut turned = Vec::with_capacity(times.len());
        let mut is_continuous = true;
        for (index, time) in times.iter().enumerate() {
            let risen = time.map(|time| {
                let Some(last) = last else {
                    return time;
                };
                let turns = last
                    .saturating_sub(time)
                    .saturating_add(period / 2)
                    .div_euclid(period);
                if turns > 0 {
                    first_turn.get_or_insert(index);
                }
                time + turns * period
            });
            if let (Some(risen), Some(last)) = (risen, last) {
                is_continuous &= risen.abs_diff(last) <= longest.unsigned_abs();
            }
            last = risen.or(last);
            turned.push(risen);
        }
        if let (true, Some(index)) = (is_continuous, first_turn) {
            times.copy_from_slice(&turned);
            return Some(format!(
                "times fall by {} s at row {}: they are read as {what} from there on",
                period as f64 / NANOSECONDS_PER_SECOND as f64,
                index + 1
            ));
        }
    }
    None
}

/// Returns the unit of times [s] that their size and steps imply, with a remark.
fn assumed_unit(instants: &[Option<Instant>]) -> (f64, Option<String>) {
    let is_count = |instant: &Instant| !matches!(instant, Instant::Date(..));
    let counts = instants
        .iter()
        .flatten()
        .filter(|instant| is_count(instant));
    let counts: Vec<f64> = counts.map(|instant| instant.count()).collect();
    let (Some(&first), step) = (counts.first(), median_step(&counts)) else {
        return (1.0, None);
    };
    for (unit, name) in UNITS {
        let is_date = (SINCE_1970[0]..=SINCE_1970[1]).contains(&(first * unit));
        // A controller's clock may count from when it was switched on.
        if is_date && step.is_none_or(|step| step * unit < LONG_STEP) {
            let remark =
                format!("times are read as {name} since 1970; --time-unit-s states another unit");
            return (unit, (unit < 1.0).then_some(remark));
        }
    }
    // Times that mostly run backwards show no step.
    let backwards = counts.windows(2).filter(|pair| pair[1] < pair[0]).count();
    let Some(step) = step.filter(|step| *step >= LONG_STEP && 2 * backwards < counts.len()) else {
        return (1.0, None);
    };
    let fits = |&&(unit, _): &&(f64, &str)| step * unit <= USUAL_STEP;
    let Some((unit, name)) = UNITS.iter().find(fits) else {
        return (1.0, None);
    };
    let remark = format!(
        "times are read as {name}, as {step} s from sample to sample would be long; --time-unit-s states another unit"
    );
    (*unit, Some(remark))
}

/// Returns the median of the positive steps. Times out of order have the steps that they have in order.
fn median_step(counts: &[f64]) -> Option<f64> {
    let mut counts = counts.to_vec();
    counts.sort_by(f64::total_cmp);
    let steps = counts.windows(2).map(|pair| pair[1] - pair[0]);
    let mut steps: Vec<f64> = steps
        .filter(|step| *step > 0.0 && step.is_finite())
        .collect();
    if steps.is_empty() {
        return None;
    }
    let middle = steps.len() / 2;
    let (_, median, _) = steps.select_nth_unstable_by(middle, f64::total_cmp);
    Some(*median)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scaled_texts(texts: &[&str]) -> (Vec<i64>, Vec<String>) {
        let instants: Vec<Option<Instant>> = (texts.iter())
            .map(|text| Some(Instant::parse(&Cell::Text((*text).into())).unwrap()))
            .collect();
        let scaled = scale_times(&instants, None).unwrap();
        (scaled.times.into_iter().flatten().collect(), scaled.remarks)
    }

    #[test]
    fn units_follow_from_the_size_of_times() {
        let second = NANOSECONDS_PER_SECOND as i64;
        // Each pair is 40 ms apart.
        for (texts, start, word) in [
            (["0", "0.04"], 0, None),
            (["0", "40"], 0, Some("milliseconds")),
            (["5000000", "5040000"], 5 * second, Some("microseconds")),
            (["1000", "40001000"], 1000, Some("nanoseconds")),
            // Twenty minutes since the controller was switched on.
            (
                ["1200000000000", "1200040000000"],
                1200 * second,
                Some("nanoseconds, as"),
            ),
            (
                ["1760000000.0", "1760000000.04"],
                1_760_000_000 * second,
                None,
            ),
            (
                ["1760000000000", "1760000000040"],
                1_760_000_000 * second,
                Some("milliseconds since 1970"),
            ),
            (
                ["1760000000000000", "1760000000040000"],
                1_760_000_000 * second,
                Some("microseconds since 1970"),
            ),
            (
                ["1760000000000000000", "1760000000040000000"],
                1_760_000_000 * second,
                Some("nanoseconds since 1970"),
            ),
            (
                ["2025-10-09T08:53:20Z", "2025-10-09T08:53:20.040Z"],
                1_760_000_000 * second,
                None,
            ),
            (
                [
                    "2025-10-09 10:53:20.000+02:00",
                    "2025-10-09 10:53:20.040+02:00",
                ],
                1_760_000_000 * second,
                None,
            ),
            (
                ["2025-10-09 08:53:20", "2025-10-09 08:53:20.04"],
                1_760_000_000 * second,
                Some("UTC"),
            ),
            (["08:53:20.00", "08:53:20.04"], 32_000 * second, Some("UTC")),
        ] {
            let (times, remarks) = scaled_texts(&texts);
            assert!((times[0] - start).abs() < 1000, "{texts:?}: {times:?}");
            assert!(
                (times[1] - times[0] - 40_000_000).abs() < 1000,
                "{texts:?}: {times:?}"
            );
            match word {
                Some(word) => assert!(remarks[0].contains(word), "{remarks:?}"),
                None => assert!(remarks.is_empty(), "{texts:?}: {remarks:?}"),
            }
        }
    }

    #[test]
    fn decimal_seconds_since_1970_are_exact_to_the_nanosecond() {
        for (texts, exact) in [
            (
                ["1760000000.123456789", "1760000000.123456790"],
                1_760_000_000_123_456_789,
            ),
            (
                ["1760000000123.456789", "1760000000123.456790"],
                1_760_000_000_123_456_789,
            ),
            (
                ["1760000000123456789", "1760000000123456790"],
                1_760_000_000_123_456_789,
            ),
            (["-0.000000001", ".0"], -1),
        ] {
            assert_eq!(scaled_texts(&texts).0, [exact, exact + 1], "{texts:?}");
        }
        assert_eq!(parse_billionths("0.28999999999999998"), Some(290_000_000));
        for text in [".", "-.", "1.2.3", "1.5e3", "0x1.0"] {
            assert_eq!(parse_billionths(text), None, "{text}");
        }
    }

    #[test]
    fn times_out_of_order_are_read_in_the_unit_that_they_have_in_order() {
        let shuffled = ["6.84", "0.04", "3.0", "0.0", "6.88", "3.04"];
        let (times, remarks) = scaled_texts(&shuffled);
        assert_eq!(times[0], 6_840_000_000, "{remarks:?}");
        assert!(remarks.is_empty(), "{remarks:?}");
    }

    #[test]
    fn times_that_pass_midnight_or_roll_over_rise() {
        let steps = |texts: &[&str]| {
            let (times, remarks) = scaled_texts(texts);
            let steps = times.windows(2).map(|pair| (pair[1] - pair[0]) / 1_000_000);
            (steps.collect::<Vec<i64>>(), remarks.join("; "))
        };
        for (texts, word) in [
            (
                ["23:59:59.98", "23:59:59.99", "00:00:00", "00:00:00.01"],
                "midnight",
            ),
            (["86399.98", "86399.99", "0.0", "0.01"], "midnight"),
            (["4294967276", "4294967286", "0", "10"], "32 bits"),
            (["4294947296", "4294957296", "0", "10000"], "32 bits"),
        ] {
            let (steps, remarks) = steps(&texts);
            assert_eq!(steps, [10, 10, 10], "{texts:?}: {remarks}");
            assert!(
                remarks.contains(word) && remarks.contains("row 3"),
                "{remarks}"
            );
        }
        // A sample from before midnight that is late stays there.
        let late = ["86399.98", "0.0", "86399.99", "0.01"];
        assert_eq!(steps(&late).0, [20, -10, 20]);
        // Neither a clock that was set back nor a second log of the same day is a turn.
        for texts in [
            ["50000.0", "50000.01", "0.0", "0.01"],
            ["86399.98", "86399.99", "500.0", "500.01"],
            ["10.0", "10.01", "0.0", "0.01"],
        ] {
            let (steps, remarks) = steps(&texts);
            assert!(steps[1] < 0 && remarks.is_empty(), "{texts:?}: {remarks}");
        }
    }

    #[test]
    fn times_of_other_clocks_and_of_far_origins_are_read() {
        let second = NANOSECONDS_PER_SECOND as i64;
        // 2026-06-01 08:00:00 UTC, and 40 ms later.
        let begin = 1_780_300_800 * second;
        for (texts, given, name) in [
            (
                ["134247744000000000", "134247744000400000"],
                None,
                "FILETIME",
            ),
            (
                ["134247744000000000", "134247744000400000"],
                Some(1e-7),
                "FILETIME",
            ),
            (["639158976000000000", "639158976000400000"], None, ".NET"),
        ] {
            let instants = texts.map(|text| Instant::parse(&Cell::Text(text.into())));
            let scaled = scale_times(&instants, given).unwrap();
            let times: Vec<i64> = scaled.times.into_iter().flatten().collect();
            assert_eq!(times, [begin, begin + 40_000_000], "{texts:?}");
            assert!(scaled.remarks[0].contains(name), "{:?}", scaled.remarks);
        }
        // With a stated unit, the origin may be anywhere.
        let instants = ["70000000000", "70000000000.04"];
        let instants = instants.map(|text| Instant::parse(&Cell::Text(text.into())));
        let scaled = scale_times(&instants, Some(1.0)).unwrap();
        assert_eq!(scaled.times, [Some(0), Some(40_000_000)]);
        assert!(
            scaled.remarks[0].contains("which is no date"),
            "{:?}",
            scaled.remarks
        );
    }

    #[test]
    fn dates_without_fractions_name_the_rate() {
        let texts: Vec<String> = (0..210)
            .map(|row| format!("2026-06-01T08:00:{:02}Z", (row + 60) / 100))
            .collect();
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let (_, remarks) = scaled_texts(&texts);
        let [remark] = remarks.as_slice() else {
            panic!("{remarks:?}");
        };
        assert!(
            remark.contains("up to 100 rows state the same time") && remark.ends_with("--rate 100"),
            "{remark}"
        );
    }

    #[test]
    fn times_out_of_range_are_refused_and_invalid_dates_are_not_times() {
        let refused = scale_times(&[Some(Instant::Real(1e300)), None], None).unwrap_err();
        let shown = refused
            .into_read_fault(|index| format!("line {}", index + 2))
            .to_string();
        assert!(
            shown.starts_with("line 2: the time 1000000000000000"),
            "{shown}"
        );
        for text in ["zero", "", "1e", "2025", "10:53"] {
            let instant = Instant::parse(&Cell::Text(text.into()));
            assert!(
                !matches!(instant, Some(Instant::Date(..))) || text == "10:53",
                "{text}: {instant:?}"
            );
        }
    }
}
