//! Mean forces and contact shares of an imported log, at any sampling rate.

use proptest::prelude::*;
use wisch::geometry::{Point2, Polygon, Pose, Vector2, Vector3};
use wisch::interpret::{Belief, InterpretConfig, TouchSample, interpret};
use wisch::represent::{Action, ParticleDistribution, Surface, Task, Tool};
use wisch_memory::{Catalogue, EpisodeHeader, EpisodeRecord, Value, remember_log};

/// Rates of logs [Hz].
const RATES: [f64; 9] = [10.0, 20.0, 50.0, 100.0, 125.0, 200.0, 500.0, 1000.0, 2000.0];
/// Largest deviation of a mean force from the true one [1], at rates from the number before on [Hz]. A sample at the
/// beginning or the end of a contact stands for up to half a period of another force.
const FORCE_BOUNDS: [[f64; 2]; 3] = [[0.0, 0.08], [50.0, 0.03], [200.0, 0.02]];
/// Largest deviation of a contact share from that of the motion [1].
const SHARE_BOUND: f64 = 0.04;
/// Length of a stroke, and height in the air [m].
const LENGTH: f64 = 0.3;
const LIFTED: f64 = 0.06;
/// Speed down and up [m/s].
const CLIMB: f64 = 0.1;
/// Distance over which the force rises from zero [m].
const SINK: f64 = 2e-3;

fn task() -> Task {
    let outline = Polygon::rectangle(Vector2::new(0.5, 0.3));
    let surface = Surface::new("tray", outline, Pose::translation(0.5, 0.0, 0.8));
    let pad = Tool::pad("pad", Vector3::new(0.07, 0.07, 0.05)).expect("a pad");
    let crumbs = ParticleDistribution::new(&[Point2::new(-0.1, 0.05), Point2::new(0.12, 0.1)]);
    let crumbs = crumbs.expect("crumbs");
    Task::new(Action::Absorb, surface, pad, "crumbs", crumbs)
}

/// A motion: strokes in contact with a constant force, with lifts between them.
#[derive(Debug, Clone, Copy)]
struct Motion {
    /// Force on the surface in contact [N].
    force: f64,
    /// Speed along the strokes [m/s].
    speed: f64,
    /// Time at rest before the first sample [s], so that samples of different logs lie elsewhere in the motion.
    offset: f64,
}

impl Motion {
    const STROKES: usize = 3;

    /// Duration of descent, stroke, ascent and pause in the air [s].
    fn parts(&self) -> [f64; 4] {
        [LIFTED / CLIMB, LENGTH / self.speed, LIFTED / CLIMB, 1.0]
    }

    fn duration(&self) -> f64 {
        Self::STROKES as f64 * self.parts().iter().sum::<f64>() + 1.0
    }

    /// Pose and height of the tool over the surface at a time [m].
    fn at(&self, time: f64) -> (Point2, f64) {
        let parts = self.parts();
        let period: f64 = parts.iter().sum();
        let time = (time - 1.0).max(0.0);
        let stroke = ((time / period) as usize).min(Self::STROKES - 1);
        let y = 0.09 * (stroke as f64 - 1.0);
        let mut rest = time - stroke as f64 * period;
        let begin = Point2::new(-0.5 * LENGTH, y);
        if rest < parts[0] {
            return (begin, LIFTED - CLIMB * rest);
        }
        rest -= parts[0];
        if rest < parts[1] {
            return (Point2::new(begin.x + self.speed * rest, y), 0.0);
        }
        rest -= parts[1];
        let end = Point2::new(0.5 * LENGTH, y);
        if rest < parts[2] {
            return (end, CLIMB * rest);
        }
        rest -= parts[2];
        // To the next stroke in the air.
        let share = (rest / parts[3]).min(1.0);
        let next = 0.09 * (stroke as f64).min(1.0);
        let to = Point2::new(-0.5 * LENGTH, next);
        (end + share * (to - end), LIFTED)
    }

    fn samples(&self, rate: f64, task: &Task) -> Vec<TouchSample> {
        let count = (self.duration() * rate) as usize;
        let samples = (0..count).map(|i| {
            let time = i as f64 / rate;
            let (place, height) = self.at(time + self.offset);
            let share = (1.0 - height / SINK).clamp(0.0, 1.0);
            let tool =
                task.surface.world_from_surface * Pose::translation(place.x, place.y, height);
            TouchSample::new(time, tool, Vector3::new(0.0, 0.0, self.force * share))
        });
        samples.collect()
    }

    fn remembered(&self, rate: f64) -> EpisodeRecord {
        self.remembered_until(rate, f64::INFINITY)
    }

