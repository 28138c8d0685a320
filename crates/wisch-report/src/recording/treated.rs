//! Passes or coat thickness of each place of a treated surface: predicted over time, estimated and true.

use super::particles::line;
use super::samples::round_to;
use crate::draw::{format_decimal, format_percent};
use crate::prediction::frames::{Frame, PlaceGrid};
use serde::Serialize;
use wisch::interpret::Belief;
use wisch::represent::{GoalState, ParticleDistribution, THICKNESS_TOLERANCE, Task, Treatment};

/// Number of written steps of a value up to the target.
const PARTS: f64 = 200.0;
/// Maximum number of changed values in a round.
const MAX_CHANGES: usize = 60_000;
const MICROMETRES: f64 = 1e6;

/// Time [s]; indices of the places whose value changes; their values, in steps.
type ValueStep = (f64, Vec<usize>, Vec<i64>);

/// The allowed band of a treatment, in passes or in micrometres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct Band {
    unit: &'static str,
    target: f64,
    low: f64,
    high: f64,
    /// Value of one written step.
    step: f64,
    /// Value of one pass.
    #[serde(skip)]
    per_pass: f64,
}

/// The treated places that a recording shows.
#[derive(Debug, Clone)]
pub(super) struct TreatedPlaces {
    band: Band,
    /// Number of places of the task.
    count: usize,
    grid: PlaceGrid,
}

/// The places of a round and the prediction of their values over time.
#[derive(Serialize)]
pub(super) struct TreatmentRecord {
    #[serde(flatten)]
    band: Band,
    cell: [f64; 2],
    places: Vec<i64>,
    steps: Vec<ValueStep>,
}

impl Band {
    /// Returns the band of a task; `None` for a task that moves dirt.
    pub(super) fn new(task: &Task) -> Option<Self> {
        let treatment = task.treatment.filter(|_| task.action.treats())?;
        let (unit, per_pass, [low, target, high]) = match treatment {
            Treatment::Polish {
                passes, max_passes, ..
            } => {
                let [least, most] = [passes, max_passes].map(f64::from);
                ("passes", 1.0, [least, least, most])
            }
            Treatment::Dispense { thickness, .. } => {
                let GoalState::Dispensed { per_pass, .. } = treatment.goal(task.tool.width())
                else {
                    return None;
                };
                let share = [1.0 - THICKNESS_TOLERANCE, 1.0, 1.0 + THICKNESS_TOLERANCE];
                let band = share.map(|share| round_to(share * MICROMETRES * thickness, 1e3));
                ("µm", MICROMETRES * per_pass, band)
            }
        };
        Some(Self {
            unit,
            target,
            low,
            high,
            step: target / PARTS,
            per_pass,
        })
    }

    /// States the target as the performance counts it. `count`: number of places, in words.
    pub(super) fn describe_target(&self, target: f64, count: &str) -> String {
        let on = format!("on {} of {count} surface points", format_percent(target));
        if self.unit == "passes" {
            let [least, most] = [self.low, self.high].map(format_passes);
            let rest = format_percent(1.0 - target);
            format!("at least {least} {on}, and more than {most} on at most {rest}")
        } else {
            format!("a coat of {} {on}", self.describe())
        }
    }

    /// Describes the band, such as "80 to 120 µm".
    pub(super) fn describe(&self) -> String {
        let digits = usize::from(self.unit != "passes" && self.low < 10.0);
        let [low, high] = [self.low, self.high].map(|value| format_decimal(value, digits));
        if low == high {
            format!("{low} {}", self.unit)
        } else {
            format!("{low} to {high} {}", self.unit)
        }
    }

    /// Describes what a place has that counts as done.
    pub(super) fn describe_done(&self) -> String {
        match self.unit {
            "passes" => format!("at least {}", format_passes(self.low)),
            _ => format!("a coat of {}", self.describe()),
        }
    }

    /// Describes what a place has above the band.
    pub(super) fn describe_excess(&self) -> String {
        let digits = usize::from(self.unit != "passes" && self.high < 10.0);
        format!(
            "more than {} {}",
            format_decimal(self.high, digits),
            self.unit
        )
    }

    /// Returns the value of a number of passes, in steps.
    fn steps(&self, passes: f64) -> i64 {
        (passes * self.per_pass / self.step).round() as i64
    }
}

fn format_passes(count: f64) -> String {
    let plural = if count == 1.0 { "" } else { "es" };
    format!("{} pass{plural}", format_decimal(count, 0))
}

impl TreatedPlaces {
    /// Selects the places of a task; `None` for a task that moves dirt.
    pub(super) fn new(task: &Task) -> Option<Self> {
        Some(Self {
            band: Band::new(task)?,
            count: task.particles.len(),
            grid: PlaceGrid::of_task(task),
        })
    }

    /// Makes the record of a round. `frames`: the prediction with times [s], whose particles are those of
    /// [`PlaceGrid::of_task`].
    pub(super) fn record<'a>(
        &self,
        task: &Task,
        frames: impl Iterator<Item = (f64, &'a Frame)>,
    ) -> TreatmentRecord {
        let moments = frames.map(|(time, frame)| {
            let passes = frame.particles.iter().map(|(_, fate)| fate.passes());
            (time, passes.map(|passes| self.band.steps(passes)).collect())
        });
        let kept: Vec<_> = (self.grid.kept.iter())
            .map(|&i| task.particles.position(i))
            .collect();
        TreatmentRecord {
            band: self.band,
            cell: self.grid.cell.map(|side| round_to(side, 1e5)),
            places: line(&kept),
            steps: list_steps_between(&moments.collect::<Vec<_>>()),
        }
    }

