//! Comparison of a run with earlier episodes while the robot executes it.

use super::bands::{ConformalBands, RunScore};
use super::gauge::{Gauge, Touch};
use super::profile::{CHANNELS, PhaseWindow, ProfileBuilder};
use std::collections::BTreeMap;
use wisch::follow::Phase;
use wisch::run::{PlannedRound, RunEvent, RunWarning, TelemetrySample};

/// Compares a run with earlier episodes while the robot wipes. A channel gives at most one warning in a run.
///
/// Its computation time per sample does not depend on the number of episodes, except for a sample
/// that gives a warning.
#[derive(Debug, Clone)]
pub struct MemoryWatch {
    bands: ConformalBands,
    gauge: Option<Gauge>,
    round: usize,
    /// Durations of the strokes of the round by number [s].
    durations: BTreeMap<usize, f64>,
    builder: ProfileBuilder,
    score: RunScore,
    has_warned: [bool; CHANNELS],
}

impl MemoryWatch {
    /// Returns a watch over a run that has not begun.
    pub fn new(bands: ConformalBands) -> Self {
        Self {
            bands,
            gauge: None,
            round: 0,
            durations: BTreeMap::new(),
            builder: ProfileBuilder::default(),
            score: RunScore::default(),
            has_warned: [false; CHANNELS],
        }
    }

    /// Receives an event of the run, and returns the warnings that it gives cause for.
    pub fn on_event(&mut self, event: &RunEvent<'_>) -> Vec<RunWarning> {
        match event {
            RunEvent::Executing(planned) => {
                self.begin(planned);
                Vec::new()
            }
            RunEvent::Sample(sample) => self.check(sample),
            _ => Vec::new(),
        }
    }

    fn begin(&mut self, planned: &PlannedRound) {
        let surface = &planned.task.surface;
        self.gauge = Some(Gauge::new(&planned.task, surface.world_from_surface));
        self.round = planned.number;
        self.builder.leave_stroke();
        self.durations.clear();
        let mut begins = BTreeMap::new();
        for motion in &planned.followed.motions {
            if let Phase::Wipe(stroke) = motion.phase {
                let begin = *begins.entry(stroke).or_insert(motion.start);
                self.durations.insert(stroke, motion.end() - begin);
            }
        }
    }

    fn check(&mut self, sample: &TelemetrySample<'_>) -> Vec<RunWarning> {
        let Phase::Wipe(stroke) = sample.phase else {
            self.builder.leave_stroke();
            return Vec::new();
        };
        let (Some(gauge), true) = (&self.gauge, sample.status.shows_motion()) else {
            return Vec::new();
        };
        let measured = gauge.measure(&Touch {
            tool: sample.world_from_tool.translation.vector.into(),
            commanded: sample.world_from_commanded.translation.vector.into(),
            force: sample.external.force,
        });
        // Without a planned duration, the phase of the stroke is unknown.
        let Some(&duration) = self.durations.get(&stroke) else {
            return Vec::new();
        };
        let window = (self.builder).push((stroke, duration), sample.time, &measured);
        window.map_or_else(Vec::new, |window| self.warn(&window, stroke, sample.time))
    }

    /// Compares a window, and returns warnings of the channels that have not warned yet.
    fn warn(&mut self, window: &PhaseWindow, stroke: usize, time: f64) -> Vec<RunWarning> {
        let beyond = self.bands.compare(&mut self.score, window);
        let mut warnings = Vec::new();
        for deviation in beyond {
            let has_warned = &mut self.has_warned[deviation.channel as usize];
            if std::mem::replace(has_warned, true) {
                continue;
            }
            warnings.push(RunWarning {
                round: self.round,
                stroke,
                time,
                phase: window.phase,
                channel: deviation.channel,
                span: deviation.span,
                value: deviation.value,
                band: deviation.band,
                p_value: self.bands.p_value(&self.score),
                episodes: self.bands.episodes(),
                alike: self.bands.alike(&self.score),
            });
        }
        warnings
    }
}
