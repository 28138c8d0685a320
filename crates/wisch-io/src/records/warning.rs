//! Records of warnings.

use serde::Serialize;
use wisch::run::RunWarning;

/// A warning that the running stroke differs from earlier episodes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WarningRecord {
    /// Number of the round, from 1.
    pub round: usize,
    /// Number of the stroke in its plan, from 1.
    pub stroke: usize,
    /// Time since the execution began.
    pub time_s: f64,
    /// Elapsed share of the stroke's duration.
    pub phase: f64,
    /// contact force, height, contact share or tracking error.
    pub channel: &'static str,
    /// Unit of the value and the band; 1 for a share.
    pub unit: &'static str,
    /// moment for a mean of a tenth of a second, run for the mean of all strokes so far.
    pub span: &'static str,
    /// The value.
    pub value: f64,
    /// Lower and upper end of the prediction band.
    pub band: [f64; 2],
    /// Probability of a run that deviates at least as much, if nothing has changed.
    pub p_value: f64,
    /// Number of episodes that the run is compared with.
    pub episodes: usize,
    /// The most similar episodes, the most similar one first.
    pub alike: Vec<AlikeEpisodeRecord>,
}

/// An earlier episode that resembles the running one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AlikeEpisodeRecord {
    /// Its name.
    pub id: String,
    /// Verdict of its last round; null if it is unknown.
    pub verdict: Option<String>,
    /// Estimated performance at its end; null if it is unknown.
    pub performance: Option<f64>,
}

impl From<&RunWarning> for WarningRecord {
    fn from(warning: &RunWarning) -> Self {
        let alike = warning.alike.iter().map(|episode| AlikeEpisodeRecord {
            id: episode.id.clone(),
            verdict: episode.verdict.clone(),
            performance: episode.performance,
        });
        Self {
            round: warning.round,
            stroke: warning.stroke + 1,
            time_s: warning.time,
            phase: warning.phase,
            channel: warning.channel.as_str(),
            unit: warning.channel.unit(),
            span: warning.span.as_str(),
            value: warning.value,
            band: warning.band,
            p_value: warning.p_value,
            episodes: warning.episodes,
            alike: alike.collect(),
        }
    }
}