    /// Returns the values of a surface, such as the true one; `None` if it has other places.
    pub(super) fn values(&self, surface: &ParticleDistribution) -> Option<Vec<i64>> {
        let passes = |&i: &usize| self.band.steps(surface.fate(i).passes());
        (surface.len() == self.count).then(|| self.grid.kept.iter().map(passes).collect())
    }

    /// Returns the means of the values over a belief; `None` if a member has other places.
    pub(super) fn mean_values(&self, belief: &Belief) -> Option<Vec<i64>> {
        let (members, weights) = (belief.members(), belief.weights());
        if members.iter().any(|member| member.len() != self.count) {
            return None;
        }
        let total: f64 = weights.iter().sum();
        let mean = |&i: &usize| {
            let weighted = (members.iter().zip(weights))
                .map(|(member, weight)| weight * member.fate(i).passes());
            self.band.steps(weighted.sum::<f64>() / total)
        };
        Some(self.grid.kept.iter().map(mean).collect())
    }
}

/// Returns the changes between moments: time [s] and the value of each place. The first step has all values.
fn list_steps_between(moments: &[(f64, Vec<i64>)]) -> Vec<ValueStep> {
    let mut now: Vec<i64> = Vec::new();
    let mut budget = MAX_CHANGES;
    let mut steps = Vec::new();
    for (i, (time, values)) in moments.iter().enumerate() {
        let changed: Vec<usize> = (0..values.len())
            .filter(|&place| now.get(place) != Some(&values[place]))
            .collect();
        // Beyond the budget, moments are skipped, except the first and the last.
        if changed.len() > budget && i > 0 && i + 1 < moments.len() {
            continue;
        }
        budget = budget.saturating_sub(changed.len());
        let new = changed.iter().map(|&place| values[place]).collect();
        steps.push((round_to(*time, 1e3), changed, new));
        now.clone_from(values);
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::tests::polished;
    use wisch::geometry::Point2;
    use wisch::represent::{Action, Fate};
    use wisch_testkit as kit;

    /// Returns the places of a task, each with its own number of passes.
    fn treated(task: &Task, passes: impl Fn(usize) -> f64) -> ParticleDistribution {
        let places: Vec<(Point2, Fate)> = (0..task.particles.len())
            .map(|i| {
                let passes = passes(i);
                (task.particles.position(i), Fate::Treated { passes })
            })
            .collect();
        ParticleDistribution::with_fates(&places).expect("finite places")
    }

    #[test]
    fn every_place_of_a_small_lattice_has_its_value() {
        let task = polished();
        let places = TreatedPlaces::new(&task).expect("it is polished");
        let surface = treated(&task, |i| 0.01 * i as f64);
        let expected: Vec<i64> = (0..task.particles.len() as i64).collect();
        assert_eq!(places.values(&surface), Some(expected));
        let fewer = ParticleDistribution::new(&[Point2::origin()]).expect("a place");
        assert_eq!(places.values(&fewer), None, "other places");
    }

    #[test]
    fn steps_reproduce_every_moment() {
        let moments: Vec<(f64, Vec<i64>)> = (0..6)
            .map(|k| {
                (
                    f64::from(k),
                    (0..50).map(|i| i64::from(i < 9 * k) * 100).collect(),
                )
            })
            .collect();
        let mut now = vec![-1; 50];
        let steps = list_steps_between(&moments);
        assert_eq!(steps.len(), moments.len());
        for ((time, changed, values), (then, expected)) in steps.iter().zip(&moments) {
            for (&place, &value) in changed.iter().zip(values) {
                now[place] = value;
            }
            assert_eq!((time, &now), (then, expected));
        }
        assert_eq!(steps[1].1.len(), 9, "only changes are written");
    }

    #[test]
    fn the_number_of_changes_is_limited_and_the_end_is_kept() {
        let moments: Vec<(f64, Vec<i64>)> = (0..80)
            .map(|k| (f64::from(k), vec![i64::from(k); 6_000]))
            .collect();
        let steps = list_steps_between(&moments);
        let changes: usize = steps.iter().map(|(_, changed, _)| changed.len()).sum();
        assert!(changes <= MAX_CHANGES + 6_000, "{changes}");
        assert_eq!(steps.last().map(|step| step.0), Some(79.0));
    }

    #[test]
    fn bands_are_described_as_they_are_counted() {
        let mut task = polished();
        let band = Band::new(&task).expect("it is polished");
        assert_eq!(band.describe(), "2 to 4 passes");
        assert_eq!(band.describe_excess(), "more than 4 passes");
        assert_eq!(
            band.describe_target(0.97, "1200"),
            "at least 2 passes on 97.0 % of 1200 surface points, and more than 4 passes on at most 3.0 %"
        );
        task.action = Action::Dispense;
        task.treatment = Some(Treatment::Dispense {
            thickness: 1e-4,
            volume_per_metre: 1e-4 * task.tool.width(),
        });
        let band = Band::new(&task).expect("it is painted");
        assert_eq!(band.describe(), "80 to 120 µm");
        assert_eq!(
            band.describe_target(0.95, "600"),
            "a coat of 80 to 120 µm on 95.0 % of 600 surface points"
        );
        assert_eq!(band.steps(1.0), 200);
        assert!(Band::new(&kit::board(Action::Absorb, [0.6, 0.0, 0.2])).is_none());
    }
}
