//! Outliers of the force: a few samples far beyond all others, between neighbours that agree with each other.

use wisch::geometry::Vector3;

/// Samples on either side of an outlier that show the force there.
const NEIGHBOURS: usize = 5;
/// Largest number of consecutive samples of an outlier.
const LONGEST: usize = 5;
/// Least deviation of an outlier from its neighbours, over their own median deviation \[1\]; 10 standard deviations.
const LEAST_BY_SPREAD: f64 = 15.0;
/// Least deviation of an outlier of one sample, over the force that 95 % of all samples do not
/// exceed \[1\]. For each further sample the limit doubles, because impacts last for several
/// samples.
const LEAST_BY_SIZE: f64 = 2.0;
/// Largest deviation of the samples next to an outlier, over its own \[1\]: an impact rises and decays.
const MOST_BESIDE: f64 = 0.1;
/// Least number of samples of a log in which outliers are searched.
const FEWEST: usize = 4 * NEIGHBOURS;

/// Outliers of a log's force.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spikes {
    /// Number of samples that are left out.
    left_out: usize,
    /// Number of samples that are used as measured, because their neighbours are too far apart for an interpolation.
    used: usize,
    /// Time of the first outlier \[ns\], its size and that of the median of its neighbours, in the unit of the log.
    first: (i64, f64, f64),
}

impl Spikes {
    /// Describes them for users; `start` is the log's time 0 \[ns\], `unit` that of its force in newtons, and `limit` the
    /// longest gap to interpolate \[s\].
    pub(crate) fn describe(&self, start: i64, unit: f64, limit: f64) -> String {
        let are = match self.left_out + self.used {
            1 => "1 sample of the force is an outlier, ".to_owned(),
            count => format!("{count} samples of the force are outliers, the first "),
        };
        let (time, size, beside) = self.first;
        let left_out = "left out, and the force is interpolated between its neighbours".to_owned();
        let used = format!(
            "used as measured, because its neighbours are more than {limit} s apart (--max-gap-s)"
        );
        let consequence = match (self.left_out, self.used) {
            (_, 0) => left_out,
            (0, _) => used,
            (out, kept) => format!("{out} {left_out}; {kept} {used}"),
        };
        format!(
            "{are}with {:.1} N at {:.3} s, where its neighbours have {:.1} N: {consequence}",
            size * unit,
            time.saturating_sub(start) as f64 * 1e-9,
            beside * unit,
        )
    }
}

/// Takes outliers out of the forces of a log, if the neighbours of an outlier are at most `max_gap` \[ns\] apart. Returns
/// `None` if there is no outlier.
pub(crate) fn take_out_spikes(entries: &mut Vec<(i64, Vector3)>, max_gap: i64) -> Option<Spikes> {
    let runs = find_spikes(entries);
    let (first, beside) = runs.first()?;
    let (time, force) = entries[first.start];
    let mut spikes = Spikes {
        left_out: 0,
        used: 0,
        first: (time, force.norm(), beside.norm()),
    };
    let mut is_kept = vec![true; entries.len()];
    for (run, _) in runs {
        if entries[run.end].0.saturating_sub(entries[run.start - 1].0) <= max_gap {
            spikes.left_out += run.len();
            is_kept[run].fill(false);
        } else {
            spikes.used += run.len();
        }
    }
    let mut kept = is_kept.into_iter();
    entries.retain(|_| kept.next().unwrap_or(true));
    Some(spikes)
}

/// Returns the outliers, as ranges of indices with the median force of their neighbours. The first and the last sample are
/// none.
fn find_spikes(entries: &[(i64, Vector3)]) -> Vec<(std::ops::Range<usize>, Vector3)> {
    if entries.len() < FEWEST {
        return Vec::new();
    }
    let mut sizes: Vec<f64> = entries.iter().map(|(_, force)| force.norm()).collect();
    let place = sizes.len() * 95 / 100;
    let (_, usual, _) = sizes.select_nth_unstable_by(place, f64::total_cmp);
    let least = LEAST_BY_SIZE * *usual;
    let mut spikes = Vec::new();
    let mut next = 1;
    while next + 1 < entries.len() {
        let start = next;
        next += 1;
        // A cheap test first: the force jumps to the outlier.
        if (entries[start].1 - entries[start - 1].1).norm() <= (1.0 - MOST_BESIDE) * least {
            continue;
        }
        let found = (1..=LONGEST)
            .map(|length| start..start + length)
            .filter(|run| run.end < entries.len())
            .find_map(|run| {
                let least = least * f64::from(1 << (run.len() - 1));
                Some((examine(entries, &run, least)?, run))
            });
        if let Some((beside, run)) = found {
            next = run.end;
            spikes.push((run, beside));
        }
    }
    spikes
}

