//! Warnings while a robot wipes, and what happens after one.

use std::fmt;

/// What a session does after a warning of its watch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OnWarning {
    /// The run is not compared with earlier runs, so that there are no warnings.
    Ignore,
    /// The warning is reported, and the run continues.
    #[default]
    Report,
    /// The round ends within the stroke, and the next round plans for the remaining dirt.
    EndStroke,
    /// The run ends as if its operator had stopped it: no further motion begins.
    Stop,
}

/// A quantity that is compared with earlier runs while the robot wipes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WarningChannel {
    /// Force of the surface on the tool along the outward normal \[N\].
    Force,
    /// Height of the tool over the believed surface \[m\]; negative for a tool that is pressed in.
    Height,
    /// Share of the samples of the stroke so far with the tool in contact \[1\].
    ContactShare,
    /// Distance of the tool from its commanded position along the surface \[m\].
    TrackingError,
}

impl WarningChannel {
    /// All channels, in the order of their indices.
    pub const ALL: [Self; 4] = [
        Self::Force,
        Self::Height,
        Self::ContactShare,
        Self::TrackingError,
    ];

    /// Name of the channel, as messages and files have it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Force => "contact force",
            Self::Height => "height",
            Self::ContactShare => "contact share",
            Self::TrackingError => "tracking error",
        }
    }

    /// Unit of the values; 1 stands for a share.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Force => "N",
            Self::Height | Self::TrackingError => "m",
            Self::ContactShare => "1",
        }
    }

    /// Formats a value with a unit that people read.
    pub fn format(self, value: f64) -> String {
        match self {
            Self::Force => format!("{value:.2} N"),
            Self::Height | Self::TrackingError => format!("{:.2} mm", 1e3 * value),
            Self::ContactShare => format!("{:.0} %", 1e2 * value),
        }
    }
}

impl fmt::Display for WarningChannel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// The samples over which the value of a warning is averaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WarningSpan {
    /// A window of a tenth of a second.
    Moment,
    /// All windows of the run's strokes so far.
    Run,
}

impl WarningSpan {
    /// Name of the span in files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Moment => "moment",
            Self::Run => "run",
        }
    }
}

/// An earlier episode that resembles the running one, and its outcome.
#[derive(Debug, Clone, PartialEq)]
pub struct AlikeEpisode {
    /// Name of the episode in its memory.
    pub id: String,
    /// Verdict of its last round; `None` if the episode does not state one.
    pub verdict: Option<String>,
    /// Estimated performance at its end \[1\]; `None` if it is unknown.
    pub performance: Option<f64>,
}

/// A warning: the running stroke differs from comparable earlier episodes at the same phase.
#[derive(Debug, Clone, PartialEq)]
pub struct RunWarning {
    /// The round, from 1.
    pub round: usize,
    /// The stroke, from 0.
    pub stroke: usize,
    /// Time since the start of the round's motion \[s\].
    pub time: f64,
    /// Elapsed share of the stroke's duration \[1\].
    pub phase: f64,
    /// The quantity that deviates.
    pub channel: WarningChannel,
    /// The samples that the value is a mean of.
    pub span: WarningSpan,
    /// The value, in the channel's unit.
    pub value: f64,
    /// Conformal prediction band of that value, in the same unit: lower and upper end.
    pub band: [f64; 2],
    /// Probability of a run that deviates at least as much, if nothing has changed \[1\].
    pub p_value: f64,
    /// Number of episodes that the run is compared with.
    pub episodes: usize,
    /// The episodes that are most similar to the run, the most similar one first.
    pub alike: Vec<AlikeEpisode>,
}

impl fmt::Display for RunWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { channel, .. } = self;
        let [low, high] = self.band.map(|end| channel.format(end));
        let span = match self.span {
            WarningSpan::Moment => "",
            WarningSpan::Run => " in the mean of the run so far",
        };
        write!(
            f,
            "round {}, stroke {} at {:.0} %, {:.1} s: {channel} {}{span}, outside {low} to {high} (p = {:.3}, {} episodes)",
            self.round,
            self.stroke + 1,
            1e2 * self.phase,
            self.time,
            channel.format(self.value),
            self.p_value,
            self.episodes
        )?;
        for (place, episode) in self.alike.iter().enumerate() {
            let lead = if place == 0 { "; most similar: " } else { ", " };
            let verdict = episode.verdict.as_deref().unwrap_or("verdict unknown");
            write!(f, "{lead}{} ({verdict}", episode.id)?;
            match episode.performance {
                Some(share) => write!(f, ", {:.0} %)", 1e2 * share)?,
                None => f.write_str(", performance unknown)")?,
            }
        }
        Ok(())
    }
}
