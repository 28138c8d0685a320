//! The learned laws, as the object of `--json` and as text.

use super::super::words::{format_count, percent};
use super::Evidence;
use serde::Serialize;
use wisch::learn::{LearnedLaw, PosteriorSummary};
use wisch::represent::Interaction;

/// Format name of the object of `--json`.
pub(super) const FORMAT: &str = "wisch-learned";
pub(super) const SCHEMA: u32 = 1;

/// The object that `--json` prints.
#[derive(Debug, Serialize)]
pub(super) struct LearnRecord {
    /// Name of the format.
    pub format: &'static str,
    /// Schema of the object.
    pub schema: u32,
    /// The written file; null with `--diff`.
    pub out: Option<String>,
    /// The changes as a unified diff; null without `--diff`.
    pub diff: Option<String>,
    /// The learned laws.
    pub laws: Vec<LawRecord>,
}

/// A law before and after.
#[derive(Debug, Serialize)]
pub(super) struct LawRecord {
    tool: String,
    medium: String,
    surface: String,
    /// Nominal press force of all rounds [N].
    press_force_n: f64,
    /// Number of bags that do not state their press force, for which that of their task is assumed.
    bags_of_assumed_force: usize,
    rounds: usize,
    runs: usize,
    particles: usize,
    mu: ParameterRecord,
    sigma: ParameterRecord,
    redraw_length_m: ParameterRecord,
    kept_share: f64,
}

/// A parameter before and after. `spread`: standard deviation of μ, or of the logarithm of the other parameters.
#[derive(Debug, Serialize)]
struct ParameterRecord {
    before: f64,
    mean: f64,
    spread: f64,
    low: f64,
    high: f64,
}

/// Returns the interval of a parameter from the summary of its logarithm.
pub(super) fn exponentiate_interval(summary: &PosteriorSummary) -> [f64; 2] {
    summary.interval.map(f64::exp)
}

/// Makes the record of a law before and after learning.
pub(super) fn law_record(evidence: &Evidence, law: &LearnedLaw) -> LawRecord {
    let Interaction {
        tool,
        medium,
        surface,
        press_force_n,
        likelihood,
        redraw,
        ..
    } = &evidence.interaction;
    let of_log = |before: f64, summary: &PosteriorSummary| {
        let [low, high] = exponentiate_interval(summary);
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
        press_force_n: *press_force_n,
        bags_of_assumed_force: evidence.undeclared.len(),
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
        let describe = |parameter: &ParameterRecord| {
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
            ("mu", describe(&law.mu)),
            ("sigma", describe(&law.sigma)),
            ("redraw length [m]", describe(&law.redraw_length_m)),
            (
                "thresholds",
                format!(
                    "permanent with a probability of {}",
                    percent(law.kept_share)
                ),
            ),
            (
                "press force",
                match law.bags_of_assumed_force {
                    0 => format!("{} N in every round", law.press_force_n),
                    bags => format!(
                        "{} N, assumed for {} of {}",
                        law.press_force_n,
                        bags,
                        format_count(law.rounds, "round")
                    ),
                },
            ),
            (
                "from",
                format!(
                    "{} of {}, {}",
                    format_count(law.rounds, "round"),
                    format_count(law.runs, "run"),
                    format_count(law.particles, "particle")
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
