//! Plausibility checks of a log, which reveal wrong units.

use super::options::LogOptions;
use wisch::geometry::Vector3;
use wisch::interpret::TouchSample;

/// Longest period between samples that still shows the motion of a tool [s].
const LONG_PERIOD: f64 = 1.0;
/// Least and largest plausible speed of a wiping tool [m/s].
const SPEEDS: [f64; 2] = [1e-3, 10.0];
/// Least distance from which a speed is computed [m].
const LEAST_WAY: f64 = 0.02;
/// Distance from the surface above which a length unit is in doubt [m].
const FAR: f64 = 10.0;
/// Distance from the surface that counts as near, in a candidate for the unit [m].
const NEAR: f64 = 3.0;
/// Usual distance of a wiping tool from the middle of its path [m], by which units are compared.
const USUAL_SPREAD: f64 = 0.2;
/// Largest force that a wiping robot measures [N].
const MOST_FORCE: f64 = 2000.0;

/// Smaller units that a length may have: size [m] and name.
const LENGTHS: [(f64, &str); 4] = [
    (1e-2, "centimetres"),
    (0.0254, "inches"),
    (1e-3, "millimetres"),
    (1e-6, "micrometres"),
];

/// Returns implausible facts about a log, each with an option that may correct it: first the unit
/// of length, then the unit of time, then quantities that depend on both.
pub(crate) fn doubts(samples: &[TouchSample], options: &LogOptions) -> Vec<String> {
    let mut doubts = Vec::new();
    let steps = || samples.windows(2).map(|pair| (&pair[0], &pair[1]));
    let way = |a: &TouchSample, b: &TouchSample| {
        (b.world_from_tool.translation.vector - a.world_from_tool.translation.vector).norm()
    };
    let distance = |unit: f64| {
        let positions = samples
            .iter()
            .map(|sample| sample.world_from_tool.translation.vector);
        let at = options.world_from_surface.translation.vector;
        median(positions.map(|position| (position * unit - at).norm())).unwrap_or(0.0)
    };
    let far = distance(1.0);
    if far > FAR {
        let spread = find_spread(samples);
        let near = LENGTHS
            .into_iter()
            .filter(|(unit, _)| distance(*unit) < NEAR);
        // A wiping tool is near its surface, and its path has a usual size; a tool closer than that size is near enough.
        let strange = |unit: f64| {
            let beyond = (distance(unit) / USUAL_SPREAD).max(1.0);
            (spread * unit / USUAL_SPREAD).ln().abs() + beyond.ln()
        };
        let advice = match near.min_by(|a, b| strange(a.0).total_cmp(&strange(b.0))) {
            Some((unit, name)) => format!(
                "in {name} (--length-unit-m {}) it would be {:.2} m",
                unit * options.length_unit.unwrap_or(1.0),
                distance(unit),
            ),
            None => "check surface.position_m and --world-from-log".to_owned(),
        };
        doubts.push(format!("the tool is {far:.1} m from the surface: {advice}"));
    }
    if let Some(period) = median(steps().map(|(a, b)| b.time - a.time))
        && period >= LONG_PERIOD
    {
        doubts.push(format!(
            "a sample every {period:.3} s is too slow to show how a tool moves: check --time-unit-s; if the times count samples, it is their period"
        ));
    }
    let moved: f64 = steps().map(|(a, b)| way(a, b)).sum();
    let moves = steps().filter(|(a, b)| way(a, b) > 0.0);
    let speed = median(moves.map(|(a, b)| way(a, b) / (b.time - a.time)));
    if let Some(speed) = speed
        .filter(|speed| moved > LEAST_WAY && far <= FAR && !(SPEEDS[0]..=SPEEDS[1]).contains(speed))
    {
        doubts.push(format!(
            "the tool moves at {speed:.1e} m/s: check --time-unit-s, --rate and --length-unit-m"
        ));
    }
    let force = median(samples.iter().map(|sample| sample.force.norm()));
    if let Some(force) = force.filter(|force| *force > MOST_FORCE) {
        doubts.push(format!("the forces are {force:.0} N: check --force-unit-n"));
    }
    doubts
}