    /// Returns the record of a log that ends at a time [s].
    fn remembered_until(&self, rate: f64, end: f64) -> EpisodeRecord {
        let task = task();
        let goal = task.goal().expect("a goal");
        let mut samples = self.samples(rate, &task);
        samples.retain(|sample| sample.time <= end);
        let config = InterpretConfig::from_task(&task);
        let believed = Belief::from_particles(task.particles.clone());
        let estimate = interpret(&samples, &task, &believed, &goal, &config);
        let estimate = estimate.expect("an interpretation");
        let header = EpisodeHeader::new(1_795_309_772.5, &task, 0.95, "test");
        let duration = samples.last().map_or(0.0, |sample| sample.time);
        remember_log(&header, "log.csv", duration, &task, &goal, &estimate)
    }
}

/// Returns a number of every individual of a class; `None` where it is missing.
fn numbers(record: &EpisodeRecord, class: &str, property: &str) -> Vec<Option<f64>> {
    let those = record.individuals.iter().filter(|one| one.class == class);
    let number = |value: Option<&Value>| match value {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    };
    those.map(|one| number(one.values.get(property))).collect()
}

/// Checks all forces and shares of the log of a motion at one rate.
fn check(motion: &Motion, rate: f64, shares: &[Option<f64>]) -> Result<(), TestCaseError> {
    let record = motion.remembered(rate);
    let bound = FORCE_BOUNDS.iter().rev().find(|[least, _]| rate >= *least);
    let bound = bound.expect("a bound")[1] * motion.force;
    for class in ["semco:Stroke", "semco:WipingRound", "semco:ToolContact"] {
        let forces = numbers(&record, class, "semco:meanNormalForce");
        let count = if class == "semco:WipingRound" {
            1
        } else {
            Motion::STROKES
        };
        prop_assert_eq!(forces.len(), count, "{} at {} Hz", class, rate);
        for force in forces {
            // Negative, because the tool presses.
            let deviation = force.map(|force| (force + motion.force).abs());
            prop_assert!(
                deviation.is_some_and(|deviation| deviation <= bound),
                "{class} at {rate} Hz: {force:?} N of {} N",
                -motion.force
            );
        }
    }
    for share in numbers(&record, "semco:Stroke", "semco:contactShare") {
        prop_assert!(
            share.is_some_and(|share| share >= 1.0 - SHARE_BOUND),
            "{share:?} at {rate} Hz"
        );
    }
    let found = numbers(&record, "semco:WipingRound", "semco:contactShare");
    for (found, share) in found.iter().zip(shares) {
        let deviation = (found.unwrap_or(0.0) - share.unwrap_or(1.0)).abs();
        prop_assert!(
            deviation <= SHARE_BOUND,
            "{found:?} at {rate} Hz, not {share:?}"
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]
    #[test]
    fn the_rate_of_a_log_changes_no_force_and_no_contact_share(
        force in 8.0..15.0_f64, speed in 0.08..0.15_f64, offset in 0.0..0.1_f64,
    ) {
        let motion = Motion { force, speed, offset };
        let shares = numbers(&motion.remembered(1000.0), "semco:WipingRound", "semco:contactShare");
        for rate in RATES {
            check(&motion, rate, &shares)?;
        }
    }
}

#[test]
fn a_log_at_the_surface_without_force_has_a_contact_share_of_0() {
    let [force, speed, offset] = [0.0, 0.1, 0.0];
    let record = Motion {
        force,
        speed,
        offset,
    }
    .remembered(100.0);
    let of_round = |property| numbers(&record, "semco:WipingRound", property);
    assert_eq!(of_round("semco:contactShare"), [Some(0.0)]);
    // There is no force during contact, and the performance is unknown.
    assert_eq!(of_round("semco:meanNormalForce"), [None]);
    assert_eq!(of_round("semco:performance"), [None]);
}

#[test]
fn a_lower_bound_is_no_performance() {
    let [force, speed, offset] = [10.0, 0.1, 0.0];
    let motion = Motion {
        force,
        speed,
        offset,
    };
    // The log ends in the middle of the first stroke.
    let [descent, stroke, ..] = motion.parts();
    let record = motion.remembered_until(100.0, 1.0 + descent + 0.5 * stroke);
    for class in ["semco:WipingRound", "semco:WipingAction"] {
        assert_eq!(numbers(&record, class, "semco:performance"), [None]);
        let low = numbers(&record, class, "semco:performanceLow");
        assert!(low[0].is_some(), "{class}: {low:?}");
    }
    let whole = motion.remembered(100.0);
    let found = numbers(&whole, "semco:WipingAction", "semco:performance");
    assert!(found[0].is_some());
    // Earlier versions stored the bound as the performance.
    let mut earlier = record;
    for one in &mut earlier.individuals {
        if one.values.contains_key("semco:performanceLow") {
            let bound = Value::Number(0.4);
            one.values.insert("semco:performance".to_owned(), bound);
        }
    }
    let catalogue = Catalogue::from_records([&earlier]);
    assert!(catalogue.numbers("semco:performance").is_empty());
}
