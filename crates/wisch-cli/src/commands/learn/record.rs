//! What was learned, as `--json` prints it and in words.

use super::super::words::{counted, percent};
use super::Evidence;
use serde::Serialize;
use wisch::learn::{LearnedLaw, PosteriorSummary};
use wisch::represent::Interaction;

/// What the object of `--json` is.
pub(super) const FORMAT: &str = "wisch-learned";
pub(super) const SCHEMA: u32 = 1;

/// The object that `--json` prints.
#[derive(Debug, Serialize)]
pub(super) struct LearnRecord {
    pub format: &'static str,
    pub schema: u32,
    /// The file that was written, or nothing.
    pub out: Option<String>,
    /// What changes, if that was asked for.
    pub diff: Option<String>,
    pub laws: Vec<LawRecord>,
}

/// A law before and after.
#[derive(Debug, Serialize)]
pub(super) struct LawRecord {
    tool: String,
    medium: String,
    surface: String,
    rounds: usize,
    runs: usize,
    particles: usize,
    mu: ParameterRecord,
    sigma: ParameterRecord,
    redraw_length_m: ParameterRecord,
    kept_share: f64,
}

/// A parameter; `spread` is that of its logarithm, but for μ.
#[derive(Debug, Serialize)]
struct ParameterRecord {
    before: f64,
    mean: f64,
    spread: f64,
    low: f64,
    high: f64,
}

/// The interval of a parameter of whose logarithm this is.
pub(super) fn exp(summary: &PosteriorSummary) -> [f64; 2] {
    summary.interval.map(f64::exp)
}

/// A law before and after it was learned.
pub(super) fn law_record(evidence: &Evidence, law: &LearnedLaw) -> LawRecord {
    let Interaction {
        tool,
        medium,
        surface,
        likelihood,
        redraw,
        ..
    } = &evidence.interaction;
    let of_log = |before: f64, summary: &PosteriorSummary| {
        let [low, high] = exp(summary);
        ParameterRecord {
            before,
            mean: summary.mean.exp(),
            spread: summary.deviation,
            low,
            high,
        }
    };
    let [low, high] = law.mu.interval;
    LawRecord {
        tool: tool.clone(),
        medium: medium.clone(),
        surface: surface.to_string(),
        rounds: law.rounds,
        runs: evidence.runs.len(),
        particles: law.particles,
        mu: ParameterRecord {
            before: likelihood.mu,
            mean: law.mu.mean,
            spread: law.mu.deviation,
            low,
            high,
        },
        sigma: of_log(likelihood.sigma, &law.ln_sigma),
        redraw_length_m: of_log(
            redraw.length_m.unwrap_or(evidence.collision_radius),
            &law.ln_redraw_length,
        ),
        kept_share: law.kept_share,
    }
}

/// The summary for people.
pub(super) fn in_words(record: &LearnRecord) -> String {
    let mut text = String::new();
    for law in &record.laws {
        text += &format!("{} on {} on {}\n", law.tool, law.medium, law.surface);
        let told = |parameter: &ParameterRecord| {
            let ParameterRecord {
                before,
                mean,
                low,
                high,
                ..
            } = parameter;
            format!("{mean:.3}, {low:.3} to {high:.3} with 90 % probability (before: {before:.3})")
        };
        for (name, value) in [
            ("mu", told(&law.mu)),
            ("sigma", told(&law.sigma)),
            ("redraw length [m]", told(&law.redraw_length_m)),
            (
                "thresholds",
                format!(
                    "kept for good with a probability of {}",
                    percent(law.kept_share)
                ),
            ),
            (
                "from",
                format!(
                    "{} of {}, {}",
                    counted(law.rounds, "round"),
                    counted(law.runs, "run"),
                    counted(law.particles, "particle")
                ),
            ),
        ] {
            text += &format!("  {name:<18} {value}\n");
        }
    }
    if let Some(out) = &record.out {
        text += &format!("  {:<18} {out}\n", "results");
    }
    text
}
