//! Windows of strokes, in which runs are compared.

use wisch::run::{AlikeEpisode, WarningChannel};

/// Duration of a window [s].
const WINDOW: f64 = 0.1;
/// Number of parts of a stroke's duration that are compared separately.
pub(super) const PHASES: usize = 8;
/// Number of channels.
pub(super) const CHANNELS: usize = WarningChannel::ALL.len();

/// The channels of one sample of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeSample {
    /// Force on the tool along the outward normal \[N\].
    pub force: f64,
    /// Height of the tool over the believed surface \[m\].
    pub height: f64,
    /// Distance of the tool from its commanded position along the surface \[m\].
    pub tracking_error: f64,
    /// Whether the tool is in contact.
    pub is_contact: bool,
}

/// Means over a tenth of a second of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhaseWindow {
    /// Elapsed share of the stroke's duration in the middle of the window, in [0, 1).
    pub phase: f64,
    /// Values in the order of [`WarningChannel::ALL`].
    pub values: [f64; CHANNELS],
}

impl PhaseWindow {
    /// Returns the part of the stroke to which the window belongs.
    pub(super) fn part(&self) -> usize {
        ((self.phase * PHASES as f64) as usize).min(PHASES - 1)
    }
}

/// The windows of an episode's strokes, and its outcome.
#[derive(Debug, Clone, PartialEq)]
pub struct EpisodeProfile {
    /// Name and outcome of the episode.
    pub episode: AlikeEpisode,
    /// Windows of all strokes, in the order of time.
    pub windows: Vec<PhaseWindow>,
}

/// Builder of the windows of a run, sample by sample.
#[derive(Debug, Clone, Default)]
pub struct ProfileBuilder {
    stroke: Option<CurrentStroke>,
}

/// The stroke of the last sample.
#[derive(Debug, Clone)]
struct CurrentStroke {
    number: usize,
    begin: f64,
    duration: f64,
    /// Number of the current window.
    window: u64,
    sums: [f64; 3],
    count: usize,
    /// Samples of the stroke so far: all, and those in contact.
    samples: [usize; 2],
}

impl ProfileBuilder {
    /// Ends the current stroke; its unfinished window is dropped.
    pub fn leave_stroke(&mut self) {
        self.stroke = None;
    }

    /// Adds a sample of a stroke, and returns the window that it completes.
    ///
    /// # Parameters
    /// - `stroke`: number of the stroke, and its whole duration \[s\].
    /// - `time`: since the start of the round \[s\].
    pub fn push(
        &mut self,
        (number, duration): (usize, f64),
        time: f64,
        sample: &StrokeSample,
    ) -> Option<PhaseWindow> {
        if (self.stroke.as_ref()).is_none_or(|stroke| stroke.number != number) {
            self.stroke = Some(CurrentStroke::new(number, time, duration));
        }
        let stroke = self.stroke.as_mut()?;
        // Rounding of a time must not move a sample into the window before.
        let window = ((time - stroke.begin) / WINDOW + 1e-6).max(0.0) as u64;
        let done = (window > stroke.window).then(|| stroke.complete());
        stroke.window = window;
        for (sum, value) in
            (stroke.sums.iter_mut()).zip([sample.force, sample.height, sample.tracking_error])
        {
            *sum += value;
        }
        stroke.count += 1;
        stroke.samples[0] += 1;
        stroke.samples[1] += usize::from(sample.is_contact);
        done.flatten()
    }
}

impl CurrentStroke {
    const fn new(number: usize, begin: f64, duration: f64) -> Self {
        Self {
            number,
            begin,
            duration,
            window: 0,
            sums: [0.0; 3],
            count: 0,
            samples: [0; 2],
        }
    }

    /// Returns the current window and begins another one; `None` for one without finite values.
    fn complete(&mut self) -> Option<PhaseWindow> {
        let count = std::mem::take(&mut self.count) as f64;
        let [force, height, tracking_error] = std::mem::take(&mut self.sums).map(|sum| sum / count);
        let middle = (self.window as f64 + 0.5) * WINDOW;
        let values = [
            force,
            height,
            self.samples[1] as f64 / self.samples[0] as f64,
            tracking_error,
        ];
        let phase = (middle / self.duration.max(WINDOW)).clamp(0.0, 1.0 - f64::EPSILON);
        (values.iter().all(|value| value.is_finite())).then_some(PhaseWindow { phase, values })
    }
}
