//! Forces at the end of their sensor's range, recognised by a component that stays at its extreme
//! value.

use wisch::geometry::Vector3;

/// Least time in all, and least time of a run, for which a component stays at its extreme value \[ns\], and least number of
/// samples of such a run.
const LEAST_TIME: i64 = 500_000_000;
const LEAST_RUN: i64 = 50_000_000;
const FEWEST: usize = 4;
/// Least share of the samples in such runs at which another component changes \[1\].
const LEAST_CHANGES: f64 = 0.8;
/// Largest share of the samples away from the extreme values that repeat the previous sample \[1\],
/// and least number of such samples: within its range, the component must have noise.
const MOST_REPEATS: f64 = 0.5;
const FEWEST_OFF: usize = 20;
/// Longest run off the extreme values over the longest run at them \[1\]: a coarse resolution repeats all values.
const LONGEST_OFF: f64 = 0.25;

/// A component of the force that stays at the end of its range.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Saturation {
    /// Number of the component: 0 for x.
    pub(crate) axis: usize,
    /// Its value there, in the unit of the log.
    pub(crate) value: f64,
    /// Time for which it has this value, in all \[ns\].
    pub(crate) lasts: i64,
    /// Intervals in which it has this value, from the first sample to the last \[ns\].
    pub(crate) intervals: Vec<[i64; 2]>,
}

impl Saturation {
    /// Whether the component has this value at a time \[ns\].
    pub(crate) fn covers(&self, time: i64) -> bool {
        let next = self.intervals.partition_point(|[_, to]| *to < time);
        (self.intervals.get(next)).is_some_and(|[from, _]| *from <= time)
    }

    /// Describes it for users; `unit` is that of the log's force in newtons.
    pub(crate) fn describe(&self, unit: f64) -> String {
        let side = if self.value > 0.0 {
            "largest"
        } else {
            "smallest"
        };
        format!(
            "f{} is exactly {} N, its {side} value, for {:.1} s in all, while the rest of the force varies: the sensor is saturated, and these samples are not used as touch",
            ["x", "y", "z"][self.axis],
            self.value * unit,
            self.lasts as f64 * 1e-9,
        )
    }
}

/// Returns the components that stay exactly at their largest or smallest value for more than 0.5 s, while the other
/// components vary; none for forces without noise. Zero is the end of no range.
pub(crate) fn find_saturated(entries: &[(i64, Vector3)]) -> Vec<Saturation> {
    (0..3)
        .flat_map(|axis| {
            let values = entries.iter().map(|(_, force)| force[axis]);
            let largest = values.clone().fold(f64::NEG_INFINITY, f64::max);
            let smallest = values.fold(f64::INFINITY, f64::min);
            [largest, smallest]
                .into_iter()
                .filter(move |value| largest > smallest && *value != 0.0)
                .filter_map(move |value| find_at(entries, axis, value, [smallest, largest]))
        })
        .collect()
}

/// Returns the saturation of a component at one of its two extreme values.
fn find_at(
    entries: &[(i64, Vector3)],
    axis: usize,
    value: f64,
    extremes: [f64; 2],
) -> Option<Saturation> {
    let (mut intervals, mut lasts) = (Vec::new(), 0_i64);
    let (mut pairs, mut changes) = (0_usize, 0_usize);
    let (mut off, mut repeats) = (0_usize, 0_usize);
    let [mut longest, mut longest_off] = [0_i64; 2];
    for run in entries.chunk_by(|a, b| a.1[axis] == b.1[axis]) {
        let [first, last] = [run[0].0, run[run.len() - 1].0];
        let lasting = last.saturating_sub(first);
        let here = run[0].1[axis];
        if here == value {
            intervals.push([first, last]);
            if lasting >= LEAST_RUN && run.len() >= FEWEST {
                lasts = lasts.saturating_add(lasting);
                longest = longest.max(lasting);
                pairs += run.len() - 1;
                changes += run.windows(2).filter(|two| two[0].1 != two[1].1).count();
            }
        } else if !extremes.contains(&here) {
            off += run.len();
            repeats += run.len() - 1;
            longest_off = longest_off.max(lasting);
        }
    }
    let share = |part: usize, all: usize| part as f64 / all.max(1) as f64;
    let has_noise = off >= FEWEST_OFF
        && share(repeats, off) <= MOST_REPEATS
        && longest_off as f64 <= LONGEST_OFF * longest as f64;
    (lasts > LEAST_TIME && has_noise && share(changes, pairs) >= LEAST_CHANGES).then_some(
        Saturation {
            axis,
            value,
            lasts,
            intervals,
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Forces of strokes at 100 Hz: 2 s in the air, then 2 s of contact, and so on, with noise of a size.
    fn strokes(noise: f64) -> Vec<(i64, Vector3)> {
        let wobble = |k: usize, row: usize| noise * ((k * (7 + row) + row) as f64 * 1.7).sin();
        (0..1200)
            .map(|k| {
                let pressed = if k / 200 % 2 == 1 { 10.0 } else { 0.0 };
                let rest = Vector3::new(0.4 * pressed, 0.0, pressed);
                let force = rest + Vector3::from_fn(|row, _| wobble(k, row));
                (k as i64 * 10_000_000, force)
            })
            .collect()
    }

    fn changed(noise: f64, change: impl Fn(f64) -> f64) -> Vec<(i64, Vector3)> {
        let mut forces = strokes(noise);
        for (_, force) in &mut forces {
            force.z = change(force.z);
        }
        forces
    }

    #[test]
    fn a_component_cut_off_at_its_extreme_is_saturated() {
        for (sign, limit) in [(1.0, 5.0), (1.0, 9.5), (-1.0, 5.0)] {
            let cut = changed(0.3, |force| (sign * force).clamp(-limit, limit));
            let found = find_saturated(&cut);
            let [saturation] = &found[..] else {
                panic!("{sign} {limit}: {found:?}");
            };
            assert_eq!((saturation.axis, saturation.value), (2, sign * limit));
            assert!(saturation.lasts > LEAST_TIME);
            assert!(saturation.covers(saturation.intervals[0][0]) && !saturation.covers(0));
        }
        let text = find_saturated(&changed(0.3, |force| force.min(5.0)))[0].describe(1.0);
        let begin = "fz is exactly 5 N, its largest value, for 6.0 s in all";
        assert!(text.starts_with(begin), "{text}");
    }

    #[test]
    fn a_working_sensor_is_not_saturated() {
        assert_eq!(find_saturated(&strokes(0.3)), []);
        assert_eq!(find_saturated(&strokes(0.0)), [], "no noise");
        let coarse = changed(0.3, f64::round);
        assert_eq!(find_saturated(&coarse), [], "a coarse resolution");
        let fine = changed(0.3, |force| (20.0 * force).round() / 20.0);
        assert_eq!(find_saturated(&fine), [], "a fine resolution");
        let rests = changed(0.3, |force| force.max(0.0));
        assert_eq!(find_saturated(&rests), [], "no force below zero");
        let mut peaks = strokes(0.3);
        for (_, force) in &mut peaks[230..260] {
            force.z = 12.0;
        }
        assert_eq!(find_saturated(&peaks), [], "too short");
    }
}
