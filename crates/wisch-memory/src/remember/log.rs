//! Log of a round's motions, kept during the execution.

use wisch::follow::Phase;
use wisch::interpret::{Event, EventKind};
use wisch::run::TelemetrySample;

/// Motions of a round, collected sample by sample.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoundLog {
    /// Runs of samples of the same kind.
    runs: Vec<Run>,
}

/// Consecutive samples of one kind.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    kind: Kind,
    /// Times of the first and last sample [s].
    start: f64,
    end: f64,
    /// Largest norm of the external force, `None` without a usable one [N].
    peak_force: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Drive,
    /// The tool is off the surface, or on its way to or from it.
    Lifted,
    Stroke(usize),
}

/// A motion of a round.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Span {
    part: Part,
    /// Begin and end [s since the round began].
    pub start: f64,
    pub end: f64,
    /// Number of the stroke, for a stroke.
    pub stroke: Option<usize>,
    /// Largest norm of the external force, `None` without a usable one [N].
    pub peak_force: Option<f64>,
}

/// Kind of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Approach,
    Stroke,
    Transfer,
    Drive,
    Retreat,
}

impl Span {
    /// Returns the kind of motion that an event of a log stands for; `None` for other events. A stroke gets the given
    /// number.
    pub(super) fn of_phase(event: &Event, stroke: usize) -> Option<Self> {
        let part = match event.kind {
            EventKind::Approach => Part::Approach,
            EventKind::Stroke => Part::Stroke,
            EventKind::Lift => Part::Transfer,
            EventKind::Retreat => Part::Retreat,
            _ => return None,
        };
        Some(Self {
            part,
            start: event.start,
            end: event.end,
            stroke: (part == Part::Stroke).then_some(stroke),
            peak_force: Some(event.peak_force),
        })
    }

    pub(super) const fn class(&self) -> &'static str {
        match self.part {
            Part::Approach => "semco:Approach",
            Part::Stroke => "semco:Stroke",
            Part::Transfer => "semco:Transfer",
            Part::Drive => "semco:Drive",
            Part::Retreat => "semco:Retreat",
        }
    }
}

impl RoundLog {
    /// Adds a sample of the round's execution.
    pub fn push(&mut self, sample: &TelemetrySample<'_>) {
        let kind = match sample.phase {
            Phase::Drive => Kind::Drive,
            Phase::FreeMotion | Phase::Lifted | Phase::Lower | Phase::Lift => Kind::Lifted,
            Phase::Wipe(stroke) => Kind::Stroke(stroke),
        };
        let is_usable = sample.status.wrench.is_usable();
        let force = is_usable.then(|| sample.external.force.norm());
        match self.runs.last_mut() {
            Some(run) if run.kind == kind => {
                run.end = sample.time;
                let forces = run.peak_force.into_iter().chain(force);
                run.peak_force = forces.reduce(f64::max);
            }
            last => {
                // Without a gap: a run lasts until the next begins.
                if let Some(last) = last {
                    last.end = sample.time;
                }
                self.runs.push(Run {
                    kind,
                    start: sample.time,
                    end: sample.time,
                    peak_force: force,
                });
            }
        }
    }

    /// Returns the motions in their order.
    pub(super) fn spans(&self) -> Vec<Span> {
        let is_stroke = |run: &Run| matches!(run.kind, Kind::Stroke(_));
        let first = self.runs.iter().position(is_stroke);
        let last = self.runs.iter().rposition(is_stroke);
        let part = |place: usize, kind: Kind| match kind {
            Kind::Drive => Part::Drive,
            Kind::Stroke(_) => Part::Stroke,
            Kind::Lifted if first.is_none_or(|first| place < first) => Part::Approach,
            Kind::Lifted if last.is_some_and(|last| place > last) => Part::Retreat,
            Kind::Lifted => Part::Transfer,
        };
        let spans = self.runs.iter().enumerate().map(|(place, run)| Span {
            part: part(place, run.kind),
            start: run.start,
            end: run.end,
            stroke: match run.kind {
                Kind::Stroke(stroke) => Some(stroke),
                _ => None,
            },
            peak_force: run.peak_force,
        });
        spans.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::{Pose, Vector3};
    use wisch::interpret::{TouchSample, WrenchQuality};
    use wisch::run::{SampleStatus, Wrench};

    #[test]
    fn lifted_motions_are_classified_by_adjacent_strokes() {
        let phases = [
            Phase::Drive,
            Phase::FreeMotion,
            Phase::Lower,
            Phase::Wipe(0),
            Phase::Wipe(0),
            Phase::Lift,
            Phase::Lifted,
            Phase::Lower,
            Phase::Wipe(1),
            Phase::Wipe(2),
            Phase::Lift,
            Phase::Drive,
        ];
        let mut log = RoundLog::default();
        for (time, phase) in (0..).zip(phases) {
            log.push(&TelemetrySample {
                time: f64::from(time),
                positions: &[],
                velocities: &[],
                efforts: &[],
                world_from_commanded: Pose::identity(),
                world_from_tool: Pose::identity(),
                controller: Wrench::default(),
                external: Wrench {
                    force: Vector3::new(0.0, 3.0, f64::from(time)),
                    moment: Vector3::zeros(),
                },
                motion: 0,
                phase,
                status: SampleStatus::default(),
            });
        }
        let spans = log.spans();
        let found: Vec<_> = (spans.iter())
            .map(|span| (&span.class()[6..], span.start, span.end, span.stroke))
            .collect();
        let expected = [
            ("Drive", 0.0, 1.0, None),
            ("Approach", 1.0, 3.0, None),
            ("Stroke", 3.0, 5.0, Some(0)),
            ("Transfer", 5.0, 8.0, None),
            ("Stroke", 8.0, 9.0, Some(1)),
            ("Stroke", 9.0, 10.0, Some(2)),
            ("Retreat", 10.0, 11.0, None),
            ("Drive", 11.0, 11.0, None),
        ];
        assert_eq!(found, expected);
        assert_eq!(spans[2].peak_force, Some(5.0));
    }

    #[test]
    fn a_force_that_is_not_usable_is_no_peak() {
        let mut log = RoundLog::default();
        for (time, wrench) in (0..).zip([WrenchQuality::Stale, WrenchQuality::Ok]) {
            for (phase, force) in [(Phase::Wipe(time), 90.0), (Phase::Wipe(2), 7.0)] {
                let force = Vector3::new(0.0, 0.0, force);
                let touch = TouchSample::new(time as f64, Pose::identity(), force);
                let mut sample = TelemetrySample::from_touch(&touch, 0, phase);
                sample.status.wrench = wrench;
                log.push(&sample);
            }
        }
        let peaks: Vec<_> = (log.spans().iter()).map(|span| span.peak_force).collect();
        assert_eq!(peaks, [None, None, Some(90.0), Some(7.0)]);
    }
}