/// Returns the median force of the neighbours of a run, if the run is an outlier.
fn examine(
    entries: &[(i64, Vector3)],
    run: &std::ops::Range<usize>,
    least: f64,
) -> Option<Vector3> {
    let before = run.start.saturating_sub(NEIGHBOURS)..run.start;
    let after = run.end..(run.end + NEIGHBOURS).min(entries.len());
    let beside: Vec<Vector3> = before.chain(after).map(|i| entries[i].1).collect();
    let middle = Vector3::from_fn(|row, _| median(beside.iter().map(|force| force[row])));
    let spread = median(beside.iter().map(|force| (force - middle).norm()));
    let off = |i: usize| (entries[i].1 - middle).norm();
    let smallest = run.clone().map(off).fold(f64::INFINITY, f64::min);
    let is_far = smallest > least.max(LEAST_BY_SPREAD * spread);
    let is_alone = off(run.start - 1).max(off(run.end)) <= MOST_BESIDE * smallest;
    (is_far && is_alone).then_some(middle)
}

fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    let middle = numbers.len() / 2;
    let (_, median, _) = numbers.select_nth_unstable_by(middle, f64::total_cmp);
    *median
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Forces at a rate [Hz]: a second in the air, 8 s of contact with 15 N, a second in the air, with noise of 0.2 N.
    fn wiping(rate: i64) -> Vec<(i64, Vector3)> {
        (0..10 * rate)
            .map(|k| {
                let pressed = if (rate..9 * rate).contains(&k) {
                    15.0
                } else {
                    0.0
                };
                let wobble = 0.2 * (k as f64 * 12.9).sin();
                (
                    k * 1_000_000_000 / rate,
                    Vector3::new(0.3 * pressed, wobble, pressed + wobble),
                )
            })
            .collect()
    }

    const GAP: i64 = 100_000_000;

    #[test]
    fn single_samples_far_beyond_their_neighbours_are_left_out_and_named() {
        let clean = wiping(100);
        assert_eq!(take_out_spikes(&mut clean.clone(), GAP), None);
        for (place, force) in [(500, 500.0), (500, -300.0), (50, 80.0), (950, 500.0)] {
            let mut spiked = clean.clone();
            spiked[place].1.z = force;
            spiked[700].1.x = 1e4;
            spiked[701].1.x = -1e4;
            let found = take_out_spikes(&mut spiked, GAP).unwrap();
            assert_eq!((found.left_out, found.used, spiked.len()), (3, 0, 997));
            let text = found.describe(0, 1.0, 0.1);
            let first = format!("{:.3} s", (place.min(700) as f64) / 100.0);
            assert!(
                text.starts_with("3 samples of the force are outliers"),
                "{text}"
            );
            assert!(
                text.contains(&first) && text.contains("left out, and"),
                "{text}"
            );
        }
    }

    #[test]
    fn outliers_of_a_slow_log_are_used_and_said() {
        let mut slow = wiping(10);
        slow[40].1.z = 500.0;
        let found = take_out_spikes(&mut slow, GAP).unwrap();
        assert_eq!((found.left_out, found.used, slow.len()), (0, 1, 100));
        let text = found.describe(0, 1.0, 0.1);
        assert!(
            text.ends_with("more than 0.1 s apart (--max-gap-s)"),
            "{text}"
        );
    }

    #[test]
    fn pushes_impacts_and_steps_are_no_outliers() {
        let clean = wiping(100);
        let with = |change: &dyn Fn(usize, &mut Vector3)| {
            let mut forces = clean.clone();
            for (k, (_, force)) in forces.iter_mut().enumerate() {
                change(k, force);
            }
            take_out_spikes(&mut forces, GAP)
        };
        let push = with(&|k, force| force.x += if (500..510).contains(&k) { 60.0 } else { 0.0 });
        assert_eq!(push, None, "a push of 0.1 s");
        let short = with(&|k, force| force.x += if (500..503).contains(&k) { 60.0 } else { 0.0 });
        assert_eq!(short, None, "a blow of 30 ms");
        // An impact that rises and decays within 60 ms.
        let impact = with(&|k, force| {
            force.z += [20.0, 80.0, 40.0, 20.0, 10.0]
                .get(k.wrapping_sub(300))
                .unwrap_or(&0.0);
        });
        assert_eq!(impact, None, "an impact");
        let step = with(&|k, force| force.z += if k > 400 { 100.0 } else { 0.0 });
        assert_eq!(step, None, "a step");
        let low = with(&|k, force| force.z += if k == 400 { 6.0 } else { 0.0 });
        assert_eq!(low, None, "not beyond what the tool presses with");
    }
}