/// Returns the median distance of the tool from the middle of its path [m].
fn find_spread(samples: &[TouchSample]) -> f64 {
    let at = |sample: &TouchSample| sample.world_from_tool.translation.vector;
    let middle = samples.iter().map(at).sum::<Vector3>() / samples.len().max(1) as f64;
    median(samples.iter().map(|sample| (at(sample) - middle).norm())).unwrap_or(0.0)
}

/// Returns the median; `None` without numbers.
fn median(numbers: impl Iterator<Item = f64>) -> Option<f64> {
    let mut numbers: Vec<f64> = numbers.collect();
    if numbers.is_empty() {
        return None;
    }
    let middle = numbers.len() / 2;
    let (_, median, _) = numbers.select_nth_unstable_by(middle, f64::total_cmp);
    Some(*median)
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::Pose;

    /// Warnings for a tool that moves at 0.1 m/s for 10 s on a surface 0.8 m from the world's origin, in the given
    /// units.
    fn log(time_unit: f64, length_unit: f64, force: f64) -> Vec<String> {
        log_over(Vector3::new(0.5, 0.0, 0.8), (time_unit, length_unit), force)
    }

    /// The same on a surface whose middle is at a point of the world [m].
    fn log_over(middle: Vector3, (time_unit, length_unit): (f64, f64), force: f64) -> Vec<String> {
        let sample = |tick: u32| {
            let time = f64::from(tick) / 25.0;
            let position = (middle + Vector3::x() * (0.1 * time - 0.5)) / length_unit;
            let pose = Pose::translation(position.x, position.y, position.z);
            TouchSample::new(time / time_unit, pose, Vector3::z() * force)
        };
        let samples: Vec<TouchSample> = (0..250).map(sample).collect();
        let options = LogOptions {
            world_from_surface: Pose::translation(middle.x, middle.y, middle.z),
            ..LogOptions::default()
        };
        doubts(&samples, &options)
    }

    #[test]
    fn a_small_board_in_centimetres_is_not_in_inches() {
        let middle = Vector3::new(0.5, 0.0, 0.8);
        let sample = |tick: u32| {
            let time = f64::from(tick) / 25.0;
            let along = 0.1 * (time % 2.0) - 0.1;
            let pose = Pose::translation(50.0 + 100.0 * along, 3.0, 80.0);
            TouchSample::new(time, pose, Vector3::z() * 10.0)
        };
        let samples: Vec<TouchSample> = (0..250).map(sample).collect();
        let options = LogOptions {
            world_from_surface: Pose::translation(middle.x, middle.y, middle.z),
            ..LogOptions::default()
        };
        let found = doubts(&samples, &options).swap_remove(0);
        assert!(
            found.contains("in centimetres (--length-unit-m 0.01)"),
            "{found}"
        );
    }

    #[test]
    fn implausible_units_are_reported_and_plausible_ones_are_not() {
        assert_eq!(log(1.0, 1.0, 10.0), [] as [String; 0]);
        let one = |mut doubts: Vec<String>| {
            assert!(!doubts.is_empty());
            doubts.swap_remove(0)
        };
        let millimetres = one(log(1.0, 1e-3, 10.0));
        assert!(
            millimetres.contains("--length-unit-m 0.001) it would be 0."),
            "{millimetres}"
        );
        assert!(one(log(1.0, 1e-2, 10.0)).contains("in centimetres (--length-unit-m 0.01)"));
        // A wrong unit of length comes before one of time.
        let both = log(1e-3, 1e-3, 10.0);
        assert!(both[0].contains("in millimetres") && both[1].starts_with("a sample every"));
        // Around the world's origin, every unit brings the tool near the surface.
        for (unit, name) in [
            (1e-2, "centimetres"),
            (1e-3, "millimetres"),
            (1e-6, "micrometres"),
        ] {
            let found = one(log_over(Vector3::zeros(), (1.0, unit), 10.0));
            assert!(found.contains(&format!("in {name} ")), "{found}");
        }
        let micrometres = one(log(1.0, 1e-6, 10.0));
        assert!(
            micrometres.contains("--length-unit-m 0.000001)"),
            "{micrometres}"
        );
        assert!(one(log(1e-3, 1.0, 10.0)).starts_with("a sample every 40.000 s"));
        assert!(one(log(1e3, 1.0, 10.0)).starts_with("the tool moves at 1.0e2 m/s"));
        assert!(one(log(1.0, 1.0, 1e4)).starts_with("the forces are 10000 N"));
    }
}
